// SPDX-License-Identifier: BSD-3-Clause
// map-combined: see vtkCombinedShadowMapPass.

float shadowFilter(int view, shadowKernel kernel)
{
  float delta;
  float found = shadowFindBlockers(view, kernel, delta);
  return shadowJitteredAverage(kernel, delta, found);
}
