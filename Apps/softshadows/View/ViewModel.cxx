// SPDX-License-Identifier: BSD-3-Clause
#include "ViewModel.h"

#include "Errors.h"
#include "Values.h"

#include "vtkShadowNumber.h"

#include <algorithm>
#include <cmath>

namespace
{
using Json = nlohmann::ordered_json;

const char* const None = "none";

template <typename List>
std::string GetNext(const List& list, const std::string& now, int step)
{
  const auto count = static_cast<int>(list.size());
  const auto at = static_cast<int>(std::find(list.begin(), list.end(), now) - list.begin());
  return list[((at + step) % count + count) % count];
}

/** The next number: by ones or twentieths of a small range, else twice or half as much. */
std::string GetNextNumber(const Json& parameter, double now, int step)
{
  const double least = parameter["minimum"];
  const double most = parameter["maximum"];
  const bool whole = parameter["type"] == "integer";
  const double range = most - least;
  double next = 0.0;
  if (whole ? range <= 16.0 : range <= 8.0)
  {
    const double unit = whole ? 1.0 : range / 20.0;
    next = least + unit * (std::round((now - least) / unit) + step);
  }
  else
  {
    // From zero to the least step that counts, and back.
    const double first = whole ? 1.0 : range / 1024.0;
    next = step > 0 ? std::max(2.0 * now, first) : 0.5 * now;
    next = step < 0 && now <= first ? 0.0 : next;
    next = whole ? std::floor(next) : next;
  }
  return vtkShadowNumber::Print(std::clamp(next, least, most));
}
}

//------------------------------------------------------------------------------
ViewModel::ViewModel(const TechniqueOptions& options, const std::string& technique)
  : Options(options)
{
  this->SetTechnique(technique);
}

//------------------------------------------------------------------------------
std::vector<std::string> ViewModel::GetTechniques()
{
  std::vector<std::string> names = Techniques::GetNames();
  names.insert(names.begin(), None);
  return names;
}

//------------------------------------------------------------------------------
void ViewModel::SetTechnique(const std::string& name)
{
  this->Restore();
  vtkSmartPointer<vtkShadowPass> pass;
  Json parameters = Json::array();
  if (name != None)
  {
    auto& kept = this->Passes[name];
    kept = kept ? kept : this->Options.Create(name, false);
    pass = kept;
    parameters = Techniques::Describe(name)["parameters"];
  }
  // The parameter of the same name stays chosen.
  const std::string chosen = this->Parameters.empty() ? "" : this->Parameters[this->Chosen]["name"];
  const auto same = std::find_if(parameters.begin(), parameters.end(),
    [&chosen](const Json& one) { return one["name"] == chosen; });
  this->Chosen = same == parameters.end() ? 0 : same - parameters.begin();
  this->Technique = name;
  this->Pass = pass;
  this->Parameters = parameters;
}

//------------------------------------------------------------------------------
void ViewModel::StepTechnique(int step)
{
  this->SetTechnique(GetNext(ViewModel::GetTechniques(), this->Technique, step));
}

//------------------------------------------------------------------------------
const std::vector<std::string>& ViewModel::GetQualities()
{
  static const std::vector<std::string> names = { "preview", "low", "medium", "high", "reference" };
  return names;
}

//------------------------------------------------------------------------------
void ViewModel::SetQuality(const std::string& quality)
{
  this->Restore();
  if (this->Pass)
  {
    Techniques::SetQuality(this->Pass, quality);
  }
}

//------------------------------------------------------------------------------
void ViewModel::Choose(int step)
{
  if (const auto count = static_cast<int>(this->Parameters.size()))
  {
    this->Chosen = (static_cast<int>(this->Chosen) + step + count) % count;
  }
}

//------------------------------------------------------------------------------
void ViewModel::Change(int step)
{
  this->Restore();
  if (this->Parameters.empty())
  {
    return;
  }
  const Json& parameter = this->Parameters[this->Chosen];
  const std::string name = parameter["name"];
  const std::string now = this->GetValue(name);
  if (parameter["type"] == "boolean")
  {
    this->SetValue(name, now == "on" ? "off" : "on");
  }
  else if (parameter.contains("choices"))
  {
    this->SetValue(name, GetNext(parameter["choices"].get<std::vector<std::string>>(), now, step));
  }
  else
  {
    this->SetValue(name, GetNextNumber(parameter, vtkShadowNumber::Parse(now).value_or(0.0), step));
  }
}

//------------------------------------------------------------------------------
bool ViewModel::Has(const std::string& parameter) const
{
  return std::any_of(this->Parameters.begin(), this->Parameters.end(),
    [&parameter](const Json& one) { return one["name"] == parameter; });
}

//------------------------------------------------------------------------------
std::string ViewModel::GetValue(const std::string& parameter) const
{
  return this->Has(parameter) ? this->Pass->GetParameter(parameter) : "";
}

//------------------------------------------------------------------------------
void ViewModel::SetValue(const std::string& parameter, const std::string& value)
{
  this->Restore();
  if (this->Has(parameter))
  {
    this->Pass->SetParameter(parameter, value);
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> ViewModel::GetDebugViews() const
{
  return this->Pass ? Values::Split(this->Pass->GetDebugViews(), ' ')
                    : std::vector<std::string>{ None };
}

//------------------------------------------------------------------------------
std::string ViewModel::GetDebugView() const
{
  return this->Pass ? this->Pass->GetDebugView() : None;
}

//------------------------------------------------------------------------------
void ViewModel::SetDebugView(const std::string& view)
{
  if (this->Pass)
  {
    this->Pass->SetDebugView(view);
  }
}

//------------------------------------------------------------------------------
void ViewModel::StepDebugView(int step)
{
  this->SetDebugView(GetNext(this->GetDebugViews(), this->GetDebugView(), step));
}

//------------------------------------------------------------------------------
bool ViewModel::Lower()
{
  static const std::vector<std::string> levels = { "low", "preview" };
  if (!this->Pass || this->Steps == static_cast<int>(levels.size()))
  {
    return false;
  }
  if (this->Steps == 0)
  {
    for (const Json& parameter : this->Parameters)
    {
      const std::string name = parameter["name"];
      this->Before[name] = this->Pass->GetParameter(name);
    }
  }
  std::map<std::string, std::string> lower = this->Before;
  const std::string& level = levels[this->Steps++];
  for (const Json& parameter : this->Parameters)
  {
    if (!parameter.contains("presets"))
    {
      continue;
    }
    const auto number = [&](const std::string& text)
    { return vtkShadowNumber::Parse(text).value_or(0.0); };
    const std::string preset = parameter["presets"][level];
    std::string& value = lower[parameter["name"]];
    // More of most is dearer, of some, such as an error to stop at, less; zero decides by itself.
    const bool upwards =
      number(parameter["presets"]["preview"]) <= number(parameter["presets"]["reference"]);
    const bool less = number(value) != 0.0 &&
                      (upwards ? number(value) < number(preset) : number(value) > number(preset));
    value = less ? value : preset;
  }
  this->SetAll(lower);
  return true;
}

//------------------------------------------------------------------------------
bool ViewModel::Restore()
{
  if (this->Steps == 0)
  {
    return false;
  }
  this->Steps = 0;
  this->SetAll(this->Before);
  return true;
}

//------------------------------------------------------------------------------
void ViewModel::SetAll(const std::map<std::string, std::string>& values)
{
  for (const auto& [name, value] : values)
  {
    this->Pass->SetParameter(name, value);
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> ViewModel::GetOptions() const
{
  std::vector<std::string> words = { "--technique", this->Technique };
  if (!this->Pass)
  {
    return words;
  }
  const Json plain = Techniques::GetParameters(TechniqueOptions().Create(this->Technique, true));
  const Json now = Techniques::GetParameters(this->Pass);
  for (const auto& [name, value] : now.items())
  {
    const auto before = this->Before.find(name);
    const std::string set =
      this->Steps > 0 && before != this->Before.end() ? before->second : value.get<std::string>();
    if (plain[name] != set)
    {
      words.insert(words.end(), { "--set", name + "=" + set });
    }
  }
  if (this->GetDebugView() != None)
  {
    words.insert(words.end(), { "--debug-view", this->GetDebugView() });
  }
  return words;
}
