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

float shadowLookUpPairs(
  shadowKernel kernel, float reference, float reach, int texel, int first, int count)
{
  int pair0 = first + (kernel.square ? shadowJitterPairs : 0);
  int at = texel + pair0 * shadowJitterTile * shadowJitterTile;
  float lit = 0.0;
  for (int i = 0; i < count; ++i)
  {
    vec4 pair = texelFetch(shadowJitter, at);
    at += shadowJitterTile * shadowJitterTile;
    lit += shadowLookUp(kernel, reference, reach, pair.xy);
    lit += shadowLookUp(kernel, reference, reach, pair.zw);
  }
  shadowCost += 2.0 * float(count);
  return lit;
}

// `found` as shadowClassify gives it.
float shadowJitteredAverage(shadowKernel kernel, float delta, float found)
{
  float reach = shadowReach(kernel, delta);
  float reference = shadowReference(kernel, shadowExtent(kernel, reach));
  ivec2 place = SHADOW_PIXEL & (shadowJitterTile - 1); // a power of two
  int texel = place.x + shadowJitterTile * place.y;
  int pairs = (shadowCount(kernel, shadowExtent(kernel, reach), 2 * shadowJitterPairs) + 1) / 2;
#ifdef SHADOW_BRANCHING
  int estimate = min(pairs, shadowEstimatePairs);
#else
  int estimate = shadowJitterPairs;
#endif
  float lit =
    shadowLookUpPairs(kernel, reference, reach, texel, 0, found < 0.0 ? estimate : 0);
  // The horizon is a light's edge that the ring may miss; where it cuts, the estimate is not enough.
  float most = 2.0 * float(estimate);
  bool agree = (lit == 0.0 || lit == most) && !kernel.horizonCuts;
  bool all = found < 0.0 && !agree;
  // All or the ring alone: rings have to be whole.
  all = all && pairs > estimate;
  lit += shadowLookUpPairs(kernel, reference, reach, texel, estimate,
    all ? shadowJitterPairs - estimate : 0);
  return found < 0.0 ? lit / (all ? 2.0 * float(shadowJitterPairs) : most) : found;
}
