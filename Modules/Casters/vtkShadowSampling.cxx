// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowSampling.h"

#include <glm/gtc/constants.hpp>

#include <cmath>

namespace vtkShadowSampling
{
//------------------------------------------------------------------------------
std::vector<Bits> Sobol(int count, int first)
{
  std::vector<Bits> points(count);
  for (int i = 0; i < count; ++i)
  {
    // Dimension 0 is van der Corput's: the bits reversed. Dimension 1 has the primitive
    // polynomial x + 1: each direction number is the last one XOR itself shifted by one.
    std::uint32_t x = 0;
    std::uint32_t y = 0;
    std::uint32_t directionX = 1u << 31;
    std::uint32_t directionY = 1u << 31;
    for (std::uint32_t index = static_cast<std::uint32_t>(first + i); index; index >>= 1)
    {
      if (index & 1u)
      {
        x ^= directionX;
        y ^= directionY;
      }
      directionX >>= 1;
      directionY ^= directionY >> 1;
    }
    points[i] = { x, y };
  }
  return points;
}

//------------------------------------------------------------------------------
std::uint32_t Hash(std::uint32_t value)
{
  // Finalizer of MurmurHash3.
  value ^= value >> 16;
  value *= 0x85ebca6bu;
  value ^= value >> 13;
  value *= 0xc2b2ae35u;
  value ^= value >> 16;
  return value;
}

//------------------------------------------------------------------------------
glm::dvec2 ConcentricDisk(const glm::dvec2& unit)
{
  const glm::dvec2 p = 2.0 * unit - 1.0;
  if (p.x == 0.0 && p.y == 0.0)
  {
    return { 0.0, 0.0 };
  }
  double radius;
  double angle;
  if (std::abs(p.x) > std::abs(p.y))
  {
    radius = p.x;
    angle = glm::quarter_pi<double>() * (p.y / p.x);
  }
  else
  {
    radius = p.y;
    angle = glm::half_pi<double>() - glm::quarter_pi<double>() * (p.x / p.y);
  }
  return radius * glm::dvec2(std::cos(angle), std::sin(angle));
}
}
