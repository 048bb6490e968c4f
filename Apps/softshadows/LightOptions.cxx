// SPDX-License-Identifier: BSD-3-Clause
// The options of the light: their part of SceneOptions.

#include "Errors.h"
#include "SceneOptions.h"
#include "Values.h"

#include "vtkAreaLight.h"
#include "vtkMath.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace
{
const char* const Shapes[] = { "point", "sphere", "disk", "rectangle", "directional" };

void CheckLength(const char* name, const std::optional<double>& value)
{
  if (value && !(*value >= 0.0 && *value <= VTK_FLOAT_MAX)) // false for NaN, too
  {
    throw Failure(std::string(name) + " must be zero or more, and finite.");
  }
}

/** One --light. */
LightOptions Parse(const std::string& text)
{
  const auto refuse = [&text](const std::string& why)
  { throw CLI::ValidationError("--light", "\"" + text + "\": " + why); };
  LightOptions light;
  const auto words = Values::Split(text, ':');
  light.Shape = words.front();
  const std::map<std::string, std::optional<double>*> numbers = { { "radius", &light.Radius },
    { "width", &light.Width }, { "height", &light.Height }, { "angle", &light.Angle },
    { "intensity", &light.Intensity } };
  const std::map<std::string, std::optional<std::array<double, 3>>*> triples = {
    { "position", &light.Position }, { "target", &light.Target }, { "color", &light.Color }
  };
  for (std::size_t i = 1; i < words.size(); ++i)
  {
    const std::size_t equals = words[i].find('=');
    const std::string name = words[i].substr(0, equals);
    const std::string value = equals == std::string::npos ? "" : words[i].substr(equals + 1);
    if (const auto number = numbers.find(name); number != numbers.end())
    {
      double read = 0.0;
      if (!Values::ParseNumber(value, read))
      {
        refuse(name + " is a number.");
      }
      *number->second = read;
    }
    else if (const auto triple = triples.find(name); triple != triples.end())
    {
      *triple->second = Values::ParseTriple(value);
      if (!*triple->second)
      {
        refuse(name + " is three numbers such as 1,2.5,-3.");
      }
    }
    else
    {
      refuse("unknown '" + name +
             "'. Known: radius, width, height, angle, position, target, color, intensity.");
    }
  }
  return light;
}

double GetDistance(vtkAreaLight* light)
{
  return std::sqrt(vtkMath::Distance2BetweenPoints(light->GetPosition(), light->GetFocalPoint()));
}

//------------------------------------------------------------------------------
// Area that a receiver at the focal point sees.
double GetArea(vtkAreaLight* light)
{
  const std::string shape = GetShapeName(light);
  if (shape == "rectangle")
  {
    return light->GetWidth() * light->GetHeight();
  }
  const double radius = shape == "point" ? 0.0
                        : shape == "directional"
                          ? GetDistance(light) * std::tan(vtkMath::RadiansFromDegrees(
                                                   0.5 * light->GetAngularDiameter()))
                          : light->GetRadius();
  return vtkMath::Pi() * radius * radius;
}

//------------------------------------------------------------------------------
void SetShape(vtkAreaLight* light, const std::string& shape)
{
  const double area = GetArea(light);
  const double radius = std::sqrt(area / vtkMath::Pi());
  light->SetPositional(shape != "directional");
  if (shape == "point")
  {
    light->SetShapeToPoint();
  }
  else if (shape == "rectangle")
  {
    light->SetShapeToRectangle();
    light->SetWidth(std::sqrt(area));
    light->SetHeight(std::sqrt(area));
  }
  else if (shape == "directional")
  {
    const double distance = GetDistance(light);
    light->SetAngularDiameter(
      distance > 0.0 ? 2.0 * vtkMath::DegreesFromRadians(std::atan(radius / distance)) : 0.0);
  }
  else
  {
    light->SetShape(shape == "disk" ? vtkAreaLight::Disk : vtkAreaLight::Sphere);
    light->SetRadius(radius);
  }
}
}

//------------------------------------------------------------------------------
std::string GetShapeName(vtkAreaLight* light)
{
  // The enumeration's order is that of the names.
  return light->GetPositional() ? Shapes[light->GetShape()] : "directional";
}

//------------------------------------------------------------------------------
nlohmann::ordered_json DescribeLight(vtkAreaLight* light)
{
  const std::string shape = GetShapeName(light);
  nlohmann::ordered_json json = { { "shape", shape } };
  if (shape == "sphere" || shape == "disk")
  {
    json["radius"] = light->GetRadius();
  }
  else if (shape == "rectangle")
  {
    json["width"] = light->GetWidth();
    json["height"] = light->GetHeight();
  }
  else if (shape == "directional")
  {
    json["angle_degrees"] = light->GetAngularDiameter();
  }
  const double* position = light->GetPosition();
  const double* target = light->GetFocalPoint();
  json["position"] = { position[0], position[1], position[2] };
  json["target"] = { target[0], target[1], target[2] };
  return json;
}

//------------------------------------------------------------------------------
void LightOptions::Declare(CLI::App& command)
{
  const auto number = [&](const char* name, std::optional<double>& value, const char* meaning)
  { command.add_option(name, value, meaning)->type_name("X")->group("Light"); };
  command.add_option("--light-shape", this->Shape, "point, sphere, disk, rectangle or directional")
    ->type_name("SHAPE")
    ->group("Light");
  number("--light-radius", this->Radius, "Of a sphere or disk, in units of the scene");
  number("--light-width", this->Width, "Of a rectangle");
  number("--light-height", this->Height, "Of a rectangle");
  number(
    "--light-angle", this->Angle, "Diameter of a directional light, in degrees (the sun: 0.53)");
  Values::AddTriple(command, "--light-position", this->Position, "X,Y,Z", "Where the light is")
    ->group("Light");
  Values::AddTriple(command, "--light-target", this->Target, "X,Y,Z",
    "What it faces; of a directional light the way")
    ->group("Light");
}

//------------------------------------------------------------------------------
void LightOptions::DeclareMany(CLI::App& command, std::vector<LightOptions>& lights)
{
  const auto parse = [&lights](const std::vector<std::string>& texts)
  {
    for (const std::string& text : texts)
    {
      lights.push_back(Parse(text));
    }
  };
  command
    .add_option_function<std::vector<std::string>>("--light", parse,
      "A light in the place of the scene's; may be given again. Its shape, then what of radius=,\n"
      "width=, height=, angle=, position=, target=, color=, intensity= is not as the scene's "
      "light\n"
      "has it: sphere:radius=0.2:position=1,2,3. Errors and visibility are of the first")
    ->type_name("SHAPE[:NAME=VALUE]...")
    ->allow_extra_args(false)
    ->group("Light");
}

//------------------------------------------------------------------------------
void LightOptions::Check() const
{
  if (!this->Shape.empty() &&
      std::find(std::begin(Shapes), std::end(Shapes), this->Shape) == std::end(Shapes))
  {
    throw Failure("unknown light shape '" + this->Shape +
                  "'. Known: point, sphere, disk, rectangle, directional.");
  }
  CheckLength("--light-radius", this->Radius);
  CheckLength("--light-width", this->Width);
  CheckLength("--light-height", this->Height);
  if (this->Angle && !(*this->Angle >= 0.0 && *this->Angle <= 90.0))
  {
    throw Failure("--light-angle is from 0 to 90 degrees.");
  }
  CheckLength("--light: intensity", this->Intensity);
  if (this->Color && std::any_of(this->Color->begin(), this->Color->end(),
                       [](double value) { return value < 0.0 || value > 1.0; }))
  {
    throw Failure("--light: color is three numbers from 0 to 1.");
  }
}

//------------------------------------------------------------------------------
bool LightOptions::IsAny() const
{
  return !this->Shape.empty() || this->Radius || this->Width || this->Height || this->Angle ||
         this->Position || this->Target;
}

//------------------------------------------------------------------------------
void LightOptions::Apply(vtkAreaLight* light) const
{
  if (!this->Shape.empty() && this->Shape != GetShapeName(light))
  {
    SetShape(light, this->Shape);
  }
  const std::string shape = GetShapeName(light);
  const auto refuse = [&](bool given, const char* option, bool fits)
  {
    if (given && !fits)
    {
      throw WrongUsage(
        std::string(option) + ": the light is a " + shape + " light. See --light-shape.");
    }
  };
  refuse(this->Radius.has_value(), "--light-radius", shape == "sphere" || shape == "disk");
  refuse(this->Width.has_value(), "--light-width", shape == "rectangle");
  refuse(this->Height.has_value(), "--light-height", shape == "rectangle");
  refuse(this->Angle.has_value(), "--light-angle", shape == "directional");

  if (this->Color)
  {
    light->SetColor(this->Color->data());
  }
  light->SetIntensity(this->Intensity.value_or(light->GetIntensity()));
  light->SetRadius(this->Radius.value_or(light->GetRadius()));
  light->SetWidth(this->Width.value_or(light->GetWidth()));
  light->SetHeight(this->Height.value_or(light->GetHeight()));
  light->SetAngularDiameter(this->Angle.value_or(light->GetAngularDiameter()));
  if (this->Position)
  {
    light->SetPosition(this->Position->data());
  }
  if (this->Target)
  {
    light->SetFocalPoint(this->Target->data());
  }
  if (shape != "point" && shape != "sphere" && !(GetDistance(light) > 0.0))
  {
    throw WrongUsage("a " + shape + " light needs a direction: it is placed on its target.");
  }
  const bool flat = shape == "rectangle" && light->GetWidth() + light->GetHeight() > 0.0;
  if (shape != "point" && !flat && GetArea(light) == 0.0)
  {
    Messages::Note("the light has no size: its shadows are hard.");
  }
  else if (flat && GetArea(light) == 0.0)
  {
    Messages::Note("the light has no area: it is a line, soft in one direction only.");
  }
}
