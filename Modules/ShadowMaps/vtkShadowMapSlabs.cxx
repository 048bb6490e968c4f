// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowMapSlabs.h"

#include "vtkLightFrusta.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkShadowCasterDrawing.h"
#include "vtkShadowCasters.h"
#include "vtkShadowFrame.h"
#include "vtkShadowMapSlabFS.h"
#include "vtkShadowMapSlabsFS.h"
#include "vtkShadowOpenGL.h"

//------------------------------------------------------------------------------
bool vtkShadowMapSlabs::Allocate(vtkOpenGLRenderWindow* window, const vtkShadowTexture& maps)
{
  using Format = vtkShadowTexture::Format;
  const int side = maps.GetWidth();
  return this->Slabs.Allocate(window, Format::Float4, side, side, maps.GetLayers()) &&
         this->First.Allocate(window, Format::Float4, side, side, 1) &&
         this->Second.Allocate(window, Format::Depth, side, side, 1);
}

//------------------------------------------------------------------------------
void vtkShadowMapSlabs::Draw(vtkShadowFrame& frame, const vtkLightView& view,
  const vtkShadowTexture& maps, int layer, const std::function<void()>& clear)
{
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglColorMask colorMask(state);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  vtkShadowCasterDraw how;
  how.FragmentShader = vtkShadowMapSlabFS;
  how.SetCasterParameters = [&frame](vtkShaderProgram* program, const vtkShadowCaster& caster)
  {
    // 0 is for sheets, which have no other side.
    const auto number = static_cast<float>(&caster - frame.Casters->Get().data() + 1);
    program->SetUniformf("shadowCaster", caster.Mesh->Sheet ? 0.0f : number);
  };
  {
    vtkShadowFramebuffer::Scope target(frame.Window, this->Framebuffer, &this->First, &maps, 0);
    // Of the two only the maps have this layer.
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, maps.GetHandle(), 0, layer);
    clear();
    frame.Drawing->Draw(frame.Window, view.SWCToClip, view.Casters, how);
    state->vtkglDisable(GL_SCISSOR_TEST);
  }
  this->Maps.Activate(frame.Window, maps, vtkShadowTexture::Sampling::Nearest);
  this->First.Activate(frame.Window);
  const auto setTextures = [&](vtkShaderProgram* program)
  {
    program->SetUniformi("shadowFirstDepth", this->Maps.GetUnit());
    program->SetUniformi("shadowFirst", this->First.GetUnit());
    program->SetUniformi("shadowLayer", layer);
  };
  {
    vtkShadowFramebuffer::Scope target(frame.Window, this->Framebuffer, nullptr, &this->Second, 0);
    clear();
    how.Definitions = "#define SHADOW_SECOND\n";
    how.SetParameters = setTextures;
    frame.Drawing->Draw(frame.Window, view.SWCToClip, view.Casters, how);
    state->vtkglDisable(GL_SCISSOR_TEST);
  }
  this->Second.Activate(frame.Window);
  {
    vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
    state->vtkglDisable(GL_DEPTH_TEST);
    vtkShadowFramebuffer::Scope target(
      frame.Window, this->Framebuffer, &this->Slabs, nullptr, layer);
    frame.Quad->Draw(frame.Window, vtkShadowMapSlabsFS,
      [&](vtkShaderProgram* program)
      {
        setTextures(program);
        program->SetUniformi("shadowSecondDepth", this->Second.GetUnit());
      });
  }
  this->Second.Deactivate(frame.Window);
  this->First.Deactivate(frame.Window);
  this->Maps.Deactivate(frame.Window);
}

//------------------------------------------------------------------------------
void vtkShadowMapSlabs::SetParameters(vtkShaderProgram* program)
{
  program->SetUniformi("shadowSlabs", this->Slabs.GetUnit());
}

//------------------------------------------------------------------------------
void vtkShadowMapSlabs::Release(vtkOpenGLRenderWindow* window)
{
  this->Slabs.Release(window);
  this->First.Release(window);
  this->Second.Release(window);
  this->Maps.Release(window);
  this->Framebuffer.Release(window);
}
