// SPDX-License-Identifier: BSD-3-Clause
// map-jitter: see vtkJitteredShadowMapPass.

float shadowFilter(int view, shadowKernel kernel)
{
  float delta = shadowAssumedDelta(kernel);
  return shadowJitteredAverage(
    kernel, shadowOneLayer(kernel, delta), shadowFindConstant(view, kernel, delta));
}
