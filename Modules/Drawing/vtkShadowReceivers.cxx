// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowReceivers.h"

#include "vtkShadowReceiversFS.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace
{
/** As shadowIsBack in vtkShadowReceiversFS.glsl. */
bool IsBack(float packed)
{
  std::uint32_t bits;
  std::memcpy(&bits, &packed, sizeof(bits));
  return packed != 0.0f && (((bits >> 23 & 255u) + 1u) & 1u) != 0;
}

/** A back alone amid fronts, as shadowFetchReceiver has it. */
bool IsTurned(const std::vector<glm::vec4>& texels, int width, std::size_t pixel)
{
  const int height = static_cast<int>(texels.size()) / width;
  const int x = static_cast<int>(pixel) % width;
  const int y = static_cast<int>(pixel) / width;
  bool fronts = false;
  for (int k = 0; k < 9; ++k)
  {
    const int atX = std::clamp(x + k % 3 - 1, 0, width - 1);
    const int atY = std::clamp(y + k / 3 - 1, 0, height - 1);
    const float packed = texels[static_cast<std::size_t>(atY) * width + atX].w;
    const bool back = IsBack(packed);
    if (back && (atX != x || atY != y))
    {
      return false;
    }
    fronts = fronts || (packed != 0.0f && !back);
  }
  return fronts;
}
}

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
  const int code = static_cast<int>((mantissa - 1.0) * 8388608.0);
  double x = (code & 4095) / 4095.0 * 2.0 - 1.0;
  double y = (code >> 12) / 2047.0 * 2.0 - 1.0;
  const double z = 1.0 - std::abs(x) - std::abs(y);
  if (z < 0.0)
  {
    const double fold = (1.0 - std::abs(y)) * (x >= 0.0 ? 1.0 : -1.0);
    y = (1.0 - std::abs(x)) * (y >= 0.0 ? 1.0 : -1.0);
    x = fold;
  }
  const glm::dvec3 normal = glm::normalize(glm::dvec3(x, y, z));
  return { IsBack(packed) ? -normal : normal, std::ldexp(1.0, half) };
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
  std::vector<std::size_t> backs; // that stay turned to the viewer
  for (std::size_t i = 0; i < this->Texels.size(); ++i)
  {
    if (IsBack(this->Texels[i].w) && !IsTurned(this->Texels, this->GetWidth(), i))
    {
      backs.push_back(i);
    }
  }
  for (const std::size_t i : backs)
  {
    this->Texels[i].w *= 0.5f;
  }
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
