// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
#extension GL_ARB_shader_bit_encoding : require

// Sums over the tiles at hand: each texel is a square of constant depth, and counts by its area
// within the kernel (section 4.1). The kernel is a parallelogram; what is left of a column between
// its corners is a box as high as it is in the middle (section 4.2), so that areas are exact. Where
// the kernel is no box, what is left of a texel counts as its middle does.

//VTK::Output::Dec

//SHADOW::Declarations

uniform sampler2DArray shadowReceivers;
uniform sampler2DArray shadowKernels;
uniform sampler2DArray shadowRequests;
uniform sampler2DArray shadowTiles;
uniform int shadowBatch; // of the tiles that are at hand
uniform int shadowLight;

// Texels along a side of a kernel, before some are left out.
const float shadowMostTaps = SHADOW_MOST_TAPS;

// Ahead of the light's plane: what is above the receiver's horizon and hidden, what is above, and all; looks at
// texels.
vec4 shadowSums = vec4(0.0);

// Of a parallelogram's side, what bounds the height at a place: half of it, and how it rises.
vec2 shadowFindSide(vec2 side, float area, float least)
{
  float across = side.x < 0.0 ? min(side.x, -least) : max(side.x, least);
  return vec2(area / abs(across), side.y / across);
}

// Weight at a place of a kernel, along its half axes: trapezoids of mean 1. Never quite nothing: a kernel
// may be as small as what places are rounded to.
float shadowFindWeight(vec2 place, vec2 even)
{
  vec2 weight = 2.0 / (1.0 + even) * clamp((1.0 - abs(place)) / (1.0 - even), 1e-3, 1.0);
  weight = mix(weight, vec2(1.0), greaterThanEqual(even, vec2(1.0)));
  return weight.x * weight.y;
}

void shadowAddTile(vec4 rectangleLC, vec4 where, int layer, shadowSight sight, vec3 ahead, vec4 kernel,
  vec2 even, float cut, float cutDelta)
{
  // All in texels of the tile from here on.
  vec2 size = where.zw;
  vec2 texelLC = (rectangleLC.zw - rectangleLC.xy) / size;
  vec2 centre = (sight.receiverLC.xy - rectangleLC.xy) / texelLC;
  vec2 u = kernel.xy / texelLC;
  vec2 v = kernel.zw / texelLC;
  vec2 extent = abs(u) + abs(v);
  float first = max(centre.x - extent.x, 0.0);
  float end = min(centre.x + extent.x, size.x);
  vec2 corners = centre.x + abs(abs(u.x) - abs(v.x)) * vec2(-1.0, 1.0);
  float least = 1e-4 * extent.x;
  float turned = u.x * v.y - u.y * v.x;
  float whole = max(abs(turned), 1e-30);
  turned = turned < 0.0 ? -whole : whole;
  bool isBox = even.x >= 1.0 && even.y >= 1.0;
  vec2 sideU = shadowFindSide(u, whole, least);
  vec2 sideV = shadowFindSide(v, whole, least);
  // Of what the map has of it.
  vec2 within =
    min(sight.receiverLC.xy / texelLC, extent) + min((1.0 - sight.receiverLC.xy) / texelLC, extent);
  vec2 stride = max(ceil(within / shadowMostTaps), 1.0);
  // A texel's middle is on the receiver's plane; half a texel is for folds of the surface.
  float bias = 0.5 * dot(abs(sight.slopeLC), texelLC);
  float area = texelLC.x * texelLC.y;
  float x = floor(first / stride.x) * stride.x;
  float from = first;
  while (from < end)
  {
    float next = x + stride.x;
    float to = max(min(next, end), from);
    to = corners.x > from ? min(to, corners.x) : to;
    to = corners.y > from ? min(to, corners.y) : to;
    float along = 0.5 * (from + to) - centre.x;
    float low = max(centre.y +
      max(sideU.y * along - sideU.x, sideV.y * along - sideV.x), 0.0);
    float high = min(centre.y +
      min(sideU.y * along + sideU.x, sideV.y * along + sideV.x), size.y);
    float width = area * (to - from);
    float texelX = min(x + floor(0.5 * stride.x), size.x - 1.0);
    for (float y = floor(low / stride.y) * stride.y; y < high; y += stride.y)
    {
      float bottom = max(low, y);
      float top = min(high, y + stride.y);
      float weight = width * (top - bottom);
      if (!isBox)
      {
        float across = 0.5 * (bottom + top) - centre.y;
        weight *= shadowFindWeight(
          vec2(along * v.y - across * v.x, across * u.x - along * u.y) / turned, even);
      }
      vec2 texel = vec2(texelX, min(y + floor(0.5 * stride.y), size.y - 1.0));
      float depth = texelFetch(shadowTiles, ivec3(where.xy + texel, layer), 0).r;
      vec2 offset = (texel + 0.5 - centre) * texelLC;
      float reference = sight.receiverLC.z - bias + sight.steeper *
        (min(dot(sight.slopeLC, offset), 0.0) - sight.wobble * (abs(offset.x) + abs(offset.y)));
      weight *= ahead.x + dot(ahead.yz, offset) >= 0.0 ? 1.0 : 0.0;
      bool above = sight.centre * cutDelta + cut * dot(sight.planeLC, offset) >= 0.0;
      shadowSums += vec4(above && depth < min(reference, 1.0) ? weight : 0.0, above ? weight : 0.0,
        weight, 1.0);
    }
    x = to < next ? x : next; // rises, however the quotient was rounded
    from = to;
  }
}

void main()
{
  float code = texelFetch(shadowRequests, ivec3(gl_FragCoord.xy, 0), 0).z;
  if (code > 0.5)
  {
    vec4 kernel = texelFetch(shadowKernels, ivec3(gl_FragCoord.xy, 0), 0);
    vec4 receiverVC = shadowFetchReceiver(shadowReceivers, ivec2(gl_FragCoord.xy));
    shadowReceiver receiver = shadowUnpackReceiver(receiverVC.w);
    shadowPropRounding = receiver.rounding;
    shadowSelf = receiverVC.w > 0.0;
    int view = shadowGetView(code);
    vec2 even = shadowGetEven(code);
    shadowSight sight;
    shadowFindSight(shadowLight, view, receiverVC.xyz, receiver.normalVC, sight);
    vec3 ahead = shadowFindAhead(shadowLight, view, receiverVC.xyz);
    // Where the horizon cuts the light, what lies below it is hidden already.
    float cut = 0.0;
    float cutDelta = 0.0;
    vec2 rises = vec2(dot(sight.planeLC, sight.axisULC), dot(sight.planeLC, sight.axisVLC));
    if (shadowSelf && sight.centre < abs(rises.x) + abs(rises.y))
    {
      // The kernel is the light's, widened by the pixel: as a share of it.
      vec2 share = 0.5 + 0.5 * even * even; // variance of trapezoids, against that of boxes
      float wide = dot(share, vec2(dot(kernel.xy, kernel.xy), dot(kernel.zw, kernel.zw)));
      float light = SHADOW_VIEW(view, 6).y *
        (dot(sight.axisULC, sight.axisULC) + dot(sight.axisVLC, sight.axisVLC));
      cut = 1.0;
      cutDelta = sqrt(wide / max(light, 1e-30));
    }
    vec2 reach = abs(kernel.xy) + abs(kernel.zw);
    vec2 low = sight.receiverLC.xy - reach;
    vec2 high = sight.receiverLC.xy + reach;
#ifdef SHADOW_PAGES
    ivec2 level = shadowGetLevel(code);
    vec2 pages = exp2(vec2(level));
    ivec2 first = ivec2(clamp(floor(low * pages), vec2(0.0), pages - 1.0));
    ivec2 end = ivec2(clamp(floor(high * pages), vec2(0.0), pages - 1.0));
    for (int y = first.y; y <= end.y; ++y)
    {
      for (int x = first.x; x <= end.x; ++x)
      {
        float layer = shadowFindPage(view, level, ivec2(x, y)).x;
        if (layer >= 0.0)
        {
          vec2 corner = vec2(x, y);
          shadowAddTile(vec4(corner, corner + 1.0) / pages.xyxy,
            vec4(0.0, 0.0, SHADOW_PAGE_SIDE, SHADOW_PAGE_SIDE), int(layer), sight, ahead, kernel, even,
            cut, cutDelta);
        }
      }
    }
#else
    int node = shadowFirstNode[view];
    int last = shadowFirstNode[view + 1];
    while (node < last)
    {
      vec4 rectangleLC = texelFetch(shadowNodes, 3 * node);
      vec4 kind = texelFetch(shadowNodes, 3 * node + 1);
      bool apart = any(greaterThan(rectangleLC.xy, high)) || any(lessThan(rectangleLC.zw, low));
      if (!apart && kind.y > 1.5 && int(kind.w) == shadowBatch)
      {
        shadowAddTile(rectangleLC, texelFetch(shadowNodes, 3 * node + 2), int(kind.z), sight, ahead,
          kernel, even, cut, cutDelta);
      }
      node = apart || kind.y > 0.5 ? int(kind.x) : node + 1;
    }
#endif
  }
  gl_FragData[0] = shadowSums;
}
