// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowRayPatterns.h"

#include "vtkShadowSampling.h"

#include <glm/vec2.hpp>

#include <algorithm>

namespace
{
/** Bits of two coordinates in turn: what is near along this order is near on the light. */
std::uint64_t Interleave(std::uint32_t x, std::uint32_t y)
{
  std::uint64_t code = 0;
  for (int bit = 31; bit >= 0; --bit)
  {
    code = code << 2 | (x >> bit & 1u) << 1 | (y >> bit & 1u);
  }
  return code;
}
}

//------------------------------------------------------------------------------
void vtkShadowRayPatterns::Update(
  const vtkShadowLight& light, const std::vector<int>& steps, int seed)
{
  const bool rectangle = light.Kind == vtkShadowLight::Shape::Rectangle;
  if (this->Steps == steps && this->Seed == static_cast<std::uint32_t>(seed) &&
      this->First == light.FirstSample && this->Rectangle == rectangle &&
      this->Texture == light.Emission && this->TextureTime == light.EmissionTime)
  {
    return;
  }
  const int samples = steps.back();
  this->Steps = steps;
  this->Samples = samples;
  this->Seed = static_cast<std::uint32_t>(seed);
  this->First = light.FirstSample;
  this->Rectangle = rectangle;
  this->Texture = light.Emission;
  this->TextureTime = light.EmissionTime;
  this->A.clear();
  this->B.clear();
  this->Emission.clear();
  this->A.reserve(static_cast<std::size_t>(Count) * samples);
  this->B.reserve(this->A.capacity());
  const auto points = vtkShadowSampling::Sobol(samples, std::max(0, light.FirstSample));
  std::vector<vtkShadowSampling::Bits> scrambled(points.size());
  for (int pattern = 0; pattern < Count; ++pattern)
  {
    const std::uint32_t x = vtkShadowSampling::Hash(2 * (this->Seed * Count + pattern) + 1);
    const std::uint32_t y = vtkShadowSampling::Hash(2 * (this->Seed * Count + pattern) + 2);
    std::transform(points.begin(), points.end(), scrambled.begin(),
      [x, y](const vtkShadowSampling::Bits& point) {
        return vtkShadowSampling::Bits{ point.X ^ x, point.Y ^ y };
      });
    auto first = scrambled.begin();
    for (const int step : steps)
    {
      const auto end = scrambled.begin() + step;
      std::sort(first, end,
        [](const vtkShadowSampling::Bits& a, const vtkShadowSampling::Bits& b)
        { return Interleave(a.X, a.Y) < Interleave(b.X, b.Y); });
      first = end;
    }
    for (const auto& point : scrambled)
    {
      const glm::dvec2 unit = vtkShadowSampling::ToUnit(point);
      const glm::dvec2 p = rectangle ? 2.0 * unit - 1.0 : vtkShadowSampling::ConcentricDisk(unit);
      this->A.push_back(static_cast<float>(p.x));
      this->B.push_back(static_cast<float>(p.y));
      if (light.Emission)
      {
        this->Emission.emplace_back(light.GetEmission(unit));
      }
    }
  }
}

//------------------------------------------------------------------------------
std::uint32_t vtkShadowRayPatterns::Hash(int pixel) const
{
  return vtkShadowSampling::Hash(
    static_cast<std::uint32_t>(pixel) ^ (0x9e3779b9u * (this->Seed + 1)));
}
