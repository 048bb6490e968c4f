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
void vtkPercentageCloserSoftShadowPass::UpdatePatterns(vtkShadowFrame& frame)
{
  this->Search->SetSobol(frame.Window, this->GetInteger("search"), true);
  this->Filter->SetSobol(frame.Window, this->GetInteger("samples"), false);
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
