// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
#extension GL_ARB_shader_bit_encoding : require
#extension GL_ARB_gpu_shader5 : enable

// Takes away what is hidden of the light, or of a part of its area.

//VTK::Output::Dec

#ifdef SHADOW_WEDGE_EMISSION
#define SHADOW_LAYER(channel) channel
#else
#define SHADOW_LAYER(channel) 0
#endif

uniform sampler2DArray shadowReceivers;
uniform sampler2DArray shadowSums; // how often the centre is hidden, what edges let through
uniform vec3 shadowShare;

void main()
{
  vec4 receiverVC = shadowFetchReceiver(shadowReceivers, ivec2(gl_FragCoord.xy));
  if (!shadowIsReceiver(receiverVC))
  {
    discard;
  }
  vec3 above = vec3(1.0);
  if (receiverVC.w > 0.0)
  {
    shadowAreaSeen area = shadowSeeArea(receiverVC.xyz);
    above = vec3(shadowAboveHorizon(
      shadowHorizon(area, shadowUnpackReceiver(receiverVC.w).normalVC)));
  }
  vec3 seen;
  for (int c = 0; c < 3; ++c)
  {
#ifdef SHADOW_COMBINED
    vec4 sums = texelFetch(shadowSums, ivec3(gl_FragCoord.xy, SHADOW_LAYER(c)), 0);
    seen[c] = above[c] - sums.x + sums.y;
#else
    vec4 sums = texelFetch(shadowSums, ivec3(gl_FragCoord.xy, 0), 0);
    seen[c] = above[c] * (1.0 - sums.x) + sums[1 + SHADOW_LAYER(c)];
#endif
  }
  gl_FragData[0] = vec4(shadowShare * (clamp(seen, 0.0, 1.0) - 1.0), 0.0);
}
