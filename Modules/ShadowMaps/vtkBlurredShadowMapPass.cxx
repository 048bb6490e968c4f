#include "vtkBlurredShadowMapPass.h"

#include "vtkBlurredShadowMapFS.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkShadowFrame.h"
#include "vtkShadowGL.h"
#include "vtkShadowMapPattern.h"
#include "vtkShadowMaps.h"
#include "vtkShadowVTKVersion.h"
#include "vtkVisibilityBuffer.h"

#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/type_ptr.hpp>

vtkStandardNewMacro(vtkBlurredShadowMapPass);

//------------------------------------------------------------------------------
vtkBlurredShadowMapPass::vtkBlurredShadowMapPass()
{
  for (auto& mask : this->Masks)
  {
    mask.reset(new vtkShadowTexture);
  }
  this->SetTechnique("map-blur");
}

//------------------------------------------------------------------------------
vtkBlurredShadowMapPass::~vtkBlurredShadowMapPass()
{
  this->Detach();
}

//------------------------------------------------------------------------------
bool vtkBlurredShadowMapPass::UpdateLightData(vtkShadowFrame& frame)
{
  if (!this->Superclass::UpdateLightData(frame))
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
      this->ErrorOnce("no memory for masks of the picture's size; drawn without shadows.");
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkBlurredShadowMapPass::UpdatePatterns(vtkShadowFrame& frame)
{
  // The mask is smooth over the distance of two points of the blur.
  this->Filter->SetGrid(frame.Window, 3, 1.0 / 7.0);
}

//------------------------------------------------------------------------------
std::string vtkBlurredShadowMapPass::GetKernelDefinitions()
{
  // The blur knows the share of the light above the horizon exactly; a mask would spread it.
  return this->GetText("blur") == "aware" ? "#define SHADOW_HORIZON_LATER\n" : "";
}

//------------------------------------------------------------------------------
void vtkBlurredShadowMapPass::FillVisibility(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer)
{
  if (this->Hard || !buffer.GetQuantity().empty())
  {
    this->Superclass::FillVisibility(frame, buffer); // what is told of the mask
    return;
  }
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  state->vtkglDisable(GL_DEPTH_TEST);
  for (int i = 0; i < static_cast<int>(frame.Lights.size()); ++i)
  {
    // Nothing to blur by: no size, no casters, or no width.
    const bool point = frame.Lights[i].IsPoint() || !(this->Maps->GetSeparation(i) > 0.0);
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
void vtkBlurredShadowMapPass::Blur(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int light,
  vtkShadowTexture& mask, const float step[2])
{
  const glm::vec4 eyeVC(frame.GetEyeVC());
  const glm::vec4 wRow(glm::row(frame.VCToClip, 3));
  const glm::vec3 pixelVC(frame.GetPixelVC(step[0] > 0.0f ? 0 : 1));
  std::string source = vtkBlurredShadowMapFS;
  vtkShaderProgram::Substitute(source, "//SHADOW::Declarations",
    this->GetLightsGLSL() + (this->GetText("blur") == "plain" ? "#define SHADOW_PLAIN\n" : ""));

  this->DrawQuad(source,
    [&](vtkShaderProgram* program)
    {
      buffer.GetReceivers().Activate(frame.Window);
      mask.Activate(frame.Window);
      program->SetUniformi("shadowReceivers", buffer.GetReceivers().GetUnit());
      program->SetUniformi("shadowMask", mask.GetUnit());
      program->SetUniformi("shadowLight", light);
      program->SetUniform2f("shadowStep", step);
      program->SetUniform4f("shadowEyeVC", glm::value_ptr(eyeVC));
      program->SetUniform4f("shadowWRow", glm::value_ptr(wRow));
      program->SetUniform3f("shadowPixelVC", glm::value_ptr(pixelVC));
      program->SetUniformf(
        "shadowSeparation", static_cast<float>(this->Maps->GetSeparation(light)));
      this->SetLightParameters(program);
    });
  mask.Deactivate(frame.Window);
  buffer.GetReceivers().Deactivate(frame.Window);
}

//------------------------------------------------------------------------------
void vtkBlurredShadowMapPass::ReleaseLightData(vtkRenderWindow* window)
{
  for (auto& mask : this->Masks)
  {
    mask->Release(vtkOpenGLRenderWindow::SafeDownCast(window));
  }
  this->Superclass::ReleaseLightData(window);
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::size_t>> vtkBlurredShadowMapPass::GetLightDataBytes()
{
  auto bytes = this->Superclass::GetLightDataBytes();
  bytes.emplace_back("masks", this->Masks[0]->GetBytes() + this->Masks[1]->GetBytes());
  return bytes;
}
