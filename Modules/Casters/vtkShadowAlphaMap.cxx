// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowAlphaMap.h"

#include "vtkTexture.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace
{
/** A texel's number within 0 to size - 1, as the texture is wrapped; -1 for its border. */
std::int64_t WrapTexel(std::int64_t i, std::int64_t size, int wrap)
{
  switch (wrap)
  {
    case vtkTexture::Repeat:
      return ((i % size) + size) % size;
    case vtkTexture::MirroredRepeat:
    {
      const std::int64_t k = ((i % (2 * size)) + 2 * size) % (2 * size);
      return k < size ? k : 2 * size - 1 - k;
    }
    case vtkTexture::ClampToBorder:
      return i < 0 || i >= size ? -1 : i;
    default:
      return std::clamp<std::int64_t>(i, 0, size - 1);
  }
}

/** In texels; what is not finite, or is far out, stays a number that can be rounded. */
double ToTexels(float coordinate, int size)
{
  const double texels = static_cast<double>(coordinate) * size;
  return std::isfinite(texels) ? std::clamp(texels, -1e15, 1e15) : 0.0;
}
}

//------------------------------------------------------------------------------
float vtkShadowAlphaMap::GetTexel(std::int64_t i, std::int64_t j) const
{
  i = WrapTexel(i, this->Width, this->Wrap);
  j = WrapTexel(j, this->Height, this->Wrap);
  return (i < 0 || j < 0 ? this->Border : this->Texels[i + j * this->Width]) / 255.0f;
}

//------------------------------------------------------------------------------
float vtkShadowAlphaMap::Get(float s, float t) const
{
  double x = ToTexels(s, this->Width);
  double y = ToTexels(t, this->Height);
  if (!this->Linear)
  {
    return this->GetTexel(
      static_cast<std::int64_t>(std::floor(x)), static_cast<std::int64_t>(std::floor(y)));
  }
  x -= 0.5;
  y -= 0.5;
  const auto i = static_cast<std::int64_t>(std::floor(x));
  const auto j = static_cast<std::int64_t>(std::floor(y));
  const auto a = static_cast<float>(x - std::floor(x));
  const auto b = static_cast<float>(y - std::floor(y));
  return (1.0f - b) * ((1.0f - a) * this->GetTexel(i, j) + a * this->GetTexel(i + 1, j)) +
         b * ((1.0f - a) * this->GetTexel(i, j + 1) + a * this->GetTexel(i + 1, j + 1));
}

//------------------------------------------------------------------------------
bool vtkShadowAlphaMap::IsBelow(float bound, const std::array<const float*, 3>& corners) const
{
  // All texels that can be looked up within the box around the triangle, but on its far edges.
  const int sizes[2] = { this->Width, this->Height };
  std::int64_t first[2];
  std::int64_t last[2];
  for (int c = 0; c < 2; ++c)
  {
    const auto range = std::minmax({ ToTexels(corners[0][c], sizes[c]),
      ToTexels(corners[1][c], sizes[c]), ToTexels(corners[2][c], sizes[c]) });
    const double reach = this->Linear ? 0.5 : 0.0;
    first[c] = static_cast<std::int64_t>(std::floor(range.first - reach));
    last[c] = std::max(first[c], static_cast<std::int64_t>(std::ceil(range.second + reach)) - 1);
    // A mirrored texture has shown all after two of its sizes.
    last[c] = std::min(last[c], first[c] + 2 * sizes[c]);
  }
  for (std::int64_t j = first[1]; j <= last[1]; ++j)
  {
    for (std::int64_t i = first[0]; i <= last[0]; ++i)
    {
      if (!(this->GetTexel(i, j) < bound))
      {
        return false;
      }
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkShadowAlphaMap::operator==(const vtkShadowAlphaMap& other) const
{
  return std::tie(
           this->Width, this->Height, this->Linear, this->Wrap, this->Border, this->Texels) ==
         std::tie(other.Width, other.Height, other.Linear, other.Wrap, other.Border, other.Texels);
}

//------------------------------------------------------------------------------
bool vtkShadowHoles::IsHole(const std::uint32_t* corners, float u, float v) const
{
  const float weights[3] = { 1.0f - u - v, u, v };
  float place[3] = { 0.0f, 0.0f, 0.0f };
  for (int k = 0; k < 3; ++k)
  {
    for (int c = 0; c < 3; ++c)
    {
      place[c] += weights[k] * this->Places[3 * corners[k] + c];
    }
  }
  const float alpha = place[2] * (this->Map ? this->Map->Get(place[0], place[1]) : 1.0f);
  return alpha < this->Threshold;
}

//------------------------------------------------------------------------------
bool vtkShadowHoles::operator==(const vtkShadowHoles& other) const
{
  const bool sameMap =
    this->Map == other.Map || (this->Map && other.Map && *this->Map == *other.Map);
  return sameMap && this->Threshold == other.Threshold && this->Places == other.Places;
}
