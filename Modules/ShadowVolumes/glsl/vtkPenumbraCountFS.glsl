// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
#extension GL_ARB_shader_bit_encoding : require
#extension GL_ARB_gpu_shader5 : enable

// How an edge changes what hides the samples of a light, against what hides its centre: where the
// edge's image lies between the two, by how many of its faces end there. Counts of some samples are
// digits of a float, SHADOW_DIGITS of SHADOW_BASE, and four floats a target.

//VTK::Output::Dec

flat in vec3 shadowFromVC;
flat in vec3 shadowToVC;
flat in vec4 shadowPlaneSWC;
flat in vec4 shadowWidthSWC;
flat in float shadowTimes;
flat in vec4 shadowFirstFaceSWC;
flat in vec4 shadowSecondFaceSWC;

uniform sampler2DArray shadowReceivers;
uniform int shadowLight;
uniform vec4 shadowSampleX[SHADOW_DIGITS * SHADOW_TARGETS]; // four samples each, on the light
uniform vec4 shadowSampleY[SHADOW_DIGITS * SHADOW_TARGETS];

// Of what the light sees of a face: 1 its front, -1 its back, as what lies behind it sees the other
// side; 0 where there is no face.
float shadowTurn(vec4 faceSWC, vec3 placeSWC)
{
  return faceSWC == vec4(0.0) ? 0.0
    : (dot(faceSWC.xyz, placeSWC) + faceSWC.w > 0.0 ? -1.0 : 1.0);
}

vec4 shadowCountCrossings(int first, vec2 from, vec2 to, vec3 line, bool behind)
{
  vec4 digits = vec4(0.0);
  for (int i = first; i < first + SHADOW_DIGITS; ++i)
  {
    vec4 x = shadowSampleX[i];
    vec4 y = shadowSampleY[i];
    vec4 side = line.x * x + line.y * y + line.z;
    bvec4 beyond = notEqual(greaterThan(side, vec4(0.0)), bvec4(behind));
    bvec4 between = notEqual(greaterThanEqual(from.x * y - from.y * x, vec4(0.0)),
      greaterThanEqual(to.x * y - to.y * x, vec4(0.0)));
    digits = SHADOW_BASE * digits + vec4(beyond) * vec4(between);
  }
  return digits;
}

void main()
{
  vec4 receiverVC = shadowFetchReceiver(shadowReceivers, ivec2(gl_FragCoord.xy));
  shadowSelf = receiverVC.w > 0.0;
  shadowReceiver receiver = shadowUnpackReceiver(receiverVC.w);
  if (!shadowIsReceiver(receiverVC)
    || shadowFacesAway(shadowLight, receiverVC.xyz, receiver.normalVC))
  {
    discard;
  }
  // Before its own face, whatever rounding has made of it, as far as the picture does not tell.
  float halfPixel = dot(shadowHalfPixel, vec4(receiverVC.xyz, 1.0));
  float height = shadowSelf ? shadowSlack(receiverVC, 0.25 * halfPixel) : 0.0;
  vec3 outsideVC = receiverVC.xyz + height * receiver.normalVC;
  vec3 outsideSWC = (shadowVCToSWC * vec4(outsideVC, 1.0)).xyz;
  float times = 0.5 * shadowTimes * (shadowTurn(shadowFirstFaceSWC, outsideSWC)
    - shadowTurn(shadowSecondFaceSWC, outsideSWC));
  shadowAreaSeen area = shadowSeeArea(receiverVC.xyz);
  vec3 from = (shadowFromVC - outsideVC) * area.rows;
  vec3 to = (shadowToVC - outsideVC) * area.rows;
  // The part of the edge between the receiver and the light.
  float least = 1e-6 * max(max(abs(from.z), abs(to.z)), max(length(from.xy), length(to.xy)));
  vec3 along = to - from;
  float first = 0.0;
  float last = 1.0;
  SHADOW_CLIP(from.z - least, to.z - least)
#if SHADOW_WEDGE_SHAPE != 3
  SHADOW_CLIP(1.0 - from.z, 1.0 - to.z)
#endif
  vec3 line = cross(from, to) * (determinant(area.rows) < 0.0 ? -1.0 : 1.0);
#ifndef SHADOW_QUANTITY
  // Its line misses the light.
  if (times == 0.0 || !(last > first) || !shadowIsCut(line))
  {
    discard;
  }
#endif
  // Where the centre's count does not change, the image alone tells on which side the centre is.
  bool behind = shadowPlaneSWC == vec4(0.0) ? line.z > 0.0
    : shadowIsBehind(shadowPlaneSWC, shadowWidthSWC, receiverVC);
  vec2 p = first > 0.0 ? from.xy + first * along.xy : from.xy;
  vec2 q = last < 1.0 ? from.xy + last * along.xy : to.xy;
  times = behind ? -times : times;
  vec4 crossings = times * shadowCountCrossings(0, p, q, line, behind);
#ifdef SHADOW_QUANTITY
  // Wedges over a pixel. The edge is asked all the same: its attributes are bound.
  gl_FragData[0] = vec4(crossings.x > -1e30 ? 1.0 : 0.0);
#else
  gl_FragData[0] = crossings;
#if SHADOW_TARGETS > 1
  gl_FragData[1] = times * shadowCountCrossings(SHADOW_DIGITS, p, q, line, behind);
#endif
#if SHADOW_TARGETS > 2
  gl_FragData[2] = times * shadowCountCrossings(2 * SHADOW_DIGITS, p, q, line, behind);
#endif
#if SHADOW_TARGETS > 3
  gl_FragData[3] = times * shadowCountCrossings(3 * SHADOW_DIGITS, p, q, line, behind);
#endif
#if SHADOW_TARGETS > 4
  gl_FragData[4] = times * shadowCountCrossings(4 * SHADOW_DIGITS, p, q, line, behind);
#endif
#if SHADOW_TARGETS > 5
  gl_FragData[5] = times * shadowCountCrossings(5 * SHADOW_DIGITS, p, q, line, behind);
#endif
#if SHADOW_TARGETS > 6
  gl_FragData[6] = times * shadowCountCrossings(6 * SHADOW_DIGITS, p, q, line, behind);
#endif
#if SHADOW_TARGETS > 7
  gl_FragData[7] = times * shadowCountCrossings(7 * SHADOW_DIGITS, p, q, line, behind);
#endif
#endif
}
