// SPDX-License-Identifier: BSD-3-Clause
// The pass under the name of the technique of penumbra wedges, and its declaration.

#include "vtkObjectFactory.h"
#include "vtkPenumbraWedgePass.h"
#include "vtkPenumbraWedgeTechnique.h"
#include "vtkShadowDeclaration.h"

vtkShadowPassOfTechniqueMacro(vtkPenumbraWedgePass, "wedges");

namespace
{
using Support = vtkShadowShapeSupport;

vtkShadowDeclaration Wedges()
{
  vtkShadowDeclaration t;
  t.Name = "wedges";
  t.Title = "Penumbra wedges";
  t.Paper = "Assarsson, Dougherty, Mounier and Akenine-Moeller, An optimized soft shadow volume "
            "algorithm with real-time performance, EGSR 2003";
  t.SetClasses<vtkPenumbraWedgeTechnique, vtkPenumbraWedgePass>("vtkPenumbraWedgePass");
  t.Traits.SignedShares = true;
  t.Traits.SamplesLights = true; // with overlap=count
  t.LightShapes = { Support::Exact, Support::Approximate, Support::Approximate,
    Support::Approximate, Support::Approximate, Support::Approximate };
  t.Parameters = {
    vtkShadowParameter::Choice("overlap", "sum", { "sum", "loops", "count" },
      "How what edges hide adds up: as if no caster stood behind another, each by its "
      "silhouette from the light's centre (sum); likewise, but of two loops of "
      "silhouettes the larger share and half of the smaller (loops); or by a count for "
      "each sample of the light, of all edges that any point of it sees casters end at "
      "(count)"),
    vtkShadowParameter::Integer(
      "samples", 64, 1, 256, "Samples of the light that are counted for, with overlap=count")
      .At({ 16, 32, 64, 256 }),
    vtkShadowParameter::Integer("split", 1, 1, 4,
      "With overlap=sum and loops the light's area is cut into split x split parts, each with "
      "silhouettes of "
      "its own; parts of disks and spheres are smaller ones of the same area together")
      .At({ 1, 1, 1, 3 }),
    vtkShadowParameter::Real("merge", 0.0, 0.0, 4.0,
      "With overlap=sum and loops: silhouettes' runs of short edges that are straight to within so "
      "much "
      "of what the picture shows are one edge, for some wrong pixels on thin bodies; 0: every edge "
      "has a wedge")
      .In("pixels"),
    vtkShadowParameter::Choice("bounds", "tight", { "tight", "sphere" },
      "What bounds a wedge: the hull of the light's own corners, or four planes around a sphere "
      "that holds the light; the picture is the same")
  };
  t.DebugViews = { "centre", "inner", "outer", "edges", "wedges" };
  t.Resources = { "on the CPU: adjacency, about 41 bytes a triangle of a closed mesh, once a mesh",
    "silhouettes, 8 bytes an edge (16 of open meshes), and 32 bytes for its plane",
    "wedges, about 3.8 KiB an edge (5.3 KiB with overlap=count)",
    "where volumes are counted by z-fail: caps, 12 bytes a triangle",
    "receivers 16 bytes, their depth 4 bytes, that of volumes with the stencil 8 bytes, sums 8 "
    "bytes "
    "(16 with a textured light), "
    "visibility 4 bytes a light (16 textured), each a pixel; with overlap=count 16 bytes more for "
    "each "
    "16 samples, or for each 12 or 8 where more than 31 or 127 volumes may nest",
    "a textured light with overlap=sum and loops: tables, 4.4 MB (times split x split)" };
  t.Limits = { "overlap=sum: where penumbrae of several casters, or of parts of one, overlap, what "
               "both hide counts twice: too dark. Of a body, only what its silhouette from the "
               "light's centre tells is known.",
    "overlap=loops: how much two loops hide together is a guess. Of a caster in whose shadow the "
    "eye "
    "may be, or whose inside it may see, all loops are one; so are those after the first 256.",
    "overlap=sum and loops: of an open mesh an edge at which two faces fold counts twice, so that "
    "its "
    "penumbra is darker by up to twice; overlap=count is right there.",
    "overlap=count: few samples show as steps, as many grey levels as samples; beyond 2047 nested "
    "volumes counts may wrap.",
    "The cost is that of filling the wedges: it grows with silhouettes, pixels and the light's "
    "size. "
    "A wedge that the light touches is the whole picture.",
    "Single pixels at silhouettes that light and eye share can be darker or lighter than the "
    "truth.",
    "Of translucent surfaces the nearest of a pixel receives; those behind it are drawn as if lit.",
    "Holes by alpha (alpha-threshold) within triangles cast as if they were filled; triangles "
    "that are clear all over cast nothing." };
  return t;
}

const vtkShadowTechniqueRegistration wedges(Wedges());
}
