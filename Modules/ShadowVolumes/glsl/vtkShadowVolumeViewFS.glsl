// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// Volumes over the picture.

//VTK::Output::Dec

uniform vec4 shadowFrontColor;
uniform vec4 shadowBackColor;

void main()
{
  gl_FragData[0] = gl_FrontFacing ? shadowFrontColor : shadowBackColor;
}
