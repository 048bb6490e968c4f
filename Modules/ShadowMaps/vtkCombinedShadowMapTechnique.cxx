// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCombinedShadowMapTechnique.h"

#include "vtkCombinedShadowMapFS.h"
#include "vtkShadowMapFilterFS.h"
#include "vtkShadowMapJitterFS.h"
#include "vtkShadowMapLayersFS.h"
#include "vtkShadowMapSearchFS.h"

//------------------------------------------------------------------------------
void vtkCombinedShadowMapTechnique::UpdatePatterns(vtkShadowFrame& frame)
{
  vtkJitteredShadowMapTechnique::UpdatePatterns(frame);
  this->UpdateSearch(frame);
}

//------------------------------------------------------------------------------
std::string vtkCombinedShadowMapTechnique::GetFilterGLSL()
{
  return std::string(vtkShadowMapFilterFS) + vtkShadowMapLayersFS + vtkShadowMapSearchFS +
         vtkShadowMapJitterFS + vtkCombinedShadowMapFS;
}
