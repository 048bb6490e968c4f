#include "vtkHardShadowMapPass.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHardShadowMapPass);

//------------------------------------------------------------------------------
vtkHardShadowMapPass::vtkHardShadowMapPass()
{
  this->SetTechnique("map-hard");
}

//------------------------------------------------------------------------------
bool vtkHardShadowMapPass::UpdateLightData(vtkShadowFrame& frame)
{
  constexpr double unlimited = 1048576.0; // megabytes: a few maps are always kept
  return this->UpdateMaps(frame, 1, unlimited);
}
