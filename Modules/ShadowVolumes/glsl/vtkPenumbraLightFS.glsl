// SPDX-License-Identifier: BSD-3-Clause
// What a receiver sees of an edge before a light, or a part of its area. Of a point v, the receiver
// at 0:
//
//   W  how far towards the light's plane v lies, 0 at the receiver, 1 in the plane
//   X, Y  W times where the light's plane is met behind v, in half axes from the light's centre
//
// so that (X, Y) / W is the point's image on the light, and inside the light |X|, |Y| <= W, or X^2
// + Y^2 <= W^2. All three are linear in v: rows of a matrix. A sphere is its disk that faces the
// receiver. SHADOW_WEDGE_SHAPE is 0 for a rectangle, 1 for a disk, 2 for a sphere, 3 for
// directions.

#ifndef GL_ARB_gpu_shader5
#define precise
#endif

uniform vec4 shadowAreaPlaceVC; // centre, w 1; or direction to it, w 0
uniform vec3 shadowAreaUVC;     // half axes over their squared lengths
uniform vec3 shadowAreaVVC;
uniform vec3 shadowAreaNormalVC;
uniform vec4 shadowHalfPixel;    // how large, as a linear function of places in VC
uniform mat4 shadowVCToSWC;

// What a receiver sees the light as.
struct shadowAreaSeen
{
  mat3 rows; // as columns, to be multiplied from the left
  vec3 towardsVC; // the light's centre, and half axes
  vec3 uVC;
  vec3 vVC;
};

shadowAreaSeen shadowSeeArea(vec3 positionVC)
{
  shadowAreaSeen area;
  area.towardsVC = shadowAreaPlaceVC.xyz - shadowAreaPlaceVC.w * positionVC;
#if SHADOW_WEDGE_SHAPE == 2
  float distance = max(length(area.towardsVC), 1e-30);
  vec3 axisVC = area.towardsVC / distance;
  vec3 leastVC = abs(axisVC.x) <= min(abs(axisVC.y), abs(axisVC.z)) ? vec3(1.0, 0.0, 0.0)
    : (abs(axisVC.y) <= abs(axisVC.z) ? vec3(0.0, 1.0, 0.0) : vec3(0.0, 0.0, 1.0));
  vec3 acrossVC = normalize(cross(axisVC, leastVC));
  vec3 upVC = cross(axisVC, acrossVC);
  float perRadius = length(shadowAreaUVC);
  area.uVC = acrossVC / perRadius;
  area.vVC = upVC / perRadius;
  area.rows = mat3(perRadius * acrossVC, perRadius * upVC, axisVC / distance);
#else
  area.uVC = shadowAreaUVC / dot(shadowAreaUVC, shadowAreaUVC);
  area.vVC = shadowAreaVVC / dot(shadowAreaVVC, shadowAreaVVC);
#if SHADOW_WEDGE_SHAPE == 3
  area.rows = mat3(shadowAreaUVC, shadowAreaVVC, area.towardsVC);
#else
  float height = dot(area.towardsVC, shadowAreaNormalVC);
  // In the light's plane all of it is seen edge-on: any height that is no zero.
  vec3 depthVC = shadowAreaNormalVC / (abs(height) > 1e-30 ? height : 1e-30);
  area.rows = mat3(shadowAreaUVC - dot(area.towardsVC, shadowAreaUVC) * depthVC,
    shadowAreaVVC - dot(area.towardsVC, shadowAreaVVC) * depthVC, depthVC);
#endif
#endif
  return area;
}

// What rounding can make of a receiver's place. What VTK computes its prop with may reach far beyond the
// scene, and is a bound: it counts up to a length at which it does no harm.
float shadowSlack(vec4 receiverVC, float most)
{
  shadowPropRounding = min(shadowUnpackReceiver(receiverVC.w).rounding, max(most, 0.0));
  return 2.0 * shadowRounding(receiverVC.xyz);
}

// Whether the light's centre is hidden by what ends at an edge, as far as that edge tells: both
// what counts and what covers take it from here, so that they change at the same place. Both faces
// at a silhouette's edge lie on the hidden side, and so do all of their points, whatever rounding
// makes of them. On the wrong side visibility is wrong by as much as that is of the penumbra's half
// width: at most a hundredth.
bool shadowIsBehind(vec4 planeSWC, vec4 widthSWC, vec4 receiverVC)
{
  precise vec3 placeSWC = (shadowVCToSWC * vec4(receiverVC.xyz, 1.0)).xyz;
  precise float side = dot(planeSWC.xyz, placeSWC) + planeSWC.w;
  precise float width = dot(widthSWC.xyz, placeSWC) + widthSWC.w;
  precise float slack = shadowSlack(receiverVC, 0.005 * width);
  return side > -slack;
}
