#include "vtkPercentageCloserFilteringPass.h"

#include "vtkObjectFactory.h"
#include "vtkPercentageCloserFilteringFS.h"
#include "vtkShadowFrame.h"
#include "vtkShadowMapConstantFS.h"
#include "vtkShadowMapPattern.h"
#include "vtkShadowMapPatternFS.h"
#include "vtkShadowMaps.h"

vtkStandardNewMacro(vtkPercentageCloserFilteringPass);

//------------------------------------------------------------------------------
vtkPercentageCloserFilteringPass::vtkPercentageCloserFilteringPass()
{
  this->SetTechnique("map-pcf");
}

//------------------------------------------------------------------------------
bool vtkPercentageCloserFilteringPass::UpdateLightData(vtkShadowFrame& frame)
{
  if (!this->Superclass::UpdateLightData(frame))
  {
    return false;
  }
  const vtkMTimeType time = this->GetParameterTime();
  if (!this->Hard && this->Filter->IsStale(time))
  {
    this->Filter->SetGrid(frame.Window, time, this->GetInteger("kernel"));
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkPercentageCloserFilteringPass::SetMapSettings(vtkShadowMapSettings& settings)
{
  this->Superclass::SetMapSettings(settings);
  settings.Separation = this->GetReal("width");
}

//------------------------------------------------------------------------------
std::string vtkPercentageCloserFilteringPass::GetFilterGLSL()
{
  return std::string(vtkShadowMapConstantFS) + vtkShadowMapPatternFS +
         vtkPercentageCloserFilteringFS;
}
