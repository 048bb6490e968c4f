// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowLight.h"

#include "vtkAreaLight.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"
#include "vtkShadowSampling.h"
#include "vtkShadowTags.h"
#include "vtkTexture.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace
{
/** A texture's image; nullptr where it has no texels. */
vtkImageData* GetImage(vtkTexture* texture)
{
  if (texture->GetNumberOfInputConnections(0) == 0)
  {
    return nullptr;
  }
  texture->Update();
  vtkImageData* image = texture->GetInput();
  vtkDataArray* texels = image ? image->GetPointData()->GetScalars() : nullptr;
  const bool whole = texels && texels->GetNumberOfTuples() > 0 &&
                     texels->GetNumberOfTuples() == image->GetNumberOfPoints();
  return whole ? image : nullptr;
}

/** Half axes of an area light, as vtkShadowLight states them. */
void SetArea(vtkShadowLight& light, vtkAreaLight* area)
{
  using Shape = vtkShadowLight::Shape;
  glm::dvec3 up = glm::make_vec3(area->GetUpVector());
  double unit = 1.0;
  if (vtkMatrix4x4* matrix = area->GetTransformMatrix())
  {
    const double in[4] = { up.x, up.y, up.z, 0.0 };
    double out[4];
    matrix->MultiplyPoint(in, out);
    up = glm::make_vec3(out);
    // Such a light's coordinates are not the world's: a camera light's are its camera's distance.
    unit = std::cbrt(std::abs(matrix->Determinant()));
  }
  glm::dvec3 width = glm::cross(light.Direction, up);
  width = glm::length(width) > 1e-12 * glm::length(up)
            ? glm::normalize(width)
            : vtkShadowLight::Perpendicular(light.Direction);
  const glm::dvec3 height = glm::cross(width, light.Direction);
  glm::dvec2 half(area->GetRadius());
  if (light.IsDirectional())
  {
    half = glm::dvec2(std::tan(glm::radians(0.5 * area->GetAngularDiameter())));
  }
  else
  {
    static constexpr Shape shapes[] = { Shape::Point, Shape::Sphere, Shape::Disk,
      Shape::Rectangle };
    light.Kind = shapes[area->GetShape()];
    if (light.Kind == Shape::Rectangle)
    {
      half = 0.5 * glm::dvec2(area->GetWidth(), area->GetHeight());
    }
    else if (light.Kind == Shape::Point)
    {
      half = glm::dvec2(0.0);
    }
    half *= unit;
  }
  light.U = half.x * width;
  light.V = half.y * height;
  if (light.Kind == Shape::Rectangle && area->GetTexture())
  {
    light.Emission = GetImage(area->GetTexture());
    light.EmissionTime = light.Emission ? light.Emission->GetMTime() : 0;
  }
}
}

//------------------------------------------------------------------------------
glm::dvec3 vtkShadowLight::Perpendicular(const glm::dvec3& axis)
{
  const glm::dvec3 a = glm::abs(axis);
  const glm::dvec3 least = a.x <= a.y && a.x <= a.z
                             ? glm::dvec3(1.0, 0.0, 0.0)
                             : (a.y <= a.z ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0));
  return glm::normalize(glm::cross(axis, least));
}

//------------------------------------------------------------------------------
vtkShadowLight vtkShadowLight::Read(vtkLight* source, double defaultRadius, double defaultAngle)
{
  vtkShadowLight light;
  light.Light = source;
  light.Position = glm::make_vec3(source->GetTransformedPosition());
  const glm::dvec3 toFocus = glm::make_vec3(source->GetTransformedFocalPoint()) - light.Position;
  light.Direction = glm::length(toFocus) > 0.0 ? glm::normalize(toFocus) : light.Direction;
  light.Kind = source->GetPositional() ? Shape::Point : Shape::Directional;
  light.ConeAngle = light.IsDirectional() ? 90.0 : std::min(source->GetConeAngle(), 90.0);
  if (auto* area = vtkAreaLight::SafeDownCast(source))
  {
    SetArea(light, area);
  }
  else
  {
    const double half =
      light.IsDirectional() ? std::tan(glm::radians(0.5 * defaultAngle)) : defaultRadius;
    light.Kind = half > 0.0 && !light.IsDirectional() ? Shape::Sphere : light.Kind;
    light.U = half * Perpendicular(light.Direction);
    light.V = glm::cross(light.Direction, light.U);
  }
  return light;
}

//------------------------------------------------------------------------------
std::vector<vtkShadowLight> vtkShadowLight::Gather(
  vtkRenderer* renderer, double defaultRadius, double defaultAngle, double darkness)
{
  std::vector<vtkShadowLight> result;
  int slot = 0;
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator cookie;
  lights->InitTraversal(cookie);
  while (vtkLight* source = lights->GetNextLight(cookie))
  {
    if (!source->GetSwitch())
    {
      continue;
    }
    const int ofShader = slot++;
    const double attenuation =
      source->GetShadowAttenuation() * (vtkShadowTags::GetFilled(source) ? 1.0 : darkness);
    const double* color = source->GetDiffuseColor();
    const bool black =
      source->GetIntensity() <= 0.0 || (color[0] <= 0.0 && color[1] <= 0.0 && color[2] <= 0.0);
    if (black || !(attenuation > 0.0) || !vtkShadowTags::GetLightCasting(source))
    {
      continue;
    }
    vtkShadowLight light = Read(source, defaultRadius, defaultAngle);
    light.Slot = ofShader;
    light.Attenuation = attenuation;
    if (light.IsDirectional())
    {
      light.Position = glm::dvec3(0.0); // so that moving both points changes nothing
    }
    result.push_back(light);
  }
  return result;
}

//------------------------------------------------------------------------------
bool vtkShadowLight::IsPoint() const
{
  return this->U == glm::dvec3(0.0) && this->V == glm::dvec3(0.0);
}

//------------------------------------------------------------------------------
bool vtkShadowLight::IsFinite() const
{
  const auto finite = [](const glm::dvec3& v)
  { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
  return finite(this->Position) && finite(this->Direction) && finite(this->U) && finite(this->V);
}

//------------------------------------------------------------------------------
std::vector<glm::dvec3> vtkShadowLight::GetExtremes() const
{
  const glm::dvec3 centre = this->IsDirectional() ? -this->Direction : this->Position;
  if (this->IsPoint())
  {
    return { centre };
  }
  std::vector<glm::dvec3> corners;
  for (const double u : { -1.0, 1.0 })
  {
    for (const double v : { -1.0, 1.0 })
    {
      corners.push_back(centre + u * this->U + v * this->V);
    }
  }
  if (this->Kind == Shape::Sphere)
  {
    const glm::dvec3 w = this->Direction * glm::length(this->U);
    const auto square = corners;
    corners.clear();
    for (const auto& corner : square)
    {
      corners.push_back(corner - w);
      corners.push_back(corner + w);
    }
  }
  return corners;
}

//------------------------------------------------------------------------------
glm::dvec3 vtkShadowLight::Map(const glm::dvec2& unit, const glm::dvec3& receiver) const
{
  switch (this->Kind)
  {
    case Shape::Point:
      return this->Position;
    case Shape::Rectangle:
    {
      const glm::dvec2 p = 2.0 * unit - 1.0;
      return this->Position + p.x * this->U + p.y * this->V;
    }
    case Shape::Disk:
    {
      const glm::dvec2 p = vtkShadowSampling::ConcentricDisk(unit);
      return this->Position + p.x * this->U + p.y * this->V;
    }
    case Shape::Directional:
    {
      const glm::dvec2 p = vtkShadowSampling::ConcentricDisk(unit);
      return glm::normalize(-this->Direction + p.x * this->U + p.y * this->V);
    }
    default:
    {
      const glm::dvec2 p = vtkShadowSampling::ConcentricDisk(unit);
      const glm::dvec3 axis = receiver - this->Position;
      const double distance = glm::length(axis);
      if (!(distance > 0.0))
      {
        return this->Position;
      }
      const glm::dvec3 u = Perpendicular(axis / distance);
      const glm::dvec3 v = glm::cross(axis / distance, u);
      return this->Position + glm::length(this->U) * (p.x * u + p.y * v);
    }
  }
}

//------------------------------------------------------------------------------
glm::dvec3 vtkShadowLight::GetEmission(const glm::dvec2& unit) const
{
  if (!this->Emission)
  {
    return glm::dvec3(1.0);
  }
  // Bilinear between texel centres, clamped at the border.
  int size[3];
  this->Emission->GetDimensions(size);
  const int* extent = this->Emission->GetExtent();
  const int components = this->Emission->GetNumberOfScalarComponents();
  const double full = this->Emission->GetScalarType() == VTK_UNSIGNED_CHAR ? 255.0 : 1.0;
  const glm::dvec2 p = glm::clamp(unit * glm::dvec2(size[0], size[1]) - 0.5, glm::dvec2(0.0),
    glm::dvec2(size[0] - 1, size[1] - 1));
  const glm::ivec2 low(p);
  const glm::ivec2 high = glm::min(low + 1, glm::ivec2(size[0] - 1, size[1] - 1));
  const glm::dvec2 t = p - glm::dvec2(low);
  glm::dvec3 result(0.0);
  for (int c = 0; c < 3; ++c)
  {
    const int channel = components >= 3 ? c : 0;
    const auto at = [&](int x, int y)
    {
      const double value = this->Emission->GetScalarComponentAsDouble(
        extent[0] + x, extent[2] + y, extent[4], channel);
      return std::isfinite(value) ? std::max(0.0, value / full) : 0.0;
    };
    result[c] = glm::mix(glm::mix(at(low.x, low.y), at(high.x, low.y), t.x),
      glm::mix(at(low.x, high.y), at(high.x, high.y), t.x), t.y);
  }
  return result;
}

//------------------------------------------------------------------------------
std::vector<vtkLightSample> vtkShadowLight::GetSamples(int count, const glm::dvec3& receiver) const
{
  if (this->IsPoint())
  {
    const glm::dvec3 point = this->IsDirectional() ? -this->Direction : this->Position;
    return { { point, glm::dvec3(1.0) } };
  }
  std::vector<vtkLightSample> samples;
  samples.reserve(count);
  glm::dvec3 sum(0.0);
  const bool alone = this->FirstSample < 0;
  for (auto bits : vtkShadowSampling::Sobol(count, std::max(0, this->FirstSample)))
  {
    // The first points of the plain sequence sit on the cells' lower corners; moving all by half a
    // stratum centres the whole set on the light, or small counts would be biased. Of how many they
    // are in the end is not known where frames add up: there bits are turned so that however many points
    // lie a third of a stratum from its middle, on either side in turn.
    if (!alone)
    {
      bits.X ^= 0xaaaaaaaau;
      bits.Y ^= 0xaaaaaaaau;
    }
    glm::dvec2 unit = vtkShadowSampling::ToUnit(bits) + (alone ? 0.5 / count : 0.0);
    unit -= glm::floor(unit);
    samples.push_back({ this->Map(unit, receiver), this->GetEmission(unit) });
    sum += samples.back().Weight;
  }
  for (auto& sample : samples)
  {
    for (int c = 0; c < 3; ++c)
    {
      // A channel without emission is decided by the others' geometry: all samples count alike.
      sample.Weight[c] = sum[c] > 0.0 ? sample.Weight[c] / sum[c] : 1.0 / count;
    }
  }
  return samples;
}

//------------------------------------------------------------------------------
std::vector<vtkLightSample> vtkShadowLight::GetPlaces(int count, const glm::dvec3& receiver) const
{
  if (count > 1 || this->FirstSample >= 0)
  {
    return this->GetSamples(count, receiver);
  }
  return { { this->IsDirectional() ? -this->Direction : this->Position, glm::dvec3(1.0) } };
}

//------------------------------------------------------------------------------
bool vtkShadowLight::SameGeometry(const vtkShadowLight& other) const
{
  return std::tie(this->Kind, this->Position, this->Direction, this->U, this->V, this->ConeAngle,
           this->Emission, this->EmissionTime, this->FirstSample) ==
         std::tie(other.Kind, other.Position, other.Direction, other.U, other.V, other.ConeAngle,
           other.Emission, other.EmissionTime, other.FirstSample);
}

//------------------------------------------------------------------------------
std::vector<vtkShadowLightPart> vtkShadowLightPart::Split(
  const std::vector<vtkShadowLight>& lights, const std::vector<double>& opacities)
{
  std::vector<vtkShadowLightPart> parts;
  for (const auto& light : lights)
  {
    double before = 0.0;
    for (const double opacity : opacities)
    {
      parts.emplace_back(light, opacity, opacity - before);
      before = opacity;
    }
    parts.emplace_back(light, 1.0, 1.0 - before); // only opaque ones hide it
  }
  return parts;
}
