// SPDX-License-Identifier: BSD-3-Clause
// The pass under the names of the family's techniques, and their declarations.

#include "vtkObjectFactory.h"
#include "vtkShadowDeclaration.h"
#include "vtkShadowVolumePass.h"
#include "vtkShadowVolumeTechnique.h"

vtkShadowPassOfTechniqueMacro(vtkShadowVolumePass, "volume-hard");
vtkShadowTechniqueAutoInit(VTKSOFTSHADOWSSHADOWVOLUMES_EXPORT, vtkSoftShadowsShadowVolumes);

namespace
{
using Support = vtkShadowShapeSupport;

vtkShadowDeclaration Common()
{
  vtkShadowDeclaration t;
  t.Paper = "Crow, Shadow algorithms for computer graphics, SIGGRAPH 1977; Heidmann, Real shadows, "
            "real time, 1991; Zapotocky, Soft shadows on GPU, 2007, section 2.4";
  t.SetClasses<vtkShadowVolumeTechnique, vtkShadowVolumePass>("vtkShadowVolumePass");
  t.Traits.SignedShares = true;
  t.DebugViews = { "volumes" };
  t.Parameters = { vtkShadowParameter::Choice("counting", "auto",
    { "auto", "z-pass", "z-fail", "xor" },
    "Count the volumes' faces before the surface (z-pass), behind it (z-fail), or their parity "
    "before it (xor); auto: z-pass, and z-fail for casters whose volume the near rectangle may "
    "lie in") };
  t.Resources = { "on the CPU: adjacency, about 41 bytes a triangle of a closed mesh, once a mesh",
    "silhouettes, 8 bytes an edge and sample (16 of open meshes)",
    "where volumes are counted by z-fail: caps, 12 bytes a triangle",
    "receivers 16 bytes, their depth 4 bytes, that of volumes with the stencil 8 bytes, "
    "visibility 4 bytes a light (16 textured), each a pixel; 4 bytes more where more than 255 "
    "volumes may nest" };
  t.Limits = { "The cost is that of filling the volumes: it grows with silhouettes, pixels and "
               "samples.",
    "counting=z-pass is wrong where the eye is in a volume, or sees the inside of a body: from "
    "within, or through faces that are translucent, culled or clipped.",
    "counting=xor is wrong there too, where volumes overlap, and where two surfaces of an open "
    "mesh lie behind each other.",
    "Single pixels at silhouettes that light and eye share can be darker or lighter than the "
    "truth.",
    "Of translucent surfaces the nearest of a pixel receives; those behind it are drawn as if lit.",
    "Holes by alpha (alpha-threshold) within triangles cast as if they were filled; triangles "
    "that are clear all over cast nothing." };
  return t;
}

vtkShadowDeclaration Hard()
{
  vtkShadowDeclaration t = Common();
  t.Name = "volume-hard";
  t.Title = "Hard shadow volumes";
  t.LightShapes = { Support::Exact, Support::Approximate, Support::Approximate,
    Support::Approximate, Support::Exact, Support::Approximate };
  t.Limits.insert(t.Limits.begin(), "The light counts as its centre: there is no penumbra.");
  t.Traits.Hard = true;
  return t;
}

vtkShadowDeclaration Soft()
{
  vtkShadowDeclaration t = Common();
  t.Name = "volume-soft";
  t.Title = "Accumulated shadow volumes";
  t.Paper += " and chapter 5";
  t.Traits.SamplesLights = true;
  t.LightShapes = { Support::Exact, Support::Approximate, Support::Exact, Support::Exact,
    Support::Exact, Support::Exact };
  t.Parameters.insert(t.Parameters.begin(), vtkShadowParameter::Integer("samples", 64, 1, 1024,
                                              "Samples of the light, all volumes for each")
                                              .At({ 16, 32, 64, 1024 }));
  t.Parameters.push_back(vtkShadowParameter::Integer("memory", 512, 1, 65536,
    "Most that silhouettes may hold; those that do not fit are found anew in every frame")
                           .In("MiB"));
  t.Limits.insert(t.Limits.begin(),
    { "A sphere is its disk that faces the middle of the casters, not each receiver.",
      "Few samples show as steps: as many grey levels as samples." });
  return t;
}

const vtkShadowTechniqueRegistration hard(Hard());
const vtkShadowTechniqueRegistration soft(Soft());
}
