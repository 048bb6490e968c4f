// SPDX-License-Identifier: BSD-3-Clause
// A tile of a virtual map that pixels ask for.

#ifndef vtkVirtualShadowTile_h
#define vtkVirtualShadowTile_h

#include <glm/vec2.hpp>

#include <array>
#include <cmath>

/** A rectangle of a view's map, [0,1] in x and y, and a map of it. */
struct vtkVirtualShadowTile
{
  int View = 0;
  /** Which one it is: halvings of the map along x and y, and its number among those. */
  std::array<int, 4> Place{};
  glm::dvec2 Low{ 0.0 };
  glm::dvec2 High{ 1.0 };
  glm::ivec2 Size{ 0 }; // texels

  // /@{ Set by whoever draws it: where its map lies, in which turn it is there, and whether it was
  // kept.
  int Batch = 0;
  int Layer = 0;
  glm::ivec2 Corner{ 0 };
  bool Kept = false;
  // /@}

  vtkVirtualShadowTile() = default;
  vtkVirtualShadowTile(int view, const std::array<int, 4>& place, int side)
    : View(view)
    , Place(place)
    , Size(side)
  {
    const glm::dvec2 size(std::ldexp(1.0, -place[0]), std::ldexp(1.0, -place[1]));
    this->Low = size * glm::dvec2(place[2], place[3]);
    this->High = this->Low + size;
  }
};

#endif
