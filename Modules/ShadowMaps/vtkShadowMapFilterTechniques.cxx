// SPDX-License-Identifier: BSD-3-Clause
// The declarations of the techniques that soften one map a light.

#include "vtkBlurredShadowMapPass.h"
#include "vtkBlurredShadowMapTechnique.h"
#include "vtkCombinedShadowMapPass.h"
#include "vtkCombinedShadowMapTechnique.h"
#include "vtkJitteredShadowMapPass.h"
#include "vtkJitteredShadowMapTechnique.h"
#include "vtkPercentageCloserFilteringPass.h"
#include "vtkPercentageCloserFilteringTechnique.h"
#include "vtkPercentageCloserSoftShadowPass.h"
#include "vtkPercentageCloserSoftShadowTechnique.h"
#include "vtkShadowMapParameters.h"
#include "vtkTracedShadowMapPass.h"
#include "vtkTracedShadowMapTechnique.h"

namespace
{
using namespace vtkShadowMapParameters;
using Support = vtkShadowShapeSupport;

vtkShadowParameter Skipping()
{
  return vtkShadowParameter::Boolean("skipping", true,
    "Leave out look-ups where the depth pyramid tells that a receiver is fully lit or in umbra; a "
    "conservative test: the picture is the same without");
}

vtkShadowParameter Width()
{
  return vtkShadowParameter::Real("width", 0.16, 0, 4,
    "Assumed distance from blocker to receiver, as a share of the diameter of a sphere around the "
    "casters: penumbrae are as wide everywhere as that makes them")
    .In("of the casters' extent");
}

vtkShadowParameter Search(int value)
{
  return vtkShadowParameter::Integer(
    "search", value, 1, 256, "Points at which blockers are searched")
    .At({ 9, 16, static_cast<double>(value), 64 })
    .AtPreview(6);
}

vtkShadowParameter Blockers()
{
  return vtkShadowParameter::Choice("blockers", "layers", { "layers", "mean" },
    "Tell apart blockers at two depths, and search finer where none are found; or, as published, "
    "take all for "
    "one in their middle");
}

vtkShadowParameter Samples(int value, const std::vector<double>& presets)
{
  return vtkShadowParameter::Integer(
    "samples", value, 1, 1024, "Compares of a receiver in a penumbra")
    .At(presets)
    .AtPreview(8);
}

vtkShadowParameter JitteredSamples(int value, const std::vector<double>& presets)
{
  return vtkShadowParameter::Integer("samples", value, 4, 256,
    "Compares of a receiver in a penumbra, rounded up to whole rings; those of the outer ring "
    "decide whether it is in one")
    .At(presets);
}

vtkShadowParameter Branching()
{
  return vtkShadowParameter::Boolean("branching", true,
    "Leave out the inner rings where the outer one's compares agree; off: all compares of every "
    "receiver");
}

template <typename Technique, typename Pass>
vtkShadowDeclaration Make(
  const char* name, const char* title, const char* className, bool searches = false)
{
  vtkShadowDeclaration t;
  t.Name = name;
  t.Title = title;
  t.SetClasses<Technique, Pass>(className);
  t.Traits.Forward = true;
  t.DebugViews = { "map", "penumbra-width" };
  if (searches)
  {
    t.DebugViews.emplace_back("blocker-depth");
  }
  t.LightShapes = { Support::Exact, Support::Approximate, Support::Approximate,
    Support::Approximate, Support::Approximate, Support::Approximate };
  // Midpoints are nearer to the silhouettes, which make the penumbrae, than lit sides are, and looking
  // around finds less of the receiver itself.
  t.Parameters = { Resolution(), Filter("bilinear"), Midpoint(true), Faces(), Skipping() };
  t.Resources = {
    "depth map, 4 bytes a texel, resolution^2 each light (up to six where the light is "
    "among the casters); its pyramid, about 3 bytes a texel where resolution is a "
    "power of two",
    "with midpoint=on, 16 bytes a texel of one map",
    "with evaluation=screen receivers 16 bytes, depth 4 bytes, visibility 4 bytes a light, each a "
    "pixel"
  };
  t.Limits = { "One map from the light's centre: what only other points of the light see behind a "
               "caster's edge is missing.",
    "A textured light counts as evenly bright.",
    "A light among its casters: what it casts further than 31 degrees beyond a cube's face is "
    "drawn in." };
  return t;
}

constexpr const char* Constant =
  "Penumbrae are as wide at contacts as far from them, and do not follow the blocker.";
constexpr const char* TwoLayers = "Blockers at more than two depths over a receiver count as two; "
                                  "what is hidden behind others counts as likely "
                                  "as what shows beside.";

vtkShadowDeclaration Filtering()
{
  auto t = Make<vtkPercentageCloserFilteringTechnique, vtkPercentageCloserFilteringPass>(
    "map-pcf", "Percentage-closer filtering", "vtkPercentageCloserFilteringPass");
  t.Paper =
    "Reeves, Salesin and Cook, Rendering antialiased shadows with depth maps, SIGGRAPH 1987; "
    "Zapotocky, Soft shadows on GPU, 2007, section 3.2";
  t.Parameters.push_back(
    vtkShadowParameter::Integer("kernel", 7, 1, 31, "Compares along either side of the kernel")
      .At({ 3, 5, 7, 15 }));
  t.Parameters.push_back(Width());
  t.Limits.insert(t.Limits.end(), { Constant });
  return t;
}

vtkShadowDeclaration Blurred()
{
  auto t = Make<vtkBlurredShadowMapTechnique, vtkBlurredShadowMapPass>(
    "map-blur", "Blurred shadow mask", "vtkBlurredShadowMapPass");
  t.Paper = "Shastry, Soft-edged shadows, 2005; Zapotocky, Soft shadows on GPU, 2007, section 3.3";
  t.Parameters.push_back(vtkShadowParameter::Choice("blur", "aware", { "aware", "plain" },
    "Aware of depth and normal, as wide as the light's footprint; or plain, 15 pixels wide, with "
    "the thesis's halo"));
  t.Parameters.push_back(Width());
  t.Resources.back() =
    "receivers 16 bytes, depth 4 bytes, visibility 4 bytes a light, two masks of 4 "
    "bytes, each a pixel";
  t.Limits.insert(t.Limits.end(),
    { Constant,
      "What is not in the picture is not blurred into it: penumbrae change at its border.",
      "Of translucent surfaces the nearest of a pixel receives from lights with a size: the blur "
      "is "
      "in screen space." });
  return t;
}

vtkShadowDeclaration Jittered()
{
  auto t = Make<vtkJitteredShadowMapTechnique, vtkJitteredShadowMapPass>(
    "map-jitter", "Jittered filtering with branching", "vtkJitteredShadowMapPass");
  t.Paper = "Uralsky, Efficient soft-edged shadows using pixel shader branching, GPU Gems 2, 2005, "
            "chapter 17; Zapotocky, Soft shadows on GPU, 2007, section 3.4";
  t.Parameters.push_back(JitteredSamples(64, { 16, 32, 64, 256 }));
  t.Parameters.push_back(Branching());
  t.Parameters.push_back(Width());
  t.Resources.push_back("jittered points, 16 bytes, 256 x samples");
  t.Limits.insert(t.Limits.end(),
    { Constant, "Noise instead of steps; a thin shadow that the outer ring misses is missed." });
  return t;
}

vtkShadowDeclaration SoftShadows()
{
  auto t = Make<vtkPercentageCloserSoftShadowTechnique, vtkPercentageCloserSoftShadowPass>(
    "map-pcss", "Percentage-closer soft shadows", "vtkPercentageCloserSoftShadowPass", true);
  t.Paper = "Fernando, Percentage-closer soft shadows, SIGGRAPH 2005 sketches; Zapotocky, Soft "
            "shadows on GPU, 2007, section 3.5";
  t.Parameters.push_back(Blockers());
  t.Parameters.push_back(Search(25));
  t.Parameters.push_back(Samples(64, { 16, 32, 64, 256 }));
  t.Limits.insert(t.Limits.end(), { TwoLayers });
  return t;
}

vtkShadowDeclaration Combined()
{
  auto t = Make<vtkCombinedShadowMapTechnique, vtkCombinedShadowMapPass>("map-combined",
    "Combined: blocker search and jittered filtering", "vtkCombinedShadowMapPass", true);
  t.Paper = "Zapotocky, Soft shadows on GPU, 2007, section 4.4.3";
  t.Parameters.push_back(Blockers());
  t.Parameters.push_back(Search(16));
  t.Parameters.push_back(JitteredSamples(32, { 16, 32, 32, 256 }));
  t.Parameters.push_back(Branching());
  t.Resources.push_back("jittered points, 16 bytes, 256 x samples");
  t.Limits.insert(t.Limits.end(),
    { TwoLayers, "Noise instead of steps; a thin shadow that the outer ring misses is missed." });
  return t;
}

vtkShadowDeclaration Traced()
{
  auto t = Make<vtkTracedShadowMapTechnique, vtkTracedShadowMapPass>(
    "map-trace", "Rays followed through a depth map", "vtkTracedShadowMapPass", true);
  t.Paper = "Shadow map ray tracing of Unreal Engine 5 (virtual shadow maps) and of EEVEE (Blender "
            "4.2); Tevs, "
            "Ihrke and Seidel, Maximum mipmaps for fast, accurate, and scalable dynamic height "
            "field rendering, "
            "I3D 2008; Keller and Heidrich, Interleaved sampling, EGRW 2001";
  t.Parameters = { Resolution(), Filter("bilinear"), Skipping(),
    vtkShadowParameter::Integer("samples", 16, 1, 256,
      "Rays of a receiver to points of the light; other ones in each of 16 pixels")
      .In("rays")
      .At({ 8, 16, 16, 64 }),
    vtkShadowParameter::Boolean("denoise", true,
      "Take the mean over 16 pixels of what lies on the same surface, in screen space; off: each "
      "pixel by itself, "
      "with noise, forward too") };
  t.Resources[1] = "slabs, 16 bytes a texel of each map and 20 of one";
  t.Resources.back() =
    "with denoise=on or evaluation=screen receivers 16 bytes, depth 4 bytes, visibility 4 bytes "
    "a light (16 textured), a mask as one light's, each a pixel";
  t.Limits = { "One map from the light's centre: of what lies behind the first body, the rays that "
               "cross it know "
               "no more than that a surface beside it goes on.",
    "A light among its casters: what it casts further than 31 degrees beyond a cube's face is "
    "missing.",
    "Of translucent surfaces the nearest of a pixel receives; with denoise=off and "
    "evaluation=forward all do." };
  return t;
}

const vtkShadowTechniqueRegistration filtering(Filtering());
const vtkShadowTechniqueRegistration blurred(Blurred());
const vtkShadowTechniqueRegistration jittered(Jittered());
const vtkShadowTechniqueRegistration softShadows(SoftShadows());
const vtkShadowTechniqueRegistration combined(Combined());
const vtkShadowTechniqueRegistration traced(Traced());
}
