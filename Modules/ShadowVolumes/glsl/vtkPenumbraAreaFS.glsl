// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec

// Takes away what is hidden of a part of the light's area.

//VTK::Output::Dec

uniform sampler2DArray shadowSums;
uniform float shadowShare;

void main()
{
  float hidden = texelFetch(shadowSums, ivec3(gl_FragCoord.xy, 0), 0).r;
  gl_FragData[0] = vec4(vec3(-shadowShare * clamp(hidden, 0.0, 1.0)), 0.0);
}
