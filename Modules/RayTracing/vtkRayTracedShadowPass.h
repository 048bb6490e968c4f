// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRayTracedShadowPass
 * @brief   Technique ray-traced: N stratified rays from each pixel to the light.
 *
 * Cook, Porter and Carpenter, Distributed ray tracing, SIGGRAPH 1984, by Embree on all CPU cores. The
 * reference that the other techniques are measured against (1024 samples and more), and a technique
 * of its own. Exact for every shape of light; the error falls with the samples alone.
 *
 * Stages: 1. acceleration structures, a mesh each, kept while it is unchanged; 2. receivers, read
 * back; 3. rays, starting off the surface along its geometric normal by what float positions of that
 * magnitude can be wrong; 4. visibility, uploaded.
 */

#ifndef vtkRayTracedShadowPass_h
#define vtkRayTracedShadowPass_h

#include "vtkShadowPass.h"
#include "vtkSoftShadowsRayTracingModule.h" // For export macro

class VTKSOFTSHADOWSRAYTRACING_EXPORT vtkRayTracedShadowPass : public vtkShadowPass
{
public:
  static vtkRayTracedShadowPass* New();
  vtkTypeMacro(vtkRayTracedShadowPass, vtkShadowPass);

protected:
  vtkRayTracedShadowPass();
  ~vtkRayTracedShadowPass() override;

private:
  vtkRayTracedShadowPass(const vtkRayTracedShadowPass&) = delete;
  void operator=(const vtkRayTracedShadowPass&) = delete;
};

#endif
