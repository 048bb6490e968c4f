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

// Half axes of the kernel over the map, a parallelogram that its code tells more of.
layout(location = 0) out vec4 shadowKernel;
// With SHADOW_PAGES: numbers of the pages that the kernel covers along x, along y, first + 4096
// last; the code (vtkVirtualTilesFS.glsl), 0 where all is lit; the smaller texel that is asked for.
// Else: cells that it covers, first + last cells^2; texel that is asked for along x; the code; texel
// along y.
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
mat2 shadowFindFootprint(int view, vec3 positionVC, vec3 normalVC, shadowSight sight)
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
    footprint[i] = (stepLC.xy - sight.receiverLC.xy * stepLC.z) / sight.w;
  }
  return footprint;
}

// Mean difference of depth to the blockers. What is hardly above the receiver's own plane, by the
// size of a cell, may be the receiver itself: it counts where there is nothing else. Cells beyond the light's
// plane do not count.
float shadowFindMean(int view, shadowSight sight, vec3 ahead, vec2 footprint, vec2 extent)
{
  float side = float(shadowPyramidResolution);
  vec2 low = clamp(sight.receiverLC.xy - extent, 0.0, 1.0) * side;
  vec2 high = clamp(sight.receiverLC.xy + extent, 0.0, 1.0) * side;
  // Cells of a level on which some hold the box.
  float width = max(high.x - low.x, high.y - low.y);
  int level = max(0, int(ceil(log2(max(width / SHADOW_MEAN_TAPS, 1.0)))));
  float cell = exp2(float(level));
  low /= cell;
  high /= cell;
  vec2 cellLC = vec2(cell / side);
  vec2 unit = shadowExtent(sight, 1.0);
  float unclear = dot(abs(sight.slopeLC), 0.5 * (cellLC + 1.0 / side)) + 1e-6;
  int layer = int(SHADOW_VIEW(view, 6).x);
  float sum = 0.0;
  float count = 0.0;
  for (float y = floor(low.y); y < high.y; y += 1.0)
  {
    for (float x = floor(low.x); x < high.x; x += 1.0)
    {
      vec2 first = max(vec2(x, y), low);
      vec2 end = min(vec2(x, y) + 1.0, high);
      vec2 depths = shadowFetchSides(ivec2(x, y), layer, level);
      vec2 offset = 0.5 * (first + end) * cellLC - sight.receiverLC.xy;
      float reference =
        sight.receiverLC.z + sight.steeper * min(dot(sight.slopeLC, offset), 0.0);
      float above = reference - depths.x;
      // The middle between the two sides of a body, where both are in front.
      bool both = depths.y < min(reference - unclear, 1.0);
      float middle = both ? 0.5 * (depths.x + depths.y) : depths.x;
      float nearer = sight.receiverLC.z - middle;
      // Behind the far plane all casters are in front.
      bool blocks = depths.x < min(reference, 1.0) &&
        ahead.x + dot(ahead.yz, offset) + 0.5 * dot(abs(ahead.yz), cellLC) >= 0.0 &&
        all(lessThanEqual(abs(offset) - 0.5 * cellLC, nearer * unit + footprint));
      float sure = clamp(above / unclear, 1e-3, 1.0);
      float weight = blocks ? sure * (end.x - first.x) * (end.y - first.y) : 0.0;
      count += weight;
      sum += weight * nearer;
    }
  }
  return count > 0.0 ? sum / count : 0.0;
}

// Lower triangle of the summed variances of two boxes: L11, L21, L22 (section 4.2). Half axes
// throughout; variances of boxes add exactly.
vec3 shadowDecompose(mat2 a, mat2 b)
{
  vec4 x = vec4(a[0].x, a[1].x, b[0].x, b[1].x);
  vec4 y = vec4(a[0].y, a[1].y, b[0].y, b[1].y);
  float l11 = sqrt(max(dot(x, x), 1e-30));
  float l21 = dot(x, y) / l11;
  return vec3(l11, l21, sqrt(max(dot(y, y) - l21 * l21, 1e-30)));
}

// A box's half axes where what has the variance L is a unit square, turned anyhow.
mat2 shadowWhiten(mat2 box, vec3 l)
{
  vec2 x = vec2(box[0].x, box[1].x) / l.x;
  vec2 y = (vec2(box[0].y, box[1].y) - l.y * x) / l.z;
  return mat2(x.x, y.x, x.y, y.y);
}

// How it is turned, by four times the angle, since a square is the same after a quarter of a turn; the
// longer, the larger it is.
vec2 shadowFindTurn(mat2 box)
{
  vec2 v = box[0].x * box[1].y < box[0].y * box[1].x ? -box[1] : box[1];
  vec2 turn = vec2(box[0].x + v.y, box[0].y - v.x);
  turn = vec2(turn.x * turn.x - turn.y * turn.y, 2.0 * turn.x * turn.y);
  return vec2(turn.x * turn.x - turn.y * turn.y, 2.0 * turn.x * turn.y);
}

// The convolution of two boxes whose variances' sum is L: along each half axis of a parallelogram a
// trapezoid, whose even part is a share of it. It is exact where both have the same directions, or one is
// small beside the other; else L, turned as they are, has at least their variance. The paper takes a box
// of this variance, with two sides along an axis, of all.
mat2 shadowConvolve(mat2 a, mat2 b, vec3 l, out vec2 even)
{
  a = shadowWhiten(a, l);
  b = shadowWhiten(b, l);
  vec2 turn = shadowFindTurn(a) + shadowFindTurn(b);
  float angle = dot(turn, turn) > 1e-12 ? 0.25 * atan(turn.y, turn.x) : 0.0;
  vec2 along = vec2(cos(angle), sin(angle));
  mat2 result;
  for (int i = 0; i < 2; ++i)
  {
    float ofA = length(along * a);
    float ofB = length(along * b);
    float wide = max(ofA + ofB, 1e-6);
    even[i] = abs(ofA - ofB) / wide;
    result[i] = wide * vec2(l.x * along.x, l.y * along.x + l.z * along.y);
    along = vec2(-along.y, along.x);
  }
  return result;
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
  shadowSight sight;
  int view = 0;
  while (view < shadowViewCount &&
    !shadowFindSight(shadowLight, view, receiverVC.xyz, receiver.normalVC, sight))
  {
    ++view;
  }
  if (view == shadowViewCount)
  {
    return;
  }
  float layer = SHADOW_VIEW(view, 6).x;
  mat2 axes = shadowFindFootprint(view, receiverVC.xyz, receiver.normalVC, sight);
  vec2 footprint = abs(axes[0]) + abs(axes[1]);

  // The nearest that a blocker can be; then what may hide the light from there.
  float delta = sight.receiverLC.z;
  vec2 extent = vec2(0.0);
  for (int i = 0; i < 2; ++i)
  {
    extent = shadowExtent(sight, delta) + footprint;
    vec2 low = sight.receiverLC.xy - extent;
    vec2 high = sight.receiverLC.xy + extent;
    float nearest =
      min(shadowDepthRange(layer, low, high).x, shadowDepthRange(layer + 1.0, low, high).x);
    delta = clamp(sight.receiverLC.z - nearest, 0.0, delta);
    if (nearest >= min(sight.receiverLC.z, 1.0))
    {
      return; // conservative: no blocker at all
    }
  }
  extent = shadowExtent(sight, delta) + footprint;
  delta = shadowFindMean(
    view, sight, shadowFindAhead(shadowLight, view, receiverVC.xyz), footprint, extent);

  float shape = sqrt(SHADOW_VIEW(view, 6).y);
  mat2 soft = delta * shape * mat2(sight.axisULC, sight.axisVLC);
  vec3 filtered = shadowDecompose(soft, axes);
  // Their sizes in pixels, along the map's axes (equation 4).
  float area = max(abs(axes[0].x * axes[1].y - axes[1].x * axes[0].y), 1e-30);
  vec2 pixels = filtered.xz *
    vec2(length(vec2(axes[0].y, axes[1].y)), length(vec2(axes[0].x, axes[1].x))) / area;
  vec2 texel = 2.0 * filtered.xz / vec2(shadowTexels(pixels.x), shadowTexels(pixels.y));
  // What the light grazes is hardly lit: its pixels are at most so narrow over the map.
  float w = abs(dot(shadowWRow, vec4(receiverVC.xyz, 1.0)));
  float facing = 0.5 * w * min(length(shadowPixelVC[0]), length(shadowPixelVC[1])) / sight.w;
  texel = shadowTexel * max(texel, facing / SHADOW_VIEW(view, 8).yz);
#ifndef SHADOW_ANTIALIAS
  // A box of no size has no weight, nor has what a place in the map is rounded to.
  vec2 least = max(1e-3, 4e-7 * SHADOW_PAGE_SIDE) * texel;
  axes = mat2(least.x, 0.0, 0.0, least.y);
  filtered = shadowDecompose(soft, axes);
#endif
  vec2 even;
  mat2 kernel = shadowConvolve(soft, axes, filtered, even);
  vec2 reach = abs(kernel[0]) + abs(kernel[1]);
  vec2 low = sight.receiverLC.xy - reach;
  vec2 high = sight.receiverLC.xy + reach;
  if (any(lessThan(high, vec2(0.0))) || any(greaterThan(low, vec2(1.0))))
  {
    return; // beside the map
  }
  float code = float(view + 1) + shadowPackEven(even);
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
  shadowRequest = vec4(
    dot(low, rows) + SHADOW_CELLS * SHADOW_CELLS * dot(high, rows), texel.x, code, texel.y);
#endif
  shadowKernel = vec4(kernel[0], kernel[1]);
}
