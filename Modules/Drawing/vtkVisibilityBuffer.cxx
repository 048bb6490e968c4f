// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVisibilityBuffer.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkShadowAccumulateFS.h"
#include "vtkShadowFrame.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowResolveFS.h"

//------------------------------------------------------------------------------
bool vtkVisibilityBuffer::Allocate(
  vtkOpenGLRenderWindow* window, vtkShadowReceivers& receivers, int lights, bool color)
{
  using Format = vtkShadowTexture::Format;
  this->Receivers = &receivers;
  this->Color = color;
  return this->Visibility.Allocate(window, color ? Format::Float4 : Format::Float1,
    receivers.GetWidth(), receivers.GetHeight(), lights);
}

//------------------------------------------------------------------------------
void vtkVisibilityBuffer::SetQuantity(vtkOpenGLRenderWindow* window, const std::string& name)
{
  this->Quantity = name;
  if (!name.empty())
  {
    this->Quantities.Allocate(window, vtkShadowTexture::Format::Float1, this->GetWidth(),
      this->GetHeight(), this->Visibility.GetLayers());
  }
}

//------------------------------------------------------------------------------
void vtkVisibilityBuffer::Clear(vtkShadowFrame& frame)
{
  const float full = this->Quantity.empty() ? 1.0f : 0.0f;
  const float value[4] = { full, full, full, full };
  vtkShadowFramebuffer::Scope target(
    frame.Window, this->Framebuffer, &this->GetTarget(), nullptr, 0);
  for (int i = 0; i < static_cast<int>(frame.Parts.size()); ++i)
  {
    target.SetLayer(i);
    glClearBufferfv(GL_COLOR, 0, value);
  }
}

//------------------------------------------------------------------------------
void vtkVisibilityBuffer::Resolve(vtkShadowFrame& frame)
{
  if (!this->Quantity.empty())
  {
    return; // what is counted needs no bounds
  }
  // In place, by blending: the least of the sum and what is seen at most, then the greatest of that and
  // what is seen at least. Float targets are not clamped by themselves.
  std::string source = vtkShadowResolveFS;
  vtkShaderProgram::Substitute(
    source, "//SHADOW::Declarations", frame.GetLightsGLSL() + vtkShadowReceivers::GetGLSL());
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction(state);
  vtkShadowFramebuffer::Scope target(
    frame.Window, this->Framebuffer, &this->Visibility, nullptr, 0);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  vtkShadowTexture& receivers = this->Receivers->GetTexture();
  receivers.Activate(frame.Window);
  for (int i = 0; i < static_cast<int>(frame.Parts.size()); ++i)
  {
    target.SetLayer(i);
    for (const bool most : { true, false })
    {
      state->vtkglBlendEquation(most ? GL_MIN : GL_MAX);
      frame.Quad->Draw(frame.Window, source,
        [&](vtkShaderProgram* program)
        {
          program->SetUniformi("shadowReceivers", receivers.GetUnit());
          program->SetUniformi("shadowLight", i);
          program->SetUniformi("shadowMost", most);
          frame.SetLights(program);
        });
    }
  }
  state->vtkglBlendEquation(GL_FUNC_ADD);
  receivers.Deactivate(frame.Window);
}

//------------------------------------------------------------------------------
bool vtkVisibilityBuffer::Accumulate(vtkShadowFrame& frame, int before)
{
  vtkShadowTexture& visibility = this->Visibility;
  if (!this->Mean.Allocate(frame.Window,
        this->Color ? vtkShadowTexture::Format::Float4 : vtkShadowTexture::Format::Float1,
        visibility.GetWidth(), visibility.GetHeight(), visibility.GetLayers()))
  {
    return false;
  }
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction(state);
  vtkShadowFramebuffer::Scope target(frame.Window, this->Framebuffer, &this->Mean, nullptr, 0);
  state->vtkglDisable(GL_DEPTH_TEST);
  if (before > 0)
  {
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ZERO);
  }
  visibility.Activate(frame.Window);
  for (int i = 0; i < static_cast<int>(frame.Parts.size()); ++i)
  {
    target.SetLayer(i);
    frame.Quad->Draw(frame.Window, vtkShadowAccumulateFS,
      [&](vtkShaderProgram* program)
      {
        program->SetUniformi("shadowBuffer", visibility.GetUnit());
        program->SetUniformi("shadowLayer", i);
        program->SetUniformf("shadowShare", 1.0f / static_cast<float>(before + 1));
      });
  }
  visibility.Deactivate(frame.Window);
  this->ShowsMean = true;
  return true;
}

//------------------------------------------------------------------------------
void vtkVisibilityBuffer::ForgetMean(vtkOpenGLRenderWindow* window)
{
  this->ShowsMean = false;
  this->Mean.Release(window);
}

//------------------------------------------------------------------------------
std::vector<float> vtkVisibilityBuffer::ReadTarget(vtkOpenGLRenderWindow* window, int part)
{
  return this->Read(window, this->GetTarget(), part);
}

//------------------------------------------------------------------------------
std::vector<float> vtkVisibilityBuffer::ReadShown(vtkOpenGLRenderWindow* window, int part)
{
  return this->Read(window, this->GetShown(), part);
}

//------------------------------------------------------------------------------
std::vector<float> vtkVisibilityBuffer::Read(
  vtkOpenGLRenderWindow* window, vtkShadowTexture& texture, int part)
{
  const int components = this->Quantity.empty() ? this->GetComponents() : 1;
  std::vector<float> values(
    static_cast<std::size_t>(components) * this->GetWidth() * this->GetHeight());
  this->Framebuffer.Read(window, texture, part, values.data());
  return values;
}

//------------------------------------------------------------------------------
void vtkVisibilityBuffer::Release(vtkOpenGLRenderWindow* window)
{
  this->Visibility.Release(window);
  this->ForgetMean(window);
  this->Quantities.Release(window);
  this->Framebuffer.Release(window);
}
