// SPDX-License-Identifier: BSD-3-Clause
//VTK::System::Dec
#extension GL_ARB_shader_bit_encoding : require
#extension GL_ARB_explicit_attrib_location : require

// Each pixel's filter over the virtual map, and the texels that it needs: Shen, Guennebaud, Yang
// and Feng, Predicted virtual soft shadow maps with high quality filtering, 2011, sections 4.2 and
// 5.1.

//SHADOW::Declarations

uniform sampler2DArray shadowReceivers;
uniform sampler2DArray shadowCoarse; // the maps that the pyramid is of
uniform int shadowLight;
uniform float shadowTexel;    // against what the metric asks for
uniform vec4 shadowEyeVC;     // where lines of sight meet, or the direction towards the viewer
uniform vec4 shadowWRow;      // of VCToClip
uniform vec3 shadowPixelVC[2]; // what moves by a pixel, times w

// Half axes (x, shear), (0, y) of the kernel over the map; its code (vtkVirtualTilesFS.glsl), 0
// where all is lit.
layout(location = 0) out vec4 shadowKernel;
// With SHADOW_PAGES: numbers of the pages that the kernel covers along x, along y, first + 4096
// last; the code; the smaller texel that is asked for. Else: cells that it covers, first + last
// cells^2; the code; texel that is asked for along x and y.
layout(location = 1) out vec4 shadowRequest;

// Of a penumbra of so many pixels, how many texels it takes (section 5.1); a hard edge, which the study
// had not, a texel a pixel.
float shadowTexels(float pixels)
{
#ifdef SHADOW_METRIC_STATIC
  float x = clamp(log2(pixels), 0.0, 7.6);
  return max(0.5477 + x * (1.406 + x * (-0.04687 - x * 0.003944)), 1.0);
#else
  float x = clamp(log2(pixels), 0.0, 10.6);
  return max(0.667 + x * (0.7794 + x * (0.3967 - x * 0.02716)), 1.0);
#endif
}

// Depth of the nearest blocker in a cell, and of the nearest of those that are turned the other
// way.
vec2 shadowFetchSides(ivec2 cell, int layer, int level)
{
  vec2 depths;
  for (int side = 0; side < 2; ++side)
  {
    ivec3 texel = ivec3(cell, layer + side);
    depths[side] = level == 0 ? texelFetch(shadowCoarse, texel, 0).r
      : texelFetch(shadowPyramid, texel, level - 1).r;
  }
  return vec2(min(depths.x, depths.y), max(depths.x, depths.y));
}

// Half a pixel's axes over the map, through the receiver's plane.
mat2 shadowFindFootprint(int view, vec3 positionVC, vec3 normalVC, shadowPlace place)
{
  vec3 rayVC = positionVC * shadowEyeVC.w - shadowEyeVC.xyz;
  float facing = dot(normalVC, rayVC);
  float least = length(rayVC) / 64.0; // at most so long for its width
  facing = facing < 0.0 ? min(facing, -least) : max(facing, least);
  float w = dot(shadowWRow, vec4(positionVC, 1.0));
  mat2 footprint;
  for (int i = 0; i < 2; ++i)
  {
    vec3 stepVC = 0.5 * abs(w) * shadowPixelVC[i];
    stepVC -= rayVC * (dot(normalVC, stepVC) / facing);
    vec3 stepLC = vec3(dot(SHADOW_VIEW(view, 0).xyz, stepVC),
      dot(SHADOW_VIEW(view, 1).xyz, stepVC), dot(SHADOW_VIEW(view, 3).xyz, stepVC));
    footprint[i] = (stepLC.xy - place.placeLC.xy * stepLC.z) / place.w;
  }
  return footprint;
}

// Mean difference of depth to the blockers. What is hardly above the receiver's own plane, by the
// size of a cell, may be the receiver itself: it counts where there is nothing else.
float shadowFindMean(int view, shadowPlace place, bool square, vec2 footprint, vec2 extent)
{
  float side = float(shadowPyramidResolution);
  vec2 low = clamp(place.placeLC.xy - extent, 0.0, 1.0) * side;
  vec2 high = clamp(place.placeLC.xy + extent, 0.0, 1.0) * side;
  // Cells of a level on which some hold the box.
  float width = max(high.x - low.x, high.y - low.y);
  int level = max(0, int(ceil(log2(max(width / SHADOW_MEAN_TAPS, 1.0)))));
  float cell = exp2(float(level));
  low /= cell;
  high /= cell;
  vec2 cellLC = vec2(cell / side);
  vec2 unit = shadowExtent(place, square, 1.0);
  float unclear = dot(abs(place.slopeLC), 0.5 * (cellLC + 1.0 / side)) + 1e-6;
  int layer = int(SHADOW_VIEW(view, 8).z);
  float sum = 0.0;
  float count = 0.0;
  for (float y = floor(low.y); y < high.y; y += 1.0)
  {
    for (float x = floor(low.x); x < high.x; x += 1.0)
    {
      vec2 first = max(vec2(x, y), low);
      vec2 end = min(vec2(x, y) + 1.0, high);
      vec2 depths = shadowFetchSides(ivec2(x, y), layer, level);
      vec2 offset = 0.5 * (first + end) * cellLC - place.placeLC.xy;
      float reference = place.placeLC.z + min(dot(place.slopeLC, offset), 0.0);
      float above = reference - depths.x;
      // The middle between the two sides of a body, where both are in front.
      bool both = depths.y < min(reference - unclear, 1.0);
      float middle = both ? 0.5 * (depths.x + depths.y) : depths.x;
      float nearer = place.placeLC.z - middle;
      // Behind the far plane all casters are in front.
      bool blocks = depths.x < min(reference, 1.0) &&
        all(lessThanEqual(abs(offset) - 0.5 * cellLC, nearer * unit + footprint));
      float sure = clamp(above / unclear, 1e-3, 1.0);
      float weight = blocks ? sure * (end.x - first.x) * (end.y - first.y) : 0.0;
      count += weight;
      sum += weight * nearer;
    }
  }
  return count > 0.0 ? sum / count : 0.0;
}

// Lower triangle of a variance: L11, L21, L22.
vec3 shadowDecompose(vec3 variance)
{
  float l11 = sqrt(max(variance.x, 1e-30));
  float l21 = variance.y / l11;
  return vec3(l11, l21, sqrt(max(variance.z - l21 * l21, 1e-30)));
}

void main()
{
  shadowKernel = vec4(0.0);
  shadowRequest = vec4(0.0);
  vec4 receiverVC = shadowFetchReceiver(shadowReceivers, ivec2(gl_FragCoord.xy));
  if (!shadowIsReceiver(receiverVC))
  {
    return;
  }
  shadowReceiver receiver = shadowUnpackReceiver(receiverVC.w);
  shadowPropRounding = receiver.rounding;
  shadowSelf = receiverVC.w > 0.0;
  if (shadowFacesAway(shadowLight, receiverVC.xyz, receiver.normalVC))
  {
    return;
  }
  shadowPlace place;
  int view = 0;
  while (view < shadowViewCount &&
    !shadowFindPlace(view, receiverVC.xyz, receiver.normalVC, place))
  {
    ++view;
  }
  if (view == shadowViewCount)
  {
    return;
  }
  bool square = shadowLightVVC[shadowLight].w > 0.0;
  float layer = SHADOW_VIEW(view, 8).z;
  mat2 axes = shadowFindFootprint(view, receiverVC.xyz, receiver.normalVC, place);
  vec2 footprint = abs(axes[0]) + abs(axes[1]);

  // The nearest that a blocker can be; then what may hide the light from there.
  float delta = place.placeLC.z;
  vec2 extent = vec2(0.0);
  for (int i = 0; i < 2; ++i)
  {
    extent = shadowExtent(place, square, delta) + footprint;
    vec2 low = place.placeLC.xy - extent;
    vec2 high = place.placeLC.xy + extent;
    float nearest =
      min(shadowDepthRange(layer, low, high).x, shadowDepthRange(layer + 1.0, low, high).x);
    delta = clamp(place.placeLC.z - nearest, 0.0, delta);
    if (nearest >= min(place.placeLC.z, 1.0))
    {
      return; // conservative: no blocker at all
    }
  }
  extent = shadowExtent(place, square, delta) + footprint;
  delta = shadowFindMean(view, place, square, footprint, extent);

  // Half axes throughout. Variances of boxes add exactly.
  vec3 soft = delta * delta * place.variance;
  vec3 pixel = vec3(dot(vec2(axes[0].x, axes[1].x), vec2(axes[0].x, axes[1].x)),
    dot(vec2(axes[0].x, axes[1].x), vec2(axes[0].y, axes[1].y)),
    dot(vec2(axes[0].y, axes[1].y), vec2(axes[0].y, axes[1].y)));
  vec3 filtered = shadowDecompose(soft + pixel);
  // Their sizes in pixels, along the map's axes (equation 4).
  float area = max(abs(axes[0].x * axes[1].y - axes[1].x * axes[0].y), 1e-30);
  vec2 pixels = filtered.xz *
    vec2(length(vec2(axes[0].y, axes[1].y)), length(vec2(axes[0].x, axes[1].x))) / area;
  vec2 texel = 2.0 * filtered.xz / vec2(shadowTexels(pixels.x), shadowTexels(pixels.y));
  // What the light grazes is hardly lit: its pixels are at most so narrow over the map.
  float w = abs(dot(shadowWRow, vec4(receiverVC.xyz, 1.0)));
  float facing = 0.5 * w * min(length(shadowPixelVC[0]), length(shadowPixelVC[1])) / place.w;
  texel = shadowTexel * max(texel, facing / SHADOW_VIEW(view, 6).yz);
#ifndef SHADOW_ANTIALIAS
  filtered = shadowDecompose(soft);
  filtered.xz = max(filtered.xz, 1e-3 * texel); // a box of no size has no weight
#endif
  filtered = clamp(filtered, vec3(-1.0), vec3(1.0));
  vec2 reach = vec2(filtered.x, filtered.z + abs(filtered.y));
  vec2 low = place.placeLC.xy - reach;
  vec2 high = place.placeLC.xy + reach;
  if (any(lessThan(high, vec2(0.0))) || any(greaterThan(low, vec2(1.0))))
  {
    return; // beside the map
  }
  float code = float(view + 1);
#ifdef SHADOW_PAGES
#ifndef SHADOW_METRIC_NONE
  vec2 level = clamp(ceil(-log2(texel * SHADOW_PAGE_SIDE) - 1e-4), vec2(0.0),
    vec2(SHADOW_MOST_HALVINGS));
#else
  vec2 level = vec2(0.0);
#endif
  code += 8.0 * level.x + 256.0 * level.y;
  vec2 pages = exp2(level);
  low = clamp(floor(low * pages), vec2(0.0), pages - 1.0);
  high = clamp(floor(high * pages), vec2(0.0), pages - 1.0);
  shadowRequest = vec4(low + 4096.0 * high, code, min(texel.x, texel.y));
#else
  low = clamp(floor(low * SHADOW_CELLS), 0.0, SHADOW_CELLS - 1.0);
  high = clamp(floor(high * SHADOW_CELLS), 0.0, SHADOW_CELLS - 1.0);
  vec2 rows = vec2(1.0, SHADOW_CELLS);
  shadowRequest =
    vec4(dot(low, rows) + SHADOW_CELLS * SHADOW_CELLS * dot(high, rows), code, texel);
#endif
  shadowKernel = vec4(filtered, code);
}
