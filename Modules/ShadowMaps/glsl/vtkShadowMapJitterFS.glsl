// SPDX-License-Identifier: BSD-3-Clause
// The mean of stratified look-ups that differ from pixel to pixel, of which a few decide whether the
// others are needed: Uralsky, Efficient soft-edged shadows using pixel shader branching, GPU Gems 2,
// 2005, chapter 17; Zapotocky, Soft shadows on GPU, 2007, section 3.4.

// Pairs of points of the disk, then of the square; those of the outer ring first. Each has a texel for
// every pixel of a tile.
uniform samplerBuffer shadowJitter;
const int shadowJitterTile = 16;
uniform int shadowJitterPairs;    // of either
uniform int shadowEstimatePairs;

void shadowTakePairs(
  shadowKernel kernel, shadowLayers layers, int texel, int first, int count, inout vec4 sums)
{
  int pair0 = first + (kernel.square ? shadowJitterPairs : 0);
  int at = texel + pair0 * shadowJitterTile * shadowJitterTile;
  for (int i = 0; i < count; ++i)
  {
    vec4 pair = texelFetch(shadowJitter, at);
    at += shadowJitterTile * shadowJitterTile;
    shadowTake(kernel, layers, pair.xy, sums);
    shadowTake(kernel, layers, pair.zw, sums);
  }
}

// `found` as shadowClassify gives it.
float shadowJitteredAverage(shadowKernel kernel, shadowLayers layers, float found)
{
  ivec2 place = SHADOW_PIXEL & (shadowJitterTile - 1); // a power of two
  int texel = place.x + shadowJitterTile * place.y;
  vec2 extent = shadowExtent(kernel, max(layers.reach, layers.farReach));
  int pairs = (shadowCount(kernel, extent, 2 * shadowJitterPairs) + 1) / 2;
#ifdef SHADOW_BRANCHING
  int estimate = min(pairs, shadowEstimatePairs);
#else
  int estimate = shadowJitterPairs;
#endif
  vec4 sums = vec4(0.0);
  shadowTakePairs(kernel, layers, texel, 0, found < 0.0 ? estimate : 0, sums);
  // The horizon is a light's edge that the ring may miss; where it cuts, the estimate is not enough.
  float most = 2.0 * float(estimate);
  float lit = shadowGetLit(sums);
  bool agree = (lit == 0.0 || lit == most) && !kernel.horizonCuts;
  bool all = found < 0.0 && !agree;
  // All or the ring alone: rings have to be whole.
  all = all && pairs > estimate;
  shadowTakePairs(
    kernel, layers, texel, estimate, all ? shadowJitterPairs - estimate : 0, sums);
  lit = shadowGetLit(sums);
  return found < 0.0 ? lit / (all ? 2.0 * float(shadowJitterPairs) : most) : found;
}
