// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowWedges.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

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
  across =
    length > 1e-6 * glm::length(edge) ? across / length : vtkShadowLight::Perpendicular(axis);
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
    const double radius =
      light.Kind == Shape::Rectangle ? glm::length(light.U + light.V) : glm::length(light.U);
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
double vtkShadowWedgeLight::GetReach(const glm::dvec3& along) const
{
  const double u = std::abs(glm::dot(along, this->U));
  const double v = std::abs(glm::dot(along, this->V));
  return this->Kind == Shape::Rectangle ? u + v
         : this->Kind == Shape::Sphere  ? glm::length(this->U)
                                        : std::hypot(u, v);
}

//------------------------------------------------------------------------------
void vtkShadowWedgeEdge::SetPlane(const vtkShadowWedgeLight& light)
{
  const glm::dvec3 from = this->Ends[0] * light.Place.w - glm::dvec3(light.Place);
  const glm::dvec3 along = this->Ends[1] - this->Ends[0];
  const glm::dvec3 normal = glm::cross(along, from);
  const double length = glm::length(normal);
  const bool seen = length > 1e-12 * glm::length(along) * glm::length(from);
  this->Plane = this->Width = glm::dvec4(0.0);
  if (seen)
  {
    this->Plane = glm::dvec4(normal, -glm::dot(normal, this->Ends[0])) / length;
    // In the plane, across the edge: as far behind it as the light is before it, the penumbra reaches as
    // far as the light.
    const glm::dvec3 away = glm::cross(normal, along);
    const glm::dvec3 width = light.GetReach(glm::dvec3(this->Plane)) / glm::dot(away, from) * away;
    this->Width = glm::dvec4(width, -glm::dot(width, this->Ends[0]));
  }
}

//------------------------------------------------------------------------------
void vtkShadowWedge::Bound(const vtkShadowWedgeLight& light, const glm::dvec3 (&ends)[2],
  Bounds bounds, const std::vector<glm::dvec4>& within)
{
  this->Whole = false;
  this->Faces.clear();
  std::vector<std::vector<glm::dvec4>> faces;
  const auto addPart = [&](const glm::dvec3& from, const glm::dvec3& to)
  {
    const glm::dvec3 part[2] = { from, to };
    this->Faces.clear();
    this->BoundPart(light, part, bounds);
    for (const auto& plane : within)
    {
      this->Cut(plane);
    }
    faces.insert(faces.end(), this->Faces.begin(), this->Faces.end());
  };
  double heights[2] = { 0.0, 0.0 };
  if (light.Kind == Shape::Rectangle || light.Kind == Shape::Disk)
  {
    for (int i = 0; i < 2; ++i)
    {
      heights[i] = glm::dot(glm::cross(light.U, light.V), ends[i] - glm::dvec3(light.Place));
    }
  }
  if (heights[0] * heights[1] < 0.0)
  {
    // What lies before the light's plane and what lies behind it have bounds of their own.
    const glm::dvec3 middle =
      ends[0] + heights[0] / (heights[0] - heights[1]) * (ends[1] - ends[0]);
    addPart(ends[0], middle);
    addPart(middle, ends[1]);
  }
  else
  {
    addPart(ends[0], ends[1]);
  }
  this->Faces = this->Whole ? std::vector<std::vector<glm::dvec4>>() : std::move(faces);
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
      this->Whole = true;
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
      this->Whole = true;
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
  const auto near = [&](int end) { return glm::dvec4(ends[end], 1.0); };
  const auto far = [&](std::size_t k) { return glm::dvec4(directions[hull[k % count]], 0.0); };
  std::vector<int> stands(count); // at which end each face stands
  for (std::size_t k = 0; k < count; ++k)
  {
    const glm::dvec3 normal = glm::cross(directions[hull[k]], directions[hull[(k + 1) % count]]);
    stands[k] = glm::dot(normal, edge) < 0.0 ? 1 : 0;
  }
  std::vector<glm::dvec4> rim; // of what is infinitely far
  for (std::size_t k = 0; k < count; ++k)
  {
    const int i = stands[k];
    const int j = stands[(k + 1) % count];
    this->Faces.push_back({ near(i), far(k + 1), far(k) });
    if (i != j)
    {
      this->Faces.push_back({ near(j), far(k + 1), near(i) });
    }
    rim.push_back(far(k));
  }
  this->Faces.push_back(rim);
}

//------------------------------------------------------------------------------
// Cuts are found from the corner inside to the one outside: both faces at an edge find the same.
void vtkShadowWedge::Cut(const glm::dvec4& plane)
{
  std::vector<glm::dvec4> rim;
  std::vector<std::vector<glm::dvec4>> faces;
  for (const auto& face : this->Faces)
  {
    std::vector<glm::dvec4> inside;
    for (std::size_t i = 0; i < face.size(); ++i)
    {
      const glm::dvec4& a = face[i];
      const glm::dvec4& b = face[(i + 1) % face.size()];
      const double heightA = glm::dot(plane, a);
      const double heightB = glm::dot(plane, b);
      if (heightA >= 0.0)
      {
        inside.push_back(a);
      }
      if ((heightA >= 0.0) != (heightB >= 0.0))
      {
        const bool leaves = heightA >= 0.0;
        const glm::dvec4& in = leaves ? a : b;
        const glm::dvec4& out = leaves ? b : a;
        const double heightIn = leaves ? heightA : heightB;
        const double heightOut = leaves ? heightB : heightA;
        glm::dvec4 cut = heightIn * out - heightOut * in;
        cut /= cut.w > 0.0 ? cut.w : 1.0;
        inside.push_back(cut);
        if (std::find(rim.begin(), rim.end(), cut) == rim.end())
        {
          rim.push_back(cut);
        }
      }
    }
    if (inside.size() >= 3)
    {
      faces.push_back(std::move(inside));
    }
  }
  if (rim.size() >= 3)
  {
    const glm::dvec3 normal(plane);
    const glm::dvec3 x = vtkShadowLight::Perpendicular(glm::normalize(normal));
    const glm::dvec3 y = glm::cross(x, normal); // counterclockwise from outside
    glm::dvec3 middle(0.0);
    for (const auto& corner : rim)
    {
      middle += glm::dvec3(corner) / static_cast<double>(rim.size());
    }
    const auto angle = [&](const glm::dvec4& corner)
    {
      const glm::dvec3 arm = glm::dvec3(corner) - middle;
      return std::atan2(glm::dot(arm, y), glm::dot(arm, x));
    };
    std::sort(rim.begin(), rim.end(),
      [&](const glm::dvec4& a, const glm::dvec4& b) { return angle(a) < angle(b); });
    faces.push_back(std::move(rim));
  }
  this->Faces = std::move(faces);
}
