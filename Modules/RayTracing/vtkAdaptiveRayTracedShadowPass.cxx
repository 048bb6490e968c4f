// SPDX-License-Identifier: BSD-3-Clause
// The pass under the technique's name, and the technique's declaration.

#include "vtkAdaptiveRayTracedShadowPass.h"

#include "vtkAdaptiveRayTracedShadowTechnique.h"
#include "vtkObjectFactory.h"
#include "vtkShadowDeclaration.h"
#include "vtkShadowRayParameters.h"

vtkShadowPassOfTechniqueMacro(vtkAdaptiveRayTracedShadowPass, "ray-adaptive");

namespace
{
vtkShadowDeclaration Adaptive()
{
  vtkShadowDeclaration t;
  t.Name = "ray-adaptive";
  t.Title = "Rays in penumbrae only";
  t.Paper =
    "Mitchell, Generating antialiased images at low sampling densities, SIGGRAPH 1987; "
    "Hasselgren, Akenine-Moeller and Ohlsson, Conservative rasterization, GPU Gems 2, 2005; "
    "Wald et al., Embree, SIGGRAPH 2014";
  t.SetClasses<vtkAdaptiveRayTracedShadowTechnique, vtkAdaptiveRayTracedShadowPass>(
    "vtkAdaptiveRayTracedShadowPass");
  t.Traits.SamplesLights = true;
  t.LightShapes.fill(vtkShadowShapeSupport::Exact);
  t.Parameters = vtkShadowRayParameters::Get();
  t.Parameters.insert(t.Parameters.begin() + 1,
    vtkShadowParameter::Real("error", 0.0, 0.0, 0.5,
      "Standard error of V at which a pixel needs no more rays; 0 traces all samples"));
  t.Parameters.push_back(vtkShadowParameter::Integer("map-resolution", 0, 0, 16384,
    "Side of the maps that tell what sees all of a light; 0: automatic. It changes the time alone")
                           .In("texels"));
  t.Parameters.push_back(vtkShadowParameter::Choice("selection", "auto", { "auto", "gpu", "cpu" },
    "Where the pixels that need rays are chosen: on the GPU, so that they alone are read back, or "
    "among all that are; auto is the GPU where there is one. It changes the time alone"));
  t.Resources = { "on the CPU: Embree's structures, about 100 bytes a triangle",
    "maps, 4 bytes a texel, and a pyramid, 2.7 bytes a texel, map-resolution^2 each view of a "
    "light",
    "receivers 16 bytes, depth 4 bytes, selection 20 bytes (40 with several lights), visibility 4 "
    "bytes "
    "a light (16 textured), each a pixel" };
  t.Limits = {
    "Noise in penumbrae as that of ray-traced.",
    "Where all first rays of a pixel and of its neighbours agree, their answer stands: the "
    "faintest "
    "border of a penumbra, or a hole of less than a pixel, may be missed.",
    "For a light among its casters no map tells anything: each pixel gets the first few rays.",
    "Of translucent surfaces the nearest of a pixel receives; those behind it are drawn as if lit."
  };
  return t;
}

const vtkShadowTechniqueRegistration registration(Adaptive());
}
