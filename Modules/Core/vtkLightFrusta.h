// Light frusta that hug the casters.
//
// A map needs to hold only what can put something else into shadow. A caster that is flat and has
// nothing behind it as the light sees it (a floor under everything) is left out; one that has
// something behind it only in places is hugged there. A light that sees all casters within a cone
// gets one frustum, a light among the casters up to six faces of a cube, each only where there are
// casters. None of this depends on the camera.

#ifndef vtkLightFrusta_h
#define vtkLightFrusta_h

#include "vtkShadowLight.h"           // For the light
#include "vtkSoftShadowsCoreModule.h" // For export macro

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <vector>

class vtkShadowCasters;

/** One view from a point of a light: a map is drawn and read through it. */
struct vtkLightView
{
  /**
   * To clip coordinates: after division x, y and z run from -1 to 1, z rises with the distance.
   * Before it, w is the distance along the view axis in world units, or 1 for a directional light.
   */
  glm::dmat4 WCToClip{ 1.0 };
  /** Casters reach over its border: other faces go on there, a cone ends, or nothing is behind. */
  bool Clipped = false;
  /**
   * Where it ends at the cone, or at what a cube's face shows, and casters go on that matter: at the
   * low end of x, of y, at the high end of x, of y.
   */
  std::array<bool, 4> Cut{};
  /** One of the faces of a cube, which holds what lies within 45 degrees of its axis both ways. */
  bool Face = false;
  /** Where it looks from, in WC; for a directional light, the direction towards the light. */
  glm::dvec3 Place{ 0.0 };
  /** The view plane's axes as unit vectors in WC, times the window's size at w = 1. */
  glm::dvec3 WindowX{ 0.0 };
  glm::dvec3 WindowY{ 0.0 };
  /**
   * Depth in [0,1] is DepthConstant - DepthScale / w, or, for a directional light, rises by DepthScale
   * with the distance along the axis.
   */
  double DepthScale = 0.0;
  double DepthConstant = 0.0;
};

class VTKSOFTSHADOWSCORE_EXPORT vtkLightFrusta
{
public:
  /**
   * Find which casters count for a light, whichever of its points is looked from.
   * The frusta's borders stay `border` (a fraction of the window) clear of casters.
   * `neighbours`: views are for look-ups all around a point, as far as the light's size can carry
   * them. Where casters reach over a border, the view then shows some way beyond it.
   */
  vtkLightFrusta(const vtkShadowLight& light, const vtkShadowCasters& casters, double border,
    bool neighbours = false);

  /** Indices of the casters that can shadow something. Empty: nothing to draw for this light. */
  const std::vector<int>& GetCasters() const { return this->Included; }

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

  /** Views from one place on the light (see vtkLightSample), in WC: none, one, or up to six. */
  std::vector<vtkLightView> GetViews(const glm::dvec3& place) const;

private:
  using Corners = std::vector<glm::dvec3>;
  /** A box of which a view must show what also lies in one of the others, or all where none is. */
  struct Region
  {
    Corners Box;
    std::vector<Corners> Others;
  };

  /** How far a view shows beyond a border, in the units of its window; a tangent at most. */
  double GetOverlap(const glm::dvec3& position, double widest) const;
  std::vector<vtkLightView> GetDirectionalViews(const glm::dvec3& towardsLight) const;
  std::vector<vtkLightView> GetPositionalViews(const glm::dvec3& position) const;
  bool AddPerspectiveView(const glm::dvec3& position, const glm::dvec3& axis, double limit,
    double overlap, bool face, std::vector<vtkLightView>& views) const;

  vtkShadowLight Light;
  double Border;
  bool Around;     // views are for look-ups around a point
  bool Neighbours; // and the light has a size that carries them
  double Extent = 0.0;
  glm::dvec3 Origin{ 0.0 }; // of WC
  std::vector<int> Included;
  std::vector<Region> Regions;
};

#endif
