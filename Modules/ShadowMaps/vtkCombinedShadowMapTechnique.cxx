// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCombinedShadowMapTechnique.h"

#include "vtkCombinedShadowMapFS.h"
#include "vtkShadowFrame.h"
#include "vtkShadowMapFilterFS.h"
#include "vtkShadowMapJitterFS.h"
#include "vtkShadowMapPattern.h"
#include "vtkShadowMapSearchFS.h"

//------------------------------------------------------------------------------
void vtkCombinedShadowMapTechnique::UpdatePatterns(vtkShadowFrame& frame)
{
  vtkJitteredShadowMapTechnique::UpdatePatterns(frame);
  this->Search->SetSobol(frame.Window, this->Settings.GetInteger("search"), true);
}

//------------------------------------------------------------------------------
std::string vtkCombinedShadowMapTechnique::GetFilterGLSL()
{
  return std::string(vtkShadowMapFilterFS) + vtkShadowMapSearchFS + vtkShadowMapJitterFS +
         vtkCombinedShadowMapFS;
}
