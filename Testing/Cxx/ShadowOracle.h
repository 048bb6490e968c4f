// SPDX-License-Identifier: BSD-3-Clause
// What a scene's visibility must be: every pixel's surface and every shadow ray by brute force over
// all triangles, in double precision. Shares no code with the library.

#ifndef ShadowOracle_h
#define ShadowOracle_h

#include "ShadowStage.h"

#include <set>

struct SurfacePoint
{
  vtkActor* Actor = nullptr; // nullptr: background
  glm::dvec3 Position{ 0.0 };
  glm::dvec3 Normal{ 0.0 }; // of the triangle, towards the camera
};

class ShadowOracle
{
public:
  /** Of the stage's renderer as it is now; `ignored` actors do not cast. */
  explicit ShadowOracle(ShadowStage& stage, const std::set<vtkActor*>& ignored = {});

  const std::vector<SurfacePoint>& GetPixels() const { return this->Pixels; }
  /** Whether a caster lies between two points; the second may be infinitely far, as a direction. */
  bool IsBlocked(const glm::dvec3& from, const glm::dvec3& to, bool directional = false) const;
  /**
   * The visibility of a light's centre at each pixel. With a technique whose receivers are planes
   * alone: what it promises, which is the truth on flat actors; all others see what they face.
   */
  Visibility GetHard(vtkLight* light, const std::string& technique = "") const;
  /** 1 where a pixel shows a flat actor. */
  std::vector<unsigned char> GetFlatMask() const;
  /** 1 where a pixel shows this actor. */
  std::vector<unsigned char> GetMask(vtkActor* actor) const;
  /**
   * 1 where a pixel shows the same actor as all within this many pixels: away from silhouettes,
   * where the rasterizer may see something else than the ray.
   */
  std::vector<unsigned char> GetInner(int pixels) const;
  /** From a surface: from just above it. */
  bool IsBlocked(const SurfacePoint& from, const glm::dvec3& to, bool directional = false) const;

private:
  struct Triangle
  {
    glm::dvec3 A, AB, AC;
  };
  struct Body
  {
    vtkActor* Actor;
    bool Casts;
    bool Flat;
    glm::dvec3 Centre;
    double Radius;
    std::vector<Triangle> Triangles;
  };

  const Body* GetBody(const SurfacePoint& pixel) const;
  template <typename Visit>
  void ForEachHit(const glm::dvec3& origin, const glm::dvec3& direction, Visit visit) const;

  int Width;
  int Height;
  double Size = 0.0;
  std::vector<Body> Bodies;
  std::vector<SurfacePoint> Pixels;
};

#endif
