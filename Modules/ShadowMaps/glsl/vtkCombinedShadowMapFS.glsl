// SPDX-License-Identifier: BSD-3-Clause
// map-combined: see vtkCombinedShadowMapPass.

float shadowFilter(int view, shadowKernel kernel)
{
  shadowLayers layers;
  float found = shadowFindBlockers(view, kernel, layers);
  return shadowJitteredAverage(kernel, layers, found);
}
