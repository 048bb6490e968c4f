// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOcclusionViews.h"

#include "vtkLightRegions.h"
#include "vtkShadowCasters.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using Shape = vtkShadowLight::Shape;
using Box = vtkLightRegions::Box;
using Range = vtkLightRegions::Range;

/** Tangents: what one view may show to either side of its axis, and a face of a cube. */
constexpr double WidestTangent = 2.2;
constexpr double FaceTangent = 1.0;

/** A face of a cube holds what kernels reach beyond it, as a share of the widest. */
constexpr double FacePadding = 1.5;

/** What is nearer to the light's plane than this share of the farthest depth is clipped. */
constexpr double NearestShare = 1e-3;

/** The centre of projection is no farther behind the light than so many times its casters. */
constexpr double FarthestBehind = 8.0;

/** Half side of a square of the same second moments as a disk of radius 1. */
const double DiskSide = std::sqrt(0.75);

/** The corners, of a disk or sphere of the box around it, in a view's plane. */
glm::dvec2 GetExtent(const vtkShadowLight& light, const vtkOcclusionView& view)
{
  if (light.Kind == Shape::Sphere)
  {
    return glm::dvec2(glm::length(light.U));
  }
  return { std::abs(glm::dot(light.U, view.X)) + std::abs(glm::dot(light.V, view.X)),
    std::abs(glm::dot(light.U, view.Y)) + std::abs(glm::dot(light.V, view.Y)) };
}

void SetAxes(vtkOcclusionView& view, const glm::dvec3& axis, const glm::dvec3& across)
{
  view.Z = axis;
  const glm::dvec3 x = across - glm::dot(across, axis) * axis;
  const double length = glm::length(x);
  view.X = length > 0.0 ? x / length : vtkShadowLight::Perpendicular(axis);
  view.Y = glm::cross(view.Z, view.X);
}

/**
 * All corners lie before the light's plane, and within the widest view; of flat casters, what has
 * something behind it does if that does.
 */
bool Fits(const vtkOcclusionView& view, const vtkLightRegions& regions)
{
  return std::all_of(regions.GetWhole().begin(), regions.GetWhole().end(),
    [&](int caster)
    {
      const Box& box = regions.GetBox(caster);
      return std::all_of(box.begin(), box.end(),
        [&](const glm::dvec3& corner)
        {
          const glm::dvec3 p = view.ToView(corner);
          return std::max(std::abs(p.x), std::abs(p.y)) < WidestTangent * p.z;
        });
    });
}

/** The mean direction to some casters' corners; zero where there is none. */
glm::dvec3 FindAxis(
  const glm::dvec3& place, const vtkLightRegions& regions, const std::vector<int>& casters)
{
  glm::dvec3 mean(0.0);
  for (const int caster : casters)
  {
    for (const auto& corner : regions.GetBox(caster))
    {
      const glm::dvec3 d = corner - place;
      const double length = glm::length(d);
      mean += length > 0.0 ? d / length : glm::dvec3(0.0);
    }
  }
  const double length = glm::length(mean);
  return length > 0.0 ? mean / length : mean;
}

/**
 * The largest distance behind the light from which a view that ends at the light's border holds all
 * casters: |x| <= a (1 + h / d).
 */
double FindBehind(
  const vtkOcclusionView& view, const glm::dvec2& extent, const vtkLightRegions& regions)
{
  double behind = std::numeric_limits<double>::max();
  double farthest = 0.0;
  for (const int caster : regions.GetWhole())
  {
    for (const auto& corner : regions.GetBox(caster))
    {
      const glm::dvec3 p = view.ToView(corner);
      farthest = std::max(farthest, p.z);
      for (int axis = 0; axis < 2; ++axis)
      {
        const double out = std::abs(p[axis]) - extent[axis];
        behind = out > 0.0 ? std::min(behind, extent[axis] * std::max(p.z, 0.0) / out) : behind;
      }
    }
  }
  return std::min(behind, FarthestBehind * farthest);
}

/** The rectangle that the light is taken for. */
void SetLight(vtkOcclusionView& view, const vtkShadowLight& light)
{
  const double side = light.Kind == Shape::Rectangle ? 1.0 : DiskSide;
  if (light.Kind == Shape::Sphere)
  {
    // The disk that faces a receiver, seen along its ray to the view's plane.
    const double reach = view.Face ? FaceTangent : WidestTangent;
    view.Light = glm::dvec2(side * glm::length(light.U) * std::sqrt(1.0 + reach * reach));
    return;
  }
  const auto along = [&](const glm::dvec3& axis)
  { return side * glm::length(glm::dvec2(glm::dot(light.U, axis), glm::dot(light.V, axis))); };
  view.Light = { along(view.X), along(view.Y) };
}

/** The greatest depth at which something can hide something: a lone flat caster nothing beyond the rest. */
double FindDeepest(
  const vtkOcclusionView& view, const vtkLightRegions& regions, const vtkShadowCasters& casters)
{
  const auto& whole = regions.GetWhole();
  const bool lone = regions.GetCasters().size() == whole.size() + 1;
  double deepest = std::numeric_limits<double>::lowest();
  const auto add = [&](const Box& box)
  {
    for (const auto& corner : box)
    {
      deepest = std::max(deepest, view.ToView(corner).z);
    }
  };
  for (int i = 0; i < static_cast<int>(casters.Get().size()); ++i)
  {
    if (!lone || std::binary_search(whole.begin(), whole.end(), i) ||
        !std::binary_search(regions.GetCasters().begin(), regions.GetCasters().end(), i))
    {
      add(casters.Get()[i].Corners);
    }
  }
  std::for_each(casters.GetReceivers().begin(), casters.GetReceivers().end(), add);
  return deepest;
}

/** Fill in what depends on the casters. False where none is in view. */
bool Hug(vtkOcclusionView& view, const vtkLightRegions& regions, const vtkShadowCasters& casters)
{
  double farthest = 0.0;
  const auto reach = [&](const Box& box)
  {
    for (const auto& corner : box)
    {
      farthest = std::max(farthest, view.ToView(corner).z);
    }
  };
  view.Receivers = std::numeric_limits<double>::lowest();
  double low = std::numeric_limits<double>::max();
  for (const auto& caster : casters.Get())
  {
    for (const auto& corner : caster.Corners)
    {
      view.Receivers = std::max(view.Receivers, view.ToView(corner).z);
    }
  }
  for (const auto& box : casters.GetReceivers())
  {
    for (const auto& corner : box)
    {
      view.Receivers = std::max(view.Receivers, view.ToView(corner).z);
    }
  }
  for (const int caster : regions.GetWhole())
  {
    reach(regions.GetBox(caster));
    for (const auto& corner : regions.GetBox(caster))
    {
      low = std::min(low, view.ToView(corner).z);
    }
  }
  if (!view.Directional && !(farthest > 0.0))
  {
    return false; // all lie behind the light's plane
  }
  const double nearest = view.Directional ? low : NearestShare * farthest;
  const glm::dvec2 widest = view.GetKernel(view.Directional ? nearest : std::max(low, nearest));
  const double limit = view.Face ? FaceTangent + FacePadding * std::max(widest.x, widest.y)
                                 : std::numeric_limits<double>::max();
  const auto project = [&](const Box& box)
  {
    Range range;
    bool cut = false;
    bool outside[4] = { true, true, true, true };
    for (const auto& corner : box)
    {
      const glm::dvec3 p = view.ToView(corner);
      const double w = view.GetW(p.z);
      for (int k = 0; k < 4; ++k)
      {
        outside[k] = outside[k] && (k < 2 ? p[k] > limit * w : -p[k - 2] > limit * w);
      }
      if (view.Directional || p.z >= nearest)
      {
        range.Add({ p.x / w, p.y / w, p.z });
      }
      else
      {
        cut = true;
      }
    }
    if (range.IsEmpty() || std::find(outside, outside + 4, true) != outside + 4)
    {
      return Range();
    }
    const double end = view.Face ? limit : WidestTangent;
    if (cut)
    {
      range.Add({ -end, -end, nearest });
      range.Add({ end, end, nearest });
    }
    for (int axis = 0; axis < 2; ++axis)
    {
      range.Low[axis] = std::max(range.Low[axis], -limit);
      range.High[axis] = std::min(range.High[axis], limit);
    }
    return range;
  };
  view.Nearest = nearest;
  view.Farthest = farthest;
  const glm::dvec2 overlap = view.GetKernel(nearest);
  const auto groups = regions.GetGroups(project, std::max(overlap.x, overlap.y), 1);
  if (groups.empty())
  {
    return false;
  }
  const auto& group = groups.front();
  view.Low = glm::dvec2(group.Needed.Low);
  view.High = glm::dvec2(group.Needed.High);
  // What is off by rounding is to be within.
  const double rounding =
    1e-6 * std::max({ std::abs(group.Whole.Low.z), std::abs(group.Whole.High.z),
             glm::length(view.High) * view.GetW(group.Whole.High.z) });
  view.Nearest = view.Directional ? group.Whole.Low.z - rounding
                                  : std::max(nearest, group.Whole.Low.z - rounding);
  view.Farthest = std::min(group.Whole.High.z, FindDeepest(view, regions, casters)) + rounding;
  view.Receivers = std::max(view.Receivers, view.Farthest);
  view.Casters = group.Casters;
  return true;
}
}

//------------------------------------------------------------------------------
glm::dvec3 vtkOcclusionView::ToView(const glm::dvec3& SWC) const
{
  const glm::dvec3 p = SWC - this->Place;
  return { glm::dot(this->X, p), glm::dot(this->Y, p), glm::dot(this->Z, p) };
}

//------------------------------------------------------------------------------
glm::dvec2 vtkOcclusionView::GetKernel(double depth) const
{
  if (this->Directional)
  {
    return this->Light * std::max(this->Receivers - depth, 0.0);
  }
  return this->Light * std::max(1.0 - depth / this->Receivers, 0.0) / this->GetW(depth);
}

//------------------------------------------------------------------------------
glm::dvec2 vtkOcclusionView::GetClipRange() const
{
  const double margin = 1e-3 * (this->Farthest - this->Nearest) +
                        1e-5 * std::max(std::abs(this->Nearest), std::abs(this->Farthest));
  return { this->Directional ? this->Nearest - margin
                             : std::max(this->Nearest - margin, 0.9 * this->Nearest),
    this->Farthest + margin };
}

//------------------------------------------------------------------------------
glm::dmat4 vtkOcclusionView::GetSWCToClip(const glm::dvec2& low, const glm::dvec2& high) const
{
  const glm::dvec2 range = this->GetClipRange();
  const double zNear = range.x;
  const double zFar = range.y;
  const glm::dvec2 size = high - low;
  const glm::dvec2 centre = 0.5 * (low + high);
  const auto row = [this](const glm::dvec3& direction, double offset)
  { return glm::dvec4(direction, offset - glm::dot(direction, this->Place)); };
  glm::dmat4 rows;
  if (this->Directional)
  {
    rows[0] = row(this->X * (2.0 / size.x), -2.0 * centre.x / size.x);
    rows[1] = row(this->Y * (2.0 / size.y), -2.0 * centre.y / size.y);
    rows[2] = row(this->Z * (2.0 / (zFar - zNear)), -(zFar + zNear) / (zFar - zNear));
    rows[3] = glm::dvec4(0.0, 0.0, 0.0, 1.0);
    return glm::transpose(rows);
  }
  const double d = this->Behind;
  const double nearW = d + zNear;
  const double farW = d + zFar;
  const double a = (farW + nearW) / (farW - nearW);
  const double b = -2.0 * farW * nearW / (farW - nearW);
  rows[0] = row((this->X - centre.x * this->Z) * (2.0 / size.x), -2.0 * centre.x * d / size.x);
  rows[1] = row((this->Y - centre.y * this->Z) * (2.0 / size.y), -2.0 * centre.y * d / size.y);
  rows[2] = row(this->Z * a, a * d + b);
  rows[3] = row(this->Z, d);
  return glm::transpose(rows);
}

//------------------------------------------------------------------------------
std::vector<vtkOcclusionView> vtkOcclusionView::Find(
  const vtkShadowLightPart& part, const vtkShadowCasters& casters, int resolution)
{
  const vtkShadowLight& light = part.Light;
  const vtkLightRegions regions(part, casters);
  std::vector<vtkOcclusionView> views;
  if (regions.GetCasters().empty())
  {
    return views;
  }
  const auto add = [&](vtkOcclusionView view)
  {
    SetLight(view, light);
    if (Hug(view, regions, casters))
    {
      views.push_back(std::move(view));
    }
  };
  vtkOcclusionView view;
  if (light.IsDirectional())
  {
    view.Directional = true;
    SetAxes(view, light.Direction, glm::dvec3(0.0));
    add(view);
    return views;
  }

  // Along the direction to the largest caster, which does not move with others, or to all; also for a
  // plane light of no size, and of so little that it is within a texel, or the limit would have other
  // texels. Else parallel to it, where that sees all.
  view.Place = light.Position - casters.GetOrigin();
  for (const auto& some : { std::vector<int>{ regions.GetLargest() }, regions.GetWhole() })
  {
    const glm::dvec3 axis = FindAxis(view.Place, regions, some);
    if (axis != glm::dvec3(0.0) && (view.Z == glm::dvec3(0.0) || !Fits(view, regions)))
    {
      SetAxes(view, axis, glm::dvec3(0.0));
    }
  }
  const auto tryOne = [&](vtkOcclusionView one)
  {
    if (one.Z == glm::dvec3(0.0) || !Fits(one, regions))
    {
      return false;
    }
    one.Behind = FindBehind(one, GetExtent(light, one), regions);
    add(one);
    // Flat casters may be needed farther out than one view sees.
    const bool wide =
      !views.empty() && glm::any(glm::greaterThanEqual(
                          glm::max(glm::abs(views.back().Low), glm::abs(views.back().High)),
                          glm::dvec2(WidestTangent)));
    if (wide)
    {
      views.clear();
    }
    return !wide;
  };
  const bool plane = light.Kind == Shape::Rectangle || light.Kind == Shape::Disk;
  if (plane && !light.IsPoint())
  {
    if (tryOne(view) && !views.empty())
    {
      const vtkOcclusionView& found = views.front();
      const glm::dvec2 texels = 2.0 * found.GetKernel(found.Nearest) *
                                static_cast<double>(resolution) /
                                glm::max(found.High - found.Low, glm::dvec2(1e-300));
      if (std::min(texels.x, texels.y) < 1.0)
      {
        return views;
      }
    }
    views.clear();
    vtkOcclusionView parallel = view;
    SetAxes(parallel, glm::normalize(light.Direction), light.U);
    if (tryOne(parallel))
    {
      return views;
    }
  }
  if (tryOne(view))
  {
    return views;
  }
  // Six, of which the faces that hold no caster are none; turned as the light is.
  const glm::dvec3 z = light.Direction;
  const glm::dvec3 x =
    glm::length(light.U) > 0.0 ? glm::normalize(light.U) : vtkShadowLight::Perpendicular(z);
  const glm::dvec3 axes[] = { x, glm::cross(z, x), z };
  for (int face = 0; face < 6; ++face)
  {
    vtkOcclusionView one = view;
    one.Face = true;
    SetAxes(one, face % 2 ? -axes[face / 2] : axes[face / 2], axes[(face / 2 + 1) % 3]);
    const glm::dvec2 extent = GetExtent(light, one);
    one.Behind = std::max(extent.x, extent.y) / FaceTangent;
    add(one);
  }
  return views;
}
