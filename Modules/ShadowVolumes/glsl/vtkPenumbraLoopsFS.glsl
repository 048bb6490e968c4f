// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
#extension GL_ARB_shader_bit_encoding : require
#extension GL_ARB_gpu_shader5 : enable

// Combines what a loop hides of the light with what others hide: how much of that both hide is not
// known, and half of the lesser is a guess between all and nothing. What a hole lets through adds
// up.

//VTK::Output::Dec

uniform sampler2DArray shadowReceivers;
uniform sampler2DArray shadowSums;  // of the loop: how often it hides the centre, what edges let through
uniform sampler2DArray shadowLoops; // hidden by loops, let through by holes: a layer each channel
uniform int shadowChannel;

void main()
{
  vec2 others = texelFetch(shadowLoops, ivec3(gl_FragCoord.xy, shadowChannel), 0).xy;
#ifndef SHADOW_COPY
  vec4 receiverVC = shadowFetchReceiver(shadowReceivers, ivec2(gl_FragCoord.xy));
  vec4 all = texelFetch(shadowSums, ivec3(gl_FragCoord.xy, 0), 0);
  vec2 sums = vec2(all.x, all[1 + shadowChannel]);
  if (shadowIsReceiver(receiverVC) && sums != vec2(0.0))
  {
    vec3 aboves = receiverVC.w > 0.0 ? vec3(shadowAboveHorizon(shadowHorizon(
      shadowSeeArea(receiverVC.xyz), shadowUnpackReceiver(receiverVC.w).normalVC))) : vec3(1.0);
    float above = aboves[shadowChannel];
    float hidden = clamp(above * sums.x - sums.y, -above, above);
    others = hidden < 0.0 ? others + vec2(0.0, -hidden)
      : vec2(max(hidden, others.x) + 0.5 * min(hidden, others.x), others.y);
  }
#endif
  gl_FragData[0] = vec4(others, 0.0, 0.0);
}
