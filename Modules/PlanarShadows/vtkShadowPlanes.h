// SPDX-License-Identifier: BSD-3-Clause
// The planes that receive: the user's, or those of flat props, the largest first.

#ifndef vtkShadowPlanes_h
#define vtkShadowPlanes_h

#include "vtkSoftShadowsPlanarShadowsModule.h" // For export macro

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

class vtkShadowCasters;
struct vtkShadowCaster;

/** A rectangle along a plane's axes, in world units; it may be empty, or without an end. */
struct VTKSOFTSHADOWSPLANARSHADOWS_EXPORT vtkPlaneRectangle
{
  static constexpr double Infinity = std::numeric_limits<double>::infinity();
  glm::dvec2 Low{ Infinity };
  glm::dvec2 High{ -Infinity };

  bool IsEmpty() const { return !(this->Low.x <= this->High.x && this->Low.y <= this->High.y); }
  bool operator==(const vtkPlaneRectangle& other) const
  {
    return this->Low == other.Low && this->High == other.High;
  }
  void Add(const glm::dvec2& point);
  void Add(const vtkPlaneRectangle& other);
  void Intersect(const vtkPlaneRectangle& other);
};

/** Normal . p = Distance, for p in SWC; thesis equations 2.1 and 2.2. */
struct VTKSOFTSHADOWSPLANARSHADOWS_EXPORT vtkShadowPlane
{
  glm::dvec3 Normal{ 0.0, 0.0, 1.0 };
  double Distance = 0.0;
  glm::dvec3 X{ 1.0, 0.0, 0.0 }; // axes along it
  glm::dvec3 Y{ 0.0, 1.0, 0.0 };
  double Area = 0.0;           // of the props that were found in it
  vtkPlaneRectangle Receivers; // where props touch it

  double GetHeight(const glm::dvec3& p) const;
  glm::dvec2 GetPlace(const glm::dvec3& p) const;
  /** (Normal, -Distance). */
  glm::dvec4 GetEquation() const;
  bool operator==(const vtkShadowPlane& other) const;

  /** The corners of a box's part whose heights lie in a range. */
  std::vector<glm::dvec3> Cut(
    const std::array<glm::dvec3, 8>& corners, double lowest, double highest) const;
  /** A caster that is flat and lies in it, but for rounding. */
  bool Holds(const vtkShadowCaster& caster) const;
};

class VTKSOFTSHADOWSPLANARSHADOWS_EXPORT vtkShadowPlanes
{
public:
  ///@{ The user's planes: a point and a normal in the world. False where they are no plane.
  bool Add(const glm::dvec3& point, const glm::dvec3& normal);
  void RemoveAll() { this->Given.clear(); }
  /** Those that were given to another one, and no others. */
  void SetGiven(const vtkShadowPlanes& other) { this->Given = other.Given; }
  int GetNumberOfGiven() const { return static_cast<int>(this->Given.size()); }
  ///@}

  /** Bring the planes up to date; true when they changed. */
  bool Update(const vtkShadowCasters& casters, int limit);
  const std::vector<vtkShadowPlane>& Get() const { return this->Planes; }
  /** How many there are without the limit. */
  int GetFound() const { return this->Found; }

private:
  void Find(const vtkShadowCasters& casters);
  void Merge(const glm::dvec3& point, const glm::dvec3& normal, double area, double extent);

  struct Flat
  {
    glm::dvec3 Point;
    vtkShadowPlane Plane;
    double Extent;
  };

  std::vector<std::pair<glm::dvec3, glm::dvec3>> Given; // point and unit normal, world
  std::vector<Flat> Flats;
  std::vector<vtkShadowPlane> Planes;
  int Found = 0;
  // What they were made from.
  std::vector<std::pair<glm::dvec3, glm::dvec3>> LastGiven;
  int LastLimit = -1;
  unsigned long CasterVersion = 0;
  unsigned long ReceiverVersion = 0;
  std::vector<bool> Receiving;
};

#endif
