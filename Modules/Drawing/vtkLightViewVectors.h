// SPDX-License-Identifier: BSD-3-Clause
// What shaders know of a view of a light, in vectors: of a receiver in a depth map
// (vtkLightViewFS.glsl), and of the light as that sees it over the map (vtkLightSightFS.glsl).

#ifndef vtkLightViewVectors_h
#define vtkLightViewVectors_h

#include "vtkSoftShadowsDrawingModule.h" // For export macro

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <string>
#include <vector>

struct vtkLightView;
struct vtkShadowFrame;
struct vtkShadowLight;

class VTKSOFTSHADOWSDRAWING_EXPORT vtkLightViewVectors
{
public:
  /** Vectors of a view, and further ones of the light. */
  static constexpr int OfView = 7;
  static constexpr int OfSight = 5;

  /** Of a view's map of so many texels, for the frame's camera; with values for whoever reads them. */
  static void AddView(std::vector<glm::vec4>& vectors, const vtkShadowFrame& frame,
    const vtkShadowLight& light, const vtkLightView& view, double texels, const glm::dvec3& values);
  /**
   * Of the light over it, with a value. Look-ups may be drawn in so far before a border that is cut, as a
   * share of the map; at others they never are.
   */
  static void AddSight(std::vector<glm::vec4>& vectors, const vtkShadowLight& light,
    const vtkLightView& view, double texels, double value, double border);

  /** GLSL of either; it reads SHADOW_VIEW(view, vector). That of sights needs the other. */
  static std::string GetViewGLSL();
  static std::string GetSightGLSL();
};

#endif
