// SPDX-License-Identifier: BSD-3-Clause
// The technique of vtkRayTracedShadowPass: see there.

#ifndef vtkRayTracedShadowTechnique_h
#define vtkRayTracedShadowTechnique_h

#include "vtkShadowRayTracer.h"
#include "vtkShadowTechnique.h"

#include <glm/vec4.hpp>

#include <memory>
#include <vector>

class vtkRayTracedShadowTechnique : public vtkShadowTechnique
{
public:
  using vtkShadowTechnique::vtkShadowTechnique;

  bool UpdateLightData(vtkShadowFrame& frame) override;
  void FillVisibility(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer) override;
  double GetMaximumCost() override;
  void Release(vtkOpenGLRenderWindow* window) override;

protected:
  using Receivers = std::vector<vtkShadowRayReceiver>;

  /** A texel of the receivers' buffer as rays start from it. */
  static vtkShadowRayReceiver MakeReceiver(
    const vtkShadowFrame& frame, const glm::vec4& texel, int pixel);
  /** Find positions anew that are not precise, of a buffer that is so many pixels wide and high. */
  void FindPositions(
    const vtkShadowFrame& frame, int width, int height, Receivers& receivers) const;
  vtkShadowRayTracer::Target GetTarget(
    const vtkShadowFrame& frame, std::size_t part, const std::vector<int>& steps) const;
  /** Count the rays of a frame and the time that they took. */
  static void CountRays(vtkShadowFrame& frame, double rays, double milliseconds);

  std::unique_ptr<vtkShadowRayTracer> Tracer;

private:
  unsigned long CasterVersion = 0;
  vtkShadowRayTracer::Options Options;
};

#endif
