// SPDX-License-Identifier: BSD-3-Clause
// Suites: plans as data.

#include "BenchPlan.h"

#include "BenchSuiteSchema.h"
#include "BenchSuites.h"
#include "Errors.h"

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace
{
using Json = nlohmann::ordered_json;

std::string ReadFile(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (!file || std::filesystem::is_directory(path))
  {
    throw Failure("cannot read the suite \"" + path + "\".");
  }
  return text.str();
}

//------------------------------------------------------------------------------
// Failure that names the first field which is not of the form.
void Validate(const std::string& text, const std::string& file)
{
  using valijson::adapters::NlohmannJsonAdapter;
  const auto form = nlohmann::json::parse(BenchSuiteSchema);
  const auto suite = nlohmann::json::parse(text);
  valijson::Schema schema;
  valijson::SchemaParser().populateSchema(NlohmannJsonAdapter(form), schema);
  valijson::ValidationResults results;
  if (valijson::Validator().validate(schema, NlohmannJsonAdapter(suite), &results))
  {
    return;
  }
  // Wholes are reported before and after their parts: the longest path is the field itself.
  valijson::ValidationResults::Error error;
  valijson::ValidationResults::Error deepest;
  while (results.popError(error))
  {
    if (error.context.size() >= deepest.context.size())
    {
      deepest = error;
    }
  }
  std::string path;
  for (std::size_t i = 1; i < deepest.context.size(); ++i)
  {
    path += deepest.context[i];
  }
  throw Failure(
    "suite \"" + file + "\"" + (path.empty() ? "" : ", " + path) + ": " + deepest.description);
}

std::string GetText(const Json& value)
{
  return value.is_string() ? value.get<std::string>() : value.dump();
}

//------------------------------------------------------------------------------
void ReadLight(const Json& light, BenchCase& one)
{
  const auto number = [&](const char* name, std::optional<double>& value)
  {
    if (light.contains(name))
    {
      value = light[name].get<double>();
    }
  };
  number("radius", one.Scene.Light.Radius);
  number("width", one.Scene.Light.Width);
  number("height", one.Scene.Light.Height);
  if (light.contains("position"))
  {
    one.Scene.Light.Position = light["position"].get<std::array<double, 3>>();
  }
  one.LightScale = light.value("scale", 1.0);
}

//------------------------------------------------------------------------------
BenchCase ReadCase(const Json& json, const Json& suite, const std::string& file)
{
  BenchCase one;
  one.Scene.Builtin = json["scene"].get<std::string>();
  one.Id = json.value("name", one.Scene.Builtin);
  const Json& sizes = json.contains("size") ? json : suite;
  if (sizes.contains("size"))
  {
    one.Scene.Size = sizes["size"].get<std::array<int, 2>>();
  }
  one.Scene.Triangles = json.value("triangles", 0);
  one.Lights = json.value("lights", 1);
  if (json.contains("light"))
  {
    ReadLight(json["light"], one);
  }
  if (json.contains("camera"))
  {
    one.Camera = BenchCase::View{ json["camera"]["position"].get<std::array<double, 3>>(),
      json["camera"]["focus"].get<std::array<double, 3>>() };
  }
  const Json set = json.value("set", Json::array());
  for (const Json& text : set)
  {
    const auto setting = TechniqueSetting::Parse(text.get<std::string>());
    if (!setting)
    {
      throw Failure("suite \"" + file + "\": \"" + text.get<std::string>() +
                    "\" is not [TECHNIQUE:]NAME=VALUE.");
    }
    one.Settings.Settings.push_back(*setting);
  }
  one.ReferenceSamples = json.value("reference", suite.value("reference", 1024));
  one.Budget = json.value("budget", suite.value("budget", one.Budget));
  one.Axis = json.value("axis", "");
  one.Published = json.value("published", "");
  return one;
}

//------------------------------------------------------------------------------
// One row of a suite: an entry for each combination of the sweep's values.
std::vector<BenchEntry> ReadEntries(const Json& json)
{
  BenchEntry entry;
  const bool peer = json.contains("peer");
  entry.Kind = peer ? BenchEntry::Role::Peer : BenchEntry::Role::Technique;
  entry.Technique = json[peer ? "peer" : "technique"].get<std::string>();
  entry.Label = json.value("label", "");
  entry.Published = json.value("published", Json());
  const Json set = json.value("set", Json::object());
  for (const auto& [name, value] : set.items())
  {
    entry.Values.emplace_back(name, GetText(value));
  }
  std::vector<BenchEntry> entries = { entry };
  const Json sweep = json.value("sweep", Json::object());
  for (const auto& [name, values] : sweep.items())
  {
    std::vector<BenchEntry> multiplied;
    for (const BenchEntry& one : entries)
    {
      for (const Json& value : values)
      {
        multiplied.push_back(one);
        multiplied.back().Values.emplace_back(name, GetText(value));
        if (!entry.Label.empty())
        {
          multiplied.back().Label += ", " + name + " " + GetText(value);
        }
      }
    }
    entries = multiplied;
  }
  return entries;
}
}

namespace BenchPlans
{
//------------------------------------------------------------------------------
std::vector<std::string> GetSuites()
{
  std::vector<std::string> names;
  for (const auto& suite : BenchSuites)
  {
    names.push_back(suite.first);
  }
  return names;
}

//------------------------------------------------------------------------------
BenchPlan Load(const std::string& nameOrFile)
{
  const auto builtin = BenchSuites.find(nameOrFile);
  if (builtin == BenchSuites.end() && !std::filesystem::exists(nameOrFile))
  {
    std::string known;
    for (const std::string& name : GetSuites())
    {
      known += (known.empty() ? "" : ", ") + name;
    }
    throw Failure("unknown suite '" + nameOrFile + "'. Known: " + known +
                  "; or give a file (suites/suite.schema.json tells its form).");
  }
  const std::string text = builtin != BenchSuites.end() ? builtin->second : ReadFile(nameOrFile);
  Json suite;
  try
  {
    suite = Json::parse(text);
    Validate(text, nameOrFile);
  }
  catch (const nlohmann::json::exception& wrong)
  {
    throw Failure("suite \"" + nameOrFile + "\" is no JSON: " + wrong.what());
  }

  BenchPlan plan;
  plan.Name =
    builtin != BenchSuites.end() ? nameOrFile : std::filesystem::path(nameOrFile).stem().string();
  plan.Title = suite["title"].get<std::string>();
  plan.About = suite.value("about", "");
  plan.Frames = suite.value("frames", plan.Frames);
  plan.Published = suite.value("published", Json());
  const Json cases = suite.value("cases", Json::array());
  for (const Json& one : cases)
  {
    plan.Cases.push_back(ReadCase(one, suite, nameOrFile));
  }
  plan.Default = ReadCase({ { "scene", "" } }, suite, nameOrFile);
  plan.Entries.emplace_back();
  plan.Entries.front().Published = plan.Published;
  for (const Json& row : suite["entries"])
  {
    const auto entries = ReadEntries(row);
    plan.Entries.insert(plan.Entries.end(), entries.begin(), entries.end());
  }
  return plan;
}
}
