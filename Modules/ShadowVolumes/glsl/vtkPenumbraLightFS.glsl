// SPDX-License-Identifier: BSD-3-Clause
// What a receiver sees of an edge before a light, or a part of its area. Of a point v, the receiver at 0:
//
//   W  how far towards the light's plane v lies, 0 at the receiver, 1 in the plane
//   X, Y  W times where the light's plane is met behind v, in half axes from the light's centre
//
// so that (X, Y) / W is the point's image on the light, and inside the light |X|, |Y| <= W, or
// X^2 + Y^2 <= W^2. All three are linear in v: rows of a matrix. A sphere is its disk that faces the
// receiver. SHADOW_WEDGE_SHAPE is 0 for a rectangle, 1 for a disk, 2 for a sphere, 3 for directions.

#ifndef GL_ARB_gpu_shader5
#define precise
#endif

uniform vec4 shadowAreaPlaceVC; // centre, w 1; or direction to it, w 0
uniform vec3 shadowAreaUVC;     // half axes over their squared lengths
uniform vec3 shadowAreaVVC;
uniform vec3 shadowAreaNormalVC;
uniform mat4 shadowVCToSWC;

// The rows as columns, to be multiplied from the left.
mat3 shadowLightRows(vec3 positionVC)
{
#if SHADOW_WEDGE_SHAPE == 3
  return mat3(shadowAreaUVC, shadowAreaVVC, shadowAreaPlaceVC.xyz);
#else
  vec3 towardsVC = shadowAreaPlaceVC.xyz - positionVC;
#if SHADOW_WEDGE_SHAPE == 2
  float distance = length(towardsVC);
  vec3 axisVC = towardsVC / max(distance, 1e-30);
  vec3 leastVC = abs(axisVC.x) <= min(abs(axisVC.y), abs(axisVC.z)) ? vec3(1.0, 0.0, 0.0)
    : (abs(axisVC.y) <= abs(axisVC.z) ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, 1.0));
  vec3 acrossVC = normalize(cross(axisVC, leastVC));
  float perRadius = length(shadowAreaUVC);
  return mat3(perRadius * acrossVC, perRadius * cross(axisVC, acrossVC),
    axisVC / max(distance, 1e-30));
#else
  float height = dot(towardsVC, shadowAreaNormalVC);
  // In the light's plane all of it is seen edge-on: any height that is no zero.
  height = abs(height) > 1e-30 ? height : 1e-30;
  vec3 depthVC = shadowAreaNormalVC / height;
  return mat3(shadowAreaUVC - dot(towardsVC, shadowAreaUVC) * depthVC,
    shadowAreaVVC - dot(towardsVC, shadowAreaVVC) * depthVC, depthVC);
#endif
#endif
}

// Whether the light's centre is hidden by what ends at an edge, as far as that edge tells: both what counts
// and what covers take it from here, so that they change at the same place.
bool shadowIsBehind(vec4 planeSWC, vec3 positionVC)
{
  precise vec3 positionSWC = (shadowVCToSWC * vec4(positionVC, 1.0)).xyz;
  precise float side = dot(planeSWC.xyz, positionSWC) + planeSWC.w;
  return side > 0.0;
}
