// SPDX-License-Identifier: BSD-3-Clause
#include "BenchTables.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace BenchTables
{
using namespace BenchFigures;

namespace
{
const char* const times[] = { "static", "dynamic" };
const char* const everyPixels[] = { "penumbra", "all" };

//------------------------------------------------------------------------------
bool Is(const Json& row, const std::string& key, const std::string& value)
{
  return FindText(row, { key }) == value;
}

//------------------------------------------------------------------------------
// The middle one of a case's advice that names an entry, for the penumbra and a moving camera.
const Json& FindTypical(const Json& oneCase, const std::string& list)
{
  static const Json nothing;
  std::vector<const Json*> found;
  for (const Json& row : FindList(oneCase, { "advice", list }))
  {
    if (Is(row, "pixels", "penumbra") && Is(row, "time", "static") &&
        !FindText(row, { "entry" }).empty())
    {
      found.push_back(&row);
    }
  }
  return found.empty() ? nothing : *found[found.size() / 2];
}

//------------------------------------------------------------------------------
/** Advice, with both kinds of frames in a row. */
Json GetAdvice(const Json& oneCase, const std::string& list, const std::string& limit)
{
  Json rows = Json::array();
  for (const char* pixels : everyPixels)
  {
    std::vector<Number> limits;
    for (const Json& one : FindList(oneCase, { "advice", list }))
    {
      const Number value = FindNumber(one, { limit });
      if (Is(one, "pixels", pixels) && value &&
          std::find(limits.begin(), limits.end(), value) == limits.end())
      {
        limits.push_back(value);
      }
    }
    for (const Number& value : limits)
    {
      Json row = { { "limit", WriteShort(value) }, { "pixels", DescribePixels(pixels) },
        { "cells", Json::array() } };
      for (const char* time : times)
      {
        Json cell = { { "entry", "" }, { "milliseconds", "" }, { "error", "" } };
        for (const Json& one : FindList(oneCase, { "advice", list }))
        {
          const std::string id = FindText(one, { "entry" });
          if (!Is(one, "pixels", pixels) || !Is(one, "time", time) || id.empty() ||
              FindNumber(one, { limit }) != value)
          {
            continue;
          }
          const bool isUnderError = limit == "error";
          cell = { { "entry", GetName(oneCase, id) },
            { "milliseconds",
              WriteMilliseconds(FindNumber(one, { isUnderError ? "milliseconds" : "reached" })) },
            { "error", WriteError(FindNumber(one, { isUnderError ? "reached" : "error" })) } };
        }
        row["cells"].push_back(cell);
      }
      rows.push_back(row);
    }
  }
  return rows;
}

//------------------------------------------------------------------------------
/** An error, unless the reference is no better than that. */
std::string WriteAboveNoise(const Number& error, const Number& noise)
{
  return error && noise && *error < *noise ? "< noise" : WriteError(error);
}

//------------------------------------------------------------------------------
/** Technique and setting of an entry whose label does not tell them. */
std::string GetDetails(const Json& entry)
{
  if (FindText(entry, { "label" }).empty())
  {
    return "";
  }
  std::string text = FindText(entry, { "technique" });
  const Json& setting = Find(entry, { "setting" });
  if (setting.is_object())
  {
    for (const auto& item : setting.items())
    {
      text += " " + item.key() + "=" + FindText(setting, { item.key() });
    }
  }
  return text;
}

//------------------------------------------------------------------------------
Json GetTime(const Json& entry, const std::string& time, double framesWanted)
{
  const Number frames = FindNumber(entry, { "time", time, "frames" });
  const Number lower = FindNumber(entry, { "time", time, "added", "lower" });
  const Number upper = FindNumber(entry, { "time", time, "added", "upper" });
  const bool hasSpread = lower && upper;
  return { { "added", WriteMilliseconds(GetAdded(entry, time)) },
    { "spread", hasSpread ? WriteMilliseconds(lower) + " \u2013 " + WriteMilliseconds(upper) : "" },
    { "few", frames && *frames < framesWanted ? WriteCount(frames) : "" },
    { "ratio", WriteRatio(FindNumber(entry, { "time", time, "ratio" })) } };
}

//------------------------------------------------------------------------------
/** Which fronts an entry is on, as short labels. */
Json GetFronts(const Json& oneCase, const std::string& id)
{
  Json labels = Json::array();
  for (const char* pixels : everyPixels)
  {
    bool isOn[2];
    for (int i = 0; i < 2; ++i)
    {
      const Json& front = FindList(oneCase, { "fronts", pixels, times[i] });
      isOn[i] = std::find(front.begin(), front.end(), Json(id)) != front.end();
    }
    if (isOn[0] || isOn[1])
    {
      labels.push_back({ { "label", std::string(pixels) + (isOn[0] && isOn[1] ? ""
                                                            : isOn[0]         ? ", static"
                                                                              : ", dynamic") } });
    }
  }
  return labels;
}
}

//------------------------------------------------------------------------------
std::string Recommend(const Json& oneCase)
{
  std::string text;
  const Json& underError = FindTypical(oneCase, "under_error");
  if (!underError.is_null())
  {
    text = "Of this toolkit's techniques, " + GetName(oneCase, FindText(underError, { "entry" })) +
           " is the fastest whose error in the penumbra is at most " +
           WriteShort(FindNumber(underError, { "error" })) + ": it adds " +
           WriteMilliseconds(FindNumber(underError, { "milliseconds" })) +
           " ms to a frame while the camera moves.";
  }
  const Json& underTime = FindTypical(oneCase, "under_time");
  if (!underTime.is_null())
  {
    text += (text.empty() ? "" : " ") + std::string("Where at most ") +
            WriteShort(FindNumber(underTime, { "milliseconds" })) + " ms may be added, " +
            GetName(oneCase, FindText(underTime, { "entry" })) + " has the smallest error, " +
            WriteError(FindNumber(underTime, { "error" })) + ".";
  }
  return text;
}

//------------------------------------------------------------------------------
Json GetUnderError(const Json& oneCase)
{
  return GetAdvice(oneCase, "under_error", "error");
}

//------------------------------------------------------------------------------
Json GetUnderTime(const Json& oneCase)
{
  return GetAdvice(oneCase, "under_time", "milliseconds");
}

//------------------------------------------------------------------------------
Json GetEntries(const Json& oneCase, double framesWanted)
{
  Json rows = Json::array();
  for (const Json& entry : FindList(oneCase, { "entries" }))
  {
    const std::string id = FindText(entry, { "id" });
    const auto write = [&](const char* pixels)
    { return WriteAboveNoise(GetError(entry, pixels), GetNoise(oneCase, pixels)); };
    Json front = GetFronts(oneCase, id);
    rows.push_back(
      { { "label", GetName(entry) }, { "details", GetDetails(entry) }, { "peer", IsPeer(entry) },
        { "skipped", IsSkipped(entry) ? FindText(entry, { "skipped" }) : "" },
        { "measured", !IsSkipped(entry) }, { "on_front", !front.empty() }, { "front", front },
        { "penumbra", write("penumbra") }, { "rmse", write("all") },
        { "bias", WriteSigned(FindNumber(entry, { "error", "bias" })) },
        { "p99", WriteError(FindNumber(entry, { "error", "p99" })) },
        { "maximum", WriteError(FindNumber(entry, { "error", "maximum" })) },
        { "correctness", WritePercent(FindNumber(entry, { "picture", "correctness_percent" })) },
        { "static", GetTime(entry, "static", framesWanted) },
        { "dynamic", GetTime(entry, "dynamic", framesWanted) },
        { "build", WriteMilliseconds(FindNumber(entry, { "time", "build_milliseconds" })) },
        { "bytes", WriteBytes(FindNumber(entry, { "bytes" })) },
        { "megarays", WriteShort(FindNumber(entry, { "megarays_per_second" })) } });
  }
  return rows;
}

//------------------------------------------------------------------------------
Json GetEqualError(const Json& oneCase)
{
  Json rows = Json::array();
  for (const Json& row : FindList(oneCase, { "against_rays" }))
  {
    rows.push_back({ { "pixels", DescribePixels(FindText(row, { "pixels" })) },
      { "time", DescribeTime(FindText(row, { "time" })) },
      { "error", WriteError(FindNumber(row, { "error" })) },
      { "entry", GetName(oneCase, FindText(row, { "entry" })) },
      { "milliseconds", WriteMilliseconds(FindNumber(row, { "milliseconds" })) },
      { "rays", WriteShort(FindNumber(row, { "rays" })) },
      { "rays_milliseconds", WriteMilliseconds(FindNumber(row, { "rays_milliseconds" })) },
      { "factor", (Find(row, { "beyond" }) == true ? "at least " : "") +
                    WriteRatio(FindNumber(row, { "factor" })) } });
  }
  return rows;
}

//------------------------------------------------------------------------------
Json GetEqualTime(const Json& oneCase)
{
  Json rows = Json::array();
  const std::string rays = FindText(oneCase, { "reference", "technique" });
  for (const char* time : times)
  {
    for (const Json& ray : FindList(oneCase, { "entries" }))
    {
      const Number limit = GetAdded(ray, time);
      if (rays.empty() || !Is(ray, "technique", rays) || !limit || !GetError(ray, "all"))
      {
        continue;
      }
      Json row = { { "time", DescribeTime(time) }, { "rays", GetName(ray) },
        { "limit", WriteMilliseconds(limit) }, { "cells", Json::array() } };
      for (const char* pixels : everyPixels)
      {
        const Json* best = nullptr;
        for (const Json& entry : FindList(oneCase, { "entries" }))
        {
          const Number added = GetAdded(entry, time);
          const Number error = GetError(entry, pixels);
          if (IsTechnique(entry) && !Is(entry, "technique", rays) && added && error &&
              *added <= *limit && (!best || *error < *GetError(*best, pixels)))
          {
            best = &entry;
          }
        }
        const Number noise = GetNoise(oneCase, pixels);
        row["cells"].push_back({ { "rays_error", WriteAboveNoise(GetError(ray, pixels), noise) },
          { "entry", best ? GetName(*best) : "" },
          { "milliseconds", best ? WriteMilliseconds(GetAdded(*best, time)) : "" },
          { "error", best ? WriteAboveNoise(GetError(*best, pixels), noise) : "" } });
      }
      rows.push_back(row);
    }
  }
  return rows;
}

//------------------------------------------------------------------------------
Json GetPublished(const Json& oneCase)
{
  Json rows = Json::array();
  for (const Json& entry : FindList(oneCase, { "entries" }))
  {
    const Json& published = Find(entry, { "published" });
    if (published.is_object())
    {
      // The thesis's dynamic part: what a light that moves adds.
      const Number still = FindNumber(entry, { "time", "static", "median" });
      rows.push_back({ { "label", GetName(entry) },
        { "rate", still && *still > 0.0 ? WriteShort(std::round(10000.0 / *still) / 10.0) : "" },
        { "dynamic_part", WriteMilliseconds(FindNumber(entry, { "time", "build_milliseconds" })) },
        { "static", WriteRatio(FindNumber(entry, { "time", "static", "ratio" })) },
        { "published_static", WriteRatio(FindNumber(published, { "static_ratio" })) },
        { "dynamic", WriteRatio(FindNumber(entry, { "time", "dynamic", "ratio" })) },
        { "published_dynamic", WriteRatio(FindNumber(published, { "dynamic_ratio" })) },
        { "correctness", WritePercent(FindNumber(entry, { "picture", "correctness_percent" })) },
        { "published_correctness", WritePercent(FindNumber(published, { "correctness" })) } });
    }
  }
  return rows;
}

//------------------------------------------------------------------------------
Json GetExponents(const Json& scaling)
{
  // The cost of these should grow no faster than they do.
  static const std::vector<std::string> bounded = { "triangles", "pixels", "lights" };
  constexpr double bound = 1.05;
  const auto axes = FindTexts(scaling, "axis");
  Json columns = Json::array();
  for (const std::string& axis : axes)
  {
    columns.push_back({ { "axis", axis } });
  }
  Json rows = Json::array();
  for (const std::string& entry : FindTexts(scaling, "entry"))
  {
    Json row = { { "entry", entry }, { "cells", Json::array() } };
    for (const std::string& axis : axes)
    {
      const bool isBounded = std::find(bounded.begin(), bounded.end(), axis) != bounded.end();
      for (const char* time : times)
      {
        Number exponent;
        Number last;
        for (const Json& line : scaling)
        {
          if (Is(line, "axis", axis) && Is(line, "entry", entry) && Is(line, "time", time))
          {
            exponent = FindNumber(line, { "exponent" });
            last = FindNumber(line, { "last_exponent" });
          }
        }
        row["cells"].push_back({ { "exponent", WritePercent(exponent) },
          { "last", WritePercent(last) }, { "over", isBounded && exponent && *exponent > bound },
          { "first", std::string(time) == times[0] } });
      }
    }
    rows.push_back(row);
  }
  return { { "axes", columns }, { "rows", rows } };
}
}
