// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
#extension GL_ARB_shader_bit_encoding : require
#extension GL_ARB_gpu_shader5 : enable

// The share of the light that an edge lets through or hides, beyond what the light's centre tells.

//VTK::Output::Dec

flat in vec3 shadowFromVC;
flat in vec3 shadowToVC;
flat in vec4 shadowPlaneSWC;
flat in vec4 shadowWidthSWC;
flat in float shadowTimes;

uniform sampler2DArray shadowReceivers;
uniform int shadowLight;

void main()
{
  vec4 receiverVC = shadowFetchReceiver(shadowReceivers, ivec2(gl_FragCoord.xy));
  shadowSelf = receiverVC.w > 0.0;
  vec3 normalVC = shadowUnpackReceiver(receiverVC.w).normalVC;
  bool receives = shadowIsReceiver(receiverVC);
#ifdef SHADOW_WEDGE_VIEW
  // Without views whatever adds up there: it is dark in the end, and to ask costs more.
  receives = receives && !shadowFacesAway(shadowLight, receiverVC.xyz, normalVC);
#endif
  if (!receives)
  {
    discard;
  }
  shadowAreaSeen area = shadowSeeArea(receiverVC.xyz);
  vec3 horizon = shadowHorizon(area, normalVC);
  bool behind = shadowIsBehind(shadowPlaneSWC, shadowWidthSWC, receiverVC);
  // By the predicate, since rounding may turn the image of an edge that passes the centre.
  float turn = behind == (determinant(area.rows) < 0.0) ? -1.0 : 1.0;
  // Whole millionths (2^-20), which floats add up without rounding as long as a sum is less than 16
  // lights: in any order of the edges, and with the halves of wedges apart or together.
  vec3 cover = vec3(shadowTimes / 1048576.0 * floor(0.5 + 1048576.0 *
    shadowCover((shadowFromVC - receiverVC.xyz) * area.rows,
    (shadowToVC - receiverVC.xyz) * area.rows, turn, shadowSelf && shadowIsCut(horizon),
    horizon)));
#ifdef SHADOW_QUANTITY
  // Wedges over a pixel. The edge is asked all the same: its attributes are bound.
  float least = behind ? -1e30 : -2e30;
  gl_FragData[0] = vec4(cover.x > least ? 1.0 : 0.0);
#else
  if (cover == vec3(0.0))
  {
    discard;
  }
#if defined(SHADOW_WEDGE_EDGES)
  gl_FragData[0] = vec4(behind ? cover : -cover, 0.0);
#elif defined(SHADOW_WEDGE_HALF)
  gl_FragData[0] = vec4(behind == (SHADOW_WEDGE_HALF == 1) ? cover : vec3(0.0), 0.0);
#else
  gl_FragData[0] = vec4(0.0, behind ? cover : -cover);
#endif
#endif
}
