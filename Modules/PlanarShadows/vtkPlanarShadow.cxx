// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPlanarShadow.h"

#include "vtkShadowCasters.h"
#include "vtkShadowRoom.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace
{
/** Heights are off by so much of a caster's size; a light's share of its own that counts as level. */
constexpr double Rounding = 1e-6;

/** Beyond this share of the light's height, shadows go on to the end of the plane. */
constexpr double HighestShare = 0.999;

/** What of the receivers' extent a penumbra may need beside them: more would cost all the others. */
constexpr double MostMargin = 0.25;

/** Overlaps of less than this share of the receivers' extent are rounding. */
constexpr double Touch = 1e-9;

/** Windows end on a grid of at least so many cells to a side. */
constexpr double CellsOfWindow = 16.0;

/**
 * A window's ends on a grid that halves the receivers' extent some times: where light or casters move
 * a little, the texels stay where they are, and edges do not swim.
 */
void Snap(double& low, double& high, double receiversLow, double receiversHigh)
{
  const double extent = receiversHigh - receiversLow;
  const double size = high - low;
  if (extent > 0.0 && size > 1e-12 * extent)
  {
    const double cell = extent / std::exp2(std::ceil(std::log2(CellsOfWindow * extent / size)));
    // Rounding is not to cross a line of the grid.
    low = receiversLow + cell * std::floor((low - receiversLow) / cell + 1e-3);
    high = receiversLow + cell * std::ceil((high - receiversLow) / cell - 1e-3);
  }
}
}

//------------------------------------------------------------------------------
vtkPlanarShadow::vtkPlanarShadow(
  const vtkShadowLightPart& part, const vtkShadowPlane& plane, double side)
  : LightPart(part)
  , Plane(plane)
  , Side(side)
{
}

//------------------------------------------------------------------------------
glm::dvec4 vtkPlanarShadow::GetEquation() const
{
  return this->Side * this->Plane.GetEquation();
}

//------------------------------------------------------------------------------
glm::dvec4 vtkPlanarShadow::GetPlace(const vtkLightSample& sample) const
{
  return { sample.Point, this->LightPart.Light.IsDirectional() ? 0.0 : 1.0 };
}

//------------------------------------------------------------------------------
double vtkPlanarShadow::GetHeight(const glm::dvec4& place) const
{
  return glm::dot(this->GetEquation(), place);
}

//------------------------------------------------------------------------------
glm::dmat4 vtkPlanarShadow::GetProjection(const glm::dvec4& place) const
{
  const glm::dvec4 equation = this->GetEquation();
  return glm::dmat4(1.0) - glm::outerProduct(place, equation) / glm::dot(equation, place);
}

//------------------------------------------------------------------------------
glm::dmat4 vtkPlanarShadow::GetWindow() const
{
  const glm::dvec2 middle = 0.5 * (this->Window.Low + this->Window.High);
  const glm::dvec2 scale = 2.0 / (this->Window.High - this->Window.Low);
  glm::dmat4 rows(0.0);
  rows[0] = glm::dvec4(this->Plane.X, -middle.x) * scale.x;
  rows[1] = glm::dvec4(this->Plane.Y, -middle.y) * scale.y;
  rows[3] = glm::dvec4(0.0, 0.0, 0.0, 1.0);
  return glm::transpose(rows);
}

//------------------------------------------------------------------------------
glm::dvec3 vtkPlanarShadow::GetMiddle() const
{
  const vtkPlaneRectangle& area = this->Casters.empty() ? this->Plane.Receivers : this->Window;
  const glm::dvec2 middle = area.IsEmpty() ? glm::dvec2(0.0) : 0.5 * (area.Low + area.High);
  return this->Plane.Distance * this->Plane.Normal + middle.x * this->Plane.X +
         middle.y * this->Plane.Y;
}

//------------------------------------------------------------------------------
double vtkPlanarShadow::GetSpread(const glm::dvec4& place, double height) const
{
  const double share = height / this->GetHeight(place);
  return share / (1.0 - place.w * std::min(share, HighestShare));
}

//------------------------------------------------------------------------------
void vtkPlanarShadow::Find(const vtkShadowCasters& casters, bool around)
{
  this->SetParts({});
  if (this->Samples.empty() || this->Plane.Receivers.IsEmpty())
  {
    return;
  }
  // A point's shadow from anywhere on the light lies amid those from its extremes, while they are
  // above it.
  std::vector<glm::dvec4> places;
  const glm::dvec3 origin =
    this->LightPart.Light.IsDirectional() ? glm::dvec3(0.0) : casters.GetOrigin();
  for (const auto& point : this->LightPart.Light.GetExtremes())
  {
    places.push_back(this->GetPlace({ point - origin, {} }));
  }
  const bool divided = std::any_of(places.begin(), places.end(),
    [this](const glm::dvec4& place) { return this->GetHeight(place) <= 0.0; });
  if (divided || this->Samples.size() == 1)
  {
    places = around ? places : std::vector<glm::dvec4>();
    for (const auto& sample : this->Samples)
    {
      places.push_back(this->GetPlace(sample));
    }
  }

  vtkShadowPlane turned = this->Plane; // heights are those on the light's side
  turned.Normal *= this->Side;
  turned.Distance *= this->Side;
  const glm::dvec4 centre = this->GetPlace(this->Samples.front());
  std::vector<Part> parts;
  for (std::size_t i = 0; i < casters.Get().size(); ++i)
  {
    const vtkShadowCaster& caster = casters.Get()[i];
    const double tolerance = Rounding * glm::length(caster.Corners[7] - caster.Corners[0]);
    if (!caster.IsSeenBy(this->LightPart) || this->Plane.Holds(caster) ||
        turned.Cut(caster.Corners, tolerance, 1e300).empty())
    {
      continue;
    }
    vtkPlaneRectangle shadow;
    double reach = 0.0;
    double spread = 0.0;
    for (const auto& place : places)
    {
      const double height = this->GetHeight(place);
      if (height <= 0.0)
      {
        // A point of the light on the other side stands for no shadow here, but for a penumbra
        // without an end.
        shadow = { glm::dvec2(-shadow.Infinity), glm::dvec2(shadow.Infinity) };
        reach = shadow.Infinity;
        continue;
      }
      const double highest = place.w > 0.0 ? HighestShare * height : 1e300;
      for (const auto& point : turned.Cut(caster.Corners, 0.0, highest))
      {
        const double above = turned.GetHeight(point);
        const auto fall = [&](const glm::dvec4& from, double fromHeight)
        {
          const glm::dvec3 ray = from.w > 0.0 ? point - glm::dvec3(from) : -glm::dvec3(from);
          return this->Plane.GetPlace(point + ray * (above / (fromHeight - from.w * above)));
        };
        const glm::dvec2 shade = fall(place, height);
        shadow.Add(shade);
        if (around && (centre.w == 0.0 || above < HighestShare * this->GetHeight(centre)))
        {
          reach = std::max(reach, glm::length(shade - fall(centre, this->GetHeight(centre))));
          spread = std::max(spread, this->GetSpread(centre, above));
        }
      }
      if (!turned.Cut(caster.Corners, highest, 1e300).empty() && place.w > 0.0 &&
          !turned.Cut(caster.Corners, 0.0, highest).empty())
      {
        shadow = { glm::dvec2(-shadow.Infinity), glm::dvec2(shadow.Infinity) };
        spread = std::max(spread, this->GetSpread(centre, HighestShare * this->GetHeight(centre)));
        reach = shadow.Infinity;
      }
    }
    vtkPlaneRectangle seen = this->Plane.Receivers;
    if (around)
    {
      // What lies beside a receiver can still reach into its penumbrae.
      const glm::dvec2 margin(std::min(reach, MostMargin * glm::length(seen.High - seen.Low)));
      seen.Low -= margin;
      seen.High += margin;
    }
    // One that only touches a receiver's border darkens nothing.
    const glm::dvec2 least = Touch * (seen.High - seen.Low);
    seen.Intersect(shadow);
    if (!seen.IsEmpty() && seen.High.x - seen.Low.x > least.x && seen.High.y - seen.Low.y > least.y)
    {
      parts.push_back({ static_cast<int>(i), seen, spread });
    }
  }
  this->SetParts(std::move(parts));
}

//------------------------------------------------------------------------------
void vtkPlanarShadow::SetParts(std::vector<Part> parts)
{
  this->Parts = std::move(parts);
  this->Casters.clear();
  this->Window = {};
  this->Spread = 0.0;
  for (const Part& part : this->Parts)
  {
    this->Casters.push_back(part.Caster);
    this->Window.Add(part.Window);
    this->Spread = std::max(this->Spread, part.Spread);
  }
  for (int axis = 0; axis < 2 && !this->Parts.empty(); ++axis)
  {
    Snap(this->Window.Low[axis], this->Window.High[axis], this->Plane.Receivers.Low[axis],
      this->Plane.Receivers.High[axis]);
  }
}

//------------------------------------------------------------------------------
std::vector<vtkPlanarShadow> vtkPlanarShadow::Divide(int most) const
{
  std::vector<vtkShadowRoom::Rectangle> windows;
  for (const Part& part : this->Parts)
  {
    windows.emplace_back(part.Window.Low, part.Window.High);
  }
  const vtkShadowRoom room = most > 1 ? vtkShadowRoom::Find(windows, 0.0) : vtkShadowRoom();
  if (room.Share <= 0.0)
  {
    return { *this };
  }
  std::vector<Part> parts = this->Parts;
  const auto middle = std::stable_partition(parts.begin(), parts.end(),
    [&room](const Part& part) { return part.Window.Low[room.Axis] < room.End; });
  std::vector<vtkPlanarShadow> all;
  for (const auto& side :
    { std::vector<Part>(parts.begin(), middle), std::vector<Part>(middle, parts.end()) })
  {
    vtkPlanarShadow shadow = *this;
    shadow.SetParts(side);
    for (vtkPlanarShadow& part : shadow.Divide(most / 2))
    {
      all.push_back(std::move(part));
    }
  }
  return all;
}

//------------------------------------------------------------------------------
bool vtkPlanarShadow::Same(const vtkPlanarShadow& other) const
{
  return this->LightPart.SameGeometry(other.LightPart) && this->Plane == other.Plane &&
         this->Side == other.Side && this->Casters == other.Casters &&
         this->Window == other.Window &&
         std::equal(this->Samples.begin(), this->Samples.end(), other.Samples.begin(),
           other.Samples.end(),
           [](const vtkLightSample& a, const vtkLightSample& b)
           { return a.Point == b.Point && a.Weight == b.Weight; }) &&
         this->Weight == other.Weight && this->Spread == other.Spread;
}
