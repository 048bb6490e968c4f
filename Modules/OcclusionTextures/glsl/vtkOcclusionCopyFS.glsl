// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// A target's slices as they are: the first level.

//VTK::Output::Dec

uniform sampler2DArray shadowSource;
uniform int shadowLayer;

void main()
{
  gl_FragData[0] = texelFetch(shadowSource, ivec3(gl_FragCoord.xy, shadowLayer), 0);
}
