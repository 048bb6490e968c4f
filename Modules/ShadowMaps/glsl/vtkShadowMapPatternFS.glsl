// SPDX-License-Identifier: BSD-3-Clause
// The mean of look-ups in a pattern that is the same for all pixels.

uniform samplerBuffer shadowPattern; // xy: points of the disk, zw: of the square
uniform int shadowPatternCount;

// Of the pattern's first `most` points; `found` as shadowClassify gives it.
float shadowAverage(shadowKernel kernel, float delta, float found, int most)
{
  float reach = shadowReach(kernel, delta);
  float reference = shadowReference(kernel, shadowExtent(kernel, reach));
  int count = found < 0.0 ? most : 0;
  float lit = 0.0;
  for (int i = 0; i < count; ++i)
  {
    vec4 both = texelFetch(shadowPattern, i);
    lit += shadowLookUp(kernel, reference, reach, kernel.square ? both.zw : both.xy);
  }
  shadowCost += float(count);
  return found < 0.0 ? lit / float(most) : found;
}
