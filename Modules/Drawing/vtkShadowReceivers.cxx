// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowReceivers.h"

#include "vtkShadowReceiversFS.h"

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
bool vtkShadowReceivers::Allocate(vtkOpenGLRenderWindow* window, int width, int height)
{
  using Format = vtkShadowTexture::Format;
  return this->Texture.Allocate(window, Format::Float4, width, height, 1) &&
         this->Depth.Allocate(window, Format::Depth24, width, height, 1);
}

//------------------------------------------------------------------------------
std::string vtkShadowReceivers::GetGLSL()
{
  return vtkShadowReceiversFS;
}

//------------------------------------------------------------------------------
const std::vector<glm::vec4>& vtkShadowReceivers::Read(vtkOpenGLRenderWindow* window)
{
  this->Texels.resize(static_cast<std::size_t>(this->GetWidth()) * this->GetHeight());
  this->Framebuffer.Read(window, this->Texture, 0, &this->Texels[0].x);
  return this->Texels;
}

//------------------------------------------------------------------------------
void vtkShadowReceivers::Release(vtkOpenGLRenderWindow* window)
{
  this->Texture.Release(window);
  this->Depth.Release(window);
  this->Framebuffer.Release(window);
  std::vector<glm::vec4>().swap(this->Texels);
}
