// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFilteredShadowMapTechnique.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkShadowCasters.h"
#include "vtkShadowFrame.h"
#include "vtkShadowLayers.h"
#include "vtkShadowMapKernelFS.h"
#include "vtkShadowMapPattern.h"
#include "vtkShadowMaps.h"
#include "vtkShadowMessages.h"
#include "vtkShadowOpenGL.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <numeric>
#include <vector>

//------------------------------------------------------------------------------
vtkFilteredShadowMapTechnique::vtkFilteredShadowMapTechnique(const vtkShadowSettings& settings)
  : vtkDepthMapTechnique(settings)
  , Search(new vtkShadowMapPattern)
  , Filter(new vtkShadowMapPattern)
  , Layers(new vtkShadowLayers)
{
}

//------------------------------------------------------------------------------
vtkFilteredShadowMapTechnique::~vtkFilteredShadowMapTechnique() = default;

//------------------------------------------------------------------------------
std::string vtkFilteredShadowMapTechnique::FindUnsupported(vtkOpenGLRenderWindow*)
{
  return VTK_SHADOW_HAS_GL(VERSION_3_3) || VTK_SHADOW_HAS_GL(ARB_sampler_objects)
           ? ""
           : "OpenGL 3.3 is needed, or ARB_sampler_objects";
}

//------------------------------------------------------------------------------
bool vtkFilteredShadowMapTechnique::UpdateLightData(vtkShadowFrame& frame)
{
  constexpr double unlimited = 1048576.0; // megabytes: a few maps are always kept
  this->Hard = frame.Hard;
  if (!this->UpdateMaps(frame, 1, unlimited))
  {
    return false;
  }
  if (!this->Hard && this->PatternTime != this->Settings.GetTime())
  {
    this->UpdatePatterns(frame);
    this->PatternTime = this->Settings.GetTime();
  }
  if (this->Maps->IsOverlapExceeded())
  {
    frame.Messages->Warn(
      "a light is among its casters and larger than three fifths of its distance from "
      "one: penumbrae that reach further beyond the face of its cube are drawn in.");
  }
  frame.Counts["lightsTooLarge"] = frame.CountLargeLights();
  if (!this->FollowsLayers())
  {
    frame.Counts["lightsWithLayers"] = this->Layers->Count(*frame.Casters, frame.Lights);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkFilteredShadowMapTechnique::SetMapSettings(vtkShadowMapSettings& settings)
{
  // Without a size, the map of map-hard.
  settings.Neighbours = !this->Hard;
  settings.Midpoint = settings.Midpoint && !this->Hard;
  if (this->Settings.Has("width"))
  {
    settings.Separation = this->Settings.GetReal("width");
  }
}

//------------------------------------------------------------------------------
bool vtkFilteredShadowMapTechnique::PrefersForward(const vtkShadowFrame& frame)
{
  // Of several lights' filters the code stays a loop, whose lights are no constants: see
  // vtkShadowInjection. In screen space it runs once a pixel for that. So it does where a software
  // rasterizer runs it for each primitive that has any of a pixel's samples: twice as long with 4 to 8.
  const bool oftener = frame.IsSoftware && frame.SamplesPerPixel > 1;
  return this->Hard || (frame.Parts.size() < 2 && !oftener);
}

//------------------------------------------------------------------------------
std::string vtkFilteredShadowMapTechnique::GetVisibilityGLSL()
{
  if (this->Hard)
  {
    return vtkDepthMapTechnique::GetVisibilityGLSL();
  }
  const bool skipping = this->Settings.GetBoolean("skipping");
  return this->Maps->GetGLSL() + (skipping ? "#define SHADOW_SKIPPING\n" : "") +
         (this->HasLayers() ? "#define SHADOW_LAYERS\n" : "") + this->GetKernelDefinitions() +
         vtkShadowMapKernelFS + this->GetFilterGLSL();
}

//------------------------------------------------------------------------------
void vtkFilteredShadowMapTechnique::Activate(vtkShadowFrame& frame)
{
  vtkDepthMapTechnique::Activate(frame);
  for (auto* pattern : { this->Search.get(), this->Filter.get() })
  {
    if (!this->Hard && pattern->GetCount() > 0)
    {
      pattern->GetTexture().Activate(frame.Window);
    }
  }
}

//------------------------------------------------------------------------------
void vtkFilteredShadowMapTechnique::Deactivate(vtkShadowFrame& frame)
{
  this->Search->GetTexture().Deactivate(frame.Window);
  this->Filter->GetTexture().Deactivate(frame.Window);
  vtkDepthMapTechnique::Deactivate(frame);
}

//------------------------------------------------------------------------------
void vtkFilteredShadowMapTechnique::SetVisibilityParameters(vtkShaderProgram* program)
{
  vtkDepthMapTechnique::SetVisibilityParameters(program);
  if (!this->Hard)
  {
    program->SetUniformi("shadowSearch", this->Search->GetTexture().GetUnit());
    program->SetUniformi("shadowSearchCount", this->Search->GetCount());
    program->SetUniformi("shadowSearchFurther", this->Search->GetFurther());
    program->SetUniformi("shadowPattern", this->Filter->GetTexture().GetUnit());
    program->SetUniformi("shadowPatternCount", this->Filter->GetCount());
  }
}

//------------------------------------------------------------------------------
bool vtkFilteredShadowMapTechnique::HasLayers() const
{
  return this->Settings.Has("blockers") && this->Settings.GetChoice("blockers") == "layers";
}

//------------------------------------------------------------------------------
void vtkFilteredShadowMapTechnique::UpdateSearch(vtkShadowFrame& frame)
{
  const int count = this->Settings.GetInteger("search");
  if (this->HasLayers())
  {
    this->Search->SetSearch(frame.Window, count, this->Settings.GetInteger("samples"));
    return;
  }
  this->Search->SetSobol(frame.Window, count, true);
}

//------------------------------------------------------------------------------
int vtkFilteredShadowMapTechnique::GetLookUps() const
{
  constexpr int ofLayers = 3;
  return this->HasLayers() ? ofLayers : 1;
}

//------------------------------------------------------------------------------
double vtkFilteredShadowMapTechnique::GetMaximumCost()
{
  constexpr int pyramid = 8;
  return this->Hard ? vtkDepthMapTechnique::GetMaximumCost()
                    : this->Search->GetCount() + this->Search->GetFurther() +
                        this->GetLookUps() * this->Filter->GetCount() + pyramid;
}

//------------------------------------------------------------------------------
std::string vtkFilteredShadowMapTechnique::GetDebugQuantity(const std::string& view)
{
  if (this->Hard && (view == "penumbra-width" || view == "blocker-depth"))
  {
    return "0.0"; // no penumbra, and nothing was searched
  }
  return view == "penumbra-width"
           ? "shadowPenumbra"
           : (view == "blocker-depth" ? "shadowBlocker"
                                      : vtkDepthMapTechnique::GetDebugQuantity(view));
}

//------------------------------------------------------------------------------
void vtkFilteredShadowMapTechnique::Release(vtkOpenGLRenderWindow* window)
{
  auto* glWindow = window;
  this->Search->GetTexture().Release(glWindow);
  this->Filter->GetTexture().Release(glWindow);
  this->PatternTime = 0;
  vtkDepthMapTechnique::Release(window);
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::size_t>> vtkFilteredShadowMapTechnique::GetBytes()
{
  auto bytes = vtkDepthMapTechnique::GetBytes();
  bytes.emplace_back(
    "patterns", this->Search->GetTexture().GetBytes() + this->Filter->GetTexture().GetBytes());
  return bytes;
}
