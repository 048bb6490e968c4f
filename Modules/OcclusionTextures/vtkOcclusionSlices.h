// SPDX-License-Identifier: BSD-3-Clause
// Where the casters of a view are cut into slices.
//
// A histogram of the casters' depths, by the area of their triangles, tells where there are any at all:
// slices without are left out, and each reaches no farther than what it holds, so that its plane, onto which
// that is projected, lies at its lower end.

#ifndef vtkOcclusionSlices_h
#define vtkOcclusionSlices_h

#include <glm/vec2.hpp>

#include <vector>

class vtkShadowCasters;
struct vtkOcclusionView;

struct vtkOcclusionSlice
{
  /** Depths between which it holds something; what it holds is projected onto the plane. */
  double Top = 0.0;
  double Plane = 0.0;
  /** It counts for a receiver this far below the plane and farther, and less above. */
  double Fade = 0.0;
  /** Where what it holds is seen, at w = 1. */
  glm::dvec2 Low{ 0.0 };
  glm::dvec2 High{ 0.0 };

  enum class Placement
  {
    Uniform, // of equal depth
    Adaptive // thinner where there is much, and near to what receives
  };
  /** At most so many, the nearest to the light first; none without casters in the view. */
  static std::vector<vtkOcclusionSlice> Place(
    const vtkOcclusionView& view, const vtkShadowCasters& casters, int count, Placement placement);
};

#endif
