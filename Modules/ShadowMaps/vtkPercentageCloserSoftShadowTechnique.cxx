// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPercentageCloserSoftShadowTechnique.h"

#include "vtkPercentageCloserSoftShadowFS.h"
#include "vtkShadowFrame.h"
#include "vtkShadowMapFilterFS.h"
#include "vtkShadowMapLayersFS.h"
#include "vtkShadowMapPattern.h"
#include "vtkShadowMapPatternFS.h"
#include "vtkShadowMapSearchFS.h"

//------------------------------------------------------------------------------
void vtkPercentageCloserSoftShadowTechnique::UpdatePatterns(vtkShadowFrame& frame)
{
  this->UpdateSearch(frame);
  this->Filter->SetSobol(frame.Window, this->Settings.GetInteger("samples"), false);
}

//------------------------------------------------------------------------------
std::string vtkPercentageCloserSoftShadowTechnique::GetFilterGLSL()
{
  return std::string(vtkShadowMapFilterFS) + vtkShadowMapLayersFS + vtkShadowMapSearchFS +
         vtkShadowMapPatternFS + vtkPercentageCloserSoftShadowFS;
}
