// SPDX-License-Identifier: BSD-3-Clause
// The declarations of the family's techniques that take a look-up a map. Those of filters:
// vtkShadowMapFilterTechniques.cxx.

#include "vtkAccumulatedShadowMapPass.h"
#include "vtkAccumulatedShadowMapTechnique.h"
#include "vtkHardShadowMapPass.h"
#include "vtkHardShadowMapTechnique.h"
#include "vtkShadowMapParameters.h"

vtkShadowTechniqueAutoInit(VTKSOFTSHADOWSSHADOWMAPS_EXPORT, vtkSoftShadowsShadowMaps);

namespace
{
using namespace vtkShadowMapParameters;
using Support = vtkShadowShapeSupport;

vtkShadowDeclaration Hard()
{
  vtkShadowDeclaration t;
  t.Name = "map-hard";
  t.Title = "Hard shadow map";
  t.Paper = "Williams, Casting curved shadows on curved surfaces, SIGGRAPH 1978; Zapotocky, Soft "
            "shadows on GPU, 2007, section 2.3";
  t.SetClasses<vtkHardShadowMapTechnique, vtkHardShadowMapPass>("vtkHardShadowMapPass");
  t.Traits.Hard = true;
  t.Traits.Forward = true;
  t.DebugViews = { "map" };
  t.LightShapes = { Support::Exact, Support::Approximate, Support::Approximate,
    Support::Approximate, Support::Exact, Support::Approximate };
  t.Parameters = { Resolution(), Filter("bilinear"), Midpoint(), Faces() };
  t.Resources = { "depth map, 4 bytes a texel, resolution^2 each light (up to six where the light "
                  "is among the casters)" };
  t.Limits = { "The light counts as its centre: there is no penumbra.",
    "Edges are as sharp as a texel of the map; a gap narrower than that between caster and "
    "receiver is closed by light." };
  return t;
}

vtkShadowDeclaration Accumulated()
{
  vtkShadowDeclaration t;
  t.Name = "map-soft";
  t.Title = "Accumulated shadow maps";
  t.Paper = "Heckbert and Herf, Simulating soft shadows with graphics hardware, 1997; Zapotocky, "
            "Soft shadows on GPU, 2007, chapter 5 (map soft) and appendix A.4 (samples)";
  t.SetClasses<vtkAccumulatedShadowMapTechnique, vtkAccumulatedShadowMapPass>(
    "vtkAccumulatedShadowMapPass");
  t.Traits.Forward = true;
  t.Traits.SamplesLights = true;
  t.DebugViews = { "map" };
  t.LightShapes = { Support::Exact, Support::Approximate, Support::Exact, Support::Exact,
    Support::Exact, Support::Exact };
  t.Parameters = {
    vtkShadowParameter::Integer("samples", 64, 1, 1024, "Samples of the light, a map each")
      .At({ 16, 32, 64, 1024 })
      .AtPreview(8),
    Resolution("; 512 where a light has a size", { 256, 512, 0, 1024 }),
    Filter("nearest"),
    Midpoint(),
    Faces(),
    vtkShadowParameter::Integer("memory", 512, 1, 65536,
      "Most that the maps may hold; more maps than fit are drawn in batches in every frame")
      .In("MiB"),
  };
  t.Resources = { "depth maps, 4 bytes a texel, samples x resolution^2 each light, up to memory",
    "receivers 16 bytes, depth 4 bytes, visibility 4 bytes a light (16 textured), each a pixel" };
  t.Limits = { "A sphere is its disk that faces the middle of the casters, not each receiver.",
    "Few samples show as steps: as many grey levels as samples.",
    "Of translucent surfaces the nearest of a pixel receives; with evaluation=forward all do." };
  return t;
}

const vtkShadowTechniqueRegistration hard(Hard());
const vtkShadowTechniqueRegistration accumulated(Accumulated());
}
