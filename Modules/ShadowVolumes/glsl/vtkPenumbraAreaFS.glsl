// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
#extension GL_ARB_shader_bit_encoding : require
#extension GL_ARB_gpu_shader5 : enable

// Takes away what is hidden of the light, or of a part of its area.

//VTK::Output::Dec

uniform sampler2DArray shadowReceivers;
uniform sampler2DArray shadowSums; // how often the centre is hidden, what edges let through
uniform float shadowShare;

void main()
{
  vec4 receiverVC = texelFetch(shadowReceivers, ivec3(gl_FragCoord.xy, 0), 0);
  if (!shadowIsReceiver(receiverVC))
  {
    discard;
  }
  vec4 sums = texelFetch(shadowSums, ivec3(gl_FragCoord.xy, 0), 0);
  float above = 1.0;
  if (receiverVC.w > 0.0)
  {
    shadowAreaSeen area = shadowSeeArea(receiverVC.xyz);
    above = shadowAboveHorizon(
      shadowHorizon(area, shadowUnpackReceiver(receiverVC.w).normalVC));
  }
#ifdef SHADOW_COMBINED
  vec3 seen = clamp(vec3(above - sums.x + sums.y), 0.0, 1.0);
#else
  vec3 seen = clamp(above * (1.0 - sums.x) + sums.yyy, 0.0, 1.0);
#endif
  gl_FragData[0] = vec4(shadowShare * (seen - 1.0), 0.0);
}
