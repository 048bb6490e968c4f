// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLightViewVectors.h"

#include "vtkLightFrusta.h"
#include "vtkLightSightFS.h"
#include "vtkLightViewFS.h"
#include "vtkShadowFrame.h"
#include "vtkShadowLight.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

namespace
{
/** Rounding of a 32-bit depth in the rasterizer, as a share of the map's depth range. */
constexpr double DepthRounding = 1.0 / 1048576.0;
}

//------------------------------------------------------------------------------
void vtkLightViewVectors::AddView(std::vector<glm::vec4>& vectors, const vtkShadowFrame& frame,
  const vtkShadowLight& light, const vtkLightView& view, double texels, const glm::dvec3& values)
{
  const glm::dmat4 toUnit =
    glm::scale(glm::translate(glm::dmat4(1.0), glm::dvec3(0.5)), glm::dvec3(0.5));
  const glm::dmat4 SWCToVC = frame.GetSWCToVC();
  const glm::dmat3 turn(SWCToVC);
  glm::dmat4 rows = glm::transpose(toUnit * view.SWCToClip * frame.VCToSWC);
  rows[2] -= DepthRounding * rows[3];
  for (int r = 0; r < 4; ++r)
  {
    vectors.emplace_back(rows[r]);
  }
  const glm::dvec4 place = SWCToVC * glm::dvec4(view.Place, light.IsDirectional() ? 0.0 : 1.0);
  const double texel = view.DepthScale / texels;
  vectors.emplace_back(glm::dvec4(turn * view.WindowX * texel, place.x));
  vectors.emplace_back(glm::dvec4(turn * view.WindowY * texel, place.y));
  vectors.emplace_back(glm::dvec4(values, place.z));
}

//------------------------------------------------------------------------------
void vtkLightViewVectors::AddSight(std::vector<glm::vec4>& vectors, const vtkShadowLight& light,
  const vtkLightView& view, double texels, double value, double border)
{
  const glm::dvec2 window(glm::length(view.WindowX), glm::length(view.WindowY));
  const glm::dvec3 x = view.WindowX / window.x;
  const glm::dvec3 y = view.WindowY / window.y;
  const bool sphere = light.Kind == vtkShadowLight::Shape::Sphere;
  // A sphere's axes are those of the view; the shader projects them for each receiver.
  const double radius = glm::length(light.U);
  const glm::dvec3 u = sphere ? radius * x : light.U;
  const glm::dvec3 v = sphere ? radius * y : light.V;
  const glm::dvec2 scale = 1.0 / (window * view.DepthScale);
  vectors.emplace_back(glm::dvec4(glm::dot(u, x), glm::dot(u, y), glm::dot(v, x), glm::dot(v, y)) *
                       glm::dvec4(scale, scale));
  vectors.emplace_back(glm::dvec4(view.DepthScale, window, 0.0));
  vectors.emplace_back(
    glm::dvec4(view.Face ? 1 : 0, sphere ? 1 : 0, value, texels / view.DepthScale));
  const glm::dvec3 z = glm::cross(x, y); // along the axis: windows are right-handed with it
  vectors.emplace_back(glm::dvec4(glm::dot(u, z), glm::dot(v, z), sphere ? radius : 0.0, 0.0));
  const auto& cut = view.Cut;
  vectors.emplace_back(glm::dvec4(cut[0] ? border : -1e6, cut[1] ? border : -1e6,
    cut[2] ? 1.0 - border : 1e6, cut[3] ? 1.0 - border : 1e6));
}

//------------------------------------------------------------------------------
std::string vtkLightViewVectors::GetViewGLSL()
{
  return vtkLightViewFS;
}

//------------------------------------------------------------------------------
std::string vtkLightViewVectors::GetSightGLSL()
{
  return vtkLightSightFS;
}
