// SPDX-License-Identifier: BSD-3-Clause
// The pass under the technique's name, and the technique's declaration.

#include "vtkRayTracedShadowPass.h"

#include "vtkObjectFactory.h"
#include "vtkRayTracedShadowTechnique.h"
#include "vtkShadowDeclaration.h"
#include "vtkShadowRayParameters.h"

vtkShadowPassOfTechniqueMacro(vtkRayTracedShadowPass, "ray-traced");
vtkShadowTechniqueAutoInit(VTKSOFTSHADOWSRAYTRACING_EXPORT, vtkSoftShadowsRayTracing);

namespace
{
vtkShadowDeclaration RayTraced()
{
  using Support = vtkShadowShapeSupport;
  vtkShadowDeclaration t;
  t.Name = "ray-traced";
  t.Title = "Ray-traced shadows";
  t.Paper =
    "Cook, Porter and Carpenter, Distributed ray tracing, SIGGRAPH 1984; Wald et al., Embree, "
    "SIGGRAPH 2014";
  t.SetClasses<vtkRayTracedShadowTechnique, vtkRayTracedShadowPass>("vtkRayTracedShadowPass");
  t.Traits.SamplesLights = true;
  t.LightShapes.fill(Support::Exact);
  t.Parameters = vtkShadowRayParameters::Get();
  t.Resources = { "on the CPU: Embree's structures, about 100 bytes a triangle",
    "on the GPU: receivers 16 bytes, depth 4 bytes, visibility 4 bytes a light (16 textured), "
    "each a pixel" };
  t.Limits = {
    "Noise of the order of 1 / samples^0.75 in penumbrae.",
    "Of translucent surfaces the nearest of a pixel receives; those behind it are drawn as if lit."
  };
  return t;
}

const vtkShadowTechniqueRegistration registration(RayTraced());
}
