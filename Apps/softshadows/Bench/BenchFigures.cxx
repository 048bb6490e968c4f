// SPDX-License-Identifier: BSD-3-Clause
#include "BenchFigures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace BenchFigures
{
namespace
{
const char* const Minus = "\u2212";

std::string Print(const char* format, double value)
{
  char text[64];
  std::snprintf(text, sizeof(text), format, value);
  return text[0] == '-' ? Minus + std::string(text + 1) : text;
}
}

//------------------------------------------------------------------------------
const Json& Find(const Json& from, Path path)
{
  static const Json nothing;
  const Json* at = &from;
  for (const std::string& key : path)
  {
    const auto found = at->find(key); // its end() where this is no object
    if (found == at->end())
    {
      return nothing;
    }
    at = &*found;
  }
  return *at;
}

//------------------------------------------------------------------------------
const Json& FindList(const Json& from, Path path)
{
  static const Json nothing = Json::array();
  const Json& found = Find(from, path);
  return found.is_array() ? found : nothing;
}

//------------------------------------------------------------------------------
Number FindNumber(const Json& from, Path path)
{
  const Json& found = Find(from, path);
  if (!found.is_number() || !std::isfinite(found.get<double>()))
  {
    return {};
  }
  return found.get<double>();
}

//------------------------------------------------------------------------------
std::string FindText(const Json& from, Path path)
{
  const Json& found = Find(from, path);
  if (found.is_null())
  {
    return "";
  }
  return found.is_string() ? found.get<std::string>() : found.dump();
}

//------------------------------------------------------------------------------
std::vector<std::string> FindTexts(const Json& list, const std::string& key)
{
  std::vector<std::string> texts;
  for (const Json& one : list)
  {
    const std::string text = FindText(one, { key });
    if (std::find(texts.begin(), texts.end(), text) == texts.end())
    {
      texts.push_back(text);
    }
  }
  return texts;
}

//------------------------------------------------------------------------------
Number GetError(const Json& entry, const std::string& pixels)
{
  return pixels == "penumbra" ? FindNumber(entry, { "error", "penumbra", "rmse" })
                              : FindNumber(entry, { "error", "rmse" });
}

//------------------------------------------------------------------------------
Number GetAdded(const Json& entry, const std::string& time)
{
  return FindNumber(entry, { "time", time, "added", "median" });
}

//------------------------------------------------------------------------------
Number GetNoise(const Json& oneCase, const std::string& pixels)
{
  return FindNumber(
    oneCase, { "reference", "noise", pixels == "penumbra" ? "penumbra_rmse" : "rmse" });
}

//------------------------------------------------------------------------------
const Json& FindEntry(const Json& oneCase, const std::string& id)
{
  static const Json nothing;
  for (const Json& entry : FindList(oneCase, { "entries" }))
  {
    if (FindText(entry, { "id" }) == id)
    {
      return entry;
    }
  }
  return nothing;
}

//------------------------------------------------------------------------------
std::string GetName(const Json& entry)
{
  for (const char* key : { "label", "id", "technique" })
  {
    const std::string name = FindText(entry, { key });
    if (!name.empty())
    {
      return name;
    }
  }
  return "?";
}

//------------------------------------------------------------------------------
std::string GetName(const Json& oneCase, const std::string& id)
{
  const Json& entry = FindEntry(oneCase, id);
  return entry.is_null() ? id : GetName(entry);
}

//------------------------------------------------------------------------------
bool IsSkipped(const Json& entry)
{
  return !Find(entry, { "skipped" }).is_null();
}

//------------------------------------------------------------------------------
bool IsTechnique(const Json& entry)
{
  return FindText(entry, { "kind" }) == "technique";
}

//------------------------------------------------------------------------------
bool IsPeer(const Json& entry)
{
  return FindText(entry, { "kind" }) == "peer";
}

//------------------------------------------------------------------------------
std::string WriteError(const Number& value)
{
  return value ? Print(*value != 0.0 && std::abs(*value) < 0.0001 ? "%.1e" : "%.4f", *value) : "";
}

//------------------------------------------------------------------------------
std::string WriteSigned(const Number& value)
{
  return value ? Print("%+.4f", *value) : "";
}

//------------------------------------------------------------------------------
std::string WriteMilliseconds(const Number& value)
{
  if (!value)
  {
    return "";
  }
  const double size = std::abs(*value);
  return Print(size < 10.0 ? "%.2f" : size < 100.0 ? "%.1f" : "%.0f", *value);
}

//------------------------------------------------------------------------------
std::string WriteRatio(const Number& value)
{
  return value ? Print(std::abs(*value) < 100.0 ? "%.2f" : "%.0f", *value) : "";
}

//------------------------------------------------------------------------------
std::string WritePercent(const Number& value)
{
  return value ? Print("%.2f", *value) : "";
}

//------------------------------------------------------------------------------
std::string WriteCount(const Number& value)
{
  if (!value)
  {
    return "";
  }
  std::string text = Print("%.0f", *value);
  // From five digits on, groups of three from the end, with spaces that do not break.
  for (std::size_t at = text.size(); at > 3 && *value > 9999.5;)
  {
    at -= 3;
    text.insert(at, "\u00a0");
  }
  return text;
}

//------------------------------------------------------------------------------
std::string WriteBytes(const Number& value)
{
  if (!value)
  {
    return "";
  }
  double rest = *value;
  for (const char* format : { "%.0f B", "%.1f KiB", "%.1f MiB" })
  {
    if (rest < 1024.0)
    {
      return Print(format, rest);
    }
    rest /= 1024.0;
  }
  return Print("%.1f GiB", rest);
}

//------------------------------------------------------------------------------
std::string WriteShort(const Number& value)
{
  return value ? Print("%.4g", *value) : "";
}

//------------------------------------------------------------------------------
std::string DescribeTime(const std::string& time)
{
  return time == "static" ? "camera moves" : time == "dynamic" ? "light moves" : time;
}

//------------------------------------------------------------------------------
std::string DescribePixels(const std::string& pixels)
{
  return pixels == "all" ? "all receivers" : pixels;
}
}
