#include "vtkCombinedShadowMapPass.h"

#include "vtkCombinedShadowMapFS.h"
#include "vtkObjectFactory.h"
#include "vtkShadowFrame.h"
#include "vtkShadowMapJitterFS.h"
#include "vtkShadowMapPattern.h"
#include "vtkShadowMapSearchFS.h"
#include "vtkShadowMaps.h"

vtkStandardNewMacro(vtkCombinedShadowMapPass);

//------------------------------------------------------------------------------
vtkCombinedShadowMapPass::vtkCombinedShadowMapPass()
{
  this->SetTechnique("map-combined");
}

//------------------------------------------------------------------------------
bool vtkCombinedShadowMapPass::UpdateLightData(vtkShadowFrame& frame)
{
  if (!this->Superclass::UpdateLightData(frame))
  {
    return false;
  }
  const vtkMTimeType time = this->GetParameterTime();
  if (!this->Hard && this->Search->IsStale(time))
  {
    this->Search->SetSobol(frame.Window, time, this->GetInteger("search"), true);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkCombinedShadowMapPass::SetMapSettings(vtkShadowMapSettings& settings)
{
  this->vtkFilteredShadowMapPass::SetMapSettings(settings);
}

//------------------------------------------------------------------------------
std::string vtkCombinedShadowMapPass::GetDebugViews()
{
  return this->Superclass::GetDebugViews() + " blocker-depth";
}

//------------------------------------------------------------------------------
std::string vtkCombinedShadowMapPass::GetFilterGLSL()
{
  return std::string(vtkShadowMapSearchFS) + vtkShadowMapJitterFS + vtkCombinedShadowMapFS;
}
