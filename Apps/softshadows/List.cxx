// SPDX-License-Identifier: BSD-3-Clause
#include "List.h"

#include "Errors.h"
#include "StandardOutput.h"
#include "Techniques.h"

#include "vtkShadowNumber.h"
#include "vtkShadowScenes.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <cstdio>
#include <memory>

namespace
{
using Json = nlohmann::ordered_json;

struct ListOptions
{
  std::string What;
  bool AsJson = false;
};

std::string Join(const Json& words, const char* between)
{
  std::string text;
  for (const auto& word : words)
  {
    text += (text.empty() ? "" : between) + word.get<std::string>();
  }
  return text;
}

/** The values that a parameter takes, for a reader. */
std::string DescribeRange(const Json& parameter)
{
  std::string text = "on|off";
  if (parameter.contains("choices"))
  {
    text = Join(parameter["choices"], "|");
  }
  else if (parameter.contains("minimum"))
  {
    text = vtkShadowNumber::Print(parameter["minimum"]) + " to " +
           vtkShadowNumber::Print(parameter["maximum"]);
  }
  const std::string unit = parameter.value("unit", "");
  return text + (unit.empty() ? "" : " ") + unit;
}

void PrintTechnique(const Json& technique)
{
  std::printf("  %s: %s\n", technique["name"].get<std::string>().c_str(),
    technique["title"].get<std::string>().c_str());
  std::string shapes;
  for (const auto& [shape, support] : technique["lightShapes"].items())
  {
    shapes += (shapes.empty() ? "" : ", ") + shape;
    shapes += support == "exact" ? "" : " (" + support.get<std::string>() + ")";
  }
  std::printf("    lights: %s\n", shapes.c_str());
  for (const auto& parameter : technique["parameters"])
  {
    const std::string value =
      parameter["name"].get<std::string>() + "=" + parameter["default"].get<std::string>();
    std::printf("    %-20s %s\n", value.c_str(), DescribeRange(parameter).c_str());
    std::printf("    %-20s %s\n", "", parameter["meaning"].get<std::string>().c_str());
  }
}

void PrintScene(const Json& scene)
{
  const Json& triangles = scene["triangles"];
  const std::string count =
    triangles.is_number() ? std::to_string(triangles.get<long long>()) + " triangles" : "";
  std::printf("  %-12s %s%s%s\n", scene["name"].get<std::string>().c_str(),
    scene["title"].get<std::string>().c_str(), count.empty() ? "" : "; ", count.c_str());
  for (const auto& parameter : scene["parameters"])
  {
    std::printf("  %-12s --%s %lld to %lld\n", "", parameter["name"].get<std::string>().c_str(),
      parameter["min"].get<long long>(), parameter["max"].get<long long>());
  }
}

void List(const ListOptions& options)
{
  if (!options.What.empty() && options.What != "techniques" && options.What != "scenes")
  {
    throw WrongUsage(
      "there is nothing to list by the name '" + options.What + "'. Known: techniques, scenes.");
  }
  Json all;
  if (options.What != "scenes")
  {
    all["techniques"] = Json::array();
    for (const std::string& name : Techniques::GetNames())
    {
      all["techniques"].push_back(Techniques::Describe(name));
    }
  }
  if (options.What != "techniques")
  {
    all["scenes"] = Json::array();
    for (int i = 0; i < vtkShadowScenes::GetNumberOfScenes(); ++i)
    {
      all["scenes"].push_back(Json::parse(vtkShadowScenes::Describe(vtkShadowScenes::GetName(i))));
    }
  }
  Messages::Check();
  if (options.AsJson)
  {
    StandardOutput::Print(all);
    return;
  }
  if (all.contains("techniques"))
  {
    std::puts("Techniques (parameter=default, range, meaning):");
    for (const auto& technique : all["techniques"])
    {
      PrintTechnique(technique);
    }
  }
  if (all.contains("scenes"))
  {
    std::puts("Scenes:");
    for (const auto& scene : all["scenes"])
    {
      PrintScene(scene);
    }
  }
}
}

//------------------------------------------------------------------------------
void DeclareList(CLI::App& app)
{
  CLI::App* command = app.add_subcommand("list", "List the techniques and the built-in scenes");
  auto options = std::make_shared<ListOptions>();
  command->add_option("what", options->What, "techniques or scenes; both if not given")
    ->type_name("WHAT");
  command->add_flag("--json", options->AsJson, "Print JSON");
  command->callback([options] { List(*options); });
}
