// SPDX-License-Identifier: BSD-3-Clause
#include "ExtremePlan.h"

#include "Errors.h"
#include "ExtremeScenes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace
{
using Json = nlohmann::ordered_json;

ExtremeValue ReadValue(const Json& json)
{
  ExtremeValue value;
  if (json.is_string())
  {
    value.Word = json.get<std::string>();
  }
  else
  {
    value.Number = json.get<double>();
  }
  return value;
}

bool Same(const ExtremeValue& a, const ExtremeValue& b)
{
  return a.Word == b.Word && std::abs(a.Number - b.Number) <= 1e-9 * std::abs(b.Number);
}

std::optional<double> ReadBound(const Json& bounds, const char* name)
{
  return bounds.contains(name) ? std::optional<double>(bounds[name].get<double>()) : std::nullopt;
}

//------------------------------------------------------------------------------
ExtremeCase ReadCase(const Json& json)
{
  ExtremeCase one;
  one.Name = json["name"].get<std::string>();
  one.About = json.value("about", "");
  one.Scene = json["scene"].get<std::string>();
  ExtremeScenes::Find(one.Scene); // a failure where there is none
  one.Ordinary = ReadValue(json["ordinary"]);
  const Json given = json.value("values", Json::array());
  for (const Json& value : given)
  {
    one.Values.push_back(ReadValue(value));
  }
  if (json.contains("decades"))
  {
    const auto ends = json["decades"].get<std::vector<int>>();
    for (int half = 2 * ends[0]; half <= 2 * ends[1]; ++half)
    {
      one.Values.push_back({ std::pow(10.0, 0.5 * half), "" });
    }
  }
  const Json quick = json.value("quick", Json::array());
  for (const Json& value : quick)
  {
    const ExtremeValue wanted = ReadValue(value);
    const auto found = std::find_if(one.Values.begin(), one.Values.end(),
      [&wanted](const ExtremeValue& other) { return Same(other, wanted); });
    if (found == one.Values.end())
    {
      throw Failure("case \"" + one.Name + "\": " + wanted.GetText() + " is none of its values.");
    }
    found->Quick = true;
  }
  const Json& bounds = json["bounds"];
  one.Change = ReadBound(bounds, "change");
  one.Growth = ReadBound(bounds, "growth");
  one.Wrong = ReadBound(bounds, "wrong");
  one.Bias = ReadBound(bounds, "bias");
  one.Motion = ReadBound(bounds, "motion");
  return one;
}
}

//------------------------------------------------------------------------------
std::string ExtremeValue::GetText() const
{
  if (!this->Word.empty())
  {
    return this->Word;
  }
  char text[32];
  const double size = std::abs(this->Number);
  if (size == 0.0 || (size >= 0.01 && size < 1e4))
  {
    std::snprintf(text, sizeof(text), "%.3g", this->Number);
    return text;
  }
  const int exponent = static_cast<int>(std::floor(std::log10(size) + 1e-9));
  const double head = this->Number / std::pow(10.0, exponent);
  std::snprintf(text, sizeof(text), "%.2ge%d", head, exponent);
  return text;
}

namespace ExtremePlans
{
//------------------------------------------------------------------------------
std::vector<ExtremeCase> Read(const Json& suite)
{
  std::vector<ExtremeCase> cases;
  const Json rows = suite.value("extremes", Json::array());
  std::transform(rows.begin(), rows.end(), std::back_inserter(cases), ReadCase);
  return cases;
}

//------------------------------------------------------------------------------
void KeepQuick(std::vector<ExtremeCase>& cases)
{
  for (ExtremeCase& one : cases)
  {
    one.Values.erase(std::remove_if(one.Values.begin(), one.Values.end(),
                       [](const ExtremeValue& value) { return !value.Quick; }),
      one.Values.end());
  }
  cases.erase(std::remove_if(cases.begin(), cases.end(),
                [](const ExtremeCase& one) { return one.Values.empty(); }),
    cases.end());
}

//------------------------------------------------------------------------------
void Select(std::vector<ExtremeCase>& cases, const std::vector<std::string>& names)
{
  std::vector<ExtremeCase> selected;
  for (const std::string& name : names)
  {
    const auto found = std::find_if(
      cases.begin(), cases.end(), [&name](const ExtremeCase& one) { return one.Name == name; });
    if (found == cases.end())
    {
      std::string known;
      for (const ExtremeCase& one : cases)
      {
        known += (known.empty() ? "" : ", ") + one.Name;
      }
      throw WrongUsage("--cases: there is no case \"" + name + "\". Known: " + known + ".");
    }
    selected.push_back(*found);
  }
  cases = selected;
}
}
