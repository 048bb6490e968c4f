// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowWedges.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace
{
using Shape = vtkShadowLight::Shape;

/** Directions that lean more than this from their mean (as a cosine) have no bound worth drawing. */
constexpr double LeastCosine = 1e-3;

/** Corners of a polygon around a unit circle; of four corners, sides are parallel to the axes. */
std::vector<glm::dvec2> GetPolygon(int corners)
{
  std::vector<glm::dvec2> polygon;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = glm::pi<double>() * (2 * i + 1) / corners;
    polygon.push_back(
      glm::dvec2(std::cos(angle), std::sin(angle)) / std::cos(glm::pi<double>() / corners));
  }
  return polygon;
}

/** Directions from a sphere through a point: of the cone around it, sides along an edge. */
bool AddCone(const glm::dvec3& towards, double radius, const glm::dvec3& edge, int corners,
  std::vector<glm::dvec3>& directions)
{
  const double distance = glm::length(towards);
  if (!(distance > (1.0 + 1e-6) * radius))
  {
    return false;
  }
  const glm::dvec3 axis = towards / distance;
  glm::dvec3 across = glm::cross(axis, edge);
  const double length = glm::length(across);
  across = length > 1e-6 * glm::length(edge) ? across / length : vtkShadowLight::Perpendicular(axis);
  const glm::dvec3 along = glm::cross(across, axis);
  const double tangent = radius / std::sqrt((distance - radius) * (distance + radius));
  for (const auto& p : GetPolygon(corners))
  {
    directions.push_back(axis + tangent * (p.x * across + p.y * along));
  }
  return true;
}

/** Directions away from the light through a point. False where the light is there. */
bool AddDirections(const vtkShadowWedgeLight& light, const glm::dvec3& point,
  const glm::dvec3& edge, vtkShadowWedge::Bounds bounds, std::vector<glm::dvec3>& directions)
{
  const glm::dvec3 place(light.Place);
  const bool directional = light.Place.w == 0.0;
  const glm::dvec3 towards = directional ? -place : point - place;
  if (bounds == vtkShadowWedge::Bounds::Sphere || light.Kind == Shape::Sphere)
  {
    const bool sphere = light.Kind == Shape::Sphere;
    const double radius = light.Kind == Shape::Rectangle ? glm::length(light.U + light.V)
                                                         : glm::length(light.U);
    // The directional light's disk stands at distance 1, its cone's sine is less than its tangent.
    const double sine = directional ? radius / std::sqrt(1.0 + radius * radius) : radius;
    const int corners = sphere && bounds == vtkShadowWedge::Bounds::Tight ? 8 : 4;
    return AddCone(towards, sine, edge, corners, directions);
  }
  static const auto square = std::vector<glm::dvec2>{ { 1, 1 }, { -1, 1 }, { -1, -1 }, { 1, -1 } };
  static const auto octagon = GetPolygon(8);
  for (const auto& p : light.Kind == Shape::Rectangle ? square : octagon)
  {
    directions.push_back(towards - p.x * light.U - p.y * light.V);
  }
  return true;
}

/** Indices of the corners of a convex hull, counterclockwise. */
std::vector<int> FindHull(const std::vector<glm::dvec2>& points)
{
  std::vector<int> order(points.size());
  double size = 0.0;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    order[i] = static_cast<int>(i);
    size = std::max({ size, std::abs(points[i].x), std::abs(points[i].y) });
  }
  std::sort(order.begin(), order.end(),
    [&](int a, int b)
    { return points[a].x != points[b].x ? points[a].x < points[b].x : points[a].y < points[b].y; });
  const auto turn = [&](int a, int b, int c)
  {
    const glm::dvec2 u = points[b] - points[a];
    const glm::dvec2 v = points[c] - points[a];
    return u.x * v.y - u.y * v.x;
  };
  const double least = 1e-14 * size * size; // what rounding makes of points in a line
  std::vector<int> hull;
  for (int pass = 0; pass < 2; ++pass)
  {
    const std::size_t first = hull.size();
    for (const int i : order)
    {
      while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), i) <= least)
      {
        hull.pop_back();
      }
      hull.push_back(i);
    }
    hull.pop_back(); // begins the other chain
    std::reverse(order.begin(), order.end());
  }
  return hull;
}
}

//------------------------------------------------------------------------------
void vtkShadowWedgeEdge::SetPlane(const glm::dvec4& place)
{
  const glm::dvec3 centre(place);
  const glm::dvec3 from = this->Ends[0] * place.w - centre;
  const glm::dvec3 along = this->Ends[1] - this->Ends[0];
  const glm::dvec3 normal = glm::cross(along, from);
  const double length = glm::length(normal);
  const bool seen = length > 1e-12 * glm::length(along) * glm::length(from);
  this->Plane = seen ? glm::dvec4(normal, -glm::dot(normal, this->Ends[0])) / length
                     : glm::dvec4(0.0);
}

//------------------------------------------------------------------------------
void vtkShadowWedge::BoundNothing()
{
  this->Whole = true;
  this->Planes.clear();
  this->Triangles.clear();
  // Both ways round: one of them is seen from behind.
  for (const int i : { 0, 1, 2, 2, 1, 3, 0, 2, 1, 1, 2, 3 })
  {
    this->Triangles.push_back(
      { 2, { i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, 0.0 }, glm::dvec3(0.0) });
  }
}

//------------------------------------------------------------------------------
void vtkShadowWedge::Bound(
  const vtkShadowWedgeLight& light, const glm::dvec3 (&ends)[2], Bounds bounds)
{
  this->Triangles.clear();
  this->Planes.clear();
  this->Whole = false;
  if (light.Kind == Shape::Rectangle || light.Kind == Shape::Disk)
  {
    // What lies before the light's plane and what lies behind it have bounds of their own.
    const glm::dvec3 normal = glm::cross(light.U, light.V);
    double heights[2];
    for (int i = 0; i < 2; ++i)
    {
      heights[i] = glm::dot(normal, ends[i] - glm::dvec3(light.Place));
    }
    if ((heights[0] < 0.0) != (heights[1] < 0.0) && heights[0] != 0.0 && heights[1] != 0.0)
    {
      const double t = heights[0] / (heights[0] - heights[1]);
      const glm::dvec3 middle = ends[0] + t * (ends[1] - ends[0]);
      const glm::dvec3 parts[2][2] = { { ends[0], middle }, { middle, ends[1] } };
      this->BoundPart(light, parts[0], bounds);
      if (!this->Whole)
      {
        this->BoundPart(light, parts[1], bounds);
      }
      this->Planes.clear();
      return;
    }
  }
  this->BoundPart(light, ends, bounds);
}

//------------------------------------------------------------------------------
void vtkShadowWedge::BoundPart(
  const vtkShadowWedgeLight& light, const glm::dvec3 (&ends)[2], Bounds bounds)
{
  const glm::dvec3 edge = ends[1] - ends[0];
  std::vector<glm::dvec3> directions;
  for (const auto& end : ends)
  {
    if (!AddDirections(light, end, edge, bounds, directions))
    {
      this->BoundNothing();
      return;
    }
  }
  glm::dvec3 axis(0.0);
  for (const auto& direction : directions)
  {
    const double length = glm::length(direction);
    axis += length > 0.0 ? direction / length : glm::dvec3(0.0);
  }
  const double length = glm::length(axis);
  axis /= length;
  const glm::dvec3 across = vtkShadowLight::Perpendicular(axis);
  const glm::dvec3 up = glm::cross(axis, across);
  std::vector<glm::dvec2> points;
  for (auto& direction : directions)
  {
    const double along = glm::dot(direction, axis);
    if (!(along > LeastCosine * glm::length(direction)))
    {
      this->BoundNothing();
      return;
    }
    direction /= along;
    points.emplace_back(glm::dot(direction, across), glm::dot(direction, up));
  }
  const auto hull = FindHull(points);
  const std::size_t count = hull.size();
  if (count < 3)
  {
    return;
  }
  const glm::dvec3 middle = 0.5 * (ends[0] + ends[1]);
  const auto near = [&](int end) { return Corner{ 1, ends[end], glm::dvec3(0.0) }; };
  const auto far = [&](int end, std::size_t k)
  {
    const glm::dvec3& along = directions[hull[k % count]];
    return Corner{ 0, ends[end] - glm::dot(axis, ends[end] - middle) * along, along };
  };
  const auto add = [&](const Corner& a, const Corner& b, const Corner& c)
  { this->Triangles.insert(this->Triangles.end(), { a, b, c }); };
  std::vector<int> stands(count); // at which end each facet stands
  for (std::size_t k = 0; k < count; ++k)
  {
    const glm::dvec3 normal =
      glm::normalize(glm::cross(directions[hull[k]], directions[hull[(k + 1) % count]]));
    stands[k] = glm::dot(normal, edge) < 0.0 ? 1 : 0;
    this->Planes.emplace_back(normal, -glm::dot(normal, ends[stands[k]]));
  }
  std::vector<Corner> rim; // of what is far
  for (std::size_t k = 0; k < count; ++k)
  {
    const int i = stands[k];
    const int j = stands[(k + 1) % count];
    add(near(i), far(i, k + 1), far(i, k));
    rim.push_back(far(i, k + 1));
    if (i != j)
    {
      add(near(j), far(j, k + 1), far(i, k + 1));
      add(near(j), far(i, k + 1), near(i));
      rim.push_back(far(j, k + 1));
    }
  }
  for (std::size_t k = 1; k + 1 < rim.size(); ++k)
  {
    add(rim[0], rim[k], rim[k + 1]);
  }
}

//------------------------------------------------------------------------------
bool vtkShadowWedge::Misses(const glm::dvec3* corners, int count) const
{
  return std::any_of(this->Planes.begin(), this->Planes.end(),
    [&](const glm::dvec4& plane)
    {
      return std::all_of(corners, corners + count,
        [&](const glm::dvec3& corner) { return glm::dot(plane, glm::dvec4(corner, 1.0)) < 0.0; });
    });
}
