// SPDX-License-Identifier: BSD-3-Clause
// Embree's side of the ray-traced technique: the casters as instances of their meshes, and rays to a
// light's samples. No OpenGL here.

#ifndef vtkShadowRayTracer_h
#define vtkShadowRayTracer_h

#include <glm/vec3.hpp>

#include <functional>
#include <memory>
#include <utility>
#include <vector>

class vtkShadowCasters;
struct vtkShadowLight;
struct vtkShadowLightPart;

class vtkShadowRayTracer
{
public:
  /**
   * What a pixel sees, in SWC. Its rays start Offset along the normal; where its prop's positions are
   * off by more than that, what they hit within Height above its plane is the surface itself.
   */
  struct Receiver
  {
    glm::dvec3 Position;
    glm::dvec3 Normal;
    double Offset;
    double Height;
    int Pixel;
    bool Casts;
  };

  vtkShadowRayTracer();
  ~vtkShadowRayTracer();

  /** Embree's own message if it could not start, else "". */
  const std::string& GetError() const;

  /**
   * Bring the acceleration structures up to date: a structure a mesh, built when the mesh is new;
   * one over their instances, built when something moved. Gives how many meshes were built.
   */
  int Update(const vtkShadowCasters& casters);

  /**
   * Find positions anew that are off by Height: where the pixel's own ray, from a point in SWC along a
   * unit vector, meets a caster near by. Those that meet none stay.
   */
  using Ray = std::pair<glm::dvec3, glm::dvec3>;
  void FindPositions(
    std::vector<Receiver>& receivers, const std::function<Ray(int pixel)>& getRay) const;

  /**
   * Visibility of each receiver, `components` (1 or 4) floats at its pixel, by `samples` stratified
   * rays each, on all cores. Deterministic: patterns depend on pixels and the seed alone. Gives the
   * rays traced.
   */
  double Trace(const vtkShadowLightPart& part, const glm::dvec3& origin,
    const std::vector<Receiver>& receivers, int samples, int seed, int components,
    std::vector<float>& visibility) const;

  /** Whether a receiver's rays can decide anything: its own surface does not hide the whole light. */
  static bool NeedsRays(
    const vtkShadowLight& light, const glm::dvec3& origin, const Receiver& receiver);

  void Clear();

private:
  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
