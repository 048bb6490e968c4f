// SPDX-License-Identifier: BSD-3-Clause
// Visibility from the sums over all tiles: the share of the light above the receiver's horizon, in
// closed form, times what of it no blocker hides, normalised by the sum of weights.

uniform sampler2DArray shadowKernels;
uniform sampler2DArray shadowRequests;
uniform sampler2DArray shadowSums;

// Told to debug views.
float shadowTile = 0.0;       // a number that neighbours do not share
float shadowResolution = 0.0; // texels across the map that are asked for, a logarithm
float shadowKernelSize = 0.0; // share of the map
float shadowLitMask = 0.0;    // 1 where no map was looked up
float shadowReused = 0.0;     // 1 where a tile was kept from before

float shadowSquare(float x)
{
  return x > 0.0 ? x * x : 0.0;
}

// Share of a light whose point (s, t) is c + s a + t b above a plane.
float shadowAbove(float c, float a, float b, bool square)
{
  a = abs(a);
  b = abs(b);
  if (square)
  {
    if (c >= a + b)
    {
      return 1.0;
    }
    // Along an axis that hardly rises the plane cuts all alike.
    float least = 1e-3 * max(a, b);
    a = max(max(a, least), 1e-30);
    b = max(max(b, least), 1e-30);
    return clamp((shadowSquare(c + a + b) - shadowSquare(c + a - b) - shadowSquare(c - a + b) +
      shadowSquare(c - a - b)) / (8.0 * a * b), 0.0, 1.0);
  }
  float height = c / max(length(vec2(a, b)), 1e-30);
  if (abs(height) >= 1.0)
  {
    return height > 0.0 ? 1.0 : 0.0;
  }
  return (acos(-height) + height * sqrt(1.0 - height * height)) / 3.14159265358979;
}

SHADOW_VISIBILITY shadowVisibility(int light, vec3 positionVC, vec3 normalVC)
{
  ivec3 pixel = ivec3(SHADOW_PIXEL, 0);
  vec4 request = texelFetch(shadowRequests, pixel, 0);
  vec4 kernel = texelFetch(shadowKernels, pixel, 0);
  vec4 sums = request.z > 0.5 ? texelFetch(shadowSums, pixel, 0) : vec4(0.0);
  float above = 1.0;
  vec4 placeVC = shadowLightPlaceVC[light];
  if (shadowSelf && dot(normalVC, normalVC) > 0.0)
  {
    float radius = shadowLightUVC[light].w;
    float c = dot(normalVC, placeVC.xyz - placeVC.w * positionVC);
#ifdef SHADOW_HARD
    above = c >= 0.0 ? 1.0 : 0.0;
#else
    above = radius > 0.0 ? shadowAbove(c, radius, 0.0, false)
      : shadowAbove(c, dot(normalVC, shadowLightUVC[light].xyz),
        dot(normalVC, shadowLightVVC[light].xyz), shadowLightVVC[light].w > 0.0);
#endif
  }
  shadowCost = sums.w;
  float visibility = above;
  if (sums.z > 0.0)
  {
    // What of the kernel lies beside the map is lit, but where the map is cut: there it is drawn
    // in.
    int view = shadowGetView(request.z);
    shadowSight sight;
    shadowFindSight(light, view, positionVC, normalVC, sight);
    vec4 bounds = SHADOW_VIEW(view, 11);
    vec2 centre = sight.receiverLC.xy;
    vec2 reach = abs(kernel.xy) + abs(kernel.zw);
    bool cut = any(lessThan(centre - reach, bounds.xy)) ||
      any(greaterThan(centre + reach, bounds.zw));
    // Of the kernel's sides, what lies beside the map where it is not cut.
    vec2 over = (max(reach - centre, 0.0) * vec2(lessThan(bounds.xy, vec2(0.0))) +
      max(centre + reach - 1.0, 0.0) * vec2(greaterThan(bounds.zw, vec2(1.0)))) / (2.0 * reach);
    vec2 within = max(1.0 - over, 1e-3);
    vec3 ahead = shadowFindAhead(light, view, positionVC);
    float share =
      shadowAbove(ahead.x, dot(ahead.yz, kernel.xy), dot(ahead.yz, kernel.zw), true);
    float beside = cut ? sums.z * (1.0 / (within.x * within.y) - 1.0)
      : 4.0 * share * abs(kernel.x * kernel.w - kernel.y * kernel.z) - sums.z;
    bool crosses = any(lessThan(centre, reach)) || any(greaterThan(centre + reach, vec2(1.0)));
    beside = crosses ? max(beside, 0.0) : 0.0;
    float all = sums.y + beside;
    visibility *= all > 0.0 ? clamp(1.0 - sums.x / all, 0.0, 1.0) : 1.0;
  }
#ifdef SHADOW_QUANTITY
  shadowLitMask = request.z > 0.5 ? 0.0 : 1.0;
  if (request.z > 0.5)
  {
    int view = shadowGetView(request.z);
    vec2 reach = abs(kernel.xy) + abs(kernel.zw);
    shadowKernelSize = max(reach.x, reach.y);
    shadowResolution = -log2(max(request.w, 1e-30));
    shadowSight sight;
    shadowFindSight(light, view, positionVC, normalVC, sight);
    vec2 told = shadowTellTile(request.z, sight.receiverLC.xy);
    shadowTile = told.x;
    shadowReused = told.y;
  }
#endif
  return SHADOW_VISIBILITY(visibility);
}
