// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowPlanes.h"

#include "vtkShadowCasters.h"
#include "vtkShadowLight.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace
{
/** What float coordinates can be off, as a share of the extent of what they describe. */
constexpr double Rounding = 1e-6;

double GetTriangleArea(const vtkShadowCaster& caster)
{
  const vtkShadowMesh& mesh = *caster.Mesh;
  const auto at = [&](std::size_t i)
  {
    const float* p = mesh.Positions.data() + 3 * static_cast<std::size_t>(mesh.Indices[i]);
    return glm::dvec3(caster.MeshToSWC * glm::dvec4(p[0], p[1], p[2], 1.0));
  };
  double sum = 0.0;
  for (std::size_t i = 0; i + 2 < mesh.Indices.size(); i += 3)
  {
    const glm::dvec3 a = at(i);
    sum += 0.5 * glm::length(glm::cross(at(i + 1) - a, at(i + 2) - a));
  }
  return sum;
}

/** Point and unit normal of a flat caster, in SWC. */
std::pair<glm::dvec3, glm::dvec3> GetPlaneOf(const vtkShadowCaster& caster)
{
  const glm::dvec3 point(caster.MeshToSWC * glm::dvec4(caster.Mesh->PlanePoint, 1.0));
  // By cofactors, which the inverse's transpose is but for a factor: a matrix may flatten.
  const glm::dmat3 m(caster.MeshToSWC);
  const glm::dvec3& n = caster.Mesh->Normal;
  const glm::dvec3 normal =
    n.x * glm::cross(m[1], m[2]) + n.y * glm::cross(m[2], m[0]) + n.z * glm::cross(m[0], m[1]);
  const double length = glm::length(normal);
  return { point, length > 0.0 ? normal / length : glm::dvec3(0.0) };
}
}

//------------------------------------------------------------------------------
void vtkPlaneRectangle::Add(const glm::dvec2& point)
{
  this->Low = glm::min(this->Low, point);
  this->High = glm::max(this->High, point);
}

//------------------------------------------------------------------------------
void vtkPlaneRectangle::Add(const vtkPlaneRectangle& other)
{
  this->Low = glm::min(this->Low, other.Low);
  this->High = glm::max(this->High, other.High);
}

//------------------------------------------------------------------------------
void vtkPlaneRectangle::Intersect(const vtkPlaneRectangle& other)
{
  this->Low = glm::max(this->Low, other.Low);
  this->High = glm::min(this->High, other.High);
}

//------------------------------------------------------------------------------
double vtkShadowPlane::GetHeight(const glm::dvec3& p) const
{
  return glm::dot(this->Normal, p) - this->Distance;
}

//------------------------------------------------------------------------------
glm::dvec2 vtkShadowPlane::GetPlace(const glm::dvec3& p) const
{
  return { glm::dot(this->X, p), glm::dot(this->Y, p) };
}

//------------------------------------------------------------------------------
glm::dvec4 vtkShadowPlane::GetEquation() const
{
  return { this->Normal, -this->Distance };
}

//------------------------------------------------------------------------------
bool vtkShadowPlane::operator==(const vtkShadowPlane& other) const
{
  return this->Normal == other.Normal && this->Distance == other.Distance &&
         this->Receivers == other.Receivers;
}

//------------------------------------------------------------------------------
std::vector<glm::dvec3> vtkShadowPlane::Cut(
  const std::array<glm::dvec3, 8>& corners, double lowest, double highest) const
{
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 8; ++i)
  {
    for (int bit = 1; bit < 8; bit *= 2)
    {
      const double a = this->GetHeight(corners[i]);
      const double b = this->GetHeight(corners[i | bit]);
      if ((i & bit) || std::max(a, b) < lowest || std::min(a, b) > highest)
      {
        continue;
      }
      for (const double height : { std::clamp(a, lowest, highest), std::clamp(b, lowest, highest) })
      {
        const double t = a == b ? 0.0 : std::clamp((height - a) / (b - a), 0.0, 1.0);
        points.push_back(corners[i] + t * (corners[i | bit] - corners[i]));
      }
    }
  }
  return points;
}

//------------------------------------------------------------------------------
bool vtkShadowPlane::Holds(const vtkShadowCaster& caster) const
{
  if (!caster.Mesh->Flat)
  {
    return false;
  }
  const auto plane = GetPlaneOf(caster);
  const double extent = 2.0 * caster.GetRadius();
  return glm::length(glm::cross(plane.second, this->Normal)) <= Rounding &&
         std::abs(this->GetHeight(caster.GetMiddle())) <= Rounding * extent &&
         std::abs(this->GetHeight(plane.first)) <= Rounding * extent;
}

//------------------------------------------------------------------------------
bool vtkShadowPlanes::Add(const glm::dvec3& point, const glm::dvec3& normal)
{
  const double largest = std::max({ std::abs(normal.x), std::abs(normal.y), std::abs(normal.z) });
  const double sum = point.x + point.y + point.z + normal.x + normal.y + normal.z;
  if (!std::isfinite(sum) || !(largest > 0.0))
  {
    return false;
  }
  this->Given.emplace_back(point, glm::normalize(normal / largest));
  return true;
}

//------------------------------------------------------------------------------
void vtkShadowPlanes::Merge(
  const glm::dvec3& point, const glm::dvec3& normal, double area, double extent)
{
  for (auto& other : this->Flats)
  {
    const double reach = other.Extent + extent + glm::length(point - other.Point);
    if (glm::length(glm::cross(normal, other.Plane.Normal)) <= Rounding &&
        std::abs(other.Plane.GetHeight(point)) <= Rounding * reach)
    {
      other.Plane.Area += area;
      return;
    }
  }
  Flat flat{ point, {}, extent };
  flat.Plane.Normal = normal;
  flat.Plane.Distance = glm::dot(normal, point);
  flat.Plane.Area = area;
  this->Flats.push_back(flat);
}

//------------------------------------------------------------------------------
void vtkShadowPlanes::Find(const vtkShadowCasters& casters)
{
  for (std::size_t i = 0; i < casters.Get().size(); ++i)
  {
    const vtkShadowCaster& caster = casters.Get()[i];
    const auto plane = GetPlaneOf(caster);
    if (caster.Mesh->Flat && this->Receiving[i] && plane.second != glm::dvec3(0.0))
    {
      this->Merge(plane.first, plane.second, GetTriangleArea(caster), 2.0 * caster.GetRadius());
    }
  }
  // Of props that do not cast there are boxes alone: flat ones lie along axes of their points.
  for (const auto& box : casters.GetReceivers())
  {
    const glm::dvec3 edges[] = { box[1] - box[0], box[2] - box[0], box[4] - box[0] };
    for (int axis = 0; axis < 3; ++axis)
    {
      const glm::dvec3 normal = glm::cross(edges[(axis + 1) % 3], edges[(axis + 2) % 3]);
      const double area = glm::length(normal);
      const double extent = glm::length(box[7] - box[0]);
      if (area > 0.0 && glm::length(edges[axis]) <= Rounding * extent)
      {
        this->Merge(box[0], normal / area, area, extent);
        break;
      }
    }
  }
}

//------------------------------------------------------------------------------
bool vtkShadowPlanes::Update(const vtkShadowCasters& casters, int limit)
{
  std::vector<bool> receiving;
  for (const auto& caster : casters.Get())
  {
    receiving.push_back(!caster.Mesh->Flat || caster.Receives);
  }
  if (limit == this->LastLimit && casters.GetVersion() == this->CasterVersion &&
      casters.GetReceiverVersion() == this->ReceiverVersion && receiving == this->Receiving &&
      this->Given == this->LastGiven)
  {
    return false;
  }
  this->LastLimit = limit;
  this->CasterVersion = casters.GetVersion();
  this->ReceiverVersion = casters.GetReceiverVersion();
  this->Receiving = std::move(receiving);
  this->LastGiven = this->Given;

  this->Flats.clear();
  if (this->Given.empty())
  {
    this->Find(casters);
  }
  else
  {
    for (const auto& plane : this->Given)
    {
      this->Merge(plane.first - casters.GetOrigin(), plane.second, 0.0, casters.GetSize());
    }
  }
  this->Found = static_cast<int>(this->Flats.size());
  // The order of equal areas is that of the props.
  std::stable_sort(this->Flats.begin(), this->Flats.end(),
    [](const Flat& a, const Flat& b) { return a.Plane.Area > b.Plane.Area; });
  this->Flats.resize(std::min<std::size_t>(this->Flats.size(), limit));

  std::vector<vtkShadowPlane> planes;
  for (auto& flat : this->Flats)
  {
    vtkShadowPlane& plane = flat.Plane;
    plane.X = vtkShadowLight::Perpendicular(plane.Normal);
    plane.Y = glm::cross(plane.Normal, plane.X);
    const auto touch = [&plane](const std::array<glm::dvec3, 8>& corners)
    {
      const double tolerance = Rounding * glm::length(corners[7] - corners[0]);
      for (const auto& point : plane.Cut(corners, -tolerance, tolerance))
      {
        plane.Receivers.Add(plane.GetPlace(point));
      }
    };
    for (const auto& caster : casters.Get())
    {
      if (!caster.Mesh->Indices.empty())
      {
        touch(caster.Corners);
      }
    }
    for (const auto& box : casters.GetReceivers())
    {
      touch(box);
    }
    planes.push_back(plane);
  }
  const bool changed = !(planes == this->Planes);
  this->Planes = std::move(planes);
  return changed;
}
