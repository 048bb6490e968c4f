// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// What a face of a volume adds to the count, by the side that is seen.

//VTK::Output::Dec

uniform float shadowFront;
uniform float shadowBack;

void main()
{
  gl_FragData[0] = vec4(gl_FrontFacing ? shadowFront : shadowBack);
}
