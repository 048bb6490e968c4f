// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowTiles.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkShadowFrame.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowReceivers.h"
#include "vtkShadowTilesFS.h"

#include <string>

//------------------------------------------------------------------------------
bool vtkShadowTiles::Update(vtkShadowFrame& frame, vtkShadowReceivers& receivers)
{
  using Format = vtkShadowTexture::Format;
  const int width = (receivers.GetWidth() + Side - 1) / Side;
  const int height = (receivers.GetHeight() + Side - 1) / Side;
  for (vtkShadowTexture* texture : { &this->Low, &this->High })
  {
    if (!texture->Allocate(frame.Window, Format::Float4, width, height, 1))
    {
      return false;
    }
  }
  std::string source = vtkShadowTilesFS;
  vtkShaderProgram::Substitute(source, "//SHADOW::Declarations",
    "#define SHADOW_TILE " + std::to_string(Side) + "\n" + vtkShadowReceivers::GetGLSL());
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  state->vtkglDisable(GL_DEPTH_TEST);
  vtkShadowFramebuffer::Scope target(
    frame.Window, this->Framebuffer, { &this->Low, &this->High }, nullptr, 0);
  vtkShadowTexture& texture = receivers.GetTexture();
  texture.Activate(frame.Window);
  frame.Quad->Draw(frame.Window, source,
    [&texture](vtkShaderProgram* program)
    { program->SetUniformi("shadowReceivers", texture.GetUnit()); });
  texture.Deactivate(frame.Window);
  return true;
}

//------------------------------------------------------------------------------
void vtkShadowTiles::Release(vtkOpenGLRenderWindow* window)
{
  this->Low.Release(window);
  this->High.Release(window);
  this->Framebuffer.Release(window);
}
