// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowSettings.h"

#include "vtkShadowDeclaration.h"

#include <algorithm>
#include <stdexcept>

//------------------------------------------------------------------------------
void vtkShadowSettings::Reset(const vtkShadowDeclaration* declaration)
{
  this->Declaration = declaration;
  this->Values.clear();
  this->Time.Modified();
  if (!declaration)
  {
    return;
  }
  for (const auto* list : { &declaration->Parameters, &vtkShadowParameter::GetCommon() })
  {
    for (const auto& parameter : *list)
    {
      this->Values[parameter.Name] =
        parameter.Read(parameter.Default).value_or(vtkShadowValue{ parameter.Default, 0.0 });
    }
  }
}

//------------------------------------------------------------------------------
std::string vtkShadowSettings::GetTechnique() const
{
  return this->Declaration ? this->Declaration->Name : "";
}

//------------------------------------------------------------------------------
std::string vtkShadowSettings::Set(const std::string& name, const std::string& value)
{
  const vtkShadowParameter* parameter =
    this->Declaration ? this->Declaration->FindParameter(name) : nullptr;
  if (!parameter)
  {
    return this->GetUnknown(name);
  }
  const auto read = parameter->Read(value);
  if (!read)
  {
    return this->GetTechnique() + ": parameter '" + name + "' cannot be '" + value + "'; it is " +
           parameter->DescribeRange() + ".";
  }
  vtkShadowValue& current = this->Values[name];
  const bool choice = parameter->ValueType == vtkShadowParameter::Type::Choice;
  const bool changed = choice ? current.Text != read->Text : current.Number != read->Number;
  current = *read;
  if (changed)
  {
    (parameter->OfShading ? this->ShadingTime : this->Time).Modified();
  }
  return "";
}

//------------------------------------------------------------------------------
const std::string* vtkShadowSettings::Find(const std::string& name) const
{
  const auto found = this->Values.find(name);
  return found == this->Values.end() ? nullptr : &found->second.Text;
}

//------------------------------------------------------------------------------
std::string vtkShadowSettings::GetUnknown(const std::string& name) const
{
  std::string known;
  for (const auto& entry : this->Values)
  {
    known += (known.empty() ? "" : ", ") + entry.first;
  }
  return this->GetTechnique() + " has no parameter '" + name + "'. Known: " + known + ".";
}

//------------------------------------------------------------------------------
void vtkShadowSettings::Copy(const vtkShadowSettings& other)
{
  const auto same = [](const auto& a, const auto& b)
  { return a.first == b.first && a.second.Text == b.second.Text; };
  if (!std::equal(
        this->Values.begin(), this->Values.end(), other.Values.begin(), other.Values.end(), same))
  {
    this->Values = other.Values;
    this->Time.Modified();
  }
}

//------------------------------------------------------------------------------
const vtkShadowValue& vtkShadowSettings::Get(
  const std::string& name, vtkShadowParameter::Type type) const
{
  const vtkShadowParameter* parameter =
    this->Declaration ? this->Declaration->FindParameter(name) : nullptr;
  if (!parameter)
  {
    throw std::logic_error(this->GetUnknown(name));
  }
  if (parameter->ValueType != type)
  {
    throw std::logic_error(this->GetTechnique() + ": parameter '" + name +
                           "' is read as of another type than declared.");
  }
  return this->Values.at(name);
}

//------------------------------------------------------------------------------
int vtkShadowSettings::GetInteger(const std::string& name) const
{
  return static_cast<int>(this->Get(name, vtkShadowParameter::Type::Integer).Number);
}

//------------------------------------------------------------------------------
double vtkShadowSettings::GetReal(const std::string& name) const
{
  return this->Get(name, vtkShadowParameter::Type::Real).Number;
}

//------------------------------------------------------------------------------
bool vtkShadowSettings::GetBoolean(const std::string& name) const
{
  return this->Get(name, vtkShadowParameter::Type::Boolean).Number != 0.0;
}

//------------------------------------------------------------------------------
std::string vtkShadowSettings::GetChoice(const std::string& name) const
{
  return this->Get(name, vtkShadowParameter::Type::Choice).Text;
}
