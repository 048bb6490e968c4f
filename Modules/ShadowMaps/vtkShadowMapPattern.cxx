// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowMapPattern.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShadowSampling.h"

#include <glm/common.hpp>

#include <utility>

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
  this->Points.UploadBuffer(window, texels);
  this->Values = std::move(texels);
}

//------------------------------------------------------------------------------
void vtkShadowMapPattern::SetSobol(vtkOpenGLRenderWindow* window, int count, bool centre)
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
  this->Points.UploadBuffer(window, texels);
  this->Values = std::move(texels);
}
