// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowRayBundle.h"

#include "vtkShadowLight.h"
#include "vtkShadowRayPatterns.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

//------------------------------------------------------------------------------
vtkShadowRayBundle::vtkShadowRayBundle(const vtkShadowLight& light, const glm::dvec3& place,
  const vtkShadowRayReceiver& receiver, const vtkShadowRayPatterns& patterns)
  : Patterns(patterns)
  , Normal(receiver.Normal)
  // Rays rise from the receiver's plane: past Height it is not its own surface that they hit. Moving
  // their start as far along the normal would move the shadow's edge.
  , Height(receiver.Casts ? static_cast<float>(receiver.Height) : 0.0f)
  // A ray of a positional light ends at the light, t = 1.
  , End(light.IsDirectional() ? std::numeric_limits<float>::infinity() : 1.0f)
{
  const std::uint32_t hash = patterns.Hash(receiver.Pixel);
  this->First = patterns.GetFirst(hash);
  const glm::dvec3 start = receiver.Position + receiver.Offset * receiver.Normal;
  glm::dvec3 u = light.U;
  glm::dvec3 v = light.V;
  if (light.Kind == vtkShadowLight::Shape::Sphere)
  {
    // The disk that faces the receiver, as vtkShadowLight::Map has it.
    const glm::dvec3 axis = receiver.Position - place;
    const double distance = glm::length(axis);
    const double radius = distance > 0.0 ? glm::length(light.U) : 0.0;
    const glm::dvec3 along = distance > 0.0 ? axis / distance : glm::dvec3(0.0, 0.0, 1.0);
    const glm::dvec3 across = vtkShadowLight::Perpendicular(along);
    u = radius * across;
    v = radius * glm::cross(along, across);
  }
  if (light.Kind != vtkShadowLight::Shape::Rectangle)
  {
    // Disks are turned besides, so that pixels of the same pattern differ.
    const double angle = glm::two_pi<double>() * (hash >> 8) / 16777216.0;
    const glm::dvec3 turned = std::cos(angle) * u + std::sin(angle) * v;
    v = std::cos(angle) * v - std::sin(angle) * u;
    u = turned;
  }
  this->Start = start;
  this->Centre = light.IsDirectional() ? place : place - start;
  this->U = u;
  this->V = v;
}

//------------------------------------------------------------------------------
vtkShadowRayBundle::Ray vtkShadowRayBundle::GetRay(int sample) const
{
  const std::size_t index = this->First + static_cast<std::size_t>(sample);
  Ray ray{ this->Centre + this->Patterns.GetA()[index] * this->U +
             this->Patterns.GetB()[index] * this->V,
    0.0f, this->End, true };
  if (this->Height > 0.0f)
  {
    const float rise = glm::dot(this->Normal, ray.Direction);
    ray.Near = this->Height / std::max(rise, std::numeric_limits<float>::min());
    ray.Needed = ray.Near < this->End;
    // Its own surface hides what lies below its horizon.
    ray.Far = rise > 0.0f ? this->End : -this->End;
  }
  return ray;
}

//------------------------------------------------------------------------------
const glm::vec3* vtkShadowRayBundle::GetEmission(int sample) const
{
  const auto& emission = this->Patterns.GetEmission();
  return emission.empty() ? nullptr : &emission[this->First + static_cast<std::size_t>(sample)];
}
