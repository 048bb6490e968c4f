// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowDepthPyramid.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkShadowDepthPyramidFS.h"
#include "vtkShadowDepthRangeFS.h"
#include "vtkShadowFrame.h"
#include "vtkShadowOpenGL.h"

//------------------------------------------------------------------------------
bool vtkShadowDepthPyramid::Allocate(vtkOpenGLRenderWindow* window, const vtkShadowTexture& maps)
{
  this->Resolution = maps.GetWidth();
  int side = 1;
  int levels = 1;
  for (; 2 * side < this->Resolution; side *= 2)
  {
    ++levels;
  }
  return this->Pyramid.Allocate(
    window, vtkShadowTexture::Format::Float2, side, side, maps.GetLayers(), levels);
}

//------------------------------------------------------------------------------
void vtkShadowDepthPyramid::Build(
  vtkShadowFrame& frame, const vtkShadowTexture& maps, int first, int count)
{
  if (count == 0)
  {
    return;
  }
  vtkShadowTimers::Scope timer(*frame.Timers, "pyramid");
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglColorMask colorMask(state);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  this->Maps.Activate(frame.Window, maps, vtkShadowTexture::Sampling::Nearest);
  // A texture may be read while it is drawn into, if its filter sees the base level alone and that is
  // another one than the framebuffer's. The base level is then the 0 of look-ups.
  const auto readLevel = [&](int level)
  {
    this->Pyramid.Activate(frame.Window);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BASE_LEVEL, level);
  };
  vtkShadowFramebuffer::Scope target(
    frame.Window, this->Framebuffer, &this->Pyramid, nullptr, first);
  const std::string mark = "//VTK::Output::Dec";
  std::string source = vtkShadowDepthPyramidFS;
  if (maps.GetFormat() == vtkShadowTexture::Format::Float4)
  {
    vtkShaderProgram::Substitute(source, mark, "#define SHADOW_OF_SLABS\n" + mark);
  }
  std::string firstSource = source;
  vtkShaderProgram::Substitute(firstSource, mark, "#define SHADOW_FIRST_LEVEL\n" + mark);
  for (int level = 0; level < this->Pyramid.GetLevels(); ++level)
  {
    if (level > 0)
    {
      readLevel(level - 1);
    }
    for (int layer = first; layer < first + count; ++layer)
    {
      target.SetLayer(layer, level);
      frame.Quad->Draw(frame.Window, level == 0 ? firstSource : source,
        [&](vtkShaderProgram* program)
        {
          program->SetUniformi(
            "shadowSource", level == 0 ? this->Maps.GetUnit() : this->Pyramid.GetUnit());
          program->SetUniformi("shadowLayer", layer);
        });
    }
  }
  readLevel(0);
  this->Pyramid.SetSampling(frame.Window, vtkShadowTexture::Sampling::Nearest); // of all levels
  this->Pyramid.Deactivate(frame.Window);
  this->Maps.Deactivate(frame.Window);
}

//------------------------------------------------------------------------------
std::string vtkShadowDepthPyramid::GetGLSL()
{
  return vtkShadowDepthRangeFS;
}

//------------------------------------------------------------------------------
void vtkShadowDepthPyramid::SetParameters(vtkShaderProgram* program)
{
  program->SetUniformi("shadowPyramid", this->Pyramid.GetUnit());
  program->SetUniformi("shadowPyramidResolution", this->Resolution);
}

//------------------------------------------------------------------------------
void vtkShadowDepthPyramid::Release(vtkOpenGLRenderWindow* window)
{
  this->Pyramid.Release(window);
  this->Maps.Release(window);
  this->Framebuffer.Release(window);
}
