#include "vtkVisibilityBuffer.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShadowVTKVersion.h"

//------------------------------------------------------------------------------
bool vtkVisibilityBuffer::Allocate(
  vtkOpenGLRenderWindow* window, int width, int height, int lights, bool color)
{
  using Format = vtkShadowTexture::Format;
  this->Color = color;
  return this->Receivers.Allocate(window, Format::Float4, width, height, 1) &&
         this->ReceiverDepth.Allocate(window, Format::Depth24, width, height, 1) &&
         this->Visibility.Allocate(
           window, color ? Format::Float4 : Format::Float1, width, height, lights);
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
void vtkVisibilityBuffer::Read(vtkOpenGLRenderWindow* window, const vtkShadowTexture& texture,
  int layer, int components, float* values)
{
  vtkShadowFramebuffer::Scope scope(window, this->Framebuffer, &texture, nullptr, layer);
  window->GetState()->vtkglPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, texture.GetWidth(), texture.GetHeight(), components == 1 ? GL_RED : GL_RGBA,
    GL_FLOAT, values);
}

//------------------------------------------------------------------------------
std::vector<glm::vec4> vtkVisibilityBuffer::ReadReceivers(vtkOpenGLRenderWindow* window)
{
  std::vector<glm::vec4> texels(static_cast<std::size_t>(this->GetWidth()) * this->GetHeight());
  this->Read(window, this->Receivers, 0, 4, &texels[0].x);
  return texels;
}

//------------------------------------------------------------------------------
std::vector<float> vtkVisibilityBuffer::ReadTarget(vtkOpenGLRenderWindow* window, int light)
{
  const int components = this->Quantity.empty() ? this->GetComponents() : 1;
  std::vector<float> values(
    static_cast<std::size_t>(components) * this->GetWidth() * this->GetHeight());
  this->Read(window, this->GetTarget(), light, components, values.data());
  return values;
}

//------------------------------------------------------------------------------
std::size_t vtkVisibilityBuffer::GetGPUBytes() const
{
  return this->Receivers.GetBytes() + this->ReceiverDepth.GetBytes() + this->Visibility.GetBytes() +
         this->Quantities.GetBytes();
}

//------------------------------------------------------------------------------
void vtkVisibilityBuffer::Release(vtkOpenGLRenderWindow* window)
{
  this->Receivers.Release(window);
  this->ReceiverDepth.Release(window);
  this->Visibility.Release(window);
  this->Quantities.Release(window);
  this->Framebuffer.Release(window);
}
