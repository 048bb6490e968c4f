#include "vtkShadowTechniques.h"

#include "vtkObjectFactory.h"
#include "vtkShadowPass.h"
#include "vtkShadowTechnique.h"

#include <nlohmann/json.hpp>

#include <iterator>

vtkStandardNewMacro(vtkShadowTechniques);

namespace
{
// Function-local, so that it exists before the first family registers, whatever the load order.
vtkShadowTechniqueRegistration::Registry& GetRegistry()
{
  static vtkShadowTechniqueRegistration::Registry techniques;
  return techniques;
}

const vtkShadowTechnique* FindOrReport(const std::string& name)
{
  const vtkShadowTechnique* technique = vtkShadowTechniqueRegistration::Find(name);
  if (!technique)
  {
    std::string known;
    for (const auto& other : GetRegistry())
    {
      known += (known.empty() ? "" : ", ") + other.first;
    }
    vtkErrorWithObjectMacro(nullptr,
      "Unknown shadow technique '"
        << name << "'. Known: " << (known.empty() ? "none; no family module is linked" : known)
        << ".");
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
vtkShadowTechniqueRegistration::vtkShadowTechniqueRegistration(vtkShadowTechnique technique)
{
  const std::string name = technique.Name;
  GetRegistry().emplace(name, std::move(technique));
}

//------------------------------------------------------------------------------
const vtkShadowTechniqueRegistration::Registry& vtkShadowTechniqueRegistration::GetAll()
{
  return GetRegistry();
}

//------------------------------------------------------------------------------
const vtkShadowTechnique* vtkShadowTechniqueRegistration::Find(const std::string& name)
{
  const auto found = GetRegistry().find(name);
  return found == GetRegistry().end() ? nullptr : &found->second;
}

//------------------------------------------------------------------------------
vtkShadowPass* vtkShadowTechniques::Create(const std::string& name)
{
  const vtkShadowTechnique* technique = FindOrReport(name);
  if (!technique)
  {
    return nullptr;
  }
  vtkShadowPass* pass = technique->New();
  pass->SetTechnique(name);
  return pass;
}

//------------------------------------------------------------------------------
int vtkShadowTechniques::GetNumberOfTechniques()
{
  return static_cast<int>(GetRegistry().size());
}

//------------------------------------------------------------------------------
const char* vtkShadowTechniques::GetName(int i)
{
  if (i < 0 || i >= vtkShadowTechniques::GetNumberOfTechniques())
  {
    vtkErrorWithObjectMacro(nullptr, "There is no technique "
                                       << i << "; there are "
                                       << vtkShadowTechniques::GetNumberOfTechniques() << ".");
    return nullptr;
  }
  return std::next(GetRegistry().begin(), i)->first.c_str();
}

//------------------------------------------------------------------------------
std::string vtkShadowTechniques::Describe(const std::string& name)
{
  const vtkShadowTechnique* technique = FindOrReport(name);
  if (!technique)
  {
    return "";
  }
  nlohmann::ordered_json json = { { "name", technique->Name }, { "title", technique->Title },
    { "paper", technique->Paper }, { "class", technique->ClassName }, { "hard", technique->Hard },
    { "planarReceivers", technique->PlanarReceivers } };
  for (std::size_t i = 0; i < vtkShadowTechnique::ShapeNames.size(); ++i)
  {
    json["lightShapes"][vtkShadowTechnique::ShapeNames[i]] = ToString(technique->LightShapes[i]);
  }
  json["parameters"] = nlohmann::ordered_json::array();
  for (const auto& parameter : technique->Parameters)
  {
    json["parameters"].push_back(ToJson(parameter));
  }
  for (const auto& parameter : vtkShadowPass::GetCommonParameters())
  {
    json["parameters"].push_back(ToJson(parameter));
  }
  json["resources"] = technique->Resources;
  json["limits"] = technique->Limits;
  return json.dump(2);
}
