// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowAdvice.h"

#include "vtkAreaLight.h"
#include "vtkShadowCasters.h"
#include "vtkShadowDeclaration.h"
#include "vtkShadowFrame.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <numeric>
#include <vector>

namespace
{
struct Box
{
  glm::dvec3 Low{ std::numeric_limits<double>::max() };
  glm::dvec3 High{ std::numeric_limits<double>::lowest() };

  explicit Box(const vtkShadowCaster& caster)
  {
    for (const auto& corner : caster.Corners)
    {
      this->Low = glm::min(this->Low, corner);
      this->High = glm::max(this->High, corner);
    }
  }
  bool Holds(const glm::dvec3& point) const
  {
    return glm::all(glm::lessThan(this->Low, point)) && glm::all(glm::lessThan(point, this->High));
  }
};

std::string Print(double number)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.3g", number);
  return text;
}

std::string Print(const glm::dvec3& place)
{
  return "(" + Print(place.x) + ", " + Print(place.y) + ", " + Print(place.z) + ")";
}

bool IsHeadlight(const vtkShadowLight& light)
{
  return light.Light->LightTypeIsHeadlight();
}

/** A light that nobody has given a size, nor none. */
bool IsPlain(const vtkShadowLight& light)
{
  return !vtkAreaLight::SafeDownCast(light.Light);
}

/** Within what casts, but for what is around all of it: a room or a sky. */
bool IsInside(const glm::dvec3& place, const vtkShadowFrame& frame)
{
  std::vector<Box> boxes;
  for (const auto& caster : frame.Casters->Get())
  {
    boxes.emplace_back(caster);
  }
  const auto isRoom = [&](const Box& box)
  {
    return std::all_of(boxes.begin(), boxes.end(),
      [&](const Box& other)
      {
        const glm::dvec3 slack = 1e-3 * (box.High - box.Low);
        return glm::all(glm::lessThanEqual(box.Low - slack, other.Low)) &&
               glm::all(glm::lessThanEqual(other.High, box.High + slack));
      });
  };
  return std::any_of(
    boxes.begin(), boxes.end(), [&](const Box& box) { return box.Holds(place) && !isRoom(box); });
}
}

//------------------------------------------------------------------------------
std::string vtkShadowAdvice::Find(
  const vtkShadowFrame& frame, const vtkShadowDeclaration& declaration)
{
  const auto& lights = frame.Lights;
  const std::string studio =
    "vtkShadowStudio (in Python enable(renderer, lights=\"studio\")) puts good light in its place";
  if (std::all_of(lights.begin(), lights.end(), IsHeadlight))
  {
    return "the only light shines from the camera, so that its shadows hide behind what casts "
           "them; " +
           studio + ".";
  }
  if (!declaration.Traits.Hard &&
      std::all_of(lights.begin(), lights.end(),
        [](const vtkShadowLight& light) { return light.IsPoint() && IsPlain(light); }))
  {
    return "no light has a size, so that shadows are hard: set DefaultLightAngle for directional "
           "lights "
           "or DefaultLightRadius for positional ones (in Python enable(renderer, angle=10, "
           "radius=0.5)), or take vtkAreaLights; " +
           studio + ".";
  }
  const double size = frame.Casters->GetSize();
  std::vector<int> all(frame.Casters->Get().size());
  std::iota(all.begin(), all.end(), 0);
  const glm::dvec3 middle = frame.Casters->GetMiddle(all) + frame.Casters->GetOrigin();
  for (const auto& light : lights)
  {
    if (light.IsDirectional())
    {
      continue;
    }
    if (IsInside(light.Position - frame.Casters->GetOrigin(), frame))
    {
      return "the light at " + Print(light.Position) +
             " lies inside the scene; vtkAreaLight::FitTo(bounds) places one outside.";
    }
    // Of one far away it is the angle that counts: the sun is large, and is seen as small.
    const double diameter = 2.0 * std::max(glm::length(light.U), glm::length(light.V));
    const double distance = glm::length(light.Position - middle);
    const bool large = diameter > std::max(size, distance);
    if (!light.IsPoint() && !declaration.Traits.Hard &&
        (large || diameter < 1e-3 * std::min(size, distance)))
    {
      return "the light at " + Print(light.Position) + " is " + Print(diameter) + " large, " +
             (large ? "more than the whole scene" : "less than a thousandth of the scene") +
             ", which is " + Print(size) + "; vtkAreaLight::FitTo(bounds) gives it a fitting size.";
    }
  }
  return "";
}

//------------------------------------------------------------------------------
std::string vtkShadowAdvice::FindBroken(const vtkShadowFrame& frame)
{
  const auto counted = [&](const char* name)
  {
    const auto count = frame.Counts.find(name);
    return count != frame.Counts.end() && count->second > 0.0;
  };
  if (counted("lightsTooLarge"))
  {
    return "a light is seen by what casts under more than 28 degrees, too large for shadows "
           "that are found from its centre: \"map-soft\" is right there.";
  }
  if (counted("lightsWithLayers"))
  {
    return "many things that cast lie behind each other as a light sees them, and a filter of one "
           "map knows the nearest alone: \"map-soft\" is right there, and \"map-trace\" nearer "
           "where lights move.";
  }
  return "";
}
