// SPDX-License-Identifier: BSD-3-Clause
// What a pixel sees, as rays start from it, and what they have found.

#ifndef vtkShadowRayReceiver_h
#define vtkShadowRayReceiver_h

#include <glm/vec3.hpp>

/**
 * A receiver in SWC. Its rays start Offset along the normal; where its prop's positions are off by more
 * than that, what they hit within Height above its plane is the surface itself.
 */
struct vtkShadowRayReceiver
{
  glm::dvec3 Position;
  glm::dvec3 Normal;
  double Offset;
  double Height;
  int Pixel;
  bool Casts;
};

/** How far a receiver's rays to a light have come. */
struct vtkShadowRaySeen
{
  int Samples = 0; // traced
  int Clear = 0;   // of them, those that reach the light
  ///@{ Emission of those, and of all that were traced; of a textured light.
  glm::vec3 Emission{ 0.0f };
  glm::vec3 All{ 0.0f };
  ///@}

  /** Add a ray's answer; of a textured light, with its emission. */
  void Add(bool clear, const glm::vec3* emission)
  {
    ++this->Samples;
    this->Clear += clear ? 1 : 0;
    if (emission)
    {
      this->All += *emission;
      this->Emission += clear ? *emission : glm::vec3(0.0f);
    }
  }

  /** Share of the light that is seen; without rays none is. */
  glm::vec3 GetVisibility(bool textured) const
  {
    const float share = this->Samples > 0
                          ? static_cast<float>(this->Clear) / static_cast<float>(this->Samples)
                          : 0.0f;
    glm::vec3 visibility(share);
    for (int c = 0; textured && c < 3; ++c)
    {
      // A channel without emission is decided by the others' geometry.
      visibility[c] = this->All[c] > 0.0f ? this->Emission[c] / this->All[c] : share;
    }
    return visibility;
  }
};

#endif
