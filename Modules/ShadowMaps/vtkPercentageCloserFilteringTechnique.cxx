// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPercentageCloserFilteringTechnique.h"

#include "vtkPercentageCloserFilteringFS.h"
#include "vtkShadowFrame.h"
#include "vtkShadowMapConstantFS.h"
#include "vtkShadowMapFilterFS.h"
#include "vtkShadowMapLayersFS.h"
#include "vtkShadowMapPattern.h"
#include "vtkShadowMapPatternFS.h"

//------------------------------------------------------------------------------
void vtkPercentageCloserFilteringTechnique::UpdatePatterns(vtkShadowFrame& frame)
{
  this->Filter->SetGrid(frame.Window, this->Settings.GetInteger("kernel"));
}

//------------------------------------------------------------------------------
std::string vtkPercentageCloserFilteringTechnique::GetFilterGLSL()
{
  return std::string(vtkShadowMapFilterFS) + vtkShadowMapLayersFS + vtkShadowMapConstantFS +
         vtkShadowMapPatternFS + vtkPercentageCloserFilteringFS;
}
