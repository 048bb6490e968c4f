// SPDX-License-Identifier: BSD-3-Clause
#include "BenchPlan.h"

#include "Errors.h"
#include "Values.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <set>

const char* const BenchPlans::VTKPeer = "vtkShadowMapPass";

namespace
{
bool HasParameter(const std::string& technique, const std::string& name)
{
  return technique == BenchPlans::VTKPeer
           ? name == "resolution"
           : Techniques::HasParameter(Techniques::Describe(technique), name);
}

bool Sets(const BenchEntry& entry, const std::string& name)
{
  return std::any_of(entry.Values.begin(), entry.Values.end(),
    [&name](const auto& value) { return value.first == name; });
}

//------------------------------------------------------------------------------
// What the case sets of the technique and the entry does not, then what the entry sets.
std::vector<TechniqueSetting> GetSettings(const BenchCase& one, const BenchEntry& entry)
{
  std::vector<TechniqueSetting> settings;
  for (const TechniqueSetting& setting : one.Settings.Settings)
  {
    if ((setting.Technique.empty() || setting.Technique == entry.Technique) &&
        !Sets(entry, setting.Name))
    {
      settings.push_back(setting);
    }
  }
  for (const auto& value : entry.Values)
  {
    settings.push_back({ entry.Technique, value.first, value.second });
  }
  return settings;
}

//------------------------------------------------------------------------------
// Failure for a setting of a case that none of the entries would use.
void CheckCaseSettings(const BenchPlan& plan, const BenchCase& one)
{
  for (const TechniqueSetting& setting : one.Settings.Settings)
  {
    const bool used = std::any_of(plan.Entries.begin(), plan.Entries.end(),
      [&setting](const BenchEntry& entry)
      {
        return entry.Kind != BenchEntry::Role::None &&
               (setting.Technique.empty() || setting.Technique == entry.Technique) &&
               HasParameter(entry.Technique, setting.Name);
      });
    // Techniques may have been left out; the name must be right all the same.
    if (!used && (setting.Technique.empty() || !HasParameter(setting.Technique, setting.Name)))
    {
      throw Failure("case \"" + one.Id + "\": no technique has what it sets, " +
                    (setting.Technique.empty() ? "" : setting.Technique + ":") + setting.Name +
                    ".");
    }
  }
}

//------------------------------------------------------------------------------
// Failure where entries have published figures of a case, and the frame they are a ratio to has none.
void CheckPublished(const BenchPlan& plan, const BenchCase& one)
{
  const auto names = [&one](const nlohmann::ordered_json& json, const char* what)
  { return json.contains(what) && json[what].contains(one.Published); };
  const bool told = std::any_of(plan.Entries.begin(), plan.Entries.end(),
    [&names](const BenchEntry& entry) { return names(entry.Published, "milliseconds"); });
  if (!one.Published.empty() && told && !names(plan.Published, "unshadowed_milliseconds"))
  {
    throw Failure("suite " + plan.Name +
                  ": its \"published\" has no unshadowed_milliseconds of \"" + one.Published +
                  "\".");
  }
}
}

//------------------------------------------------------------------------------
double BenchCase::GetValue(const ::Scene& built) const
{
  if (this->Axis == "triangles")
  {
    return static_cast<double>(built.Triangles);
  }
  if (this->Axis == "lights")
  {
    return this->Lights;
  }
  if (this->Axis == "pixels")
  {
    return static_cast<double>(this->Scene.Size[0]) * this->Scene.Size[1];
  }
  if (this->Axis == "light-size")
  {
    return this->LightScale;
  }
  for (const TechniqueSetting& setting : this->Settings.Settings)
  {
    double value = 0.0;
    if (setting.Name == this->Axis && Values::ParseNumber(setting.Value, value) && value > 0.0)
    {
      return value;
    }
  }
  throw Failure("case \"" + this->Id + "\" sets no number for its axis, " + this->Axis + ".");
}

//------------------------------------------------------------------------------
void BenchCase::CheckAxis() const
{
  if (!this->Axis.empty())
  {
    this->GetValue({});
  }
}

//------------------------------------------------------------------------------
std::string BenchEntry::GetId() const
{
  std::string id = this->Kind == Role::None ? "none" : this->Technique;
  for (const auto& value : this->Values)
  {
    id += " " + value.first + "=" + value.second;
  }
  return id;
}

//------------------------------------------------------------------------------
double BenchPlan::GetBudget() const
{
  if (!this->Extremes.empty())
  {
    return this->Default.Budget;
  }
  return std::accumulate(this->Cases.begin(), this->Cases.end(), 0.0,
    [](double sum, const BenchCase& one) { return sum + one.Budget; });
}

namespace BenchPlans
{
//------------------------------------------------------------------------------
void Select(BenchPlan& plan, const std::vector<std::string>& techniques)
{
  std::vector<BenchEntry> selected = { plan.Entries.front() };
  for (const std::string& name : techniques)
  {
    if (std::any_of(selected.begin(), selected.end(),
          [&name](const BenchEntry& entry) { return entry.Technique == name; }))
    {
      continue; // named twice
    }
    if (name != VTKPeer)
    {
      Techniques::Describe(name); // a failure where there is none
    }
    const std::size_t before = selected.size();
    std::copy_if(plan.Entries.begin(), plan.Entries.end(), std::back_inserter(selected),
      [&name](const BenchEntry& entry) { return entry.Technique == name; });
    if (selected.size() == before)
    {
      BenchEntry entry;
      entry.Kind = name == VTKPeer ? BenchEntry::Role::Peer : BenchEntry::Role::Technique;
      entry.Technique = name;
      selected.push_back(entry);
    }
  }
  plan.Entries = selected;
}

//------------------------------------------------------------------------------
void Sweep(BenchPlan& plan, const std::vector<std::string>& sweeps)
{
  // The first sweep of a technique takes the place of what the plan had, the next ones multiply it.
  std::set<std::string> swept;
  for (const std::string& text : sweeps)
  {
    const auto sweep = TechniqueSetting::Parse(text);
    const auto values = sweep ? Values::Split(sweep->Value) : std::vector<std::string>();
    if (values.empty() || std::any_of(values.begin(), values.end(),
                            [](const std::string& value) { return value.empty(); }))
    {
      throw WrongUsage("--sweep: \"" + text + "\" is not [TECHNIQUE:]NAME=VALUE,VALUE,...");
    }
    std::vector<BenchEntry> entries;
    bool used = false;
    std::set<std::string> sweptNow;
    for (const BenchEntry& entry : plan.Entries)
    {
      const bool meant = entry.Kind != BenchEntry::Role::None &&
                         (sweep->Technique.empty() || sweep->Technique == entry.Technique) &&
                         HasParameter(entry.Technique, sweep->Name);
      if (!meant)
      {
        entries.push_back(entry);
        continue;
      }
      used = true;
      const bool first = swept.count(entry.Technique) == 0;
      if (!sweptNow.insert(entry.Technique).second && first)
      {
        continue; // its first entry stands for all
      }
      BenchEntry one = entry;
      one.Values = first ? BenchEntry::Setting() : entry.Values;
      one.Label.clear(); // what is said of the plan's own settings
      one.Published = nullptr;
      if (Sets(one, sweep->Name))
      {
        throw WrongUsage("--sweep: " + sweep->Name + " of " + entry.Technique + " is given twice.");
      }
      one.Values.emplace_back(sweep->Name, "");
      for (auto value = values.begin(); value != values.end(); ++value)
      {
        if (std::find(values.begin(), value, *value) != value)
        {
          throw WrongUsage("--sweep " + text + ": " + *value + " is given twice.");
        }
        one.Values.back().second = *value;
        entries.push_back(one);
      }
    }
    if (!used)
    {
      throw Failure("--sweep " + text + ": none of the techniques used here has that parameter.");
    }
    swept.insert(sweptNow.begin(), sweptNow.end());
    plan.Entries = entries;
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkShadowPass> MakePass(const BenchCase& one, const BenchEntry& entry)
{
  TechniqueOptions options;
  options.Settings = GetSettings(one, entry);
  options.Measured = true;
  return options.Create(entry.Technique, false);
}

//------------------------------------------------------------------------------
int GetVTKResolution(const BenchCase& one, const BenchEntry& entry)
{
  int resolution = 1024;
  for (const TechniqueSetting& setting : GetSettings(one, entry))
  {
    if (setting.Name != "resolution" && setting.Technique.empty())
    {
      continue; // another technique's
    }
    char* end = nullptr;
    const long value = std::strtol(setting.Value.c_str(), &end, 10);
    if (setting.Name != "resolution" || *end != '\0' || value < 1 || value > 16384)
    {
      throw Failure(std::string(VTKPeer) + ": " + setting.Name + "=" + setting.Value +
                    ". It has a resolution, from 1 to 16384.");
    }
    resolution = static_cast<int>(value);
  }
  return resolution;
}

//------------------------------------------------------------------------------
void Check(const BenchPlan& plan)
{
  std::set<std::string> ids;
  for (const BenchEntry& entry : plan.Entries)
  {
    if (!ids.insert(entry.GetId()).second)
    {
      throw Failure("suite " + plan.Name + ": \"" + entry.GetId() + "\" stands there twice.");
    }
  }
  ids.clear();
  for (const BenchCase& one : plan.Cases)
  {
    if (!ids.insert(one.Id).second)
    {
      throw Failure("suite " + plan.Name + ": two cases are named \"" + one.Id + "\".");
    }
    one.Scene.Check();
    one.CheckAxis();
    CheckCaseSettings(plan, one);
    CheckPublished(plan, one);
    for (const BenchEntry& entry : plan.Entries)
    {
      if (entry.Technique == VTKPeer)
      {
        GetVTKResolution(one, entry);
      }
      else if (entry.Kind != BenchEntry::Role::None)
      {
        MakePass(one, entry);
      }
    }
  }
}
}
