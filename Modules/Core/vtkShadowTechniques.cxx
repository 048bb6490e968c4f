#include "vtkShadowTechniques.h"

#include "vtkObjectFactory.h"
#include "vtkShadowPass.h"
#include "vtkShadowTechnique.h"

#include <nlohmann/json.hpp>

#include <algorithm>

vtkStandardNewMacro(vtkShadowTechniques);

namespace
{
// Function-local, so that it exists before the first family registers, whatever the load order.
std::vector<vtkShadowTechnique>& Registry()
{
  static std::vector<vtkShadowTechnique> techniques;
  return techniques;
}

const vtkShadowTechnique* FindOrReport(const std::string& name)
{
  const vtkShadowTechnique* technique = vtkShadowTechniqueRegistration::Find(name);
  if (!technique)
  {
    std::string known;
    for (const auto& other : Registry())
    {
      known += (known.empty() ? "" : ", ") + other.Name;
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
  auto& all = Registry();
  const auto place = std::lower_bound(all.begin(), all.end(), technique,
    [](const vtkShadowTechnique& a, const vtkShadowTechnique& b) { return a.Name < b.Name; });
  all.insert(place, std::move(technique));
}

//------------------------------------------------------------------------------
const std::vector<vtkShadowTechnique>& vtkShadowTechniqueRegistration::GetAll()
{
  return Registry();
}

//------------------------------------------------------------------------------
const vtkShadowTechnique* vtkShadowTechniqueRegistration::Find(const std::string& name)
{
  for (const auto& technique : Registry())
  {
    if (technique.Name == name)
    {
      return &technique;
    }
  }
  return nullptr;
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
  return static_cast<int>(Registry().size());
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
  return Registry()[i].Name.c_str();
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
