// SPDX-License-Identifier: BSD-3-Clause
// One plane's shadow from one part of a light: what falls onto it, where, and by which projection.

#ifndef vtkPlanarShadow_h
#define vtkPlanarShadow_h

#include "vtkShadowLight.h"                    // For samples
#include "vtkShadowPlanes.h"                   // For the plane
#include "vtkSoftShadowsPlanarShadowsModule.h" // For export macro

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

class vtkShadowCasters;

struct VTKSOFTSHADOWSPLANARSHADOWS_EXPORT vtkPlanarShadow
{
  vtkShadowLightPart LightPart;
  vtkShadowPlane Plane;
  double Side = 1.0; // 1: of light above the plane, where its normal points; -1: below
  /** What of the light's emission is on this side, and where: points in SWC, or directions. */
  std::vector<vtkLightSample> Samples;
  glm::dvec3 Weight{ 0.0 };
  /** Those between light and plane whose shadow meets a receiver. None: there is no shadow. */
  std::vector<int> Casters;
  /** What of the plane is to be kept. */
  vtkPlaneRectangle Window;
  /** The most that a caster lifts a penumbra: see GetSpread(). */
  double Spread = 0.0;

  vtkPlanarShadow(const vtkShadowLightPart& part, const vtkShadowPlane& plane, double side);

  /** Find casters and window. `around`: as far as penumbrae of all of the light's size reach. */
  void Find(const vtkShadowCasters& casters, bool around);

  /**
   * This shadow, or up to `most`, a power of two, of casters whose shadows lie far apart: each then has
   * a window of its own, which nothing that moves in another one touches.
   */
  std::vector<vtkPlanarShadow> Divide(int most) const;

  /** (Normal, -Distance), turned to the light's side. */
  glm::dvec4 GetEquation() const;
  /** A light's sample, homogeneous; and its height above the plane, a cosine for directions. */
  glm::dvec4 GetPlace(const vtkLightSample& sample) const;
  double GetHeight(const glm::dvec4& place) const;
  /** Equation 2.3 of the thesis, of column vectors, over the light's height: w is 1 on the plane. */
  glm::dmat4 GetProjection(const glm::dvec4& place) const;
  /** From SWC to clip coordinates of the window, of what lies on the plane; z is 0. */
  glm::dmat4 GetWindow() const;
  /** The window's middle, in SWC. */
  glm::dvec3 GetMiddle() const;
  /**
   * How far the shadow of something at a height moves, as a share of what the light's point moves
   * along the plane: h / (H - h); for directions h / H.
   */
  double GetSpread(const glm::dvec4& place, double height) const;

  /** All that its image depends on but the casters' shapes. */
  bool Same(const vtkPlanarShadow& other) const;

private:
  /** What one caster darkens. */
  struct Part
  {
    int Caster;
    vtkPlaneRectangle Window;
    double Spread;
  };
  void SetParts(std::vector<Part> parts);

  std::vector<Part> Parts;
};

#endif
