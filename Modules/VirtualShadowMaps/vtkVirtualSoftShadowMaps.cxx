// SPDX-License-Identifier: BSD-3-Clause
// The declaration of the family's technique, and its pass.

#include "vtkObjectFactory.h"
#include "vtkShadowDeclaration.h"
#include "vtkVirtualSoftShadowMapPass.h"
#include "vtkVirtualSoftShadowMapTechnique.h"

vtkShadowTechniqueAutoInit(VTKSOFTSHADOWSVIRTUALSHADOWMAPS_EXPORT, vtkSoftShadowsVirtualShadowMaps);

vtkShadowPassOfTechniqueMacro(vtkVirtualSoftShadowMapPass, "virtual-maps");

namespace
{
using Support = vtkShadowShapeSupport;

vtkShadowDeclaration Declare()
{
  vtkShadowDeclaration t;
  t.Name = "virtual-maps";
  t.Title = "Predicted virtual soft shadow maps";
  t.Paper = "Shen, Guennebaud, Yang and Feng, Predicted virtual soft shadow maps with high quality "
            "filtering, Computer Graphics Forum 30(2), 2011";
  t.SetClasses<vtkVirtualSoftShadowMapTechnique, vtkVirtualSoftShadowMapPass>(
    "vtkVirtualSoftShadowMapPass");
  t.Traits.NeedsReceivers = true;
  t.Traits.CameraDependent = true;
  t.LightShapes = { Support::Exact, Support::Approximate, Support::Approximate,
    Support::Approximate, Support::Approximate, Support::Unsupported };
  t.Parameters = { vtkShadowParameter::Choice("metric", "dynamic", { "dynamic", "static", "none" },
                     "How many texels a penumbra takes: by the paper's user study of moving or of "
                     "still scenes; none: one map of the whole light, whatever is needed"),
    vtkShadowParameter::Real("texel", 1.0, 0.0625, 16.0,
      "Texels against those that the metric asks for: smaller ones are finer, and cost more")
      .In("of the metric's")
      .At({ 2.0, 1.0, 1.0, 0.5 }),
    vtkShadowParameter::Boolean("antialias", true,
      "Widen each filter by its pixel's footprint on the receiver, so that no shadow is sharper "
      "than a pixel"),
    vtkShadowParameter::Integer("resolution", 0, 0, 16384,
      "Side of a tile's map, 16 at least (less counts as 16): of kept pages the power of two "
      "below, "
      "of others at most; with metric=none of the only map; 0: 512, with metric=none the power of "
      "two next to the picture's longer side, 1024 to 4096")
      .In("texels"),
    vtkShadowParameter::Boolean("cache", true,
      "Keep tiles as pages from frame to frame; off: the paper's own tiles, drawn anew in each "
      "frame and of just the size that is needed"),
    vtkShadowParameter::Real(
      "budget", 256, 1, 16384, "Most that pages take; where more are asked for, all get coarser")
      .In("MB"),
    vtkShadowParameter::Integer("taps", 48, 1, 16384,
      "Most texels that a kernel takes along a side; of more, some are left out. No metric asks "
      "for as "
      "many as by default, so that it counts where the map is finer than pixels need, as with "
      "metric=none")
      .In("texels"),
    vtkShadowParameter::Integer("coarse", 256, 1, 4096,
      "Side of the map in which blockers are searched, 32 at least (less counts as 32), rounded "
      "down to a power of two")
      .In("texels")
      .At({ 256, 256, 256, 1024 }) };
  t.DebugViews = { "tiles", "predicted-resolution", "kernel-size", "lit-mask", "cache-hits" };
  t.Resources = {
    "pages, 4 bytes a texel, resolution^2 each, within the budget; with cache=off one",
    "coarse map and its pyramid, 30 bytes a texel, coarse^2 each light (up to six where the light "
    "is "
    "among the casters)",
    "receivers 16 bytes, depth 4 bytes, kernels, requests and sums 48 bytes, visibility 4 bytes a "
    "light, each a pixel"
  };
  t.Limits = { "One map from the light's centre: what only other points of the light see behind a "
               "caster's edge is missing.",
    "Blockers at several depths over a receiver count as one in their mean depth.",
    "A disk or sphere is the square of equal variance, half side 0.866 radius.",
    "Where a light and a pixel are as large as each other and turned apart, their filter is a "
    "parallelogram of the same variance.",
    "A textured light casts no shadow.",
    "Of a translucent pixel's surfaces the nearest alone receives: it is evaluated in screen "
    "space.",
    "Blockers are searched in triangles without their holes by alpha; the filter knows these.",
    "A light among its casters: what it casts further than 31 degrees beyond a cube's face is "
    "drawn in." };
  return t;
}

const vtkShadowTechniqueRegistration registration(Declare());
}
