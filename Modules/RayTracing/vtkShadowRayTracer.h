// SPDX-License-Identifier: BSD-3-Clause
// Embree's side of ray-traced techniques: the casters, and rays to a light's samples. No OpenGL here.

#ifndef vtkShadowRayTracer_h
#define vtkShadowRayTracer_h

#include "vtkShadowRayReceiver.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

class vtkShadowCasters;
struct vtkShadowLight;
struct vtkShadowLightPart;

class vtkShadowRayTracer
{
public:
  enum class Structure
  {
    Automatic, // flat until the first change, if no two casters share a mesh; then instanced
    Instanced,
    Flat
  };
  /** How rays are traced: it changes the time, and V by rounding alone. */
  struct Options
  {
    int Packet = 16; // rays that go together: 1, 4, 8 or 16
    vtkShadowRayTracer::Structure Structure = vtkShadowRayTracer::Structure::Automatic;

    bool operator==(const Options& other) const
    {
      return this->Packet == other.Packet && this->Structure == other.Structure;
    }
  };
  /** Rays to a light. */
  struct Target
  {
    const vtkShadowLightPart& Part;
    const glm::dvec3& Origin; // of SWC
    std::vector<int> Steps;   // how many each receiver gets first, and then
    int Seed;
  };

  vtkShadowRayTracer();
  ~vtkShadowRayTracer();

  /** Embree's own message if it could not start, else "". */
  const std::string& GetError() const;

  /**
   * Bring the acceleration structures up to date. Instanced: a structure a mesh, built when the mesh is
   * new, and one over their instances, built when something moved. Flat: one over all triangles, built
   * with every change. Gives how many meshes were built.
   */
  int Update(const vtkShadowCasters& casters, const Options& options);
  bool IsFlat() const;

  /**
   * Find positions anew that are off by Height: where the pixel's own ray, from a point in SWC along a
   * unit vector, meets a caster near by. Those that meet none stay.
   */
  using Ray = std::pair<glm::dvec3, glm::dvec3>;
  void FindPositions(std::vector<vtkShadowRayReceiver>& receivers,
    const std::function<Ray(int pixel)>& getRay) const;

  /**
   * Trace on until each of some receivers has so many rays, stratified, on all cores; none from those
   * whose own surface hides the whole light. Deterministic: patterns depend on pixels and the seed
   * alone. Gives the rays traced.
   */
  double Trace(const Target& target, const std::vector<vtkShadowRayReceiver>& receivers,
    const std::vector<int>& chosen, int samples, std::vector<vtkShadowRaySeen>& seen);

  /** Whether a receiver's rays can decide anything: its own surface does not hide the whole light. */
  static bool NeedsRays(
    const vtkShadowLight& light, const glm::dvec3& origin, const vtkShadowRayReceiver& receiver);

  /** Call a function for each of so many, on all cores, in chunks of `grain`. */
  static void ForAll(std::size_t count, std::size_t grain,
    const std::function<void(std::size_t first, std::size_t end)>& function);

  void Clear();

private:
  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
