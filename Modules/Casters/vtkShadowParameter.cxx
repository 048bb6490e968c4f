// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowParameter.h"

#include "vtkShadowNumber.h"

#include <algorithm>
#include <cmath>

namespace
{
vtkShadowParameter Make(const std::string& name, vtkShadowParameter::Type type,
  const std::string& value, const std::string& meaning)
{
  vtkShadowParameter parameter;
  parameter.Name = name;
  parameter.ValueType = type;
  parameter.Default = value;
  parameter.Meaning = meaning;
  return parameter;
}

vtkShadowParameter GetDarkness()
{
  auto parameter = vtkShadowParameter::Real("darkness", 1, 0, 1,
    "How dark shadows are: a factor on each light's shadow attenuation, 0 for none. Of a "
    "studio's light the fill answers for it, so that unlit sides are as dark as shadows");
  parameter.OfShading = true;
  return parameter;
}
}

//------------------------------------------------------------------------------
vtkShadowParameter vtkShadowParameter::Integer(
  const std::string& name, int value, int minimum, int maximum, const std::string& meaning)
{
  auto parameter = Make(name, Type::Integer, vtkShadowNumber::Print(value), meaning);
  parameter.Minimum = minimum;
  parameter.Maximum = maximum;
  return parameter;
}

//------------------------------------------------------------------------------
vtkShadowParameter vtkShadowParameter::Real(
  const std::string& name, double value, double minimum, double maximum, const std::string& meaning)
{
  auto parameter = Make(name, Type::Real, vtkShadowNumber::Print(value), meaning);
  parameter.Minimum = minimum;
  parameter.Maximum = maximum;
  return parameter;
}

//------------------------------------------------------------------------------
vtkShadowParameter vtkShadowParameter::Boolean(
  const std::string& name, bool value, const std::string& meaning)
{
  return Make(name, Type::Boolean, value ? "on" : "off", meaning);
}

//------------------------------------------------------------------------------
vtkShadowParameter vtkShadowParameter::Choice(const std::string& name, const std::string& value,
  const std::vector<std::string>& choices, const std::string& meaning)
{
  auto parameter = Make(name, Type::Choice, value, meaning);
  parameter.Choices = choices;
  return parameter;
}

//------------------------------------------------------------------------------
vtkShadowParameter& vtkShadowParameter::In(const std::string& unit)
{
  this->Unit = unit;
  return *this;
}

//------------------------------------------------------------------------------
vtkShadowParameter& vtkShadowParameter::At(const std::vector<double>& presets)
{
  this->Presets.clear();
  for (const double preset : presets)
  {
    this->Presets.push_back(vtkShadowNumber::Print(preset));
  }
  return *this;
}

//------------------------------------------------------------------------------
vtkShadowParameter& vtkShadowParameter::AtPreview(double preview)
{
  this->Preview = vtkShadowNumber::Print(preview);
  return *this;
}

//------------------------------------------------------------------------------
const std::vector<vtkShadowParameter>& vtkShadowParameter::GetCommon()
{
  static const std::vector<vtkShadowParameter> parameters = {
    Choice("evaluation", "auto", { "auto", "forward", "screen" },
      "Where visibility is evaluated: in each prop's shader (forward; keeps translucent receivers "
      "and several samples a pixel), or once a pixel into a buffer (screen); auto takes what the "
      "technique measured as the faster"),
    Choice("translucent-casters", "off", { "off", "opaque", "weighted" },
      "Whether translucent props cast: not at all, as if they were opaque, or by their property's "
      "(or block's) opacity; of several in a row the most opaque counts. Weighted costs one "
      "evaluation more for each opacity that occurs"),
    Boolean("accumulate", false,
      "Whether frames add up while nothing changes, of techniques that sample the lights: each "
      "takes "
      "other samples, and the picture shows the mean of all, evaluated in screen space. Any change "
      "starts anew; IsFinished tells when all are there, and frames cost nothing more"),
    Integer("accumulate-samples", 1024, 1, 1048576,
      "With accumulate=on: how many samples of each light frames add up to"),
    Real("alpha-threshold", 0.5, 0, 1,
      "Where the alpha of a prop's own texture and colours (not its property's opacity) is below "
      "this, it has a hole that light passes; elsewhere it casts. 0: no holes"),
    Choice("terminator", "smooth", { "smooth", "facets" },
      "Whether the shadows on a prop that its normals shade smoothly are those of the smooth "
      "surface that they stand for, or of its facets as they are, which cut the shading where it "
      "is coarse. Facets for measuring"),
    GetDarkness(),
  };
  return parameters;
}

//------------------------------------------------------------------------------
std::optional<vtkShadowValue> vtkShadowParameter::Read(const std::string& text) const
{
  if (this->ValueType == Type::Boolean)
  {
    if (text == "on" || text == "true" || text == "1")
    {
      return vtkShadowValue{ "on", 1.0 };
    }
    if (text == "off" || text == "false" || text == "0")
    {
      return vtkShadowValue{ "off", 0.0 };
    }
    return std::nullopt;
  }
  if (this->ValueType == Type::Choice)
  {
    const bool known =
      std::find(this->Choices.begin(), this->Choices.end(), text) != this->Choices.end();
    return known ? std::optional(vtkShadowValue{ text, 0.0 }) : std::nullopt;
  }
  const bool whole = this->ValueType == Type::Integer;
  const auto number = vtkShadowNumber::Parse(text);
  if (!number || !(*number >= this->Minimum && *number <= this->Maximum) ||
      (whole && *number != std::trunc(*number)))
  {
    return std::nullopt;
  }
  return vtkShadowValue{ whole ? vtkShadowNumber::Print(*number) : text, *number };
}

//------------------------------------------------------------------------------
std::string vtkShadowParameter::DescribeRange() const
{
  switch (this->ValueType)
  {
    case Type::Boolean:
      return "on or off";
    case Type::Choice:
    {
      std::string text;
      for (const auto& choice : this->Choices)
      {
        text += (text.empty() ? "one of: " : ", ") + choice;
      }
      return text;
    }
    default:
      return (this->ValueType == Type::Integer ? "a whole number from " : "a number from ") +
             vtkShadowNumber::Print(this->Minimum) + " to " + vtkShadowNumber::Print(this->Maximum);
  }
}
