// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLightFrusta.h"

#include "vtkLightRegions.h"
#include "vtkShadowCasters.h"
#include "vtkShadowLight.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace
{
/**
 * A light inside or touching geometry: what is nearer to it than this share of the frustum's depth
 * is clipped. 32-bit depth then still resolves less than a texel at the far end.
 */
constexpr double NearestNear = 1e-3;

/** Beyond this angle from its axis one frustum wastes its texels, and a cube takes over. */
constexpr double WidestHalfAngle = 65.0;

/** Sizes of windows for each doubling: they are at most 9 % larger than needed. */
constexpr double StepsADoubling = 8.0;

/** Casters within this angle from the largest are seen along its axis: steeper wastes texels. */
constexpr double WidestSteadyAngle = 55.0;

/** A view shows at most so much beyond a border, as a tangent: look-ups further out are drawn in. */
constexpr double WidestOverlap = 0.6;

double Tangent(double degrees)
{
  return std::tan(glm::radians(degrees));
}

using Range = vtkLightRegions::Range;

/** Orthonormal axes of a view, z along it. They follow from it alone, not from the light's size. */
struct Frame
{
  explicit Frame(const glm::dvec3& axis)
    : X(vtkShadowLight::Perpendicular(axis))
    , Y(glm::cross(axis, X))
    , Z(axis)
  {
  }
  glm::dvec3 operator()(const glm::dvec3& v) const
  {
    return { glm::dot(this->X, v), glm::dot(this->Y, v), glm::dot(this->Z, v) };
  }
  glm::dvec3 X, Y, Z;
};

/**
 * Let one side of a window take steps: its size against the anchor's in powers of a little more than 1,
 * its place in whole texels. Both follow from the scene alone, whatever its units, place and turn, and
 * whatever was before. What is off by rounding takes no step.
 */
void Step(Range& range, const Range& anchor, int axis, const vtkLightFrusta::Options& options)
{
  double& low = range.Low[axis];
  double& high = range.High[axis];
  const double own = anchor.High[axis] - anchor.Low[axis];
  const bool alone = low == anchor.Low[axis] && high == anchor.High[axis];
  if (options.Texel == 0.0 || alone || !(own > 1e-6 * (high - low)))
  {
    return;
  }
  double end = low;
  double start = low;
  for (double step = std::ceil(StepsADoubling * std::log2((high - low) / own) - 1e-6);
       end < high - 1e-6 * own; ++step)
  {
    const double size = own * std::exp2(step / StepsADoubling);
    const double texel = size * (1.0 + 2.0 * options.Border) * options.Texel;
    start = anchor.Low[axis] + texel * std::floor((low - anchor.Low[axis]) / texel + 1e-6);
    end = start + size;
  }
  low = start;
  high = end;
}

/** A clear border around the window, as a share of its size. */
void Widen(Range& range, double border)
{
  glm::dvec3 size = range.High - range.Low;
  const double largest = std::max({ size.x, size.y, std::numeric_limits<double>::min() });
  for (int c = 0; c < 2; ++c)
  {
    // A window of no width (an edge-on caster) still needs some.
    const double margin = std::max(border * size[c], 1e-6 * largest);
    range.Low[c] -= margin;
    range.High[c] += margin;
  }
}

}

//------------------------------------------------------------------------------
vtkLightFrusta::vtkLightFrusta(const vtkShadowLightPart& part, const vtkShadowCasters& casters)
  : vtkLightFrusta(part, casters, Options())
{
}

//------------------------------------------------------------------------------
vtkLightFrusta::vtkLightFrusta(
  const vtkShadowLightPart& part, const vtkShadowCasters& casters, const Options& options)
  : Light(part.Light)
  , Wanted(options)
  , Neighbours(options.Neighbours && !part.Light.IsPoint())
  , Origin(casters.GetOrigin())
  , Regions(std::make_shared<vtkLightRegions>(part, casters))
{
  const auto& all = casters.Get();
  // Bodies, or flat things where there are no others: a floor is not what casts.
  std::vector<int> bodies;
  const auto& included = this->GetCasters();
  std::copy_if(included.begin(), included.end(), std::back_inserter(bodies),
    [&all](int i) { return !all[i].Mesh->Flat; });
  bodies = bodies.empty() ? included : bodies;
  glm::dvec3 middle(0.0);
  for (const int i : bodies)
  {
    middle += all[i].GetMiddle() / static_cast<double>(bodies.size());
  }
  for (const int i : bodies)
  {
    this->Extent =
      std::max(this->Extent, 2.0 * (glm::length(all[i].GetMiddle() - middle) + all[i].GetRadius()));
  }
}

//------------------------------------------------------------------------------
const std::vector<int>& vtkLightFrusta::GetCasters() const
{
  return this->Regions->GetCasters();
}

//------------------------------------------------------------------------------
double vtkLightFrusta::GetExtent() const
{
  return this->Extent;
}

//------------------------------------------------------------------------------
double vtkLightFrusta::GetOverlap(const glm::dvec3& position, double widest) const
{
  if (!this->Neighbours)
  {
    return 0.0;
  }
  const double size = glm::length(this->Light.U) + glm::length(this->Light.V);
  if (this->Light.IsDirectional())
  {
    return size * this->Regions->GetDiameter();
  }
  double nearest = std::numeric_limits<double>::max();
  for (const int caster : this->GetCasters())
  {
    // Of the sphere around the box; negative where the light may be in it.
    const auto& box = this->Regions->GetBox(caster);
    const glm::dvec3 middle = 0.5 * (box.front() + box.back());
    const double radius = 0.5 * glm::length(box.back() - box.front());
    nearest = std::min(nearest, glm::length(middle - position) - radius);
  }
  return nearest * widest > size ? size / nearest : widest;
}

//------------------------------------------------------------------------------
bool vtkLightFrusta::IsOverlapExceeded(const vtkShadowCasters& casters) const
{
  const double size = glm::length(this->Light.U) + glm::length(this->Light.V);
  const double least = size / WidestOverlap;
  const glm::dvec3 position = this->Light.Position - this->Origin;
  if (!this->Neighbours || this->Light.IsDirectional() ||
      this->GetOverlap(position, WidestOverlap) < WidestOverlap)
  {
    return false;
  }
  return std::any_of(this->GetCasters().begin(), this->GetCasters().end(),
    [&](int index)
    {
      const vtkShadowCaster& caster = casters.Get()[index];
      const auto& positions = caster.Mesh->Positions;
      for (std::size_t i = 0; i + 2 < positions.size(); i += 3)
      {
        const glm::dvec4 p(positions[i], positions[i + 1], positions[i + 2], 1.0);
        if (glm::length(glm::dvec3(caster.MeshToSWC * p) - position) < least)
        {
          return true;
        }
      }
      return false;
    });
}

//------------------------------------------------------------------------------
std::vector<vtkLightView> vtkLightFrusta::GetViews(const glm::dvec3& place) const
{
  if (this->GetCasters().empty())
  {
    return {};
  }
  return this->Light.IsDirectional() ? this->GetDirectionalViews(place)
                                     : this->GetPositionalViews(place - this->Origin);
}

//------------------------------------------------------------------------------
std::vector<vtkLightView> vtkLightFrusta::GetDirectionalViews(const glm::dvec3& towardsLight) const
{
  const Frame frame(-towardsLight);
  const auto groups = this->Regions->GetGroups(
    [&frame](const vtkLightRegions::Box& box)
    {
      Range range;
      for (const auto& corner : box)
      {
        range.Add(frame(corner));
      }
      return range;
    },
    this->GetOverlap(glm::dvec3(0.0), 0.0), this->Wanted.Groups);
  std::vector<vtkLightView> views;
  for (const auto& group : groups)
  {
    Range range = group.Needed;
    for (int axis = 0; axis < 2; ++axis)
    {
      Step(range, group.Anchor, axis, this->Wanted);
    }
    Widen(range, this->Wanted.Border);
    const double depthMargin = 1e-3 * glm::length(range.High - range.Low);
    range.Low.z -= depthMargin;
    range.High.z += depthMargin;

    const glm::dvec3 size = range.High - range.Low;
    const glm::dvec3 centre = 0.5 * (range.High + range.Low);
    vtkLightView view;
    const glm::dvec3 axes[] = { frame.X, frame.Y, frame.Z };
    glm::dmat4 rows(0.0);
    for (int c = 0; c < 3; ++c)
    {
      rows[c] = glm::dvec4(axes[c], -centre[c]) * (2.0 / size[c]);
    }
    rows[3] = glm::dvec4(0.0, 0.0, 0.0, 1.0);
    view.SWCToClip = glm::transpose(rows);
    view.Clipped = group.Whole.ReachesOver(group.Needed);
    view.Place = towardsLight;
    view.WindowX = frame.X * size.x;
    view.WindowY = frame.Y * size.y;
    view.DepthScale = 1.0 / size.z;
    view.Casters = group.Casters;
    views.push_back(view);
  }
  return views;
}

//------------------------------------------------------------------------------
bool vtkLightFrusta::FindAxis(const glm::dvec3& position, const std::vector<int>& casters,
  double widestAngle, glm::dvec3& axis) const
{
  glm::dvec3 mean(0.0);
  for (const int caster : casters)
  {
    for (const auto& corner : this->Regions->GetBox(caster))
    {
      const glm::dvec3 d = corner - position;
      const double length = glm::length(d);
      mean += length > 0.0 ? d / length : glm::dvec3(0.0);
    }
  }
  const double length = glm::length(mean);
  const double least = std::cos(glm::radians(widestAngle));
  axis = mean / length;
  const auto fits = [&](int caster)
  {
    const auto& box = this->Regions->GetBox(caster);
    return std::all_of(box.begin(), box.end(),
      [&](const glm::dvec3& corner)
      {
        // "Greater", so that a corner at the light itself fails too.
        const glm::dvec3 d = corner - position;
        return glm::dot(d, mean) > least * length * glm::length(d);
      });
  };
  return length > 0.0 && std::all_of(this->GetCasters().begin(), this->GetCasters().end(), fits);
}

//------------------------------------------------------------------------------
std::vector<vtkLightView> vtkLightFrusta::GetPositionalViews(const glm::dvec3& position) const
{
  // VTK has one cone, at the centre: another place on the light has to see beyond its own.
  // So do look-ups around the centre: as far as the light's size carries them, or all the way.
  const double widest = Tangent(WidestHalfAngle);
  const double overlap = this->GetOverlap(position, widest);
  if (position == this->Light.Position - this->Origin && this->Light.ConeAngle <= WidestHalfAngle &&
      Tangent(this->Light.ConeAngle) + overlap <= widest)
  {
    const double cone = Tangent(this->Light.ConeAngle);
    return this->GetPerspectiveViews(
      { position, this->Light.Direction, cone, overlap, false }, this->Wanted.Groups);
  }

  // Around an axis that does not move with what is smaller than the largest.
  glm::dvec3 axis;
  if (this->Wanted.Texel > 0.0 &&
      this->FindAxis(position, { this->Regions->GetLargest() }, WidestSteadyAngle, axis))
  {
    return this->GetPerspectiveViews(
      { position, axis, widest * 1.01, overlap, false }, this->Wanted.Groups);
  }

  // One frustum along the mean direction, where it sees all corners under a small enough angle.
  if (this->FindAxis(position, this->GetCasters(), WidestHalfAngle, axis))
  {
    return this->GetPerspectiveViews({ position, axis, widest * 1.01, overlap, false }, 1);
  }

  std::vector<vtkLightView> views;
  for (int face = 0; face < 6; ++face)
  {
    axis = glm::dvec3(0.0);
    axis[face / 2] = face % 2 ? -1.0 : 1.0;
    const auto more = this->GetPerspectiveViews(
      { position, axis, 1.0, this->GetOverlap(position, WidestOverlap), true }, 1);
    views.insert(views.end(), more.begin(), more.end());
  }
  return views;
}

//------------------------------------------------------------------------------
std::vector<vtkLightView> vtkLightFrusta::GetPerspectiveViews(const Aim& aim, int groups) const
{
  const Frame frame(aim.Axis);
  const double limit = aim.Border + aim.Overlap;
  // A box in x/z, y/z and z, clipped to |x/z|, |y/z| <= limit; the whole window where the box
  // reaches behind the light.
  const auto project = [&](const vtkLightRegions::Box& box)
  {
    Range range;
    bool behind = false;
    bool outside[5] = { true, true, true, true, true };
    for (const auto& corner : box)
    {
      const glm::dvec3 p = frame(corner - aim.Position);
      outside[0] = outside[0] && p.x > limit * p.z;
      outside[1] = outside[1] && p.x < -limit * p.z;
      outside[2] = outside[2] && p.y > limit * p.z;
      outside[3] = outside[3] && p.y < -limit * p.z;
      outside[4] = outside[4] && p.z <= 0.0;
      behind = behind || p.z <= 0.0;
      if (p.z > 0.0)
      {
        range.Add({ p.x / p.z, p.y / p.z, p.z });
      }
    }
    if (std::any_of(outside, outside + 5, [](bool all) { return all; }))
    {
      return Range();
    }
    const double farthest = range.High.z;
    if (behind)
    {
      range.Low = { -limit, -limit, 0.0 };
      range.High = { limit, limit, farthest };
    }
    range.Low.x = std::max(range.Low.x, -limit);
    range.Low.y = std::max(range.Low.y, -limit);
    range.High.x = std::min(range.High.x, limit);
    range.High.y = std::min(range.High.y, limit);
    return range;
  };
  std::vector<vtkLightView> views;
  for (const auto& group : this->Regions->GetGroups(project, aim.Overlap, groups))
  {
    Range range = group.Needed;
    vtkLightView view;
    view.Cut = { -range.Low.x >= limit, -range.Low.y >= limit, range.High.x >= limit,
      range.High.y >= limit };
    view.Clipped = std::count(view.Cut.begin(), view.Cut.end(), true) > 0 ||
                   group.Whole.ReachesOver(group.Needed);
    for (int axis = 0; axis < 2; ++axis)
    {
      if (!view.Cut[axis] && !view.Cut[axis + 2])
      {
        Step(range, group.Anchor, axis, this->Wanted);
      }
    }
    Widen(range, this->Wanted.Border);
    if (aim.Face && !this->Wanted.Neighbours)
    {
      // Faces of a cube do not overlap, or a point on their common edge would be counted twice.
      range.Low = glm::max(range.Low, glm::dvec3(-1.0, -1.0, 0.0));
      range.High = glm::dvec3(glm::min(glm::dvec2(range.High), glm::dvec2(1.0)), range.High.z);
    }
    const double zFar = range.High.z * 1.001;
    const double zNear =
      std::max(range.Low.z * 0.999, std::min(zFar * NearestNear, group.Nearest * 0.999));

    const glm::dvec2 size(range.High - range.Low);
    const glm::dvec2 centre = 0.5 * (glm::dvec2(range.High) + glm::dvec2(range.Low));
    const auto row = [&](const glm::dvec3& direction, double offset)
    { return glm::dvec4(direction, offset - glm::dot(direction, aim.Position)); };
    glm::dmat4 rows;
    rows[0] = row((frame.X - centre.x * frame.Z) * (2.0 / size.x), 0.0);
    rows[1] = row((frame.Y - centre.y * frame.Z) * (2.0 / size.y), 0.0);
    rows[2] =
      row(frame.Z * ((zFar + zNear) / (zFar - zNear)), -2.0 * zFar * zNear / (zFar - zNear));
    rows[3] = row(frame.Z, 0.0);
    view.SWCToClip = glm::transpose(rows);
    view.Place = aim.Position;
    view.Face = aim.Face;
    view.WindowX = frame.X * size.x;
    view.WindowY = frame.Y * size.y;
    view.DepthScale = zFar * zNear / (zFar - zNear);
    view.DepthConstant = zFar / (zFar - zNear);
    view.Casters = group.Casters;
    views.push_back(view);
  }
  return views;
}
