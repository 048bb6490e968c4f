#include "vtkCombinedShadowMapPass.h"

#include "vtkCombinedShadowMapFS.h"
#include "vtkObjectFactory.h"
#include "vtkShadowFrame.h"
#include "vtkShadowMapJitterFS.h"
#include "vtkShadowMapPattern.h"
#include "vtkShadowMapSearchFS.h"

vtkStandardNewMacro(vtkCombinedShadowMapPass);

//------------------------------------------------------------------------------
vtkCombinedShadowMapPass::vtkCombinedShadowMapPass()
{
  this->SetTechnique("map-combined");
}

//------------------------------------------------------------------------------
void vtkCombinedShadowMapPass::UpdatePatterns(vtkShadowFrame& frame)
{
  this->Superclass::UpdatePatterns(frame);
  this->Search->SetSobol(frame.Window, this->GetInteger("search"), true);
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
