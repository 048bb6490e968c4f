// SPDX-License-Identifier: BSD-3-Clause
#include "vtkBlurredShadowMapTechnique.h"

#include "vtkBlurredShadowMapFS.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShadowFrame.h"
#include "vtkShadowGL.h"
#include "vtkShadowMapPattern.h"
#include "vtkShadowMaps.h"
#include "vtkShadowMessages.h"
#include "vtkShadowOpenGL.h"
#include "vtkVisibilityBuffer.h"

#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/type_ptr.hpp>

//------------------------------------------------------------------------------
vtkBlurredShadowMapTechnique::vtkBlurredShadowMapTechnique(const vtkShadowSettings& settings)
  : vtkPercentageCloserFilteringTechnique(settings)
{
  for (auto& mask : this->Masks)
  {
    mask.reset(new vtkShadowTexture);
  }
}

//------------------------------------------------------------------------------
vtkBlurredShadowMapTechnique::~vtkBlurredShadowMapTechnique() = default;

//------------------------------------------------------------------------------
bool vtkBlurredShadowMapTechnique::UpdateLightData(vtkShadowFrame& frame)
{
  if (!vtkPercentageCloserFilteringTechnique::UpdateLightData(frame))
  {
    return false;
  }
  if (this->Hard)
  {
    return true;
  }
  for (auto& mask : this->Masks)
  {
    if (!mask->Allocate(
          frame.Window, vtkShadowTexture::Format::Float1, frame.Size[0], frame.Size[1], 1))
    {
      frame.Messages->Error("no memory for masks of the picture's size; drawn without shadows.");
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkBlurredShadowMapTechnique::UpdatePatterns(vtkShadowFrame& frame)
{
  // The mask is smooth over the distance of two points of the blur.
  this->Filter->SetGrid(frame.Window, 3, 1.0 / 7.0);
}

//------------------------------------------------------------------------------
std::string vtkBlurredShadowMapTechnique::GetKernelDefinitions()
{
  // The blur knows the share of the light above the horizon exactly; a mask would spread it.
  return this->Settings.GetChoice("blur") == "aware" ? "#define SHADOW_HORIZON_LATER\n" : "";
}

//------------------------------------------------------------------------------
void vtkBlurredShadowMapTechnique::FillVisibility(
  vtkShadowFrame& frame, vtkVisibilityBuffer& buffer)
{
  if (this->Hard || !buffer.GetQuantity().empty())
  {
    vtkPercentageCloserFilteringTechnique::FillVisibility(
      frame, buffer); // what is told of the mask
    return;
  }
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  state->vtkglDisable(GL_DEPTH_TEST);
  for (int i = 0; i < static_cast<int>(frame.Parts.size()); ++i)
  {
    // Nothing to blur by: no size, no casters, or no width.
    const bool point = frame.Parts[i].Light.IsPoint() || !(this->Maps->GetSeparation(i) > 0.0);
    {
      vtkShadowFramebuffer::Scope target(frame.Window, buffer.GetFramebuffer(),
        point ? &buffer.GetTarget() : this->Masks[0].get(), nullptr, point ? i : 0);
      this->DrawEvaluation(frame, buffer, i);
    }
    if (point)
    {
      continue;
    }
    const float x[] = { 1.0f, 0.0f };
    const float y[] = { 0.0f, 1.0f };
    {
      vtkShadowFramebuffer::Scope target(
        frame.Window, buffer.GetFramebuffer(), this->Masks[1].get(), nullptr, 0);
      this->Blur(frame, buffer, i, *this->Masks[0], x);
    }
    vtkShadowFramebuffer::Scope target(
      frame.Window, buffer.GetFramebuffer(), &buffer.GetTarget(), nullptr, i);
    this->Blur(frame, buffer, i, *this->Masks[1], y);
  }
}

//------------------------------------------------------------------------------
void vtkBlurredShadowMapTechnique::Blur(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer,
  int light, vtkShadowTexture& mask, const float step[2])
{
  const glm::vec4 eyeVC(frame.GetEyeVC());
  const glm::vec4 wRow(glm::row(frame.VCToClip, 3));
  const glm::vec3 pixelVC(frame.GetPixelVC(step[0] > 0.0f ? 0 : 1));
  std::string source = vtkBlurredShadowMapFS;
  vtkShaderProgram::Substitute(source, "//SHADOW::Declarations",
    frame.GetLightsGLSL() + vtkShadowReceivers::GetGLSL() +
      (this->Settings.GetChoice("blur") == "plain" ? "#define SHADOW_PLAIN\n" : ""));

  frame.Quad->Draw(frame.Window, source,
    [&](vtkShaderProgram* program)
    {
      buffer.GetReceivers().GetTexture().Activate(frame.Window);
      mask.Activate(frame.Window);
      program->SetUniformi("shadowReceivers", buffer.GetReceivers().GetTexture().GetUnit());
      program->SetUniformi("shadowMask", mask.GetUnit());
      program->SetUniformi("shadowLight", light);
      program->SetUniform2f("shadowStep", step);
      program->SetUniform4f("shadowEyeVC", glm::value_ptr(eyeVC));
      program->SetUniform4f("shadowWRow", glm::value_ptr(wRow));
      program->SetUniform3f("shadowPixelVC", glm::value_ptr(pixelVC));
      program->SetUniformf(
        "shadowSeparation", static_cast<float>(this->Maps->GetSeparation(light)));
      frame.SetLights(program);
    });
  mask.Deactivate(frame.Window);
  buffer.GetReceivers().GetTexture().Deactivate(frame.Window);
}

//------------------------------------------------------------------------------
void vtkBlurredShadowMapTechnique::Release(vtkOpenGLRenderWindow* window)
{
  for (auto& mask : this->Masks)
  {
    mask->Release(window);
  }
  vtkPercentageCloserFilteringTechnique::Release(window);
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::size_t>> vtkBlurredShadowMapTechnique::GetBytes()
{
  auto bytes = vtkPercentageCloserFilteringTechnique::GetBytes();
  bytes.emplace_back("masks", this->Masks[0]->GetBytes() + this->Masks[1]->GetBytes());
  return bytes;
}
