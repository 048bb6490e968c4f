// SPDX-License-Identifier: BSD-3-Clause
// Rays in Embree's packets.

#ifndef vtkShadowRayPackets_h
#define vtkShadowRayPackets_h

#include "vtkShadowRayReceiver.h"

#include <embree3/rtcore.h>
#include <glm/vec3.hpp>

#include <cstddef>
#include <vector>

class vtkShadowRayPatterns;
struct vtkShadowLight;

/** What rays are traced of, by several threads. */
struct vtkShadowRayPackets
{
  RTCScene Scene;
  bool Flat; // it has no instances
  const vtkShadowLight& Light;
  const glm::dvec3& Place;  // its centre in SWC, or the direction towards it
  const glm::dvec3& Origin; // of SWC
  const vtkShadowRayPatterns& Patterns;
  const std::vector<vtkShadowRayReceiver>& Receivers;
  std::vector<vtkShadowRaySeen>& Seen;

  /**
   * Trace on until each of some receivers has so many rays, in packets of 1, 4, 8 or 16, or fewer where no
   * more are wanted of one; none from those whose own surface hides the whole light. Gives the rays traced.
   */
  std::size_t Trace(int packet, const int* first, const int* end, int samples) const;

private:
  template <typename Packet>
  std::size_t TraceBy(const int* first, const int* end, int samples) const;
};

#endif
