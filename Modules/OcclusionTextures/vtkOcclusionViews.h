// SPDX-License-Identifier: BSD-3-Clause
// How the casters of a light are seen to be sliced: a frame with the light's centre as origin, a centre of
// projection behind it, and a window that hugs the casters.
//
// The depth h of a point is its distance from the light's plane. Seen from the centre of projection, d
// behind the light, a point lies at (x, y) / (d + h); for a directional light at (x, y). A receiver at
// depth D sees the light through a plane at depth h around (x, y) h / D, and as large as the light times
// (D - h) / D: as a share of a texture that is as wide as the light at h = 0, that is
// (D - h) / D d / (d + h), which is equation 4 of the paper. The sun's disk is D - h times what it is at
// distance 1.

#ifndef vtkOcclusionViews_h
#define vtkOcclusionViews_h

#include "vtkShadowLight.h" // For parts of lights

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <vector>

class vtkShadowCasters;

struct vtkOcclusionView
{
  bool Directional = false;
  /** One of six around a light among its casters: it holds what lies within 45 degrees of its axis. */
  bool Face = false;
  /** The light's centre in SWC; the origin for a directional light. */
  glm::dvec3 Place{ 0.0 };
  /** Unit axes; Z leads away from the light. */
  glm::dvec3 X{ 0.0 };
  glm::dvec3 Y{ 0.0 };
  glm::dvec3 Z{ 0.0 };
  /** From the centre of projection to the light: d. */
  double Behind = 0.0;
  /** What has to be held, at w = d + h = 1: without a border. */
  glm::dvec2 Low{ 0.0 };
  glm::dvec2 High{ 0.0 };
  /** Depths that casters have, and the greatest that anything has which receives. */
  double Nearest = 0.0;
  double Farthest = 0.0;
  double Receivers = 0.0;
  /** Half sides of the rectangle that the light is taken for, at its centre. */
  glm::dvec2 Light{ 0.0 };
  /** What it shows: indices of vtkShadowCasters::Get(), ascending. */
  std::vector<int> Casters;

  glm::dvec3 ToView(const glm::dvec3& SWC) const;
  /** Distance from the centre of projection along the axis, or 1. */
  double GetW(double depth) const { return this->Directional ? 1.0 : this->Behind + depth; }
  /** Half sides of the light as the farthest receiver sees it through a plane, at w = 1. */
  glm::dvec2 GetKernel(double depth) const;
  /** Depths that are drawn: a hair more than casters have, so that none is clipped by rounding. */
  glm::dvec2 GetClipRange() const;
  /** To the texture of a window, clip coordinates. */
  glm::dmat4 GetSWCToClip(const glm::dvec2& low, const glm::dvec2& high) const;

  /** One view, up to six around a light among its casters, or none; for textures of a resolution. */
  static std::vector<vtkOcclusionView> Find(
    const vtkShadowLightPart& part, const vtkShadowCasters& casters, int resolution);
};

#endif
