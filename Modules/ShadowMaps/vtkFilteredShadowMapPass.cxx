#include "vtkFilteredShadowMapPass.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkShadowFrame.h"
#include "vtkShadowMapKernelFS.h"
#include "vtkShadowMapPattern.h"
#include "vtkShadowMaps.h"
#include "vtkShadowVTKVersion.h"

//------------------------------------------------------------------------------
vtkFilteredShadowMapPass::vtkFilteredShadowMapPass()
  : Search(new vtkShadowMapPattern)
  , Filter(new vtkShadowMapPattern)
{
}

//------------------------------------------------------------------------------
vtkFilteredShadowMapPass::~vtkFilteredShadowMapPass()
{
  this->Detach();
}

//------------------------------------------------------------------------------
std::string vtkFilteredShadowMapPass::FindUnsupported(vtkRenderWindow*)
{
  return VTK_SHADOW_HAS_GL(VERSION_3_3) || VTK_SHADOW_HAS_GL(ARB_sampler_objects)
           ? ""
           : "OpenGL 3.3 is needed, or ARB_sampler_objects";
}

//------------------------------------------------------------------------------
bool vtkFilteredShadowMapPass::UpdateLightData(vtkShadowFrame& frame)
{
  constexpr double unlimited = 1048576.0; // megabytes: a few maps are always kept
  this->Hard = frame.Hard;
  if (!this->UpdateMaps(frame, 1, unlimited))
  {
    return false;
  }
  if (!this->Hard && this->PatternTime != this->GetParameterTime())
  {
    this->UpdatePatterns(frame);
    this->PatternTime = this->GetParameterTime();
  }
  if (this->Maps->IsOverlapExceeded())
  {
    this->WarnOnce("a light is among its casters and larger than three fifths of its distance from "
                   "one: penumbrae that reach further beyond the face of its cube are drawn in.");
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkFilteredShadowMapPass::SetMapSettings(vtkShadowMapSettings& settings)
{
  // Without a size, the map of map-hard.
  settings.Neighbours = !this->Hard;
  settings.Midpoint = settings.Midpoint && !this->Hard;
  if (this->HasParameter("width"))
  {
    settings.Separation = this->GetReal("width");
  }
}

//------------------------------------------------------------------------------
bool vtkFilteredShadowMapPass::PrefersForward(const vtkShadowFrame& frame)
{
  // Of several lights' filters the code stays a loop, whose lights are no constants: see
  // vtkShadowInjection. In screen space it runs once a pixel for that.
  return this->Hard || frame.Lights.size() < 2;
}

//------------------------------------------------------------------------------
std::string vtkFilteredShadowMapPass::GetVisibilityGLSL()
{
  if (this->Hard)
  {
    return this->Superclass::GetVisibilityGLSL();
  }
  const bool skipping = this->GetBoolean("skipping");
  return this->Maps->GetGLSL() + (skipping ? "#define SHADOW_SKIPPING\n" : "") +
         this->GetKernelDefinitions() + vtkShadowMapKernelFS + this->GetFilterGLSL();
}

//------------------------------------------------------------------------------
void vtkFilteredShadowMapPass::ActivateLightData(vtkShadowFrame& frame)
{
  this->Superclass::ActivateLightData(frame);
  for (auto* pattern : { this->Search.get(), this->Filter.get() })
  {
    if (!this->Hard && pattern->GetCount() > 0)
    {
      pattern->GetTexture().Activate(frame.Window);
    }
  }
}

//------------------------------------------------------------------------------
void vtkFilteredShadowMapPass::DeactivateLightData(vtkShadowFrame& frame)
{
  this->Search->GetTexture().Deactivate(frame.Window);
  this->Filter->GetTexture().Deactivate(frame.Window);
  this->Superclass::DeactivateLightData(frame);
}

//------------------------------------------------------------------------------
void vtkFilteredShadowMapPass::SetVisibilityParameters(vtkShaderProgram* program)
{
  this->Superclass::SetVisibilityParameters(program);
  if (!this->Hard)
  {
    program->SetUniformi("shadowSearch", this->Search->GetTexture().GetUnit());
    program->SetUniformi("shadowSearchCount", this->Search->GetCount());
    program->SetUniformi("shadowPattern", this->Filter->GetTexture().GetUnit());
    program->SetUniformi("shadowPatternCount", this->Filter->GetCount());
  }
}

//------------------------------------------------------------------------------
double vtkFilteredShadowMapPass::GetMaximumCost()
{
  constexpr int pyramid = 8;
  return this->Hard ? this->Superclass::GetMaximumCost()
                    : this->Search->GetCount() + this->Filter->GetCount() + pyramid;
}

//------------------------------------------------------------------------------
std::string vtkFilteredShadowMapPass::GetDebugViews()
{
  return this->Superclass::GetDebugViews() + " penumbra-width";
}

//------------------------------------------------------------------------------
std::string vtkFilteredShadowMapPass::GetDebugQuantity(const std::string& view)
{
  if (this->Hard && (view == "penumbra-width" || view == "blocker-depth"))
  {
    return "0.0"; // no penumbra, and nothing was searched
  }
  return view == "penumbra-width"
           ? "shadowPenumbra"
           : (view == "blocker-depth" ? "shadowBlocker" : this->Superclass::GetDebugQuantity(view));
}

//------------------------------------------------------------------------------
void vtkFilteredShadowMapPass::ReleaseLightData(vtkRenderWindow* window)
{
  auto* glWindow = vtkOpenGLRenderWindow::SafeDownCast(window);
  this->Search->GetTexture().Release(glWindow);
  this->Filter->GetTexture().Release(glWindow);
  this->PatternTime = 0;
  this->Superclass::ReleaseLightData(window);
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::size_t>> vtkFilteredShadowMapPass::GetLightDataBytes()
{
  auto bytes = this->Superclass::GetLightDataBytes();
  bytes.emplace_back(
    "patterns", this->Search->GetTexture().GetBytes() + this->Filter->GetTexture().GetBytes());
  return bytes;
}
