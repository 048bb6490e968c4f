// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
#extension GL_ARB_shader_bit_encoding : require

// Sums over the tiles at hand: each texel is a square of constant depth, and counts by its area
// within the kernel (section 4.1). Columns of the kernel are boxes, moved by its shear at the
// middle of what is left of the column (section 4.2).

//VTK::Output::Dec

//SHADOW::Declarations

uniform sampler2DArray shadowReceivers;
uniform sampler2DArray shadowKernels;
uniform sampler2DArray shadowTiles;
uniform int shadowBatch; // of the tiles that are at hand
uniform int shadowLight;

// Texels along a side of a kernel, before some are left out.
const float shadowMostTaps = SHADOW_MOST_TAPS;

// Of the light above the receiver's horizon: hidden, and all; of all; looks at texels.
vec4 shadowSums = vec4(0.0);

void shadowAddTile(vec4 rectangleLC, vec4 where, int layer, shadowPlace place, vec3 kernel,
  float cut, float cutDelta)
{
  // All in texels of the tile from here on.
  vec2 size = where.zw;
  vec2 texelLC = (rectangleLC.zw - rectangleLC.xy) / size;
  vec2 centre = (place.placeLC.xy - rectangleLC.xy) / texelLC;
  vec2 extent = kernel.xz / texelLC;
  float shear = kernel.y / kernel.x * texelLC.x / texelLC.y;
  float first = max(centre.x - extent.x, 0.0);
  float end = min(centre.x + extent.x, size.x);
  vec2 stride = max(ceil(2.0 * extent / shadowMostTaps), 1.0);
  // A texel's middle is on the receiver's plane; half a texel is for folds of the surface.
  float bias = 0.5 * dot(abs(place.slopeLC), texelLC);
  float area = texelLC.x * texelLC.y;
  for (float x = floor(first / stride.x) * stride.x; x < end; x += stride.x)
  {
    vec2 column = vec2(max(first, x), min(end, x + stride.x));
    float middle = centre.y + shear * (0.5 * (column.x + column.y) - centre.x);
    float low = max(middle - extent.y, 0.0);
    float high = min(middle + extent.y, size.y);
    float width = area * (column.y - column.x);
    float texelX = min(x + floor(0.5 * stride.x), size.x - 1.0);
    for (float y = floor(low / stride.y) * stride.y; y < high; y += stride.y)
    {
      float weight = width * (min(high, y + stride.y) - max(low, y));
      vec2 texel = vec2(texelX, min(y + floor(0.5 * stride.y), size.y - 1.0));
      float depth = texelFetch(shadowTiles, ivec3(where.xy + texel, layer), 0).r;
      vec2 offset = (texel + 0.5 - centre) * texelLC;
      float reference = place.placeLC.z + min(dot(place.slopeLC, offset), 0.0) - bias -
        place.wobble * (abs(offset.x) + abs(offset.y));
      bool above = place.centre * cutDelta + cut * dot(place.planeLC, offset) >= 0.0;
      shadowSums += vec4(above && depth < min(reference, 1.0) ? weight : 0.0, above ? weight : 0.0,
        weight, 1.0);
    }
  }
}

void main()
{
  vec4 kernel = texelFetch(shadowKernels, ivec3(gl_FragCoord.xy, 0), 0);
  if (kernel.w > 0.5)
  {
    vec4 receiverVC = shadowFetchReceiver(shadowReceivers, ivec2(gl_FragCoord.xy));
    shadowReceiver receiver = shadowUnpackReceiver(receiverVC.w);
    shadowPropRounding = receiver.rounding;
    shadowSelf = receiverVC.w > 0.0;
    int view = shadowGetView(kernel.w);
    shadowPlace place;
    shadowFindPlace(view, receiverVC.xyz, receiver.normalVC, place);
    // Where the horizon cuts the light, what lies below it is hidden already.
    float cut = 0.0;
    float cutDelta = 0.0;
    vec2 rises = vec2(dot(place.planeLC, place.axisULC), dot(place.planeLC, place.axisVLC));
    if (shadowSelf && place.centre < abs(rises.x) + abs(rises.y))
    {
      // The kernel is the light's, widened by the pixel: as a share of it.
      float wide = kernel.x * kernel.x + kernel.y * kernel.y + kernel.z * kernel.z;
      float light = max(place.variance.x + place.variance.z, 1e-30);
      cut = 1.0;
      cutDelta = sqrt(wide / light);
    }
    vec2 half2 = vec2(kernel.x, kernel.z + abs(kernel.y));
    vec2 low = place.placeLC.xy - half2;
    vec2 high = place.placeLC.xy + half2;
#ifdef SHADOW_PAGES
    ivec2 level = shadowGetLevel(kernel.w);
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
            vec4(0.0, 0.0, SHADOW_PAGE_SIDE, SHADOW_PAGE_SIDE), int(layer), place, kernel.xyz, cut,
            cutDelta);
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
        shadowAddTile(rectangleLC, texelFetch(shadowNodes, 3 * node + 2), int(kind.z), place,
          kernel.xyz, cut, cutDelta);
      }
      node = apart || kind.y > 0.5 ? int(kind.x) : node + 1;
    }
#endif
  }
  gl_FragData[0] = shadowSums;
}
