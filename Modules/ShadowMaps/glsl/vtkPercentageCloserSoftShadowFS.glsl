// SPDX-License-Identifier: BSD-3-Clause
// map-pcss: see vtkPercentageCloserSoftShadowPass.

float shadowFilter(int view, shadowKernel kernel)
{
  shadowLayers layers;
  float found = shadowFindBlockers(view, kernel, layers);
  vec2 extent = shadowExtent(kernel, max(layers.reach, layers.farReach));
  return shadowAverage(kernel, layers, found, shadowCount(kernel, extent, shadowPatternCount));
}
