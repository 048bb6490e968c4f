// SPDX-License-Identifier: BSD-3-Clause
#include "Techniques.h"

#include "Errors.h"

#include "vtkShadowTechniques.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <algorithm>

//------------------------------------------------------------------------------
std::optional<TechniqueSetting> TechniqueSetting::Parse(const std::string& text)
{
  const std::size_t equals = text.find('=');
  const std::size_t colon = text.substr(0, equals).find(':');
  TechniqueSetting setting;
  if (equals != std::string::npos)
  {
    const std::size_t start = colon == std::string::npos ? 0 : colon + 1;
    setting.Technique = text.substr(0, colon == std::string::npos ? 0 : colon);
    setting.Name = text.substr(start, equals - start);
    setting.Value = text.substr(equals + 1);
  }
  if (setting.Name.empty() || colon == 0)
  {
    return std::nullopt;
  }
  return setting;
}

//------------------------------------------------------------------------------
void TechniqueOptions::Declare(CLI::App& command)
{
  command.add_option("--quality", this->Quality, "Preset: preview, low, medium, high or reference")
    ->type_name("LEVEL")
    ->group("Technique");
  command
    .add_option_function<std::vector<std::string>>(
      "--set",
      [this](const std::vector<std::string>& texts)
      {
        for (const std::string& text : texts)
        {
          const auto setting = TechniqueSetting::Parse(text);
          if (!setting)
          {
            throw CLI::ValidationError("--set", "\"" + text + "\" is not NAME=VALUE");
          }
          this->Settings.push_back(*setting);
        }
      },
      "Set a parameter (see \"softshadows list\"); may be given again. TECHNIQUE:NAME=VALUE\n"
      "sets it for that technique alone")
    ->type_name("NAME=VALUE")
    ->allow_extra_args(false)
    ->group("Technique");
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkShadowPass> TechniqueOptions::Create(
  const std::string& technique, bool strict) const
{
  auto pass = vtkSmartPointer<vtkShadowPass>::Take(vtkShadowTechniques::Create(technique));
  if (!pass)
  {
    Messages::Check();
    throw Failure("technique '" + technique + "' cannot be made.");
  }
  Techniques::SetQuality(pass, this->Quality);
  if (this->Measured)
  {
    pass->SetParameter("terminator", "facets");
  }
  const nlohmann::ordered_json description = Techniques::Describe(technique);
  for (const TechniqueSetting& setting : this->Settings)
  {
    const bool meant = setting.Technique.empty()
                         ? strict || Techniques::HasParameter(description, setting.Name)
                         : setting.Technique == technique;
    if (meant && !pass->SetParameter(setting.Name, setting.Value))
    {
      break;
    }
  }
  Messages::Check();
  return pass;
}

//------------------------------------------------------------------------------
std::string TechniqueOptions::TakeDefault(bool studio)
{
  if (!studio)
  {
    return "map-pcss";
  }
  // The studio's light stands still: maps are kept.
  this->Settings.insert(this->Settings.begin(), { "map-soft", "midpoint", "on" });
  return "map-soft";
}

//------------------------------------------------------------------------------
void TechniqueOptions::CheckSettings(const std::vector<std::string>& techniques) const
{
  for (const TechniqueSetting& setting : this->Settings)
  {
    if (!setting.Technique.empty())
    {
      Techniques::Describe(setting.Technique); // a failure where there is none
      if (std::find(techniques.begin(), techniques.end(), setting.Technique) == techniques.end())
      {
        throw Failure("--set " + setting.Technique + ":" + setting.Name + "=" + setting.Value +
                      ": " + setting.Technique + " is not among the techniques used here.");
      }
    }
    else if (std::none_of(techniques.begin(), techniques.end(),
               [&](const std::string& name)
               { return Techniques::HasParameter(Techniques::Describe(name), setting.Name); }))
    {
      throw Failure("none of the techniques has a parameter '" + setting.Name + "'.");
    }
  }
}

namespace Techniques
{
//------------------------------------------------------------------------------
std::vector<std::string> GetNames()
{
  std::vector<std::string> names;
  for (int i = 0; i < vtkShadowTechniques::GetNumberOfTechniques(); ++i)
  {
    names.emplace_back(vtkShadowTechniques::GetName(i));
  }
  return names;
}

//------------------------------------------------------------------------------
nlohmann::ordered_json Describe(const std::string& technique)
{
  const std::string text = vtkShadowTechniques::Describe(technique);
  Messages::Check();
  return nlohmann::ordered_json::parse(text);
}

//------------------------------------------------------------------------------
bool HasParameter(const nlohmann::ordered_json& description, const std::string& parameter)
{
  const auto& parameters = description["parameters"];
  return std::any_of(parameters.begin(), parameters.end(),
    [&](const nlohmann::ordered_json& one) { return one["name"] == parameter; });
}

//------------------------------------------------------------------------------
void SetQuality(vtkShadowPass* pass, const std::string& quality)
{
  if (quality == "preview")
  {
    pass->SetQualityToPreview();
  }
  else if (quality == "low")
  {
    pass->SetQualityToLow();
  }
  else if (quality == "medium")
  {
    pass->SetQualityToMedium();
  }
  else if (quality == "high")
  {
    pass->SetQualityToHigh();
  }
  else if (quality == "reference")
  {
    pass->SetQualityToReference();
  }
  else if (!quality.empty())
  {
    throw Failure(
      "unknown quality '" + quality + "'. Known: preview, low, medium, high, reference.");
  }
}
//------------------------------------------------------------------------------
nlohmann::ordered_json GetParameters(vtkShadowPass* pass)
{
  nlohmann::ordered_json values = nlohmann::ordered_json::object();
  const nlohmann::ordered_json description = Describe(pass->GetTechnique());
  for (const auto& parameter : description["parameters"])
  {
    const std::string name = parameter["name"];
    values[name] = pass->GetParameter(name);
  }
  return values;
}

//------------------------------------------------------------------------------
int GetLightSamples(vtkShadowPass* pass)
{
  constexpr int some = 64;
  if (!pass)
  {
    return some;
  }
  const nlohmann::ordered_json description = Describe(pass->GetTechnique());
  return HasParameter(description, "samples") ? std::stoi(pass->GetParameter("samples"))
         : description["hard"].get<bool>()    ? 1
                                              : some;
}

//------------------------------------------------------------------------------
std::string FindUnsupported(
  vtkShadowPass* pass, vtkRenderWindow* window, const std::string& lightShape)
{
  if (Describe(pass->GetTechnique())["lightShapes"].value(lightShape, "") == "unsupported")
  {
    return "does not support a " + lightShape + " light";
  }
  return pass->IsSupported(window) ? "" : pass->GetUnsupportedReason();
}
}
