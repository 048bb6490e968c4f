#include "vtkVisibilityBuffer.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShadowVTKVersion.h"

#include <glm/geometric.hpp>

#include <cmath>

//------------------------------------------------------------------------------
bool vtkShadowReceiver::IsOne(const glm::vec4& texel)
{
  return texel.w != 0.0f && std::isfinite(texel.x) && std::isfinite(texel.y) &&
         std::isfinite(texel.z) && std::isfinite(texel.w);
}

//------------------------------------------------------------------------------
vtkShadowReceiver vtkShadowReceiver::Unpack(float packed)
{
  int exponent;
  const double mantissa =
    2.0 * std::frexp(std::abs(static_cast<double>(packed)), &exponent); // 1 to 2
  --exponent;
  const int half = static_cast<int>(std::floor(0.5 * exponent));
  const int code = static_cast<int>((mantissa - 1.0) * 8388608.0) + 8388608 * (exponent - 2 * half);
  double x = (code & 4095) / 4095.0 * 2.0 - 1.0;
  double y = (code >> 12) / 4095.0 * 2.0 - 1.0;
  const double z = 1.0 - std::abs(x) - std::abs(y);
  if (z < 0.0)
  {
    const double fold = (1.0 - std::abs(y)) * (x >= 0.0 ? 1.0 : -1.0);
    y = (1.0 - std::abs(x)) * (y >= 0.0 ? 1.0 : -1.0);
    x = fold;
  }
  return { glm::normalize(glm::dvec3(x, y, z)), std::ldexp(1.0, half) };
}

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
