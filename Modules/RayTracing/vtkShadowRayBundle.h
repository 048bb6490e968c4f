// SPDX-License-Identifier: BSD-3-Clause
// The rays from one receiver to a light.

#ifndef vtkShadowRayBundle_h
#define vtkShadowRayBundle_h

#include "vtkShadowRayReceiver.h"

#include <glm/vec3.hpp>

#include <cstddef>

class vtkShadowRayPatterns;
struct vtkShadowLight;

class vtkShadowRayBundle
{
public:
  /** `place` is the light's centre in SWC, or the direction towards it. */
  vtkShadowRayBundle(const vtkShadowLight& light, const glm::dvec3& place,
    const vtkShadowRayReceiver& receiver, const vtkShadowRayPatterns& patterns);

  /** The ray of a sample that its own surface does not hide, as Embree takes it. */
  struct Ray
  {
    glm::vec3 Direction;
    float Near;
    float Far; // negative where it is hidden
    bool Needed;
  };
  const glm::vec3& GetStart() const { return this->Start; }
  Ray GetRay(int sample) const;
  /** Emission of a sample of a textured light, else nullptr. */
  const glm::vec3* GetEmission(int sample) const;

private:
  const vtkShadowRayPatterns& Patterns;
  std::size_t First; // of the pattern
  // Half axes as this receiver sees them, and the light's centre relative to where its rays start.
  glm::vec3 Start;
  glm::vec3 Centre;
  glm::vec3 U;
  glm::vec3 V;
  glm::vec3 Normal;
  float Height;
  float End;
};

#endif
