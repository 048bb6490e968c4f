// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowCasters.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkShadowLight.h"
#include "vtkShadowMeshes.h"
#include "vtkShadowSurfaces.h"
#include "vtkShadowTags.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

namespace
{
std::array<glm::dvec3, 8> BoxCorners(const glm::dvec3& low, const glm::dvec3& high)
{
  std::array<glm::dvec3, 8> corners;
  for (int i = 0; i < 8; ++i)
  {
    corners[i] = { i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z };
  }
  return corners;
}

bool IsFinite(const glm::dmat4& matrix)
{
  const double* values = glm::value_ptr(matrix);
  return std::all_of(values, values + 16, [](double value) { return std::isfinite(value); });
}

template <typename Count>
std::size_t Sum(const std::vector<vtkShadowCaster>& casters, Count count)
{
  return std::accumulate(casters.begin(), casters.end(), std::size_t(0),
    [&count](std::size_t sum, const vtkShadowCaster& c) { return sum + count(*c.Mesh); });
}

/** A mesh in the world: what Update gathers before it knows the origin of SWC. */
struct Placed
{
  std::shared_ptr<const vtkShadowMesh> Mesh;
  vtkProp* Prop;
  glm::dmat4 MeshToWorld;
  double Opacity;
  bool Receives;
};

/**
 * The opacities below 1 that occur, ascending. Where there are more than so many levels, opacities
 * are rounded to as many between 0 and 1, and what is rounded to 0 casts nothing.
 */
std::vector<double> FindOpacities(std::vector<Placed>& placed, int levels)
{
  std::set<double> found;
  for (const auto& item : placed)
  {
    found.insert(item.Opacity);
  }
  found.erase(1.0);
  if (static_cast<int>(found.size()) > levels)
  {
    found.clear();
    for (auto& item : placed)
    {
      item.Opacity = std::round(item.Opacity * (levels + 1)) / (levels + 1);
      found.insert(item.Opacity);
    }
    placed.erase(std::remove_if(placed.begin(), placed.end(),
                   [](const Placed& item) { return item.Opacity == 0.0; }),
      placed.end());
    found.erase(0.0);
    found.erase(1.0);
  }
  return { found.begin(), found.end() };
}
}

//------------------------------------------------------------------------------
bool vtkShadowCaster::IsSeenBy(const vtkShadowLightPart& part) const
{
  return this->Opacity >= part.LeastOpacity;
}

//------------------------------------------------------------------------------
glm::dvec3 vtkShadowCaster::GetMiddle() const
{
  return { this->MeshToSWC * glm::dvec4(this->Mesh->Middle, 1.0) };
}

//------------------------------------------------------------------------------
double vtkShadowCaster::GetRadius() const
{
  const glm::dmat3 axes(this->MeshToSWC);
  return this->Mesh->Radius *
         std::max({ glm::length(axes[0]), glm::length(axes[1]), glm::length(axes[2]) });
}

//------------------------------------------------------------------------------
vtkShadowCasters::vtkShadowCasters()
  : Meshes(new vtkShadowMeshes)
{
}

//------------------------------------------------------------------------------
vtkShadowCasters::~vtkShadowCasters() = default;

//------------------------------------------------------------------------------
bool vtkShadowCasters::Update(
  vtkRenderer* renderer, vtkTranslucentCasters translucent, int levels, double alphaThreshold)
{
  this->UnknownAlphas = 0;
  vtkShadowMeshes known; // of this time; what is in it no more is forgotten
  std::vector<Placed> placed;
  std::vector<std::array<glm::dvec3, 8>> receivers; // in the world
  std::size_t dropped = 0;
  std::size_t notFinite = 0;
  const auto add = [&](vtkProp* root, vtkProp* prop, vtkMatrix4x4* matrix)
  {
    const glm::dmat4 modelToWorld = glm::transpose(glm::make_mat4(matrix->GetData()));
    bool surfaces = false; // of the prop, that may cast
    const bool receives = vtkShadowTags::GetReceiving(root);
    const auto addSurface = [&](const vtkShadowSurface& surface)
    {
      this->UnknownAlphas += surface.AlphaUnknown ? 1 : 0;
      const bool weighted = surface.Translucent && translucent == vtkTranslucentCasters::Weighted;
      const double opacity = weighted ? std::min(surface.Opacity, 1.0) : 1.0;
      if ((surface.Translucent && translucent == vtkTranslucentCasters::Off) || !(opacity > 0.0))
      {
        return;
      }
      const auto mesh = known.Find(surface, alphaThreshold, *this->Meshes);
      // What casts nothing has no place: it must not move the origin, nor widen a map.
      surfaces = surfaces || !mesh->Indices.empty() || mesh->Dropped > 0;
      dropped += mesh->Dropped;
      notFinite +=
        IsFinite(modelToWorld) ? mesh->NotFinite : mesh->NotFinite + mesh->GetNumberOfTriangles();
      if (!mesh->Indices.empty() && IsFinite(modelToWorld))
      {
        placed.push_back(
          { mesh, prop, glm::translate(modelToWorld, mesh->Centre), opacity, receives });
      }
    };
    if (vtkShadowTags::GetCasting(root) && !vtkShadowTags::GetShadowCatcher(root))
    {
      vtkForEachShadowSurface(prop, matrix, addSurface);
    }
    auto* actor = vtkActor::SafeDownCast(prop);
    if (surfaces || !actor || !actor->GetMapper() || !receives)
    {
      return;
    }
    const double* b = actor->GetMapper()->GetBounds();
    if (b && b[0] <= b[1] &&
        std::all_of(b, b + 6, [](double bound) { return std::isfinite(bound); }) &&
        IsFinite(modelToWorld))
    {
      receivers.push_back(BoxCorners({ b[0], b[2], b[4] }, { b[1], b[3], b[5] }));
      for (auto& corner : receivers.back())
      {
        corner = glm::dvec3(modelToWorld * glm::dvec4(corner, 1.0));
      }
    }
  };
  vtkCollectionSimpleIterator cookie;
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal(cookie);
  while (vtkProp* prop = props->GetNextProp(cookie))
  {
    if (prop->GetVisibility())
    {
      vtkShadowTags::ForEachPart(
        prop, [&](vtkProp* part, vtkMatrix4x4* matrix) { add(prop, part, matrix); });
    }
  }
  *this->Meshes = std::move(known);
  this->Dropped = dropped;
  this->NotFinite = notFinite;
  this->Opacities = FindOpacities(placed, levels);

  bool changed = placed.size() != this->Casters.size();
  bool meshesChanged = changed;
  glm::dvec3 low(std::numeric_limits<double>::max());
  glm::dvec3 high(std::numeric_limits<double>::lowest());
  for (std::size_t i = 0; i < placed.size(); ++i)
  {
    const auto& mesh = *placed[i].Mesh;
    for (const auto& corner : BoxCorners(mesh.Minimum, mesh.Maximum))
    {
      const glm::dvec3 p(placed[i].MeshToWorld * glm::dvec4(corner, 1.0));
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
    meshesChanged = meshesChanged || this->Casters[i].Mesh != placed[i].Mesh;
  }
  // The origin stays as long as it is near: moving it would rebuild everything else.
  const glm::dvec3 centre = 0.5 * (low + high);
  this->Size = placed.empty() ? 0.0 : glm::length(high - low);
  if (!placed.empty() && glm::length(centre - this->Origin) > this->Size)
  {
    this->Origin = centre;
    changed = true;
  }

  std::vector<vtkShadowCaster> casters;
  casters.reserve(placed.size());
  const glm::dmat4 worldToSWC = glm::translate(glm::dmat4(1.0), -this->Origin);
  for (const auto& item : placed)
  {
    vtkShadowCaster caster{ item.Mesh, item.Prop, worldToSWC * item.MeshToWorld, item.Opacity,
      item.Receives, {} };
    changed = changed || meshesChanged ||
              caster.MeshToSWC != this->Casters[casters.size()].MeshToSWC ||
              caster.Opacity != this->Casters[casters.size()].Opacity;
    caster.Corners = BoxCorners(item.Mesh->Minimum, item.Mesh->Maximum);
    for (auto& corner : caster.Corners)
    {
      corner = glm::dvec3(caster.MeshToSWC * glm::dvec4(corner, 1.0));
    }
    casters.push_back(std::move(caster));
  }
  this->Casters = std::move(casters);

  for (auto& box : receivers)
  {
    for (auto& corner : box)
    {
      corner -= this->Origin;
    }
  }
  this->ReceiverVersion += receivers != this->Receivers ? 1 : 0;
  this->Receivers = std::move(receivers);

  this->MeshVersion += meshesChanged ? 1 : 0;
  this->Version += changed ? 1 : 0;
  return changed;
}

//------------------------------------------------------------------------------
glm::dvec3 vtkShadowCasters::GetMiddle(const std::vector<int>& casters) const
{
  glm::dvec3 middle(0.0);
  for (const int i : casters)
  {
    const auto& corners = this->Casters[i].Corners;
    middle += 0.5 * (corners[0] + corners[7]) / static_cast<double>(casters.size());
  }
  return middle;
}

//------------------------------------------------------------------------------
std::vector<vtkLightSample> vtkShadowCasters::GetPlaces(
  const vtkShadowLight& light, int count, const std::vector<int>& casters) const
{
  return light.GetPlaces(light.IsPoint() ? 1 : count, this->GetMiddle(casters) + this->Origin);
}

//------------------------------------------------------------------------------
std::vector<vtkLightSample> vtkShadowCasters::GetMiddles(
  const vtkShadowLight& sampled, int count, const std::vector<int>& casters) const
{
  vtkShadowLight light = sampled;
  light.FirstSample = -1; // parts of the area are no samples of it
  const int side = light.IsPoint() ? 1 : static_cast<int>(std::lround(std::sqrt(count)));
  if (side == 1)
  {
    return this->GetPlaces(light, 1, casters);
  }
  const glm::dvec3 receiver = this->GetMiddle(casters) + this->Origin;
  std::vector<vtkLightSample> samples;
  for (int i = 0; i < side * side; ++i)
  {
    const glm::dvec2 unit = (glm::dvec2(i % side, i / side) + 0.5) / static_cast<double>(side);
    samples.push_back({ light.Map(unit, receiver), glm::dvec3(1.0 / (side * side)) });
  }
  if (light.Kind != vtkShadowLight::Shape::Rectangle)
  {
    // Small disks do not cover a large one. Moved outwards, they are as wide as it together: their mean
    // square distance from the centre is its own, half of the radius' square.
    const glm::dvec3 centre = this->GetPlaces(light, 1, casters)[0].Point;
    const double radius = glm::length(light.U);
    double square = 0.0;
    for (const auto& sample : samples)
    {
      const double distance = glm::length(sample.Point - centre) / radius;
      square += distance * distance / (side * side);
    }
    const double factor = std::sqrt(0.5 * (1.0 - 1.0 / (side * side)) / square);
    for (auto& sample : samples)
    {
      sample.Point = centre + factor * (sample.Point - centre);
    }
  }
  return samples;
}

//------------------------------------------------------------------------------
std::size_t vtkShadowCasters::GetNumberOfVertices() const
{
  return Sum(this->Casters, [](const vtkShadowMesh& m) { return m.GetNumberOfVertices(); });
}

//------------------------------------------------------------------------------
std::size_t vtkShadowCasters::GetNumberOfTriangles() const
{
  return Sum(this->Casters, [](const vtkShadowMesh& m) { return m.GetNumberOfTriangles(); });
}

//------------------------------------------------------------------------------
std::size_t vtkShadowCasters::GetNumberOfClearTriangles() const
{
  return Sum(this->Casters, [](const vtkShadowMesh& m) { return m.Clear; });
}

//------------------------------------------------------------------------------
std::size_t vtkShadowCasters::GetNumberWithHoles() const
{
  return Sum(this->Casters, [](const vtkShadowMesh& m) { return m.Holes ? 1 : 0; });
}
