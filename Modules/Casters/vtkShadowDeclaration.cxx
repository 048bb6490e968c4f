// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowDeclaration.h"

#include <algorithm>
#include <utility>

namespace
{
// Function-local, so that it exists before the first family registers, whatever the load order.
vtkShadowTechniqueRegistration::Registry& GetRegistry()
{
  static vtkShadowTechniqueRegistration::Registry techniques;
  return techniques;
}
}

//------------------------------------------------------------------------------
const vtkShadowParameter* vtkShadowDeclaration::FindParameter(const std::string& name) const
{
  for (const auto* list : { &this->Parameters, &vtkShadowParameter::GetCommon() })
  {
    const auto found = std::find_if(list->begin(), list->end(),
      [&name](const vtkShadowParameter& parameter) { return parameter.Name == name; });
    if (found != list->end())
    {
      return &*found;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
vtkShadowTechniqueRegistration::vtkShadowTechniqueRegistration(vtkShadowDeclaration declaration)
{
  const std::string name = declaration.Name;
  GetRegistry().emplace(name, std::move(declaration));
}

//------------------------------------------------------------------------------
const vtkShadowTechniqueRegistration::Registry& vtkShadowTechniqueRegistration::GetAll()
{
  return GetRegistry();
}

//------------------------------------------------------------------------------
const vtkShadowDeclaration* vtkShadowTechniqueRegistration::Find(const std::string& name)
{
  const auto found = GetRegistry().find(name);
  return found == GetRegistry().end() ? nullptr : &found->second;
}

//------------------------------------------------------------------------------
std::string vtkShadowTechniqueRegistration::GetHint()
{
  return "none: link a module of techniques, such as SoftShadows::ShadowMaps, and name it in "
         "CMake's "
         "vtk_module_autoinit(TARGETS ... MODULES ...), which initializes it";
}
