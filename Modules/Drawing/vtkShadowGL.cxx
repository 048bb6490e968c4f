// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowQuadVS.h"
#include "vtkShadowShaderFiles.h"
#include "vtkTextureUnitManager.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace
{
struct Layout
{
  GLint Internal;
  GLenum External;
  GLenum Type;
  std::size_t Size; // bytes
};

/** In the order of vtkShadowTexture::Format. */
const Layout& GetLayout(vtkShadowTexture::Format format)
{
  static constexpr Layout layouts[] = { { GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, 4 },
    { GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, 4 },
    { GL_DEPTH32F_STENCIL8, GL_DEPTH_STENCIL, GL_FLOAT_32_UNSIGNED_INT_24_8_REV, 8 },
    { GL_R32F, GL_RED, GL_FLOAT, 4 }, { GL_RG32F, GL_RG, GL_FLOAT, 8 },
    { GL_RGBA32F, GL_RGBA, GL_FLOAT, 16 }, { GL_R8, GL_RED, GL_UNSIGNED_BYTE, 1 },
    { GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 4 }, { GL_R16F, GL_RED, GL_HALF_FLOAT, 2 },
    { GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT, 8 }, { GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, 4 },
    { GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT, 16 } };
  return layouts[static_cast<int>(format)];
}

bool IsInteger(vtkShadowTexture::Format format)
{
  return GetLayout(format).Type == GL_UNSIGNED_INT;
}
}

//------------------------------------------------------------------------------
bool vtkShadowTexture::Allocate(
  vtkOpenGLRenderWindow* window, Format format, int width, int height, int layers, int levels)
{
  if (this->Handle && this->TexelFormat == format && this->Width == width &&
      this->Height == height && this->Layers == layers && this->Levels == levels)
  {
    return true;
  }
  this->Release(window);
  this->Target = GL_TEXTURE_2D_ARRAY;
  this->TexelFormat = format;
  this->Width = width;
  this->Height = height;
  this->Layers = layers;
  this->Levels = levels;
  ++this->Generation;
  glGenTextures(1, &this->Handle);
  this->Activate(window);
  const Layout& layout = GetLayout(format);
  while (glGetError() != GL_NO_ERROR)
  {
  }
  this->Bytes = 0;
  // First, so that drivers need not guess how many there will be.
  glTexParameteri(this->Target, GL_TEXTURE_MAX_LEVEL, levels - 1);
  // All levels at once, where that can be: of others a driver may copy all when the base level changes.
  const bool storage = VTK_SHADOW_HAS_GL(ARB_texture_storage) || VTK_SHADOW_HAS_GL(VERSION_4_2);
  if (storage)
  {
    glTexStorage3D(this->Target, levels, layout.Internal, width, height, layers);
  }
  for (int level = 0; level < levels; ++level)
  {
    const int levelWidth = std::max(1, width >> level);
    const int levelHeight = std::max(1, height >> level);
    if (!storage)
    {
      glTexImage3D(this->Target, level, layout.Internal, levelWidth, levelHeight, layers, 0,
        layout.External, layout.Type, nullptr);
    }
    this->Bytes += layout.Size * levelWidth * levelHeight * layers;
  }
  const bool made = glGetError() == GL_NO_ERROR;
  glTexParameteri(this->Target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(this->Target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  this->SetSampling(window, Sampling::Nearest);
  this->Deactivate(window);
  if (!made)
  {
    this->Release(window);
  }
  return made;
}

//------------------------------------------------------------------------------
void vtkShadowTexture::SetSampling(vtkOpenGLRenderWindow* window, Sampling sampling)
{
  const bool active = this->Unit >= 0;
  this->Activate(window);
  const bool linear = sampling == Sampling::CompareLinear || sampling == Sampling::Linear;
  const bool compare = sampling == Sampling::CompareLinear || sampling == Sampling::CompareNearest;
  const GLint nearest = this->Levels > 1 ? GL_NEAREST_MIPMAP_NEAREST : GL_NEAREST;
  const GLint between = this->Levels > 1 ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR;
  glTexParameteri(this->Target, GL_TEXTURE_MIN_FILTER, linear ? between : nearest);
  glTexParameteri(this->Target, GL_TEXTURE_MAG_FILTER, linear ? GL_LINEAR : GL_NEAREST);
  if (this->TexelFormat == Format::Depth)
  {
    glTexParameteri(
      this->Target, GL_TEXTURE_COMPARE_MODE, compare ? GL_COMPARE_REF_TO_TEXTURE : GL_NONE);
    glTexParameteri(this->Target, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  }
  if (!active)
  {
    this->Deactivate(window);
  }
}

//------------------------------------------------------------------------------
void vtkShadowTexture::UploadBuffer(
  vtkOpenGLRenderWindow* window, const std::vector<glm::vec4>& texels)
{
  this->Target = GL_TEXTURE_BUFFER;
  if (!this->Buffer)
  {
    glGenBuffers(1, &this->Buffer);
    glGenTextures(1, &this->Handle);
  }
  this->Bytes = texels.size() * sizeof(glm::vec4);
  glBindBuffer(GL_TEXTURE_BUFFER, this->Buffer);
  glBufferData(
    GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(this->Bytes), texels.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_TEXTURE_BUFFER, 0);
  const bool active = this->Unit >= 0;
  this->Activate(window);
  glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, this->Buffer);
  if (!active)
  {
    this->Deactivate(window);
  }
}

//------------------------------------------------------------------------------
void vtkShadowTexture::UploadLayer(vtkOpenGLRenderWindow* window, int layer, const float* values)
{
  if (IsInteger(this->TexelFormat))
  {
    throw std::logic_error("vtkShadowTexture::UploadLayer: floats cannot become integers");
  }
  const bool active = this->Unit >= 0;
  this->Activate(window);
  window->GetState()->vtkglPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexSubImage3D(this->Target, 0, 0, 0, layer, this->Width, this->Height, 1,
    GetLayout(this->TexelFormat).External, GL_FLOAT, values);
  if (!active)
  {
    this->Deactivate(window);
  }
}

//------------------------------------------------------------------------------
void vtkShadowTexture::MakeLevels(vtkOpenGLRenderWindow* window)
{
  const bool active = this->Unit >= 0;
  this->Activate(window);
  glGenerateMipmap(this->Target);
  if (!active)
  {
    this->Deactivate(window);
  }
}

//------------------------------------------------------------------------------
void vtkShadowTexture::Activate(vtkOpenGLRenderWindow* window)
{
  if (this->Unit < 0)
  {
    this->Unit = window->GetTextureUnitManager()->Allocate();
  }
  window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + this->Unit);
  glBindTexture(this->Target, this->Handle);
}

//------------------------------------------------------------------------------
void vtkShadowTexture::Deactivate(vtkOpenGLRenderWindow* window)
{
  if (this->Unit >= 0)
  {
    window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + this->Unit);
    glBindTexture(this->Target, 0);
    window->GetTextureUnitManager()->Free(this->Unit);
    this->Unit = -1;
  }
}

//------------------------------------------------------------------------------
void vtkShadowTexture::Release(vtkOpenGLRenderWindow* window)
{
  if (this->Handle)
  {
    this->Deactivate(window);
    glDeleteTextures(1, &this->Handle);
    this->Handle = 0;
  }
  if (this->Buffer)
  {
    glDeleteBuffers(1, &this->Buffer);
    this->Buffer = 0;
  }
  this->Width = this->Height = this->Layers = this->Levels = 0;
  this->Bytes = 0;
}

//------------------------------------------------------------------------------
void vtkShadowSampler::Activate(vtkOpenGLRenderWindow* window, const vtkShadowTexture& texture,
  vtkShadowTexture::Sampling sampling)
{
  if (this->Unit < 0)
  {
    this->Unit = window->GetTextureUnitManager()->Allocate();
  }
  if (!this->Handle)
  {
    glGenSamplers(1, &this->Handle);
    glSamplerParameteri(this->Handle, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glSamplerParameteri(this->Handle, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  }
  using Sampling = vtkShadowTexture::Sampling;
  const GLint filter = sampling == Sampling::CompareLinear ? GL_LINEAR : GL_NEAREST;
  glSamplerParameteri(this->Handle, GL_TEXTURE_MIN_FILTER, filter);
  glSamplerParameteri(this->Handle, GL_TEXTURE_MAG_FILTER, filter);
  glSamplerParameteri(this->Handle, GL_TEXTURE_COMPARE_MODE,
    sampling == Sampling::Nearest ? GL_NONE : GL_COMPARE_REF_TO_TEXTURE);
  glSamplerParameteri(this->Handle, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + this->Unit);
  glBindTexture(GL_TEXTURE_2D_ARRAY, texture.GetHandle());
  glBindSampler(this->Unit, this->Handle);
}

//------------------------------------------------------------------------------
void vtkShadowSampler::Deactivate(vtkOpenGLRenderWindow* window)
{
  if (this->Unit >= 0)
  {
    window->GetState()->vtkglActiveTexture(GL_TEXTURE0 + this->Unit);
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    glBindSampler(this->Unit, 0);
    window->GetTextureUnitManager()->Free(this->Unit);
    this->Unit = -1;
  }
}

//------------------------------------------------------------------------------
void vtkShadowSampler::Release(vtkOpenGLRenderWindow* window)
{
  this->Deactivate(window);
  if (this->Handle)
  {
    glDeleteSamplers(1, &this->Handle);
    this->Handle = 0;
  }
}

//------------------------------------------------------------------------------
void vtkShadowQuad::Draw(vtkOpenGLRenderWindow* window, const std::string& fragmentShader,
  const std::function<void(vtkShaderProgram*)>& setParameters)
{
  vtkShaderProgram* program =
    window->GetShaderCache()->ReadyShaderProgram(vtkShadowQuadVS, fragmentShader.c_str(), "");
  if (!program)
  {
    return; // the shader cache has reported why
  }
  vtkShadowShaderFiles::Write(program, "screen");
  setParameters(program);
  if (!this->VertexArray)
  {
    glGenVertexArrays(1, &this->VertexArray);
  }
  glBindVertexArray(this->VertexArray);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
}

//------------------------------------------------------------------------------
void vtkShadowQuad::Release()
{
  glDeleteVertexArrays(1, &this->VertexArray); // 0 is no error
  this->VertexArray = 0;
}

//------------------------------------------------------------------------------
vtkShadowFramebuffer::Scope::Scope(vtkOpenGLRenderWindow* window, vtkShadowFramebuffer& framebuffer,
  const vtkShadowTexture* color, const vtkShadowTexture* depth, int layer)
  : Scope(window, framebuffer,
      color ? std::vector<const vtkShadowTexture*>{ color }
            : std::vector<const vtkShadowTexture*>(),
      depth, layer)
{
}

//------------------------------------------------------------------------------
vtkShadowFramebuffer::Scope::Scope(vtkOpenGLRenderWindow* window, vtkShadowFramebuffer& framebuffer,
  std::vector<const vtkShadowTexture*> colors, const vtkShadowTexture* depth, int layer)
  : Window(window)
  , Colors(std::move(colors))
  , Depth(depth)
{
  vtkOpenGLState* state = window->GetState();
  state->vtkglGetIntegerv(GL_VIEWPORT, this->Viewport);
  state->vtkglGetIntegerv(GL_SCISSOR_BOX, this->Scissor);
  this->ScissorTest = state->GetEnumState(GL_SCISSOR_TEST);
  this->Blend = state->GetEnumState(GL_BLEND);
  state->PushFramebufferBindings();
  if (!framebuffer.Handle)
  {
    glGenFramebuffers(1, &framebuffer.Handle);
  }
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, framebuffer.Handle);
  const auto count = static_cast<unsigned int>(this->Colors.size());
  for (unsigned int i = std::max(1u, count); i < framebuffer.Attached; ++i)
  {
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + i, GL_TEXTURE_2D, 0, 0);
  }
  this->SetLayer(layer);
  const GLenum first = count > 0 ? GL_COLOR_ATTACHMENT0 : GL_NONE;
  // VTK's cache knows the first buffer of a framebuffer alone: the others are told to OpenGL directly.
  state->vtkglDrawBuffer(first);
  if (count > 1 || framebuffer.Attached > 1)
  {
    std::vector<GLenum> buffers(std::max(1u, count), first);
    std::iota(buffers.begin(), buffers.end(), first);
    glDrawBuffers(static_cast<GLsizei>(buffers.size()), buffers.data());
  }
  framebuffer.Attached = count;
  state->vtkglReadBuffer(first);
  state->vtkglDisable(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_BLEND);
}

//------------------------------------------------------------------------------
void vtkShadowFramebuffer::Scope::SetLayer(int layer, int level)
{
  this->Window->GetState()->vtkglDisable(GL_SCISSOR_TEST);
  for (std::size_t i = 0; i < this->Colors.size(); ++i)
  {
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i),
      this->Colors[i]->GetHandle(), level, layer);
  }
  if (this->Colors.empty())
  {
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, 0, 0);
  }
  const unsigned int depth = this->Depth ? this->Depth->GetHandle() : 0;
  // With a colour attachment, depth is a helper of one layer.
  const int depthLayer = this->Colors.empty() ? layer : 0;
  for (const GLenum attachment : { GL_DEPTH_ATTACHMENT, GL_STENCIL_ATTACHMENT })
  {
    const bool has =
      attachment == GL_DEPTH_ATTACHMENT ? depth != 0 : this->Depth && this->Depth->HasStencil();
    if (has)
    {
      glFramebufferTextureLayer(GL_FRAMEBUFFER, attachment, depth, 0, depthLayer);
    }
    else
    {
      glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, 0, 0);
    }
  }
  const vtkShadowTexture* texture = this->Colors.empty() ? this->Depth : this->Colors.front();
  this->Window->GetState()->vtkglViewport(
    0, 0, std::max(1, texture->GetWidth() >> level), std::max(1, texture->GetHeight() >> level));
}

//------------------------------------------------------------------------------
void vtkShadowFramebuffer::Scope::SetRectangle(int x, int y, int width, int height)
{
  vtkOpenGLState* state = this->Window->GetState();
  state->vtkglViewport(x, y, width, height);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(x, y, width, height);
}

//------------------------------------------------------------------------------
vtkShadowFramebuffer::Scope::~Scope()
{
  vtkOpenGLState* state = this->Window->GetState();
  state->PopFramebufferBindings();
  state->vtkglViewport(this->Viewport[0], this->Viewport[1], this->Viewport[2], this->Viewport[3]);
  state->vtkglScissor(this->Scissor[0], this->Scissor[1], this->Scissor[2], this->Scissor[3]);
  state->SetEnumState(GL_SCISSOR_TEST, this->ScissorTest);
  state->SetEnumState(GL_BLEND, this->Blend);
}

//------------------------------------------------------------------------------
void vtkShadowFramebuffer::Read(
  vtkOpenGLRenderWindow* window, const vtkShadowTexture& texture, int layer, float* values)
{
  if (IsInteger(texture.GetFormat()))
  {
    throw std::logic_error("vtkShadowFramebuffer::Read: integers are not read as floats");
  }
  Scope scope(window, *this, &texture, nullptr, layer);
  window->GetState()->vtkglPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, texture.GetWidth(), texture.GetHeight(),
    GetLayout(texture.GetFormat()).External, GL_FLOAT, values);
}

//------------------------------------------------------------------------------
void vtkShadowFramebuffer::Release(vtkOpenGLRenderWindow*)
{
  if (this->Handle)
  {
    glDeleteFramebuffers(1, &this->Handle);
    this->Handle = this->Attached = 0;
  }
}

//------------------------------------------------------------------------------
void vtkShadowTimers::StartFrame()
{
  for (const auto& span : this->Spans)
  {
    this->Free.insert(this->Free.end(), span.Queries, span.Queries + 2);
  }
  this->Spans.clear();
  this->Milliseconds.clear();
}

//------------------------------------------------------------------------------
const std::map<std::string, double>& vtkShadowTimers::GetMilliseconds()
{
  if (this->Milliseconds.empty())
  {
    for (const auto& span : this->Spans)
    {
      GLuint64 times[2];
      glGetQueryObjectui64v(span.Queries[0], GL_QUERY_RESULT, &times[0]);
      glGetQueryObjectui64v(span.Queries[1], GL_QUERY_RESULT, &times[1]);
      this->Milliseconds[span.Stage] += 1e-6 * static_cast<double>(times[1] - times[0]);
    }
  }
  return this->Milliseconds;
}

//------------------------------------------------------------------------------
void vtkShadowTimers::Release()
{
  this->GetMilliseconds(); // the last figures stay readable
  const auto last = this->Milliseconds;
  this->StartFrame();
  if (!this->Free.empty())
  {
    glDeleteQueries(static_cast<GLsizei>(this->Free.size()), this->Free.data());
    this->Free.clear();
  }
  this->Milliseconds = last;
}

//------------------------------------------------------------------------------
vtkShadowTimers::Scope::Scope(vtkShadowTimers& timers, const char* stage)
  : Timers(timers)
  , Index(timers.Spans.size())
{
  if (!VTK_SHADOW_HAS_GL(VERSION_3_3) && !VTK_SHADOW_HAS_GL(ARB_timer_query))
  {
    return; // no times then
  }
  if (timers.Free.size() < 2)
  {
    timers.Free.resize(2);
    glGenQueries(2, timers.Free.data());
  }
  Span span{ stage, { timers.Free.back(), timers.Free[timers.Free.size() - 2] } };
  timers.Free.resize(timers.Free.size() - 2);
  glQueryCounter(span.Queries[0], GL_TIMESTAMP);
  timers.Spans.push_back(span);
}

//------------------------------------------------------------------------------
vtkShadowTimers::Scope::~Scope()
{
  if (this->Index < this->Timers.Spans.size())
  {
    glQueryCounter(this->Timers.Spans[this->Index].Queries[1], GL_TIMESTAMP);
  }
}
