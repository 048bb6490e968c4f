// SPDX-License-Identifier: BSD-3-Clause
// Whether a receiver surely sees all of a light, by vtkShadowDepthBounds: 1, or -1 where that is not sure.
//
// A view is six vectors: the rows of the matrix from VC to the map ([0,1] in x, y and z after division: LC);
// the depth scale (see vtkLightView) and the layer; low x, low y, high x, high y that the map is to be
// asked within, as casters go on beyond. The rays to the point a of the light, seen from its centre, lie
//
//   (row.xy - receiverLC.xy * row.w) . a * (receiver's depth - depth) / (scale * (1 - row.w . a / w))
//
// from the receiver's place in the map where they have come to a depth. What is in their way lies no
// nearer to the light than the least depth in the box that they have come to by then.

uniform samplerBuffer shadowBoundsViews;
uniform int shadowFirstBounds[SHADOW_LIGHTS];
uniform int shadowBoundsCount[SHADOW_LIGHTS]; // -1: nothing is known of casters

// Half sides of the box over the map, a unit of depth, that the light's points span; z: how much nearer
// to the receiver they are than the centre, along the view's axis.
vec3 shadowSpan(int light, vec3 x, vec3 y, vec3 along)
{
  vec4 uVC = shadowLightUVC[light];
  vec4 vVC = shadowLightVVC[light];
  vec3 u = abs(vec3(dot(x, uVC.xyz), dot(y, uVC.xyz), dot(along, uVC.xyz)));
  vec3 v = abs(vec3(dot(x, vVC.xyz), dot(y, vVC.xyz), dot(along, vVC.xyz)));
  return uVC.w > 0.0 ? uVC.w * vec3(length(x), length(y), length(along))
    : (vVC.w > 0.0 ? u + v : sqrt(u * u + v * v));
}

bool shadowIsClear(int light, int view, vec3 positionVC)
{
  vec4 rowX = texelFetch(shadowBoundsViews, 6 * view);
  vec4 rowY = texelFetch(shadowBoundsViews, 6 * view + 1);
  vec4 rowZ = texelFetch(shadowBoundsViews, 6 * view + 2);
  vec4 rowW = texelFetch(shadowBoundsViews, 6 * view + 3);
  vec4 form = texelFetch(shadowBoundsViews, 6 * view + 4);
  vec4 bounds = texelFetch(shadowBoundsViews, 6 * view + 5);
  vec4 receiverVC = vec4(positionVC, 1.0);
  float w = dot(rowW, receiverVC);
  vec3 receiverLC = vec3(dot(rowX, receiverVC), dot(rowY, receiverVC), dot(rowZ, receiverVC)) / w;
  if (!(w > 0.0) || !(abs(receiverLC.x) + abs(receiverLC.y) < 1.0e6))
  {
    return false; // beside the light
  }
  vec3 x = rowX.xyz - receiverLC.x * rowW.xyz;
  vec3 y = rowY.xyz - receiverLC.y * rowW.xyz;
  vec3 span = shadowSpan(light, x, y, rowW.xyz);
  float nearest = 1.0 - span.z / w;
  if (!(nearest > 0.25))
  {
    return false; // it reaches around the receiver
  }
  vec2 axes = span.xy / (nearest * form.x);
  // What the position may be off by: over the map, and in depth.
  float rounding = 2.0 * shadowRounding(positionVC) / w;
  vec2 own = rounding * vec2(length(x), length(y)) + 0.125 / float(shadowPyramidResolution);
  float depth = receiverLC.z + rounding * length(rowZ.xyz - receiverLC.z * rowW.xyz) +
    1.0 / 524288.0;
  float reach = depth;
  for (int i = 0; i < 5; ++i)
  {
    vec2 extent = reach * axes + own;
    vec2 low = receiverLC.xy - extent;
    vec2 high = receiverLC.xy + extent;
    if (any(lessThan(high, vec2(0.0))) || any(greaterThan(low, vec2(1.0))))
    {
      return true; // past all casters
    }
    if (any(lessThan(low, bounds.xy)) || any(greaterThan(high, bounds.zw)))
    {
      return false;
    }
    float least = shadowDepthRange(form.y, low, high).x;
    if (least >= min(depth, 1.0))
    {
      return true;
    }
    if (depth - least > 0.9 * reach)
    {
      return false;
    }
    reach = depth - least;
  }
  return false;
}

SHADOW_VISIBILITY shadowVisibility(int light, vec3 positionVC, vec3 normalVC)
{
  vec4 placeVC = shadowLightPlaceVC[light];
  vec3 towardsVC = placeVC.xyz - placeVC.w * positionVC;
  // Its own surface, which no map need hold, hides no part of the light: more than normals are off by.
  float below = shadowSpan(light, normalVC, normalVC, normalVC).x;
  bool clear = shadowBoundsCount[light] >= 0 &&
    (!shadowSelf || dot(normalVC, towardsVC) - below > (length(towardsVC) + below) / 512.0);
  int end = shadowFirstBounds[light] + shadowBoundsCount[light];
  for (int view = shadowFirstBounds[light]; clear && view < end; ++view)
  {
    clear = shadowIsClear(light, view, positionVC);
  }
  shadowCost = clear ? 0.0 : -1.0;
  return SHADOW_VISIBILITY(clear ? 1.0 : -1.0);
}
