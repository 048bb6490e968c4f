// SPDX-License-Identifier: BSD-3-Clause
// The passes under the names of the family's techniques.

#include "vtkAccumulatedShadowMapPass.h"
#include "vtkBlurredShadowMapPass.h"
#include "vtkCombinedShadowMapPass.h"
#include "vtkHardShadowMapPass.h"
#include "vtkJitteredShadowMapPass.h"
#include "vtkObjectFactory.h"
#include "vtkPercentageCloserFilteringPass.h"
#include "vtkPercentageCloserSoftShadowPass.h"
#include "vtkTracedShadowMapPass.h"

vtkShadowPassOfTechniqueMacro(vtkAccumulatedShadowMapPass, "map-soft");
vtkShadowPassOfTechniqueMacro(vtkBlurredShadowMapPass, "map-blur");
vtkShadowPassOfTechniqueMacro(vtkCombinedShadowMapPass, "map-combined");
vtkShadowPassOfTechniqueMacro(vtkHardShadowMapPass, "map-hard");
vtkShadowPassOfTechniqueMacro(vtkJitteredShadowMapPass, "map-jitter");
vtkShadowPassOfTechniqueMacro(vtkPercentageCloserFilteringPass, "map-pcf");
vtkShadowPassOfTechniqueMacro(vtkPercentageCloserSoftShadowPass, "map-pcss");
vtkShadowPassOfTechniqueMacro(vtkTracedShadowMapPass, "map-trace");
