// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowTechniques.h"

#include "vtkObjectFactory.h"
#include "vtkShadowDeclaration.h"
#include "vtkShadowPass.h"

#include <nlohmann/json.hpp>

#include <iterator>

vtkStandardNewMacro(vtkShadowTechniques);

namespace
{
const vtkShadowDeclaration* FindOrReport(const std::string& name)
{
  const vtkShadowDeclaration* technique = vtkShadowTechniqueRegistration::Find(name);
  if (!technique)
  {
    std::string known;
    for (const auto& other : vtkShadowTechniqueRegistration::GetAll())
    {
      known += (known.empty() ? "" : ", ") + other.first;
    }
    vtkErrorWithObjectMacro(
      nullptr, "Unknown shadow technique '"
                 << name << "'. Known: "
                 << (known.empty() ? vtkShadowTechniqueRegistration::GetHint() : known) << ".");
  }
  return technique;
}

const char* ToString(vtkShadowParameter::Type type)
{
  switch (type)
  {
    case vtkShadowParameter::Type::Integer:
      return "integer";
    case vtkShadowParameter::Type::Real:
      return "real";
    case vtkShadowParameter::Type::Boolean:
      return "boolean";
    default:
      return "choice";
  }
}

const char* ToString(vtkShadowShapeSupport support)
{
  switch (support)
  {
    case vtkShadowShapeSupport::Exact:
      return "exact";
    case vtkShadowShapeSupport::Approximate:
      return "approximate";
    default:
      return "unsupported";
  }
}

nlohmann::ordered_json ToJson(const vtkShadowParameter& parameter)
{
  nlohmann::ordered_json json = { { "name", parameter.Name },
    { "type", ToString(parameter.ValueType) }, { "default", parameter.Default } };
  if (parameter.ValueType == vtkShadowParameter::Type::Integer ||
      parameter.ValueType == vtkShadowParameter::Type::Real)
  {
    json["minimum"] = parameter.Minimum;
    json["maximum"] = parameter.Maximum;
  }
  if (!parameter.Choices.empty())
  {
    json["choices"] = parameter.Choices;
  }
  json["unit"] = parameter.Unit;
  json["meaning"] = parameter.Meaning;
  if (!parameter.Presets.empty())
  {
    json["presets"]["preview"] = parameter.GetPreview();
    static const char* const levels[] = { "low", "medium", "high", "reference" };
    for (std::size_t i = 0; i < parameter.Presets.size(); ++i)
    {
      json["presets"][levels[i]] = parameter.Presets[i];
    }
  }
  return json;
}
}

//------------------------------------------------------------------------------
vtkShadowPass* vtkShadowTechniques::Create(const std::string& name)
{
  const vtkShadowDeclaration* technique = FindOrReport(name);
  if (!technique)
  {
    return nullptr;
  }
  vtkShadowPass* pass = technique->NewPass ? technique->NewPass() : vtkShadowPass::New();
  pass->SetTechnique(name);
  return pass;
}

//------------------------------------------------------------------------------
int vtkShadowTechniques::GetNumberOfTechniques()
{
  return static_cast<int>(vtkShadowTechniqueRegistration::GetAll().size());
}

//------------------------------------------------------------------------------
const char* vtkShadowTechniques::GetName(int i)
{
  if (i < 0 || i >= vtkShadowTechniques::GetNumberOfTechniques())
  {
    vtkErrorWithObjectMacro(nullptr, "There is no technique "
                                       << i << "; there are "
                                       << vtkShadowTechniques::GetNumberOfTechniques() << ".");
    return "";
  }
  return std::next(vtkShadowTechniqueRegistration::GetAll().begin(), i)->first.c_str();
}

//------------------------------------------------------------------------------
std::string vtkShadowTechniques::Describe(const std::string& name)
{
  const vtkShadowDeclaration* technique = FindOrReport(name);
  if (!technique)
  {
    return "";
  }
  nlohmann::ordered_json json = { { "name", technique->Name }, { "title", technique->Title },
    { "paper", technique->Paper },
    { "class", technique->ClassName.empty() ? "vtkShadowPass" : technique->ClassName } };
  const vtkShadowTraits& traits = technique->Traits;
  json["hard"] = traits.Hard;
  json["planarReceivers"] = traits.PlanarReceivers;
  json["needsReceivers"] = traits.NeedsReceivers;
  json["cameraDependent"] = traits.CameraDependent;
  json["forward"] = traits.Forward;
  json["signedShares"] = traits.SignedShares;
  json["samplesLights"] = traits.SamplesLights;
  for (std::size_t i = 0; i < vtkShadowDeclaration::ShapeNames.size(); ++i)
  {
    json["lightShapes"][vtkShadowDeclaration::ShapeNames[i]] = ToString(technique->LightShapes[i]);
  }
  json["parameters"] = nlohmann::ordered_json::array();
  for (const auto& parameter : technique->Parameters)
  {
    json["parameters"].push_back(ToJson(parameter));
  }
  for (const auto& parameter : vtkShadowParameter::GetCommon())
  {
    json["parameters"].push_back(ToJson(parameter));
  }
  json["debugViews"] = { "none", "visibility", "penumbra", "cost" };
  for (const auto& view : technique->DebugViews)
  {
    json["debugViews"].push_back(view);
  }
  json["resources"] = technique->Resources;
  json["limits"] = technique->Limits;
  return json.dump(2);
}
