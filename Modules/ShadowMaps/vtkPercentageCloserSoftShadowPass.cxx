#include "vtkPercentageCloserSoftShadowPass.h"

#include "vtkObjectFactory.h"
#include "vtkPercentageCloserSoftShadowFS.h"
#include "vtkShadowFrame.h"
#include "vtkShadowMapPattern.h"
#include "vtkShadowMapPatternFS.h"
#include "vtkShadowMapSearchFS.h"

vtkStandardNewMacro(vtkPercentageCloserSoftShadowPass);

//------------------------------------------------------------------------------
vtkPercentageCloserSoftShadowPass::vtkPercentageCloserSoftShadowPass()
{
  this->SetTechnique("map-pcss");
}

//------------------------------------------------------------------------------
bool vtkPercentageCloserSoftShadowPass::UpdateLightData(vtkShadowFrame& frame)
{
  if (!this->Superclass::UpdateLightData(frame))
  {
    return false;
  }
  const vtkMTimeType time = this->GetParameterTime();
  if (!this->Hard && this->Search->IsStale(time))
  {
    this->Search->SetSobol(frame.Window, time, this->GetInteger("search"), true);
    this->Filter->SetSobol(frame.Window, time, this->GetInteger("samples"), false);
  }
  return true;
}

//------------------------------------------------------------------------------
std::string vtkPercentageCloserSoftShadowPass::GetDebugViews()
{
  return this->Superclass::GetDebugViews() + " blocker-depth";
}

//------------------------------------------------------------------------------
std::string vtkPercentageCloserSoftShadowPass::GetFilterGLSL()
{
  return std::string(vtkShadowMapSearchFS) + vtkShadowMapPatternFS +
         vtkPercentageCloserSoftShadowFS;
}
