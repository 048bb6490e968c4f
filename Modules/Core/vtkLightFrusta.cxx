#include "vtkLightFrusta.h"

#include "vtkShadowCasters.h"
#include "vtkShadowLight.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vector_relational.hpp>

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

/** So many flat casters get the exact treatment; more are all drawn whole. */
constexpr std::size_t MostFlatCasters = 64;

/** A view shows at most so much beyond a border, as a tangent: look-ups further out are drawn in. */
constexpr double WidestOverlap = 0.6;

double Tangent(double degrees)
{
  return std::tan(glm::radians(degrees));
}

/** An axis-aligned range on a view plane, and along the view axis. */
struct Range
{
  glm::dvec3 Low{ std::numeric_limits<double>::max() };
  glm::dvec3 High{ std::numeric_limits<double>::lowest() };

  /** The window of this one reaches over that of another. */
  bool ReachesOver(const Range& other) const
  {
    return this->Low.x < other.Low.x || this->Low.y < other.Low.y || this->High.x > other.High.x ||
           this->High.y > other.High.y;
  }
  bool IsEmpty() const
  {
    return this->Low.x > this->High.x || this->Low.y > this->High.y || this->Low.z > this->High.z;
  }
  void Add(const glm::dvec3& p)
  {
    this->Low = glm::min(this->Low, p);
    this->High = glm::max(this->High, p);
  }
  void Add(const Range& other)
  {
    if (!other.IsEmpty())
    {
      this->Add(other.Low);
      this->Add(other.High);
    }
  }
  /** The common window, the other being that much larger; the depth stays this one's. */
  Range Window(const Range& other, double overlap) const
  {
    Range result = *this;
    result.Low.x = std::max(this->Low.x, other.Low.x - overlap);
    result.Low.y = std::max(this->Low.y, other.Low.y - overlap);
    result.High.x = std::min(this->High.x, other.High.x + overlap);
    result.High.y = std::min(this->High.y, other.High.y + overlap);
    return result;
  }
};

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

/** Everything that a box shows of itself in a view, given how its corners project; and its whole. */
template <typename Project>
Range RegionRange(const std::vector<glm::dvec3>& box,
  const std::vector<std::vector<glm::dvec3>>& others, double overlap, Project project, Range& whole)
{
  const Range own = project(box);
  whole.Add(own);
  if (others.empty() || own.IsEmpty())
  {
    return own;
  }
  Range shared;
  for (const auto& other : others)
  {
    const Range window = project(other);
    if (!window.IsEmpty())
    {
      shared.Add(own.Window(window, overlap));
    }
  }
  return shared;
}
}

//------------------------------------------------------------------------------
vtkLightFrusta::vtkLightFrusta(
  const vtkShadowLight& light, const vtkShadowCasters& casters, double border, bool neighbours)
  : Light(light)
  , Border(border)
  , Around(neighbours)
  , Neighbours(neighbours && !light.IsPoint())
  , Origin(casters.GetOrigin())
{
  const auto& all = casters.Get();
  auto receivers = casters.GetReceivers();
  for (const auto& caster : all)
  {
    if (!caster.IsSeenBy(light))
    {
      receivers.push_back(caster.Corners); // for this part of the light
    }
  }
  const auto extremes = light.GetExtremes();
  // Signed distance of a place on the light from a plane; of a direction, its component.
  const auto side = [&](const glm::dvec3& place, const glm::dvec3& normal, const glm::dvec3& point)
  {
    return light.IsDirectional() ? glm::dot(normal, place)
                                 : glm::dot(normal, place - this->Origin - point);
  };
  const std::size_t flatCount = std::count_if(
    all.begin(), all.end(), [](const vtkShadowCaster& caster) { return caster.Mesh->Flat; });

  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const auto& caster = all[i];
    if (caster.Mesh->Indices.empty() || !caster.IsSeenBy(light))
    {
      continue;
    }
    Region region{ Corners(caster.Corners.begin(), caster.Corners.end()), {} };
    if (caster.Mesh->Flat && flatCount <= MostFlatCasters)
    {
      // A plane cannot shadow itself; only what lies behind it matters.
      const glm::dmat3 linear(caster.MeshToWC);
      glm::dvec3 normal = glm::transpose(glm::inverse(linear)) * caster.Mesh->Normal;
      const glm::dvec3 point(caster.MeshToWC * glm::dvec4(caster.Mesh->PlanePoint, 1.0));
      const double length = glm::length(normal);
      normal = length > 0.0 && std::isfinite(length) ? normal / length : glm::dvec3(0.0);
      double lowest = std::numeric_limits<double>::max();
      double highest = std::numeric_limits<double>::lowest();
      for (const auto& place : extremes)
      {
        const double distance = side(place, normal, point);
        lowest = std::min(lowest, distance);
        highest = std::max(highest, distance);
      }
      if (lowest > 0.0 || highest < 0.0)
      {
        const double towardsLight = lowest > 0.0 ? 1.0 : -1.0;
        const auto addIfBehind = [&](const std::array<glm::dvec3, 8>& box)
        {
          // Touching is not behind: floors under things that stand on them.
          const double tolerance = 1e-6 * glm::length(box[7] - box[0]);
          for (const auto& corner : box)
          {
            if (towardsLight * glm::dot(normal, corner - point) < -tolerance)
            {
              region.Others.emplace_back(box.begin(), box.end());
              return;
            }
          }
        };
        for (std::size_t j = 0; j < all.size(); ++j)
        {
          if (j != i && all[j].IsSeenBy(light))
          {
            addIfBehind(all[j].Corners);
          }
        }
        for (const auto& box : receivers)
        {
          addIfBehind(box);
        }
        if (region.Others.empty())
        {
          continue; // nothing can lie in its shadow
        }
      }
    }
    this->Included.push_back(static_cast<int>(i));
    this->Regions.push_back(std::move(region));
  }

  // Bodies, or flat things where there are no others: a floor is not what casts.
  std::vector<int> bodies;
  std::copy_if(this->Included.begin(), this->Included.end(), std::back_inserter(bodies),
    [&all](int i) { return !all[i].Mesh->Flat; });
  bodies = bodies.empty() ? this->Included : bodies;
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
    // As far as anything is from anything else.
    Range all;
    for (const auto& region : this->Regions)
    {
      for (const auto& corner : region.Box)
      {
        all.Add(corner);
      }
      for (const auto& other : region.Others)
      {
        for (const auto& corner : other)
        {
          all.Add(corner);
        }
      }
    }
    return all.IsEmpty() ? 0.0 : size * glm::length(all.High - all.Low);
  }
  double nearest = std::numeric_limits<double>::max();
  for (const auto& region : this->Regions)
  {
    // Of the sphere around the box; negative where the light may be in it.
    const glm::dvec3 middle = 0.5 * (region.Box.front() + region.Box.back());
    const double radius = 0.5 * glm::length(region.Box.back() - region.Box.front());
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
  return std::any_of(this->Included.begin(), this->Included.end(),
    [&](int index)
    {
      const vtkShadowCaster& caster = casters.Get()[index];
      const auto& positions = caster.Mesh->Positions;
      for (std::size_t i = 0; i + 2 < positions.size(); i += 3)
      {
        const glm::dvec4 p(positions[i], positions[i + 1], positions[i + 2], 1.0);
        if (glm::length(glm::dvec3(caster.MeshToWC * p) - position) < least)
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
  if (this->Included.empty())
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
  const double overlap = this->GetOverlap(glm::dvec3(0.0), 0.0);
  Range range;
  Range whole;
  for (const auto& region : this->Regions)
  {
    range.Add(RegionRange(
      region.Box, region.Others, overlap,
      [&](const Corners& box)
      {
        Range own;
        for (const auto& corner : box)
        {
          own.Add(frame(corner));
        }
        return own;
      },
      whole));
  }
  if (range.IsEmpty())
  {
    return {};
  }
  const bool clipped = whole.ReachesOver(range);
  Widen(range, this->Border);
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
  view.WCToClip = glm::transpose(rows);
  view.Clipped = clipped;
  view.Place = towardsLight;
  view.WindowX = frame.X * size.x;
  view.WindowY = frame.Y * size.y;
  view.DepthScale = 1.0 / size.z;
  return { view };
}

//------------------------------------------------------------------------------
std::vector<vtkLightView> vtkLightFrusta::GetPositionalViews(const glm::dvec3& position) const
{
  std::vector<vtkLightView> views;
  // VTK has one cone, at the centre: another place on the light has to see beyond its own.
  // So do look-ups around the centre: as far as the light's size carries them, or all the way.
  const double overlap = this->GetOverlap(position, Tangent(WidestHalfAngle));
  if (position == this->Light.Position - this->Origin && this->Light.ConeAngle <= WidestHalfAngle &&
      Tangent(this->Light.ConeAngle) + overlap <= Tangent(WidestHalfAngle))
  {
    this->AddPerspectiveView(
      position, this->Light.Direction, Tangent(this->Light.ConeAngle), overlap, false, views);
    return views;
  }

  // One frustum along the mean direction, where it sees all corners under a small enough angle.
  glm::dvec3 mean(0.0);
  for (const auto& region : this->Regions)
  {
    for (const auto& corner : region.Box)
    {
      const glm::dvec3 d = corner - position;
      const double length = glm::length(d);
      mean += length > 0.0 ? d / length : glm::dvec3(0.0);
    }
  }
  const double length = glm::length(mean);
  const double least = std::cos(glm::radians(WidestHalfAngle));
  bool fits = length > 0.0;
  for (const auto& region : this->Regions)
  {
    for (std::size_t i = 0; fits && i < region.Box.size(); ++i)
    {
      const glm::dvec3 d = region.Box[i] - position;
      // "Not less", so that a corner at the light itself fails too.
      fits = glm::dot(d, mean) > least * length * glm::length(d);
    }
  }
  if (fits)
  {
    this->AddPerspectiveView(
      position, mean / length, Tangent(WidestHalfAngle) * 1.01, overlap, false, views);
    return views;
  }

  for (int face = 0; face < 6; ++face)
  {
    glm::dvec3 axis(0.0);
    axis[face / 2] = face % 2 ? -1.0 : 1.0;
    this->AddPerspectiveView(
      position, axis, 1.0, this->GetOverlap(position, WidestOverlap), true, views);
  }
  return views;
}

//------------------------------------------------------------------------------
bool vtkLightFrusta::AddPerspectiveView(const glm::dvec3& position, const glm::dvec3& axis,
  double border, double overlap, bool face, std::vector<vtkLightView>& views) const
{
  const Frame frame(axis);
  const double limit = border + overlap;
  // A box in x/z, y/z and z, clipped to |x/z|, |y/z| <= limit; the whole window where the box
  // reaches behind the light.
  const auto project = [&](const Corners& box)
  {
    Range range;
    bool behind = false;
    bool outside[5] = { true, true, true, true, true };
    for (const auto& corner : box)
    {
      const glm::dvec3 p = frame(corner - position);
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
  Range range;
  Range whole;
  for (const auto& region : this->Regions)
  {
    range.Add(RegionRange(region.Box, region.Others, overlap, project, whole));
  }
  if (range.IsEmpty())
  {
    return false;
  }
  const std::array<bool, 4> cut = { -range.Low.x >= limit, -range.Low.y >= limit,
    range.High.x >= limit, range.High.y >= limit };
  const bool clipped = std::count(cut.begin(), cut.end(), true) > 0 || whole.ReachesOver(range);
  Widen(range, this->Border);
  if (face && !this->Around)
  {
    // Faces of a cube do not overlap, or a point on their common edge would be counted twice.
    range.Low = glm::max(range.Low, glm::dvec3(-1.0, -1.0, 0.0));
    range.High = glm::dvec3(glm::min(glm::dvec2(range.High), glm::dvec2(1.0)), range.High.z);
  }
  const double zFar = range.High.z * 1.001;
  const double zNear = std::max(range.Low.z * 0.999, zFar * NearestNear);

  const glm::dvec2 size(range.High - range.Low);
  const glm::dvec2 centre = 0.5 * (glm::dvec2(range.High) + glm::dvec2(range.Low));
  const auto row = [&](const glm::dvec3& direction, double offset)
  { return glm::dvec4(direction, offset - glm::dot(direction, position)); };
  glm::dmat4 rows;
  rows[0] = row((frame.X - centre.x * frame.Z) * (2.0 / size.x), 0.0);
  rows[1] = row((frame.Y - centre.y * frame.Z) * (2.0 / size.y), 0.0);
  rows[2] = row(frame.Z * ((zFar + zNear) / (zFar - zNear)), -2.0 * zFar * zNear / (zFar - zNear));
  rows[3] = row(frame.Z, 0.0);
  vtkLightView view;
  view.WCToClip = glm::transpose(rows);
  view.Clipped = clipped;
  view.Place = position;
  view.Cut = cut;
  view.Face = face;
  view.WindowX = frame.X * size.x;
  view.WindowY = frame.Y * size.y;
  view.DepthScale = zFar * zNear / (zFar - zNear);
  view.DepthConstant = zFar / (zFar - zNear);
  views.push_back(view);
  return true;
}
