// SPDX-License-Identifier: BSD-3-Clause
// The pass under the technique's name, and the technique's declaration.

#include "vtkOcclusionTexturePass.h"

#include "vtkObjectFactory.h"
#include "vtkOcclusionTextureTechnique.h"
#include "vtkShadowDeclaration.h"

vtkShadowPassOfTechniqueMacro(vtkOcclusionTexturePass, "occlusion-textures");
vtkShadowTechniqueAutoInit(VTKSOFTSHADOWSOCCLUSIONTEXTURES_EXPORT, vtkSoftShadowsOcclusionTextures);

namespace
{
vtkShadowParameter SliceCount()
{
  vtkShadowParameter parameter = vtkShadowParameter::Choice("slice-count", "16",
    { "4", "8", "12", "16" }, "Most slices that a light's casters are cut into");
  parameter.Presets = { "4", "8", "16", "16" };
  return parameter;
}

vtkShadowDeclaration OcclusionTextures()
{
  using Support = vtkShadowShapeSupport;
  vtkShadowDeclaration t;
  t.Name = "occlusion-textures";
  t.Title = "Occlusion textures";
  t.Paper =
    "Eisemann and Decoret, Occlusion textures for plausible soft shadows, Computer Graphics "
    "Forum 27(1), 2008";
  t.SetClasses<vtkOcclusionTextureTechnique, vtkOcclusionTexturePass>("vtkOcclusionTexturePass");
  t.Traits.Forward = true;
  t.LightShapes = { Support::Exact, Support::Approximate, Support::Approximate,
    Support::Approximate, Support::Approximate, Support::Approximate };
  t.Parameters = { SliceCount(),
    vtkShadowParameter::Choice("slices", "uniform", { "uniform", "adaptive" },
      "Slices of equal depth, or thinner where there is much to cast and near to what receives"),
    vtkShadowParameter::Choice("prefilter", "n-buffers", { "n-buffers", "mipmap", "summed-area" },
      "What means over rectangles are made of: boxes of all powers of two at every texel, mipmaps, "
      "or summed-area tables, which are exact"),
    vtkShadowParameter::Choice("combine", "product", { "product", "sum", "max", "bits" },
      "What several slices hide together: as if independent of each other, each another part, the "
      "same part; or what of some samples of the light any of them hides"),
    vtkShadowParameter::Integer("samples", 32, 1, 1024,
      "Samples of the light with combine=bits, and half as many at contacts")
      .At({ 16, 32, 32, 256 }),
    vtkShadowParameter::Boolean("double-projection", false,
      "Flatten each slice onto the next one's plane too, where surfaces are thin and light leaks "
      "between slices"),
    vtkShadowParameter::Integer("resolution", 0, 0, 16384,
      "Longer side of a texture, 16 at least (less counts as 16); 0: 512, or where no light has a "
      "size the power of two next to the picture's longer side, 2048 or 4096")
      .In("texels")
      .At({ 256, 0, 0, 1024 }),
    vtkShadowParameter::Boolean("skipping", true,
      "Leave out slices that hold nothing where a receiver looks; the picture is the same "
      "without") };
  t.DebugViews = { "slices", "levels", "kernel", "slices-read" };
  t.Resources = { "slices, 4 bytes a texel for every four, and 4 bytes of what is nearest, at most "
                  "resolution^2 each light (up to six where the light is among the casters)",
    "N-buffers, 4 bytes a texel each level for every four slices; mipmaps a third more than "
    "slices; summed-area tables 16 bytes a texel for every four slices; bits 4 bytes",
    "with evaluation=screen receivers 16 bytes, depth 4 bytes, visibility 4 bytes a light, each a "
    "pixel" };
  t.Limits = {
    "Disks, spheres and the sun count as the rectangle of equal second moments (half side "
    "0.866 of the radius), but with combine=bits.",
    "Within a slice all casters lie in its plane; slices are combined as if independent: what "
    "spans "
    "several of them is too dark (combine=bits cures that).",
    "In the receiver's own slice, and in part in the one above it, only what is nearest to the "
    "light hides.",
    "A textured light counts as evenly bright, but with combine=bits.",
    "A light among its casters is seen through six views, along whose borders its form changes a "
    "little; next to a wall around it some light leaks.",
    "A light's casters share one window: edges of shadows move by parts of a texel as other "
    "casters move."
  };
  return t;
}

const vtkShadowTechniqueRegistration registration(OcclusionTextures());
}
