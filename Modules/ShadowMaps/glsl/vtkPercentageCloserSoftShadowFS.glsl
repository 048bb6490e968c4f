// SPDX-License-Identifier: BSD-3-Clause
// map-pcss: see vtkPercentageCloserSoftShadowPass.

float shadowFilter(int view, shadowKernel kernel)
{
  float delta;
  float found = shadowFindBlockers(view, kernel, delta);
  vec2 extent = shadowExtent(kernel, shadowReach(kernel, delta));
  return shadowAverage(kernel, delta, found, shadowCount(kernel, extent, shadowPatternCount));
}
