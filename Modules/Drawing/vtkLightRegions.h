// SPDX-License-Identifier: BSD-3-Clause
// What of the casters a light's maps have to hold.
//
// A caster that is flat and has nothing behind it as the light sees it (a floor under everything) is
// left out, as is a room or a sky that holds the light and everything else; one that has something
// behind it only in places is needed only there. What a view has to show may lie in groups with a lot of
// room between them: each then is worth a view of its own, which nothing that moves in another one
// touches.

#ifndef vtkLightRegions_h
#define vtkLightRegions_h

#include "vtkSoftShadowsDrawingModule.h" // For export macro

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

class vtkShadowCasters;
struct vtkShadowCaster;
struct vtkShadowLight;
struct vtkShadowLightPart;

class VTKSOFTSHADOWSDRAWING_EXPORT vtkLightRegions
{
public:
  using Box = std::array<glm::dvec3, 8>;

  /** An axis-aligned range on a view plane, and along the view axis. */
  struct VTKSOFTSHADOWSDRAWING_EXPORT Range
  {
    glm::dvec3 Low{ std::numeric_limits<double>::max() };
    glm::dvec3 High{ std::numeric_limits<double>::lowest() };

    bool IsEmpty() const;
    void Add(const glm::dvec3& p);
    void Add(const Range& other);
    /** The window of this one reaches over that of another. */
    bool ReachesOver(const Range& other) const;
    /** The common window, the other being that much larger; the depth stays this one's. */
    Range Window(const Range& other, double overlap) const;
  };

  /** What one view shows. */
  struct Group
  {
    Range Needed;
    Range Anchor; // of these, what is needed of the largest
    Range Whole;  // of its casters, also where they need not be shown
    /** So near to the light some caster has to be shown, in a perspective view. */
    double Nearest = std::numeric_limits<double>::max();
    std::vector<int> Casters; // indices of vtkShadowCasters::Get(), ascending
  };

  vtkLightRegions(const vtkShadowLightPart& part, const vtkShadowCasters& casters);

  /** Indices of the casters that can shadow something. */
  const std::vector<int>& GetCasters() const { return this->Casters; }
  /** Those that count whole, not only where something lies behind them; all where there is none. */
  const std::vector<int>& GetWhole() const { return this->Whole; }
  /** The largest of those that count whole, or of all: by its radius, which moving does not change. */
  int GetLargest() const;
  /** The box of a caster, by its index. */
  const Box& GetBox(int caster) const { return this->Boxes[caster]; }
  /** As far as anything that casts is from anything that it can shadow. */
  double GetDiameter() const;

  /**
   * What a view has to show, given how it shows a box: nothing, one group, or up to `most`, a power of
   * two. Where casters hide things only in places, it shows so much more around these.
   */
  std::vector<Group> GetGroups(
    const std::function<Range(const Box&)>& project, double overlap, int most) const;

private:
  /** A caster; of a flat one that all of the light sees from one side, only what lies behind counts. */
  struct Region
  {
    int Caster = 0;
    bool Plane = false;
    glm::dvec3 Normal{ 0.0 }; // towards the light
    glm::dvec3 Point{ 0.0 };

    /** Whether some of a box lies behind the plane, beyond a tolerance. */
    bool IsBefore(const Box& box, double tolerance) const;
    bool IsBefore(const Box& box) const;
    /** Of one whose box does: where its sides are askew to the plane, the vertices may not. */
    bool IsBefore(const vtkShadowCaster& caster) const;
  };

  bool IsShell(int index, const vtkShadowLight& light, const vtkShadowCasters& casters) const;
  bool FindPlane(
    Region& region, const vtkShadowLight& light, const vtkShadowCasters& casters) const;

  std::vector<Box> Boxes;      // the casters', then those of what only receives
  std::vector<Region> Regions; // the largest first
  std::vector<int> Casters;    // ascending
  std::vector<int> Whole;      // ascending
};

#endif
