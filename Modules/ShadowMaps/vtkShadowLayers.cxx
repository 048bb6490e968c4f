// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowLayers.h"

#include "vtkShadowCasters.h"
#include "vtkShadowLight.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace
{
constexpr int Side = 32;              // cells of the grid
constexpr std::size_t Wanted = 16384; // triangles to look at
constexpr double LeastGap = 0.05;     // of the depths' range
constexpr std::size_t Least = 2;      // depths on either side of a gap: one may be chance

/** A triangle's centre in the light's view. */
struct Centre
{
  glm::dvec2 Place;
  double Depth;
};

/** Of every so many triangles one that faces the light. */
std::vector<Centre> Collect(const vtkShadowCasters& casters, const vtkShadowLight& light)
{
  std::vector<int> all(casters.Get().size());
  std::iota(all.begin(), all.end(), 0);
  const glm::dvec3 place = light.Position - casters.GetOrigin();
  const glm::dvec3 way = light.IsDirectional() ? light.Direction : casters.GetMiddle(all) - place;
  const double length = glm::length(way);
  if (!(length > 0.0))
  {
    return {};
  }
  const glm::dvec3 axis = way / length;
  const glm::dvec3 u = vtkShadowLight::Perpendicular(axis);
  const glm::dvec3 v = glm::cross(axis, u);
  const std::size_t step = casters.GetNumberOfTriangles() / Wanted + 1;
  std::vector<Centre> centres;
  std::size_t next = 0; // of the caster's triangles
  for (const auto& caster : casters.Get())
  {
    const auto& mesh = *caster.Mesh;
    const std::size_t count = mesh.GetNumberOfTriangles();
    const bool mirrored = glm::determinant(glm::dmat3(caster.MeshToSWC)) < 0.0;
    for (; next < count; next += step)
    {
      if (mesh.Sheet)
      {
        continue;
      }
      glm::dvec3 corners[3];
      for (int i = 0; i < 3; ++i)
      {
        const float* position = &mesh.Positions[3 * std::size_t(mesh.Indices[3 * next + i])];
        corners[i] = caster.MeshToSWC * glm::dvec4(position[0], position[1], position[2], 1.0);
      }
      const glm::dvec3 centre = (corners[0] + corners[1] + corners[2]) / 3.0;
      const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
      const glm::dvec3 ray = light.IsDirectional() ? axis : centre - place;
      const double depth = glm::dot(light.IsDirectional() ? centre : ray, axis);
      if ((glm::dot(normal, ray) < 0.0) == mirrored || (!light.IsDirectional() && depth <= 0.0))
      {
        continue;
      }
      const glm::dvec3 seen = light.IsDirectional() ? centre : ray / depth;
      centres.push_back({ { glm::dot(seen, u), glm::dot(seen, v) }, depth });
    }
    next -= count;
  }
  return centres;
}

bool HasLayers(std::vector<double>& depths, double leastGap)
{
  std::sort(depths.begin(), depths.end());
  for (std::size_t i = Least; i + Least <= depths.size(); ++i)
  {
    const double gap = depths[i] - depths[i - 1];
    if (gap > leastGap && gap > depths[i - 1] - depths.front() && gap > depths.back() - depths[i])
    {
      return true;
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
double vtkShadowLayers::FindShare(const vtkShadowCasters& casters, const vtkShadowLight& light)
{
  const auto centres = Collect(casters, light);
  constexpr double most = std::numeric_limits<double>::max();
  glm::dvec3 low(most);
  glm::dvec3 high(-most);
  for (const auto& centre : centres)
  {
    low = glm::min(low, glm::dvec3(centre.Place, centre.Depth));
    high = glm::max(high, glm::dvec3(centre.Place, centre.Depth));
  }
  const double width = std::max(high.x - low.x, high.y - low.y);
  if (centres.empty() || !(width > 0.0 && std::isfinite(width)))
  {
    return 0.0;
  }
  std::vector<std::vector<double>> cells(Side * Side);
  for (const auto& centre : centres)
  {
    const glm::dvec2 cell = (centre.Place - glm::dvec2(low)) * (Side / width);
    const int column = std::min(static_cast<int>(cell.x), Side - 1);
    const int row = std::min(static_cast<int>(cell.y), Side - 1);
    cells[Side * row + column].push_back(centre.Depth);
  }
  int filled = 0;
  int layered = 0;
  for (auto& cell : cells)
  {
    filled += cell.empty() ? 0 : 1;
    layered += HasLayers(cell, LeastGap * (high.z - low.z)) ? 1 : 0;
  }
  return static_cast<double>(layered) / filled;
}

//------------------------------------------------------------------------------
int vtkShadowLayers::Count(
  const vtkShadowCasters& casters, const std::vector<vtkShadowLight>& lights)
{
  constexpr double most = 0.2;
  const auto same = [](const vtkShadowLight& a, const vtkShadowLight& b)
  { return a.SameGeometry(b); };
  if (this->Version != casters.GetVersion() ||
      !std::equal(lights.begin(), lights.end(), this->Lights.begin(), this->Lights.end(), same))
  {
    this->Version = casters.GetVersion();
    this->Lights = lights;
    this->Layered = static_cast<int>(std::count_if(lights.begin(), lights.end(),
      [&](const vtkShadowLight& light)
      { return !light.IsPoint() && FindShare(casters, light) > most; }));
  }
  return this->Layered;
}
