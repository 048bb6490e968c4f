// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// A frame's visibility as a share of the mean of several, for vtkVisibilityBuffer::Accumulate, which blends.

//VTK::Output::Dec

uniform sampler2DArray shadowBuffer;
uniform int shadowLayer;
uniform float shadowShare;

void main()
{
  vec4 visibility = texelFetch(shadowBuffer, ivec3(gl_FragCoord.xy, shadowLayer), 0);
  gl_FragData[0] = vec4(clamp(visibility.rgb, 0.0, 1.0), shadowShare);
}
