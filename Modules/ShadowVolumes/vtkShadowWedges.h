// SPDX-License-Identifier: BSD-3-Clause
// Penumbra wedges: what is known of an edge that a caster ends at as a light of some size sees it, and
// the bound of the space in which that edge hides a part of the light.
//
// A point p sees an edge before the light where p lies on a line from the light through the edge, beyond
// it. All such points are v + t (v - L), for v on the edge, L on the light and t >= 0. They are held by
// the hull of the edge's ends and of the directions from the light's corners through them: a cone in
// homogeneous coordinates. Its facets stand on neighbours of the hull of directions, each at the end
// that it leaves all else behind; where that changes from one end to the other, a facet holds the edge.
//
// Outside of the true wedge the edge hides nothing, so that a bound may be loose. Where there is none
// (the light is touched by the edge) it is the whole picture.

#ifndef vtkShadowWedges_h
#define vtkShadowWedges_h

#include "vtkShadowLight.h"                    // For shapes
#include "vtkSoftShadowsShadowVolumesModule.h" // For export macro

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

/** A light, or a part of its area, in SWC. */
struct vtkShadowWedgeLight
{
  vtkShadowLight::Shape Kind = vtkShadowLight::Shape::Rectangle;
  glm::dvec4 Place{ 0.0 }; // its centre, w 1; or the direction to it, w 0
  glm::dvec3 U{ 0.0 };     // half axes
  glm::dvec3 V{ 0.0 };
};

/** A directed edge that casters end at, in SWC. */
struct VTKSOFTSHADOWSSHADOWVOLUMES_EXPORT vtkShadowWedgeEdge
{
  glm::dvec3 Ends[2];
  /** Through the light's centre and the edge, of unit normal; positive where the caster is. */
  glm::dvec4 Plane{ 0.0 };
  /** How many times it counts; negative where the caster is on the other side. */
  int Times = 1;
  /** Planes of the two faces whose sides as the light sees them make it an edge; 0: none. */
  glm::dvec4 Faces[2]{ glm::dvec4(0.0), glm::dvec4(0.0) };

  /** Set the plane; 0 where the centre lies in line with the edge, from where nothing is seen of it. */
  void SetPlane(const glm::dvec4& place);
};

/** The bound of a wedge: triangles that close it, and planes. */
struct VTKSOFTSHADOWSSHADOWVOLUMES_EXPORT vtkShadowWedge
{
  enum class Bounds
  {
    Tight, // the hull of the light's own corners
    Sphere // of the sphere around the light, as four planes, as wedges were before the paper
  };
  /** A corner of the bound. */
  struct Corner
  {
    /** 0: far along a direction; 1: a point; 2: x and y are a corner of the picture. */
    int Kind;
    /** The point; or where the direction's ray, times the distance along the wedge's axis, starts. */
    glm::dvec3 Base;
    glm::dvec3 Along;
  };

  /** Three corners a triangle, seen counterclockwise from outside; none where the wedge is flat. */
  std::vector<Corner> Triangles;
  /** Inside is positive. */
  std::vector<glm::dvec4> Planes;
  /** It could not be bounded. */
  bool Whole = false;

  void Bound(const vtkShadowWedgeLight& light, const glm::dvec3 (&ends)[2], Bounds bounds);
  /** No point of a box is in it. */
  bool Misses(const glm::dvec3* corners, int count) const;

private:
  void BoundPart(const vtkShadowWedgeLight& light, const glm::dvec3 (&ends)[2], Bounds bounds);
  void BoundNothing();
};

#endif
