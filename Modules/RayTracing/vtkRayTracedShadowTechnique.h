// SPDX-License-Identifier: BSD-3-Clause
// The technique of vtkRayTracedShadowPass: see there.

#ifndef vtkRayTracedShadowTechnique_h
#define vtkRayTracedShadowTechnique_h

#include "vtkShadowRayTracer.h"
#include "vtkShadowTechnique.h"

#include <memory>

class vtkRayTracedShadowTechnique : public vtkShadowTechnique
{
public:
  using vtkShadowTechnique::vtkShadowTechnique;

  bool UpdateLightData(vtkShadowFrame& frame) override;
  void FillVisibility(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer) override;
  double GetMaximumCost() override;
  void Release(vtkOpenGLRenderWindow* window) override;

private:
  std::unique_ptr<vtkShadowRayTracer> Tracer;
  unsigned long CasterVersion = 0;
};

#endif
