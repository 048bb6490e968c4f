// SPDX-License-Identifier: BSD-3-Clause
// One casting light of one frame, as plain values in double precision: what every technique reads
// instead of the vtkLight, and what tells whether a light changed since its data was built.

#ifndef vtkShadowLight_h
#define vtkShadowLight_h

#include "vtkImageData.h"                // For Emission
#include "vtkSmartPointer.h"             // For Emission
#include "vtkSoftShadowsCastersModule.h" // For export macro
#include "vtkType.h"                     // For vtkMTimeType

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

class vtkLight;
class vtkRenderer;

/**
 * A place on the light: a position for positional lights, a direction towards the light for
 * directional ones, and the share of the light's emission that it stands for (its sum over all
 * samples of a light is 1 in each channel).
 */
struct vtkLightSample
{
  glm::dvec3 Point{ 0.0 };
  glm::dvec3 Weight{ 0.0 };
};

struct VTKSOFTSHADOWSCASTERS_EXPORT vtkShadowLight
{
  enum class Shape
  {
    Point = 0,
    Sphere,
    Disk,
    Rectangle,
    Directional
  };

  vtkLight* Light = nullptr; // whose values these are; not compared
  int Slot = 0;              // N of lightColorN in VTK's shaders: counts switched-on lights only
  Shape Kind = Shape::Point;
  glm::dvec3 Position{ 0.0 };             // world; unused for a directional light
  glm::dvec3 Direction{ 0.0, 0.0, -1.0 }; // unit, from the light to its focal point
  /**
   * Half axes: of the rectangle or disk in world units; of the directional light's disk at distance
   * 1; of the sphere any two perpendicular ones of the radius' length. Zero for a point.
   */
  glm::dvec3 U{ 0.0 };
  glm::dvec3 V{ 0.0 };
  double ConeAngle = 90.0;  // degrees from axis to edge; 90 and more is no cone
  double Attenuation = 1.0; // vtkLight::GetShadowAttenuation() x darkness: 1 is a black shadow
  vtkSmartPointer<vtkImageData> Emission;
  vtkMTimeType EmissionTime = 0;
  /**
   * Where frames add up (parameter accumulate): which of the samples of all of them is this frame's first.
   * -1: this frame stands for itself, and its samples are centred on the light.
   */
  int FirstSample = -1;

  bool IsDirectional() const { return this->Kind == Shape::Directional; }
  /** A light without size: one sample decides, and soft techniques take the hard path. */
  bool IsPoint() const;
  /** False for a light whose position or size is no number: it casts nothing. */
  bool IsFinite() const;
  /** The corners of the emitter (positions), or of the cone of directions towards the light. */
  std::vector<glm::dvec3> GetExtremes() const;
  /**
   * The place on the light that a point of the unit square stands for, area-preserving: the square
   * itself on a rectangle, Shirley and Chiu's concentric map on disks. For a sphere, the disk
   * through its centre that faces the receiver.
   */
  glm::dvec3 Map(const glm::dvec2& unit, const glm::dvec3& receiver) const;
  /**
   * N samples as a receiver sees them, stratified (see vtkShadowSampling), weights summing to 1. From
   * FirstSample on, those of several frames are stratified together.
   */
  std::vector<vtkLightSample> GetSamples(int count, const glm::dvec3& receiver) const;
  /**
   * The same, but a single one that stands for itself is the light's centre: where a light that counts as
   * a point is.
   */
  std::vector<vtkLightSample> GetPlaces(int count, const glm::dvec3& receiver) const;
  /** Some unit vector perpendicular to a unit vector, the same one each time. */
  static glm::dvec3 Perpendicular(const glm::dvec3& axis);
  /** Emission at a point of the unit square, 1 without a texture. */
  glm::dvec3 GetEmission(const glm::dvec2& unit) const;
  /** Whether place, form and emission are the same, and so the samples. */
  bool SameGeometry(const vtkShadowLight& other) const;

  /**
   * A light's place and form, whether it casts or not; see Gather for the defaults. The position of a
   * directional light is what the light has.
   */
  static vtkShadowLight Read(
    vtkLight* light, double defaultRadius = 0.0, double defaultAngle = 0.0);
  /**
   * The lights of a renderer that cast shadows: switched on, neither black nor without shadow
   * attenuation, and casting not switched off (vtkShadowTags::SetLightCasting). Plain positional
   * vtkLights become spheres of the default radius (world units) where it is positive, directional ones
   * disks of the default angle (degrees). Darkness is a factor on the attenuation of lights that no fill
   * answers for (vtkShadowTags::SetFilled).
   */
  static std::vector<vtkShadowLight> Gather(
    vtkRenderer* renderer, double defaultRadius, double defaultAngle = 0.0, double darkness = 1.0);
};

/**
 * What light data is made for: a light as some of the casters hide it. Where translucent casters count
 * by their opacity, a light comes in several parts: each sees the casters of an opacity and more, and
 * stands for a share of the light (see vtkShadowCasters). Else it has one, of all casters.
 */
struct VTKSOFTSHADOWSCASTERS_EXPORT vtkShadowLightPart
{
  vtkShadowLight Light;
  double LeastOpacity = 0.0;
  double Share = 1.0;

  vtkShadowLightPart() = default;
  vtkShadowLightPart(const vtkShadowLight& light, double leastOpacity = 0.0, double share = 1.0)
    : Light(light)
    , LeastOpacity(leastOpacity)
    , Share(share)
  {
  }

  /** Whether it casts the same: then its light data can be reused. */
  bool SameGeometry(const vtkShadowLightPart& other) const
  {
    return this->LeastOpacity == other.LeastOpacity && this->Light.SameGeometry(other.Light);
  }

  /** The parts of lights, given the opacities of casters that count by them, ascending. */
  static std::vector<vtkShadowLightPart> Split(
    const std::vector<vtkShadowLight>& lights, const std::vector<double>& opacities);
};

#endif
