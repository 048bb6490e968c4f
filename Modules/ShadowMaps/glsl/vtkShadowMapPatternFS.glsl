// SPDX-License-Identifier: BSD-3-Clause
// The mean of look-ups in a pattern that is the same for all pixels.

uniform samplerBuffer shadowPattern; // xy: points of the disk, zw: of the square
uniform int shadowPatternCount;

// Of the pattern's first `most` points; `found` as shadowClassify gives it.
float shadowAverage(shadowKernel kernel, shadowLayers layers, float found, int most)
{
  int count = found < 0.0 ? most : 0;
  vec4 sums = vec4(0.0);
  for (int i = 0; i < count; ++i)
  {
    vec4 both = texelFetch(shadowPattern, i);
    shadowTake(kernel, layers, kernel.square ? both.zw : both.xy, sums);
  }
  return found < 0.0 ? shadowGetLit(sums) / float(most) : found;
}
