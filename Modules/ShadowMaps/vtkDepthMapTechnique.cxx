// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDepthMapTechnique.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkShadowCasters.h"
#include "vtkShadowFrame.h"
#include "vtkShadowMapParameters.h"
#include "vtkShadowMapViewFS.h"
#include "vtkShadowMaps.h"
#include "vtkShadowMapsFS.h"
#include "vtkShadowMessages.h"
#include "vtkShadowOpenGL.h"

#include <algorithm>
#include <cmath>

namespace
{
/** Of one of many maps, whose errors are averaged. */
constexpr int ResolutionOfMany = 512;

/**
 * What the finest mesh needs: four texels along a side of its triangles if it fills the picture. A rough
 * surface's own shadows are as fine.
 */
double FindDetail(const vtkShadowCasters& casters)
{
  std::size_t triangles = 0;
  for (const auto& caster : casters.Get())
  {
    triangles = std::max(triangles, caster.Mesh->GetNumberOfTriangles());
  }
  return std::min(2048.0, 4.0 * std::sqrt(static_cast<double>(triangles)));
}
}

//------------------------------------------------------------------------------
vtkDepthMapTechnique::vtkDepthMapTechnique(const vtkShadowSettings& settings)
  : vtkShadowTechnique(settings)
  , Maps(new vtkShadowMaps)
{
}

//------------------------------------------------------------------------------
vtkDepthMapTechnique::~vtkDepthMapTechnique() = default;

//------------------------------------------------------------------------------
bool vtkDepthMapTechnique::UpdateMaps(vtkShadowFrame& frame, int samples, double megabytes)
{
  vtkShadowMapSettings settings;
  settings.Samples = samples;
  settings.Midpoint = this->Settings.Has("midpoint") && this->Settings.GetBoolean("midpoint");
  if (this->Settings.Has("faces"))
  {
    settings.Faces = vtkShadowMapFaces::Read(this->Settings.GetChoice("faces"));
  }
  settings.Bilinear = this->Settings.GetChoice("filter") == "bilinear";
  settings.MemoryLimit = static_cast<std::size_t>(megabytes * 1048576.0);
  const int asked = this->Settings.GetInteger("resolution");
  const bool many = samples > 1 && !frame.Hard;
  settings.Resolution = frame.ChooseResolution(asked == 0 && many ? ResolutionOfMany : asked,
    vtkShadowMapParameters::LeastResolution, 1024, FindDetail(*frame.Casters));
  this->SetMapSettings(settings);
  if (!this->Maps->Update(frame, settings))
  {
    const std::string side = std::to_string(settings.Resolution);
    frame.Messages->Error(
      "no memory for a map of " + side + " x " + side + "; drawn without shadows.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
std::string vtkDepthMapTechnique::GetVisibilityGLSL()
{
  // A light's height is found for the bias, wherever it has a map.
  const bool tellsAway = this->Maps->HasViewOfEach();
  return this->Maps->GetGLSL() +
         (tellsAway ? "#ifdef SHADOW_HARD\n#define SHADOW_TELLS_AWAY\n#endif\n" : "") +
         vtkShadowMapsFS;
}

//------------------------------------------------------------------------------
void vtkDepthMapTechnique::Activate(vtkShadowFrame& frame)
{
  this->Maps->Activate(frame);
}

//------------------------------------------------------------------------------
void vtkDepthMapTechnique::Deactivate(vtkShadowFrame& frame)
{
  this->Maps->Deactivate(frame);
}

//------------------------------------------------------------------------------
void vtkDepthMapTechnique::SetVisibilityParameters(vtkShaderProgram* program)
{
  this->Maps->SetParameters(program);
}

//------------------------------------------------------------------------------
double vtkDepthMapTechnique::GetMaximumCost()
{
  return this->Maps->GetNumberOfViews();
}

//------------------------------------------------------------------------------
void vtkDepthMapTechnique::DrawDebugView(vtkShadowFrame& frame, const std::string&)
{
  vtkShadowTexture& texture = this->Maps->GetTexture();
  texture.SetSampling(frame.Window, vtkShadowTexture::Sampling::Nearest);
  texture.Activate(frame.Window);
  int viewport[4];
  frame.Window->GetState()->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  const int columns =
    static_cast<int>(std::ceil(std::sqrt(static_cast<double>(texture.GetLayers()))));
  frame.Quad->Draw(frame.Window, vtkShadowMapViewFS,
    [&](vtkShaderProgram* program)
    {
      program->SetUniformi("shadowMaps", texture.GetUnit());
      program->SetUniform2i("shadowViewportOrigin", viewport);
      program->SetUniform2i("shadowViewportSize", viewport + 2);
      program->SetUniformi("shadowColumns", columns);
    });
  texture.SetSampling(frame.Window, this->Settings.GetChoice("filter") == "bilinear"
                                      ? vtkShadowTexture::Sampling::CompareLinear
                                      : vtkShadowTexture::Sampling::CompareNearest);
}

//------------------------------------------------------------------------------
void vtkDepthMapTechnique::Release(vtkOpenGLRenderWindow* window)
{
  this->Maps->Release(window);
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::size_t>> vtkDepthMapTechnique::GetBytes()
{
  return this->Maps->GetBytes();
}
