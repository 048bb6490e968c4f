// SPDX-License-Identifier: BSD-3-Clause
// The depth pyramid: every level is what the maps' texels say; and no technique reads the image that it
// draws into, which OpenGL leaves undefined.

#include "ShadowStage.h"
#include "ShadowTest.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShadowDepthPyramid.h"
#include "vtkShadowFrame.h"
#include "vtkShadowGL.h"
#include "vtkShadowOpenGL.h"

#include <algorithm>
#include <cmath>
#include <dlfcn.h>

namespace
{
bool Watching = false;
int Watched = 0; // draws that read textures
int Loops = 0;   // of them, into what they read

/** The rule of OpenGL 3.2, section 4.4.3: by the level that is attached, filter and base level. */
bool Reads(GLint texture, GLint level, GLenum target, GLenum binding)
{
  GLint bound = 0;
  glGetIntegerv(binding, &bound);
  if (bound != texture)
  {
    return false;
  }
  GLint filter = 0;
  GLint base = 0;
  GLint last = 0;
  glGetTexParameteriv(target, GL_TEXTURE_MIN_FILTER, &filter);
  glGetTexParameteriv(target, GL_TEXTURE_BASE_LEVEL, &base);
  glGetTexParameteriv(target, GL_TEXTURE_MAX_LEVEL, &last);
  const bool one = filter == GL_NEAREST || filter == GL_LINEAR;
  return one ? level == base : level >= base && level <= last;
}

/** Before a draw: whether a sampler of the program sees what is attached to the framebuffer. */
void Watch()
{
  GLint framebuffer = 0;
  GLint program = 0;
  GLint active = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &framebuffer);
  glGetIntegerv(GL_CURRENT_PROGRAM, &program);
  glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
  if (framebuffer == 0 || program == 0)
  {
    return;
  }
  GLint uniforms = 0;
  glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &uniforms);
  bool reads = false;
  for (GLint i = 0; i < uniforms; ++i)
  {
    char name[256];
    GLint size = 0;
    GLenum type = 0;
    glGetActiveUniform(program, i, sizeof(name), nullptr, &size, &type, name);
    const bool array = type == GL_SAMPLER_2D_ARRAY || type == GL_SAMPLER_2D_ARRAY_SHADOW;
    if (!array && type != GL_SAMPLER_2D && type != GL_SAMPLER_2D_SHADOW)
    {
      continue;
    }
    reads = true;
    GLint unit = 0;
    glGetUniformiv(program, glGetUniformLocation(program, name), &unit);
    glActiveTexture(GL_TEXTURE0 + unit);
    for (const GLenum point : { GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT, GL_STENCIL_ATTACHMENT })
    {
      GLint kind = 0;
      GLint texture = 0;
      GLint level = 0;
      glGetFramebufferAttachmentParameteriv(
        GL_DRAW_FRAMEBUFFER, point, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, &kind);
      if (kind != GL_TEXTURE)
      {
        continue;
      }
      glGetFramebufferAttachmentParameteriv(
        GL_DRAW_FRAMEBUFFER, point, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, &texture);
      glGetFramebufferAttachmentParameteriv(
        GL_DRAW_FRAMEBUFFER, point, GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL, &level);
      Loops += array ? Reads(texture, level, GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY)
                     : Reads(texture, level, GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D);
    }
  }
  Watched += reads;
  glActiveTexture(active);
}

#ifdef glDrawArrays
// With glad it is a pointer, which each new window sets to OpenGL's again.
PFNGLDRAWARRAYSPROC DrawArrays = nullptr;

void GLAPIENTRY WatchDrawArrays(GLenum mode, GLint first, GLsizei count)
{
  if (Watching)
  {
    Watch();
  }
  DrawArrays(mode, first, count);
}

void UseWatch()
{
  if (glDrawArrays != WatchDrawArrays)
  {
    DrawArrays = glDrawArrays;
    glDrawArrays = WatchDrawArrays;
  }
}
#else
void UseWatch() {}
#endif
}

#ifndef glDrawArrays
/** In the place of OpenGL's, for all libraries of this program. */
extern "C" __attribute__((visibility("default"))) void glDrawArrays(
  GLenum mode, GLint first, GLsizei count)
{
  using Function = void (*)(GLenum, GLint, GLsizei);
  static const auto original = reinterpret_cast<Function>(dlsym(RTLD_NEXT, "glDrawArrays"));
  if (Watching)
  {
    Watch();
  }
  original(mode, first, count);
}
#endif

//------------------------------------------------------------------------------
// Whatever a technique draws over the whole of a picture or map, it reads from elsewhere.
SHADOW_TEST(Pyramid, NothingIsReadThatIsDrawnInto, Each)
{
  ShadowStage stage;
  stage.AddThings();
  stage.AddLight(
    ShadowStage::Supports(technique, LightKind::Sphere) ? LightKind::Sphere : LightKind::Point);
  stage.SetPass(technique);
  stage.Window->Render(); // so that there is a context
  UseWatch();
  stage.SetPass(technique, { { "resolution", "300" } });
  Watched = Loops = 0;
  Watching = true;
  stage.Render();
  stage.GetVisibility();
  Watching = false;
  if (technique != "ray-traced") // which uploads
  {
    ShadowTest::CheckAtLeast(Watched, 1.0, "draws that read textures");
  }
  ShadowTest::CheckEqual(Loops, 0.0, "of them, into what they read");
}

//------------------------------------------------------------------------------
// Least and greatest depth of every level and layer, as added up here; layers that were not asked for
// stay; afterwards look-ups see all levels again.
SHADOW_TEST(Pyramid, LevelsHoldTheRange, Once)
{
  ShadowStage stage;
  stage.AddThings();
  stage.Render();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(stage.Window);
  window->MakeCurrent();
  vtkShadowQuad quad;
  vtkShadowTimers timers;
  vtkShadowFrame frame;
  frame.Window = window;
  frame.Quad = &quad;
  frame.Timers = &timers;
  constexpr int layers = 3;
  for (const int side : { 1, 2, 3, 4, 16, 37, 64, 100 })
  {
    const std::string what = std::to_string(side) + " texels a side: ";
    vtkShadowTexture maps;
    vtkShadowDepthPyramid pyramid;
    // The pyramid's texture is its own: it is the one that comes into being.
    std::vector<GLboolean> before;
    ShadowTest::Check(
      maps.Allocate(window, vtkShadowTexture::Format::Float1, side, side, layers), what + "maps");
    for (GLuint name = 0; name < 4096; ++name)
    {
      before.push_back(glIsTexture(name));
    }
    ShadowTest::Check(pyramid.Allocate(window, maps), what + "pyramid");
    GLuint texture = 0;
    for (GLuint name = 1; name < before.size(); ++name)
    {
      texture = glIsTexture(name) && !before[name] ? name : texture;
    }
    std::vector<std::vector<float>> depths(layers);
    for (int layer = 0; layer < layers; ++layer)
    {
      for (int i = 0; i < side * side; ++i)
      {
        const double x = 12.9898 * (i % side) + 78.233 * (i / side) + 37.7 * layer;
        depths[layer].push_back(static_cast<float>(0.5 + 0.5 * std::sin(x * x)));
      }
      maps.UploadLayer(window, layer, depths[layer].data());
    }
    pyramid.Build(frame, maps, 0, layers);
    // Of the middle one once more, with other depths.
    std::reverse(depths[1].begin(), depths[1].end());
    maps.UploadLayer(window, 1, depths[1].data());
    pyramid.Build(frame, maps, 1, 1);

    window->GetState()->vtkglActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
    GLint base = -1;
    GLint filter = 0;
    glGetTexParameteriv(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BASE_LEVEL, &base);
    glGetTexParameteriv(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, &filter);
    ShadowTest::CheckEqual(base, 0.0, what + "base level");
    int wrong = 0;
    int level = 0;
    for (GLint width = 0; level < 16; ++level)
    {
      glGetTexLevelParameteriv(GL_TEXTURE_2D_ARRAY, level, GL_TEXTURE_WIDTH, &width);
      if (width == 0)
      {
        break;
      }
      std::vector<float> ranges(2 * width * width * layers);
      glGetTexImage(GL_TEXTURE_2D_ARRAY, level, GL_RG, GL_FLOAT, ranges.data());
      const int cell = 2 << level;
      for (int i = 0; i < width * width * layers; ++i)
      {
        const int layer = i / (width * width);
        float low = 2.0f;
        float high = -1.0f;
        // Beyond the border are its texels again.
        for (int y = 0; y < cell; ++y)
        {
          for (int x = 0; x < cell; ++x)
          {
            const int column = std::min((i % width) * cell + x, side - 1);
            const int row = std::min((i / width % width) * cell + y, side - 1);
            const float depth = depths[layer][row * side + column];
            low = std::min(low, depth);
            high = std::max(high, depth);
          }
        }
        wrong += ranges[2 * i] != low || ranges[2 * i + 1] != high;
      }
    }
    ShadowTest::CheckAtLeast(2 << (level - 1), side, what + "texels under the last level");
    ShadowTest::CheckEqual(
      filter, level > 1 ? GL_NEAREST_MIPMAP_NEAREST : GL_NEAREST, what + "filter");
    ShadowTest::CheckEqual(wrong, 0.0, what + "wrong cells");
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    pyramid.Release(window);
    maps.Release(window);
  }
  quad.Release();
  timers.Release();
}
