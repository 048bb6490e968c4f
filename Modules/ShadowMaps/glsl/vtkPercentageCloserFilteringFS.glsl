// SPDX-License-Identifier: BSD-3-Clause
// map-pcf: see vtkPercentageCloserFilteringPass.

float shadowFilter(int view, shadowKernel kernel)
{
  float delta = shadowAssumedDelta(kernel);
  return shadowAverage(kernel, shadowOneLayer(kernel, delta),
    shadowFindConstant(view, kernel, delta), shadowPatternCount);
}
