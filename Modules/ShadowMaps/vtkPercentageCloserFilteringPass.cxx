#include "vtkPercentageCloserFilteringPass.h"

#include "vtkObjectFactory.h"
#include "vtkPercentageCloserFilteringFS.h"
#include "vtkShadowFrame.h"
#include "vtkShadowMapConstantFS.h"
#include "vtkShadowMapPattern.h"
#include "vtkShadowMapPatternFS.h"

vtkStandardNewMacro(vtkPercentageCloserFilteringPass);

//------------------------------------------------------------------------------
vtkPercentageCloserFilteringPass::vtkPercentageCloserFilteringPass()
{
  this->SetTechnique("map-pcf");
}

//------------------------------------------------------------------------------
void vtkPercentageCloserFilteringPass::UpdatePatterns(vtkShadowFrame& frame)
{
  this->Filter->SetGrid(frame.Window, this->GetInteger("kernel"));
}

//------------------------------------------------------------------------------
std::string vtkPercentageCloserFilteringPass::GetFilterGLSL()
{
  return std::string(vtkShadowMapConstantFS) + vtkShadowMapPatternFS +
         vtkPercentageCloserFilteringFS;
}
