#include "vtkShadowMapPattern.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShadowSampling.h"

#include <glm/gtc/constants.hpp>

//------------------------------------------------------------------------------
void vtkShadowMapPattern::SetGrid(
  vtkOpenGLRenderWindow* window, vtkMTimeType time, int n, double scale)
{
  const double disk = 0.5 * glm::root_pi<double>();
  std::vector<glm::vec4> texels;
  for (int i = 0; i < n * n; ++i)
  {
    const glm::dvec2 p =
      scale * ((2.0 * glm::dvec2(i % n, i / n) + 1.0) / static_cast<double>(n) - 1.0);
    texels.emplace_back(glm::dvec4(disk * p, p));
  }
  this->Points.UploadBuffer(window, texels);
  this->Count = n * n;
  this->Time = time;
}

//------------------------------------------------------------------------------
void vtkShadowMapPattern::SetSobol(
  vtkOpenGLRenderWindow* window, vtkMTimeType time, int count, bool centre)
{
  std::vector<glm::vec4> texels(centre ? 1 : 0, glm::vec4(0.0f));
  for (const auto& bits : vtkShadowSampling::Sobol(centre ? count - 1 : count))
  {
    const glm::dvec2 unit = vtkShadowSampling::ToUnit(bits);
    texels.emplace_back(glm::dvec4(vtkShadowSampling::ConcentricDisk(unit), 2.0 * unit - 1.0));
  }
  this->Points.UploadBuffer(window, texels);
  this->Count = count;
  this->Time = time;
}
