// SPDX-License-Identifier: BSD-3-Clause
// Light frusta that hug the casters.
//
// A map needs to hold only what can put something else into shadow. A caster that is flat and has
// nothing behind it as the light sees it (a floor under everything) is left out; one that has
// something behind it only in places is hugged there. A light that sees all casters within a cone
// gets one frustum, a light among the casters up to six faces of a cube, each only where there are
// casters. Casters in groups with a lot of room between them get a frustum for each group: a thing that
// moves far away then neither costs resolution nor moves a texel. None of this depends on the camera.

#ifndef vtkLightFrusta_h
#define vtkLightFrusta_h

#include "vtkShadowLight.h"              // For the light
#include "vtkSoftShadowsDrawingModule.h" // For export macro

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <memory>
#include <vector>

class vtkLightRegions;
class vtkShadowCasters;

/** One view from a point of a light: a map is drawn and read through it. */
struct vtkLightView
{
  /**
   * To clip coordinates: after division x, y and z run from -1 to 1, z rises with the distance.
   * Before it, w is the distance along the view axis in world units, or 1 for a directional light.
   */
  glm::dmat4 SWCToClip{ 1.0 };
  /** Casters reach over its border: other faces go on there, a cone ends, or nothing is behind. */
  bool Clipped = false;
  /**
   * Where it ends at the cone, or at what a cube's face shows, and casters go on that matter: at the
   * low end of x, of y, at the high end of x, of y.
   */
  std::array<bool, 4> Cut{};
  /** One of the faces of a cube, which holds what lies within 45 degrees of its axis both ways. */
  bool Face = false;
  /** Where it looks from, in SWC; for a directional light, the direction towards the light. */
  glm::dvec3 Place{ 0.0 };
  /** The view plane's axes as unit vectors in SWC, times the window's size at w = 1. */
  glm::dvec3 WindowX{ 0.0 };
  glm::dvec3 WindowY{ 0.0 };
  /**
   * Depth in [0,1] is DepthConstant - DepthScale / w, or, for a directional light, rises by DepthScale
   * with the distance along the axis.
   */
  double DepthScale = 0.0;
  double DepthConstant = 0.0;
  /** What it shows: indices of vtkShadowCasters::Get(), ascending. */
  std::vector<int> Casters;
};

class VTKSOFTSHADOWSDRAWING_EXPORT vtkLightFrusta
{
public:
  /** So many groups of casters get maps of their own, where few maps are drawn. */
  static constexpr int MostGroups = 4;
  /** Texels of a map's border that stay clear of casters, where one look-up reads its neighbours. */
  static constexpr double BorderTexels = 2.0;

  struct Options
  {
    /** So far the frusta's borders stay clear of casters, as a share of the window. */
    double Border = 0.0;
    /**
     * A texel, as a share of the window. Where it is positive, the window around several casters takes
     * steps: its sides are the largest caster's times powers of 2^(1/8), and it moves by whole texels
     * against that. While another caster moves, the texels then stay in their place but for the steps.
     */
    double Texel = 0.0;
    /**
     * Views are for look-ups all around a point, as far as the light's size can carry them. Where
     * casters reach over a border, the view then shows some way beyond it.
     */
    bool Neighbours = false;
    /** At most so many groups of casters get frusta of their own, a power of two. */
    int Groups = 1;
  };

  /** Find which casters count for a light, whichever of its points is looked from. */
  vtkLightFrusta(const vtkShadowLightPart& part, const vtkShadowCasters& casters);
  vtkLightFrusta(
    const vtkShadowLightPart& part, const vtkShadowCasters& casters, const Options& options);

  /** Indices of the casters that can shadow something. Empty: nothing to draw for this light. */
  const std::vector<int>& GetCasters() const;

  /**
   * Diameter of a sphere around those that are not flat, or around all, in world units; it does not
   * depend on how they are turned.
   */
  double GetExtent() const;

  /**
   * Whether some caster is so near to a light among its casters that look-ups around a point reach
   * further beyond a cube's face than the views show.
   */
  bool IsOverlapExceeded(const vtkShadowCasters& casters) const;

  /**
   * Views from one place on the light (see vtkLightSample), in SWC: none, one for each group, or up to
   * six. What one of them shows, none of the others does, but for what faces of a cube overlap.
   */
  std::vector<vtkLightView> GetViews(const glm::dvec3& place) const;

private:
  /** A view along an axis, from a position, that ends at a tangent and shows some more beyond it. */
  struct Aim
  {
    glm::dvec3 Position;
    glm::dvec3 Axis;
    double Border;
    double Overlap;
    bool Face;
  };

  /** How far a view shows beyond a border, in the units of its window; a tangent at most. */
  double GetOverlap(const glm::dvec3& position, double widest) const;
  std::vector<vtkLightView> GetDirectionalViews(const glm::dvec3& towardsLight) const;
  std::vector<vtkLightView> GetPositionalViews(const glm::dvec3& position) const;
  /** The mean direction to some casters' corners, if all casters are within an angle from it. */
  bool FindAxis(const glm::dvec3& position, const std::vector<int>& casters, double widestAngle,
    glm::dvec3& axis) const;
  std::vector<vtkLightView> GetPerspectiveViews(const Aim& aim, int groups) const;

  vtkShadowLight Light;
  Options Wanted;
  bool Neighbours; // and the light has a size that carries look-ups
  double Extent = 0.0;
  glm::dvec3 Origin{ 0.0 }; // of SWC
  std::shared_ptr<const vtkLightRegions> Regions;
};

#endif
