// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowMapPattern.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShadowSampling.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
std::vector<glm::vec4> MakeSobol(int count, bool centre)
{
  std::vector<glm::vec4> texels;
  for (auto bits : vtkShadowSampling::Sobol(count))
  {
    // From the middle on, so that few of them are centred too; then all by half a cell.
    bits.X ^= 1u << 31;
    bits.Y ^= 1u << 31;
    const glm::dvec2 unit = glm::fract(vtkShadowSampling::ToUnit(bits) + 0.5 / count);
    texels.emplace_back(glm::dvec4(vtkShadowSampling::ConcentricDisk(unit), 2.0 * unit - 1.0));
  }
  if (centre)
  {
    texels[0] = glm::vec4(0.0f);
  }
  return texels;
}
}

//------------------------------------------------------------------------------
void vtkShadowMapPattern::SetGrid(vtkOpenGLRenderWindow* window, int n, double scale)
{
  std::vector<glm::vec4> texels;
  for (int i = 0; i < n * n; ++i)
  {
    const glm::dvec2 unit = (glm::dvec2(i % n, i / n) + 0.5) / static_cast<double>(n);
    texels.emplace_back(
      scale * glm::dvec4(vtkShadowSampling::ConcentricDisk(unit), 2.0 * unit - 1.0));
  }
  this->Set(window, std::move(texels));
}

//------------------------------------------------------------------------------
void vtkShadowMapPattern::SetSobol(vtkOpenGLRenderWindow* window, int count, bool centre)
{
  this->Set(window, MakeSobol(count, centre));
}

//------------------------------------------------------------------------------
void vtkShadowMapPattern::SetSearch(vtkOpenGLRenderWindow* window, int count, int further)
{
  auto texels = MakeSobol(count, true);
  for (auto& texel : texels)
  {
    const float disk = glm::length(glm::vec2(texel));
    const float square = std::max(std::abs(texel.z), std::abs(texel.w));
    texel *= glm::vec4(disk, disk, square, square);
  }
  const auto even = MakeSobol(further, false);
  texels.insert(texels.end(), even.begin(), even.end());
  this->Set(window, std::move(texels), further);
}

//------------------------------------------------------------------------------
void vtkShadowMapPattern::Set(
  vtkOpenGLRenderWindow* window, std::vector<glm::vec4> points, int further)
{
  this->Points.UploadBuffer(window, points);
  this->Values = std::move(points);
  this->Further = further;
}
