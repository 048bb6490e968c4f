// SPDX-License-Identifier: BSD-3-Clause
// Suites: plans as data.

#include "BenchPlan.h"

#include "BenchSuiteSchema.h"
#include "BenchSuites.h"
#include "Errors.h"
#include "Inputs.h"

#include "vtkShadowScenes.h"

#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include <filesystem>

namespace
{
using Json = nlohmann::ordered_json;

constexpr unsigned long long LargestFile = 16 << 20;
constexpr std::size_t MostEntries = 10000;

//------------------------------------------------------------------------------
// The part of the form that a field has to have.
Json FindForm(const Json& form, const std::vector<std::string>& path)
{
  const auto resolve = [&form](Json part)
  {
    while (part.contains("$ref"))
    {
      part = form[Json::json_pointer(part["$ref"].get<std::string>().substr(1))];
    }
    return part;
  };
  Json part = form;
  for (const std::string& name : path)
  {
    const Json none = Json::object();
    const Json fields = part.value("properties", none);
    const Json others = part.value("additionalProperties", none);
    const Json outer = part;
    part = resolve(fields.contains(name)    ? fields[name]
                   : part.contains("items") ? part["items"]
                   : others.is_object()     ? others
                                            : none);
    if (!part.contains("description"))
    {
      part["description"] = outer.value("description", ""); // items are what the list is of
    }
  }
  return part;
}

// The words between others, "a, b or c".
std::string List(const Json& words, const char* last = " or ")
{
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
  {
    const char* const between = i + 1 == words.size() ? last : ", ";
    text += (i == 0 ? "" : between) +
            (words[i].is_string() ? words[i].get<std::string>() : words[i].dump());
  }
  return text;
}

//------------------------------------------------------------------------------
// What is wrong, in words of the suite instead of those of the form.
std::string Explain(const std::string& reason, const Json& form)
{
  const auto says = [&reason](const char* words)
  { return reason.find(words) != std::string::npos; };
  std::string text = reason.substr(0, reason.find_last_not_of(" .") + 1);
  if (says("'type' constraint") && form.contains("type"))
  {
    const Json& type = form["type"];
    text = "is no " + List(type.is_array() ? type : Json::array({ type }));
  }
  else if (says("enum") && form.contains("enum"))
  {
    text = "is none of " + List(form["enum"]);
  }
  else if (says("pattern") && form.contains("pattern"))
  {
    text = "has not its form";
  }
  else if (form.contains("oneOf") && says("child schema"))
  {
    Json names = Json::array();
    for (const Json& one : form["oneOf"])
    {
      names.push_back(one["required"][0]);
    }
    text = "names just one of " + List(names);
  }
  else if (says("'properties' or 'additionalProperties'"))
  {
    Json names = Json::array();
    const Json fields = form.value("properties", Json::object());
    for (const auto& field : fields.items())
    {
      names.push_back(field.key());
    }
    const std::size_t name = reason.find('\'', reason.rfind(": "));
    return "has no field " + reason.substr(name, reason.rfind('\'') + 1 - name) + ", but " +
           List(names, " and ") + ".";
  }
  const std::string meaning = form.value("description", "");
  return text + "." + (meaning.empty() ? "" : " It is: " + meaning);
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
  std::vector<std::string> names;
  for (std::size_t i = 1; i < deepest.context.size(); ++i)
  {
    const std::string& name = deepest.context[i]; // "[name]"
    path += name;
    names.push_back(name.substr(1, name.size() - 2));
  }
  throw Failure("suite \"" + file + "\"" + (path.empty() ? "" : ", " + path) + ": " +
                Explain(deepest.description, FindForm(Json::parse(BenchSuiteSchema), names)));
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
  one.Scene.SamplesPerPixel =
    json.value("samples_per_pixel", suite.value("samples_per_pixel", one.Scene.SamplesPerPixel));
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
        if (multiplied.size() == MostEntries)
        {
          throw Failure("the sweep of " + entry.Technique + " has more than " +
                        std::to_string(MostEntries) + " combinations.");
        }
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

//------------------------------------------------------------------------------
// The row, for each technique of this build where it stands for all. Not auto: it is one of the others,
// chosen anew in each case by their times.
std::vector<Json> NameTechniques(const Json& row)
{
  if (row.value("technique", "") != "*")
  {
    return { row };
  }
  std::vector<Json> rows;
  for (const std::string& name : Techniques::GetNames())
  {
    if (name != "auto")
    {
      rows.push_back(row);
      rows.back()["technique"] = name;
    }
  }
  return rows;
}

//------------------------------------------------------------------------------
BenchPlan ReadPlan(const Json& suite, const std::string& name, const std::string& file)
{
  BenchPlan plan;
  plan.Name = name;
  plan.Title = suite["title"].get<std::string>();
  plan.About = suite.value("about", "");
  plan.Frames = suite.value("frames", plan.Frames);
  plan.Published = suite.value("published", Json());
  const Json cases = suite.value("cases", Json::array());
  for (const Json& one : cases)
  {
    plan.Cases.push_back(ReadCase(one, suite, file));
  }
  plan.Default = ReadCase({ { "scene", "" } }, suite, file);
  plan.Entries.emplace_back();
  plan.Entries.front().Published = plan.Published;
  plan.Extremes = ExtremePlans::Read(suite);
  for (const Json& row : suite["entries"])
  {
    for (const Json& named : NameTechniques(row))
    {
      const auto entries = ReadEntries(named);
      plan.Entries.insert(plan.Entries.end(), entries.begin(), entries.end());
    }
  }
  return plan;
}

//------------------------------------------------------------------------------
// Failure, which names the file, for what will not work, before anything of the command line is put in
// its place.
BenchPlan ReadFile(const Json& suite, const std::string& file)
{
  try
  {
    const BenchPlan plan = ReadPlan(suite, std::filesystem::path(file).stem().string(), file);
    BenchPlan checked = plan;
    if (checked.Cases.empty())
    {
      checked.Cases = { plan.Default }; // entries are the same in any scene
      checked.Cases.front().Scene.Builtin = vtkShadowScenes::GetName(0);
    }
    BenchPlans::Check(checked);
    return plan;
  }
  catch (const std::runtime_error& wrong) // of a command line it would be wrong usage
  {
    const std::string text = wrong.what();
    throw Failure(text.rfind("suite ", 0) == 0 ? text : "suite \"" + file + "\": " + text);
  }
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
  if (builtin != BenchSuites.end())
  {
    return ReadPlan(Json::parse(builtin->second), nameOrFile, nameOrFile);
  }
  std::error_code ignored;
  if (!std::filesystem::exists(nameOrFile, ignored))
  {
    std::string known;
    for (const std::string& name : GetSuites())
    {
      known += (known.empty() ? "" : ", ") + name;
    }
    throw WrongUsage("unknown suite '" + nameOrFile + "'. Known: " + known +
                     "; or give a file (suites/suite.schema.json tells its form).");
  }
  const std::string text = Inputs::ReadText(nameOrFile, LargestFile);
  Json suite;
  try
  {
    suite = Json::parse(text);
  }
  catch (const nlohmann::json::exception& wrong)
  {
    throw Failure("suite \"" + nameOrFile + "\" is no JSON: " + wrong.what());
  }
  Validate(text, nameOrFile);
  return ReadFile(suite, nameOrFile);
}
}
