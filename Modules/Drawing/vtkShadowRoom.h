// SPDX-License-Identifier: BSD-3-Clause
// Where what a map has to hold may be divided: the widest room between rectangles along one of two axes.

#ifndef vtkShadowRoom_h
#define vtkShadowRoom_h

#include "vtkSoftShadowsDrawingModule.h" // For export macro

#include <glm/vec2.hpp>

#include <utility>
#include <vector>

struct VTKSOFTSHADOWSDRAWING_EXPORT vtkShadowRoom
{
  double Share = 0.0; // of all that the rectangles take along the axis; 0 where none is wide enough
  int Axis = 0;
  double End = 0.0; // the rectangles that begin before it lie on one side

  /** A rectangle's low and high corner. */
  using Rectangle = std::pair<glm::dvec2, glm::dvec2>;

  /** A quarter of the extent is wide enough, and `least`. Rounding does not choose between two. */
  static vtkShadowRoom Find(const std::vector<Rectangle>& rectangles, double least);
};

#endif
