// SPDX-License-Identifier: BSD-3-Clause
// Penumbra wedges: what is known of an edge that a caster ends at as a light of some size sees it,
// and the bound of the space in which that edge hides a part of the light.
//
// A point p sees an edge before the light where p lies on a line from the light through the edge,
// beyond it. All such points are v + t (v - L), for v on the edge, L on the light and t >= 0. They
// are held by the hull of the edge's ends and of the directions from the light's corners through
// them: a cone in homogeneous coordinates. Its facets stand on neighbours of the hull of
// directions, each at the end that it leaves all else behind; where that changes from one end to
// the other, a facet holds the edge.
//
// Outside of the true wedge the edge hides nothing, so that a bound may be loose. Where there is
// none (the light is touched by the edge) it is the whole picture.

#ifndef vtkShadowWedges_h
#define vtkShadowWedges_h

#include "vtkShadowLight.h"                    // For shapes
#include "vtkSoftShadowsShadowVolumesModule.h" // For export macro

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

/** A light, or a part of its area, in SWC. */
struct VTKSOFTSHADOWSSHADOWVOLUMES_EXPORT vtkShadowWedgeLight
{
  vtkShadowLight::Shape Kind = vtkShadowLight::Shape::Rectangle;
  glm::dvec4 Place{ 0.0 }; // its centre, w 1; or the direction to it, w 0
  glm::dvec3 U{ 0.0 };     // half axes
  glm::dvec3 V{ 0.0 };

  /** How far it reaches from its centre along a unit vector. */
  double GetReach(const glm::dvec3& along) const;
};

/** A directed edge that casters end at, in SWC. */
struct VTKSOFTSHADOWSSHADOWVOLUMES_EXPORT vtkShadowWedgeEdge
{
  glm::dvec3 Ends[2];
  /** Through the light's centre and the edge, of unit normal; positive where the caster is. */
  glm::dvec4 Plane{ 0.0 };
  /**
   * Behind the edge, half the width of its penumbra, across the plane, as a linear function of places;
   * negative before it. 0 where there is no plane.
   */
  glm::dvec4 Width{ 0.0 };
  /** How many times it counts; negative where the caster is on the other side. */
  int Times = 1;
  /** Planes of the two faces whose sides as the light sees them make it an edge; 0: none. */
  glm::dvec4 Faces[2]{ glm::dvec4(0.0), glm::dvec4(0.0) };

  /** Set plane and width; 0 where the centre lies in line with the edge, from where nothing is seen of it. */
  void SetPlane(const vtkShadowWedgeLight& light);
};

/** The bound of a wedge, or of the part of it that lies in a box. */
struct VTKSOFTSHADOWSSHADOWVOLUMES_EXPORT vtkShadowWedge
{
  enum class Bounds
  {
    Tight, // the hull of the light's own corners
    Sphere // of the sphere around the light, as four planes, as wedges were before the paper
  };

  /** Polygons that close it, in homogeneous coordinates, seen counterclockwise from outside. */
  std::vector<std::vector<glm::dvec4>> Faces;
  /** It could not be bounded: there are no faces, but it may be anywhere. */
  bool Whole = false;

  /** Of the edge between two points, within planes that are positive inside. */
  void Bound(const vtkShadowWedgeLight& light, const glm::dvec3 (&ends)[2], Bounds bounds,
    const std::vector<glm::dvec4>& within);

private:
  void BoundPart(const vtkShadowWedgeLight& light, const glm::dvec3 (&ends)[2], Bounds bounds);
  void Cut(const glm::dvec4& plane);
};

#endif
