// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTracedShadowMapTechnique.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkShadowFrame.h"
#include "vtkShadowMapDenoiseFS.h"
#include "vtkShadowMapPattern.h"
#include "vtkShadowMapTraceFS.h"
#include "vtkShadowMaps.h"
#include "vtkShadowMessages.h"
#include "vtkShadowOpenGL.h"
#include "vtkTracedShadowMapFS.h"
#include "vtkVisibilityBuffer.h"

#include <cmath>

namespace
{
/** Side of the tile of pixels whose points differ: that of vtkShadowMapTraceFS.glsl and the filter. */
constexpr int Tile = 4;
}

//------------------------------------------------------------------------------
vtkTracedShadowMapTechnique::vtkTracedShadowMapTechnique(const vtkShadowSettings& settings)
  : vtkFilteredShadowMapTechnique(settings)
  , Emission(new vtkShadowTexture)
  , Mask(new vtkShadowTexture)
{
}

//------------------------------------------------------------------------------
vtkTracedShadowMapTechnique::~vtkTracedShadowMapTechnique() = default;

//------------------------------------------------------------------------------
void vtkTracedShadowMapTechnique::SetMapSettings(vtkShadowMapSettings& settings)
{
  vtkFilteredShadowMapTechnique::SetMapSettings(settings);
  settings.Slabs = !this->Hard;
}

//------------------------------------------------------------------------------
bool vtkTracedShadowMapTechnique::UpdateLightData(vtkShadowFrame& frame)
{
  this->Color = frame.Color;
  if (!vtkFilteredShadowMapTechnique::UpdateLightData(frame))
  {
    return false;
  }
  if (!this->Hard && frame.Color)
  {
    this->UpdateEmission(frame);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkTracedShadowMapTechnique::UpdatePatterns(vtkShadowFrame& frame)
{
  this->Filter->SetSobol(frame.Window, Tile * Tile * this->Settings.GetInteger("samples"), false);
}

//------------------------------------------------------------------------------
void vtkTracedShadowMapTechnique::UpdateEmission(vtkShadowFrame& frame)
{
  std::vector<glm::vec4> texels;
  for (const auto& part : frame.Parts)
  {
    const std::size_t first = texels.size();
    glm::dvec3 sum(0.0);
    for (const auto& point : this->Filter->GetPoints())
    {
      const glm::dvec3 emission = part.Light.GetEmission(0.5 * glm::dvec2(point.z, point.w) + 0.5);
      texels.emplace_back(emission, 0.0);
      sum += emission;
    }
    // A channel without emission is decided by the others' geometry: all points count alike.
    for (std::size_t i = first; i < texels.size(); ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        texels[i][c] = sum[c] > 0.0 ? texels[i][c] : 1.0f;
      }
    }
  }
  this->Emission->UploadBuffer(frame.Window, texels);
}

//------------------------------------------------------------------------------
std::string vtkTracedShadowMapTechnique::GetKernelDefinitions()
{
  return "#define SHADOW_TILE " + std::to_string(Tile) + "\n" +
         (this->Color ? "#define SHADOW_EMISSION\n" : "") +
         (this->ToMask ? "#define SHADOW_TELLS_NOISE\n" : "");
}

//------------------------------------------------------------------------------
std::string vtkTracedShadowMapTechnique::GetFilterGLSL()
{
  return std::string(vtkShadowMapTraceFS) + vtkTracedShadowMapFS;
}

//------------------------------------------------------------------------------
bool vtkTracedShadowMapTechnique::CanEvaluateForward()
{
  return this->Hard || !this->Settings.GetBoolean("denoise");
}

//------------------------------------------------------------------------------
double vtkTracedShadowMapTechnique::GetMaximumCost()
{
  constexpr int stepsOfRay = 16;
  return this->Hard ? vtkDepthMapTechnique::GetMaximumCost()
                    : stepsOfRay * this->Settings.GetInteger("samples");
}

//------------------------------------------------------------------------------
void vtkTracedShadowMapTechnique::FillVisibility(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer)
{
  using Format = vtkShadowTexture::Format;
  if (this->CanEvaluateForward() || !buffer.GetQuantity().empty())
  {
    vtkFilteredShadowMapTechnique::FillVisibility(frame, buffer);
    return;
  }
  const vtkShadowTexture& target = buffer.GetTarget();
  if (!this->Mask->Allocate(frame.Window, buffer.IsColor() ? Format::Float4 : Format::Float1,
        target.GetWidth(), target.GetHeight(), 1))
  {
    frame.Messages->Warn("no memory for a mask of the picture's size; drawn without denoise.");
    vtkFilteredShadowMapTechnique::FillVisibility(frame, buffer);
    return;
  }
  for (int i = 0; i < static_cast<int>(frame.Parts.size()); ++i)
  {
    // A light without size has no noise.
    const bool point = frame.Parts[i].Light.IsPoint();
    {
      vtkShadowFramebuffer::Scope scope(frame.Window, buffer.GetFramebuffer(),
        point ? &buffer.GetTarget() : this->Mask.get(), nullptr, point ? i : 0);
      this->ToMask = !point;
      this->DrawEvaluation(frame, buffer, i);
      this->ToMask = false;
    }
    if (!point)
    {
      vtkShadowFramebuffer::Scope scope(
        frame.Window, buffer.GetFramebuffer(), &buffer.GetTarget(), nullptr, i);
      this->Denoise(frame, buffer, i);
    }
  }
}

//------------------------------------------------------------------------------
void vtkTracedShadowMapTechnique::Denoise(
  vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int part)
{
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  state->vtkglDisable(GL_DEPTH_TEST);
  std::string source = vtkShadowMapDenoiseFS;
  vtkShaderProgram::Substitute(
    source, "//SHADOW::Declarations", frame.GetLightsGLSL() + vtkShadowReceivers::GetGLSL());
  vtkShadowTexture& receivers = buffer.GetReceivers().GetTexture();
  receivers.Activate(frame.Window);
  this->Mask->Activate(frame.Window);
  frame.Quad->Draw(frame.Window, source,
    [&](vtkShaderProgram* program)
    {
      program->SetUniformi("shadowReceivers", receivers.GetUnit());
      program->SetUniformi("shadowMask", this->Mask->GetUnit());
      program->SetUniformi("shadowLight", part);
      frame.SetLights(program);
      // Stratified samples of a light that an edge cuts are off by half of this.
      program->SetUniformf(
        "shadowNoise", std::pow(static_cast<float>(this->Settings.GetInteger("samples")), -0.75f));
    });
  this->Mask->Deactivate(frame.Window);
  receivers.Deactivate(frame.Window);
}

//------------------------------------------------------------------------------
void vtkTracedShadowMapTechnique::Activate(vtkShadowFrame& frame)
{
  vtkFilteredShadowMapTechnique::Activate(frame);
  if (!this->Hard && this->Color)
  {
    this->Emission->Activate(frame.Window);
  }
}

//------------------------------------------------------------------------------
void vtkTracedShadowMapTechnique::Deactivate(vtkShadowFrame& frame)
{
  this->Emission->Deactivate(frame.Window);
  vtkFilteredShadowMapTechnique::Deactivate(frame);
}

//------------------------------------------------------------------------------
void vtkTracedShadowMapTechnique::SetVisibilityParameters(vtkShaderProgram* program)
{
  vtkFilteredShadowMapTechnique::SetVisibilityParameters(program);
  if (!this->Hard)
  {
    program->SetUniformi("shadowSamples", this->Settings.GetInteger("samples"));
    if (this->Color)
    {
      program->SetUniformi("shadowEmission", this->Emission->GetUnit());
    }
  }
}

//------------------------------------------------------------------------------
void vtkTracedShadowMapTechnique::Release(vtkOpenGLRenderWindow* window)
{
  this->Emission->Release(window);
  this->Mask->Release(window);
  vtkFilteredShadowMapTechnique::Release(window);
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::size_t>> vtkTracedShadowMapTechnique::GetBytes()
{
  auto bytes = vtkFilteredShadowMapTechnique::GetBytes();
  bytes.emplace_back("emission", this->Emission->GetBytes());
  bytes.emplace_back("mask", this->Mask->GetBytes());
  return bytes;
}
