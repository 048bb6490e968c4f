// SPDX-License-Identifier: BSD-3-Clause
#include "BenchAnalysis.h"

#include "References.h"

#include "vtkShadowNumber.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace
{
using Json = nlohmann::ordered_json;

const char* const PixelKinds[] = { "penumbra", "all" };
const char* const TimeKinds[] = { "static", "dynamic" };
/** Levels, in visibility and in milliseconds, that advice is given for. */
constexpr double Errors[] = { 0.2, 0.1, 0.05, 0.02, 0.01 };
constexpr double Milliseconds[] = { 1.0, 3.0, 10.0, 30.0, 100.0, 300.0 };

/** An entry in the plane of time and error. */
struct Point
{
  const Json* Entry;
  double Time;
  double Error;
};
using Points = std::vector<Point>;

double GetAdded(const Json& entry, const std::string& timeKind)
{
  return entry["time"][timeKind]["added"]["median"];
}

//------------------------------------------------------------------------------
// Entries that have a time and an error and are wanted, by time. Below the reference's noise errors are
// the same.
Points GetPoints(const Json& one, const std::string& pixels, const std::string& timeKind,
  const std::function<bool(const Json&)>& wanted)
{
  Points points;
  const Json& reference = one["reference"];
  const char* noiseName = pixels == "penumbra" ? "penumbra_rmse" : "rmse";
  const double noise = reference.is_null() || reference["noise"][noiseName].is_null()
                         ? 0.0
                         : reference["noise"][noiseName].get<double>();
  for (const Json& entry : one["entries"])
  {
    const auto has = [&entry](const char* name)
    { return entry.contains(name) && !entry[name].is_null(); };
    if (!has("time") || !has("error") || !wanted(entry))
    {
      continue;
    }
    const Json& errors = pixels == "penumbra" ? entry["error"]["penumbra"] : entry["error"];
    if (errors["rmse"].is_null())
    {
      continue; // no pixel lies in a penumbra
    }
    points.push_back(
      { &entry, GetAdded(entry, timeKind), std::max(errors["rmse"].get<double>(), noise) });
  }
  std::stable_sort(points.begin(), points.end(),
    [](const Point& a, const Point& b)
    { return std::tie(a.Time, a.Error) < std::tie(b.Time, b.Error); });
  return points;
}

//------------------------------------------------------------------------------
// Of points by time: those that no faster one equals in error.
Points GetFront(const Points& points)
{
  Points front;
  for (const Point& point : points)
  {
    if (front.empty() || point.Error < front.back().Error)
    {
      front.push_back(point);
    }
  }
  return front;
}

bool Shadows(const Json& entry)
{
  return entry["kind"] != "none";
}

bool IsOurs(const Json& entry)
{
  return Shadows(entry) && entry["technique"] != BenchPlans::VTKPeer;
}

bool IsRays(const Json& entry)
{
  return entry["technique"] == ReferenceTechnique;
}

bool IsRaster(const Json& entry)
{
  return IsOurs(entry) && !IsRays(entry);
}

double GetRays(const Point& point)
{
  const auto samples = (*point.Entry)["parameters"]["samples"].get<std::string>();
  return vtkShadowNumber::Parse(samples).value_or(0.0);
}

//------------------------------------------------------------------------------
// What rays take for an error: between two settings by a power law. Beyond the settings, the nearest.
struct RayCost
{
  double Rays;
  double Time;
  bool Beyond; // the error is less than what all settings reach: it takes more
};

RayCost FindRayCost(const Points& rays, double error)
{
  const auto more = std::find_if(
    rays.begin(), rays.end(), [error](const Point& point) { return point.Error <= error; });
  if (more == rays.begin() || more == rays.end())
  {
    const Point& nearest = more == rays.end() ? rays.back() : rays.front();
    return { GetRays(nearest), nearest.Time, more == rays.end() };
  }
  const Point& less = *(more - 1);
  const double share = std::log(error / less.Error) / std::log(more->Error / less.Error);
  const auto mix = [share](double a, double b) { return a * std::pow(b / a, share); };
  return { mix(GetRays(less), GetRays(*more)), mix(less.Time, more->Time), false };
}

//------------------------------------------------------------------------------
Json CompareWithRays(const Json& one, const std::string& pixels, const std::string& timeKind)
{
  Json rows = Json::array();
  Points rays = GetPoints(one, pixels, timeKind, IsRays);
  rays.erase(std::remove_if(rays.begin(), rays.end(),
               [](const Point& point) { return point.Time <= 0.0 || point.Error <= 0.0; }),
    rays.end());
  rays = GetFront(rays);
  if (rays.empty())
  {
    return rows;
  }
  for (const Point& point : GetFront(GetPoints(one, pixels, timeKind, IsRaster)))
  {
    if (point.Time > 0.0)
    {
      const RayCost cost = FindRayCost(rays, point.Error);
      rows.push_back({ { "pixels", pixels }, { "time", timeKind }, { "error", point.Error },
        { "entry", (*point.Entry)["id"] }, { "milliseconds", point.Time }, { "rays", cost.Rays },
        { "rays_milliseconds", cost.Time }, { "factor", cost.Time / point.Time },
        { "beyond", cost.Beyond } });
    }
  }
  return rows;
}

//------------------------------------------------------------------------------
void Advise(const Json& one, const std::string& pixels, const std::string& timeKind, Json& advice)
{
  const Points points = GetFront(GetPoints(one, pixels, timeKind, IsOurs));
  if (points.empty())
  {
    return;
  }
  for (const double error : Errors)
  {
    Json row = { { "pixels", pixels }, { "time", timeKind }, { "error", error },
      { "entry", nullptr }, { "milliseconds", nullptr }, { "reached", nullptr } };
    const auto fastest = std::find_if(
      points.begin(), points.end(), [error](const Point& point) { return point.Error <= error; });
    if (fastest != points.end())
    {
      row["entry"] = (*fastest->Entry)["id"];
      row["milliseconds"] = fastest->Time;
      row["reached"] = fastest->Error;
    }
    advice["under_error"].push_back(row);
  }
  for (const double time : Milliseconds)
  {
    Json row = { { "pixels", pixels }, { "time", timeKind }, { "milliseconds", time },
      { "entry", nullptr }, { "reached", nullptr }, { "error", nullptr } };
    const auto slower = std::find_if(
      points.begin(), points.end(), [time](const Point& point) { return point.Time > time; });
    if (slower != points.begin())
    {
      const Point& best = *(slower - 1);
      row["entry"] = (*best.Entry)["id"];
      row["reached"] = best.Time;
      row["error"] = best.Error;
    }
    advice["under_time"].push_back(row);
  }
}

//------------------------------------------------------------------------------
Json GetPublished(
  const Json& published, const Json& ofSuite, const std::string& key, bool withErrors)
{
  Json json;
  if (withErrors && published.contains("correctness"))
  {
    json["correctness"] = published["correctness"];
  }
  if (published.contains("milliseconds") && published["milliseconds"].contains(key))
  {
    const double base = ofSuite.at("unshadowed_milliseconds").at(key);
    const Json& times = published["milliseconds"][key];
    json["static_ratio"] = times["static"].get<double>() / base;
    json["dynamic_ratio"] = times["dynamic"].get<double>() / base;
  }
  return json;
}

//------------------------------------------------------------------------------
// The slope of log time against log value by least squares.
double FitExponent(const std::vector<std::pair<double, double>>& points)
{
  double x = 0.0;
  double y = 0.0;
  double xx = 0.0;
  double xy = 0.0;
  for (const auto& point : points)
  {
    x += std::log(point.first);
    y += std::log(point.second);
    xx += std::log(point.first) * std::log(point.first);
    xy += std::log(point.first) * std::log(point.second);
  }
  const auto n = static_cast<double>(points.size());
  return (n * xy - x * y) / (n * xx - x * x);
}
}

namespace BenchAnalysis
{
//------------------------------------------------------------------------------
void AddToCase(Json& one, const BenchPlan& plan)
{
  Json rows = Json::array();
  Json fronts;
  Json advice = { { "under_error", Json::array() }, { "under_time", Json::array() } };
  for (const char* pixels : PixelKinds)
  {
    for (const char* timeKind : TimeKinds)
    {
      fronts[pixels][timeKind] = Json::array();
      for (const Point& point : GetFront(GetPoints(one, pixels, timeKind, Shadows)))
      {
        fronts[pixels][timeKind].push_back((*point.Entry)["id"]);
      }
      const Json compared = CompareWithRays(one, pixels, timeKind);
      rows.insert(rows.end(), compared.begin(), compared.end());
      Advise(one, pixels, timeKind, advice);
    }
  }
  one["fronts"] = fronts;
  one["against_rays"] = rows;
  one["advice"] = advice;

  if (!one.contains("published"))
  {
    return;
  }
  for (std::size_t i = 0; i < plan.Entries.size(); ++i)
  {
    const Json& published = plan.Entries[i].Published;
    if (!published.is_null())
    {
      const Json figures =
        GetPublished(published, plan.Published, one["published"], !one["reference"].is_null());
      if (!figures.is_null())
      {
        one["entries"][i]["published"] = figures;
      }
    }
  }
}

//------------------------------------------------------------------------------
Json GetScaling(const Json& cases)
{
  using Series = std::vector<std::pair<double, double>>;
  struct Curve
  {
    Json Head;
    Series Points;
    int LeftOut = 0;
  };
  std::vector<Curve> curves;
  for (const Json& one : cases)
  {
    if (!one.contains("axis"))
    {
      continue;
    }
    for (const Json& entry : one["entries"])
    {
      if (!Shadows(entry) || !entry.contains("time") || entry["time"].is_null())
      {
        continue;
      }
      for (const char* timeKind : TimeKinds)
      {
        const Json head = { { "axis", one["axis"] }, { "entry", entry["id"] },
          { "technique", entry["technique"] }, { "time", timeKind } };
        auto curve = std::find_if(
          curves.begin(), curves.end(), [&head](const Curve& known) { return known.Head == head; });
        if (curve == curves.end())
        {
          curve = curves.insert(curves.end(), { head, {} });
        }
        const double added = GetAdded(entry, timeKind);
        if (added > 0.0) // less is noise, and has no logarithm
        {
          curve->Points.emplace_back(one["value"].get<double>(), added);
        }
        else
        {
          ++curve->LeftOut;
        }
      }
    }
  }
  Json scaling = Json::array();
  for (const Curve& curve : curves)
  {
    Json json = curve.Head;
    const std::size_t count = curve.Points.size();
    json["exponent"] = count > 1 ? Json(FitExponent(curve.Points)) : Json();
    json["last_exponent"] =
      count > 1 ? Json(FitExponent({ curve.Points[count - 2], curve.Points[count - 1] })) : Json();
    json["left_out"] = curve.LeftOut;
    json["points"] = curve.Points;
    scaling.push_back(json);
  }
  return scaling;
}
}
