// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPlanarShadowTechnique.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPlanarViewFS.h"
#include "vtkShaderProgram.h"
#include "vtkShadowCasters.h"
#include "vtkShadowFrame.h"
#include "vtkShadowMessages.h"
#include "vtkShadowOpenGL.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
vtkPlanarShadowTechnique::vtkPlanarShadowTechnique(const vtkShadowSettings& settings, Kind kind)
  : vtkShadowTechnique(settings)
  , Technique(kind)
{
}

//------------------------------------------------------------------------------
bool vtkPlanarShadowTechnique::UpdateLightData(vtkShadowFrame& frame)
{
  vtkPlanarShadowSettings settings;
  settings.Technique = this->Technique;
  constexpr int smallest = 16; // a smaller layer has no middle within its border
  settings.Resolution =
    this->Technique == Kind::Hard
      ? 1
      : frame.ChooseResolution(this->Settings.GetInteger("resolution"), smallest, 512);
  settings.Samples = settings.Technique == Kind::Soft ? this->Settings.GetInteger("samples") : 1;
  settings.Kernel = settings.Technique == Kind::Fake ? this->Settings.GetInteger("kernel") : 1;

  const bool changed = this->Planes.Update(*frame.Casters, this->Settings.GetInteger("planes"));
  const auto planes = static_cast<int>(this->Planes.Get().size());
  if (settings.Technique == Kind::Fake)
  {
    frame.Counts["lightsTooLarge"] = frame.CountLargeLights();
  }
  frame.Counts["planes"] = planes;
  frame.Counts["planesFound"] = this->Planes.GetFound();
  frame.Counts["planesLeftOut"] = this->Planes.GetFound() - planes;
  const auto& casters = frame.Casters->Get();
  if (planes == 0 && std::none_of(casters.begin(), casters.end(),
                       [](const vtkShadowCaster& caster) { return caster.Mesh->Flat; }))
  {
    frame.Messages->Warn(
      "nothing receives a shadow: no prop is flat, and no plane is given (AddPlane).");
  }
  if (!this->Maps.Update(frame, this->Planes, changed, settings))
  {
    const std::string width =
      std::to_string(settings.Technique == Kind::Hard ? frame.Size[0] : settings.Resolution);
    const std::string height =
      std::to_string(settings.Technique == Kind::Hard ? frame.Size[1] : settings.Resolution);
    frame.Messages->Error("no memory for " + std::to_string(this->Maps.GetNumberOfLayers()) +
                          " layers of " + width + " x " + height + "; drawn without shadows.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
std::string vtkPlanarShadowTechnique::GetVisibilityGLSL()
{
  return this->Maps.GetGLSL();
}

//------------------------------------------------------------------------------
bool vtkPlanarShadowTechnique::PrefersForward(const vtkShadowFrame& frame)
{
  // As vtkFilteredShadowMapTechnique: the filter's code is long.
  const bool oftener = frame.IsSoftware && frame.SamplesPerPixel > 1;
  return this->Technique != Kind::Fake || (frame.Parts.size() < 2 && !oftener);
}

//------------------------------------------------------------------------------
void vtkPlanarShadowTechnique::Activate(vtkShadowFrame& frame)
{
  this->Maps.Activate(frame);
}

//------------------------------------------------------------------------------
void vtkPlanarShadowTechnique::Deactivate(vtkShadowFrame& frame)
{
  this->Maps.Deactivate(frame);
}

//------------------------------------------------------------------------------
void vtkPlanarShadowTechnique::SetVisibilityParameters(vtkShaderProgram* program)
{
  this->Maps.SetParameters(program);
}

//------------------------------------------------------------------------------
double vtkPlanarShadowTechnique::GetMaximumCost()
{
  return this->Maps.GetMaximumCost();
}

//------------------------------------------------------------------------------
void vtkPlanarShadowTechnique::DrawDebugView(vtkShadowFrame& frame, const std::string&)
{
  vtkShadowTexture& texture = this->Maps.GetTexture();
  texture.Activate(frame.Window);
  int viewport[4];
  frame.Window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  std::string source = vtkPlanarViewFS;
  vtkShaderProgram::Substitute(
    source, "SHADOW_VIEW_SWIZZLE", frame.Color && !frame.Hard ? "texel.rgb" : "texel.rrr");
  const int layers = this->Maps.GetNumberOfLayers();
  frame.Quad->Draw(frame.Window, source,
    [&](vtkShaderProgram* program)
    {
      program->SetUniformi("shadowPlanarMaps", texture.GetUnit());
      program->SetUniform2i("shadowViewportOrigin", viewport);
      program->SetUniform2i("shadowViewportSize", viewport + 2);
      program->SetUniformi("shadowLayers", layers);
      program->SetUniformi("shadowCoverage", this->Technique == Kind::Fake);
      program->SetUniformi("shadowColumns",
        static_cast<int>(std::ceil(std::sqrt(static_cast<double>(std::max(1, layers))))));
    });
}

//------------------------------------------------------------------------------
void vtkPlanarShadowTechnique::Release(vtkOpenGLRenderWindow* window)
{
  this->Maps.Release(window);
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::size_t>> vtkPlanarShadowTechnique::GetBytes()
{
  return this->Maps.GetBytes();
}
