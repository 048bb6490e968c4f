// SPDX-License-Identifier: BSD-3-Clause
// The declarations of the family's techniques.

#include "vtkPlanarShadowPass.h"
#include "vtkPlanarShadowTechnique.h"
#include "vtkShadowDeclaration.h"

vtkShadowTechniqueAutoInit(VTKSOFTSHADOWSPLANARSHADOWS_EXPORT, vtkSoftShadowsPlanarShadows);

namespace
{
using Kind = vtkPlanarShadowTechnique::Kind;
using Support = vtkShadowShapeSupport;

vtkShadowParameter Planes()
{
  return vtkShadowParameter::Integer("planes", 4, 1, 16,
    "Most planes that receive: the user's, or those of flat props, the largest first");
}

vtkShadowParameter Resolution()
{
  return vtkShadowParameter::Integer("resolution", 1024, 0, 16384,
    "Side of a plane's layer, 16 at least (less counts as 16); 0: the power of two next to the "
    "picture's longer side, 512 to 4096")
    .In("texels")
    .At({ 512, 1024, 1024, 2048 });
}

/** What all three cannot do. */
std::vector<std::string> Limits(std::vector<std::string> others)
{
  std::vector<std::string> limits = {
    "Only planes receive: curved surfaces and the faces of bodies have visibility 1, so that "
    "nothing shadows itself or another body.",
    "Planes beyond the parameter planes have visibility 1; the statistics name them "
    "(planesLeftOut).",
    "Of a flat prop that does not cast the plane is found only where it lies along the axes of "
    "its points; else it is to be given (AddPlane).",
  };
  limits.insert(limits.end(), others.begin(), others.end());
  return limits;
}

vtkShadowDeclaration Declare(const char* name, const char* title, const char* part, Kind kind)
{
  vtkShadowDeclaration t;
  t.Name = name;
  t.Title = title;
  t.Paper = std::string("Blinn, Me and my (fake) shadow, IEEE Computer Graphics and "
                        "Applications 8(1), 1988; Zapotocky, Soft shadows on GPU, 2007, section "
                        "2.2 (equations 2.1 to 2.4)") +
            part;
  t.SetClasses<vtkPlanarShadowTechnique, vtkPlanarShadowPass>("vtkPlanarShadowPass", kind);
  t.Traits.PlanarReceivers = true;
  t.Traits.Forward = true;
  t.DebugViews = { "map" };
  return t;
}

vtkShadowDeclaration Hard()
{
  vtkShadowDeclaration t =
    Declare("planar-hard", "Hard shadows projected onto planes", "", Kind::Hard);
  t.LightShapes = { Support::Exact, Support::Approximate, Support::Approximate,
    Support::Approximate, Support::Exact, Support::Approximate };
  t.Parameters = { Planes() };
  t.Resources = { "mask, 1 byte a pixel each light and plane that casters darken" };
  t.Limits = Limits({ "The light counts as its centre: there is no penumbra.",
    "The masks are drawn anew for each camera.",
    "With several samples a pixel, a shadow's edge is decided once for the pixel." });
  t.Traits.Hard = true;
  t.Traits.CameraDependent = true;
  return t;
}

vtkShadowDeclaration Soft()
{
  vtkShadowDeclaration t = Declare("planar-soft", "Accumulated shadows projected onto planes",
    " and chapter 5 (projective soft)", Kind::Soft);
  t.Traits.SamplesLights = true;
  t.LightShapes = { Support::Exact, Support::Approximate, Support::Exact, Support::Exact,
    Support::Exact, Support::Exact };
  t.Parameters = { vtkShadowParameter::Integer(
                     "samples", 64, 1, 1024, "Samples of the light, each projected once")
                     .At({ 16, 32, 64, 1024 }),
    Resolution(), Planes() };
  t.Resources = { "visibility, 4 bytes (16 textured) a texel, resolution^2 each light and plane "
                  "that casters darken",
    "stencil, 4 bytes a texel, resolution^2 once" };
  t.Limits = Limits({ "A sphere is its disk that faces the middle of the shadow, not each "
                      "receiver.",
    "Few samples show as steps: as many grey levels as samples.",
    "Edges are as sharp as a texel of the layer." });
  return t;
}

vtkShadowDeclaration Fake()
{
  vtkShadowDeclaration t = Declare("planar-fake", "Filtered shadows projected onto planes",
    " and chapter 5 (projective fake: PCF 7 x 7 on a saved texture)", Kind::Fake);
  t.LightShapes = { Support::Exact, Support::Approximate, Support::Approximate,
    Support::Approximate, Support::Approximate, Support::Approximate };
  t.Parameters = { vtkShadowParameter::Integer(
                     "kernel", 7, 1, 31, "Taps a side, both to find the blockers and to filter")
                     .In("taps")
                     .At({ 5, 7, 7, 15 }),
    Resolution(), Planes() };
  t.Resources = { "coverage and spread with levels, 10.7 bytes a texel, resolution^2 each light "
                  "and plane that casters darken" };
  t.Limits = Limits({ "One shadow, from the light's centre, stands for all: behind casters at "
                      "several heights, or of a light among its casters, the penumbra is that of "
                      "their mean.",
    "A textured light counts as evenly bright; one that reaches through a plane is on its "
    "centre's side.",
    "Edges are as sharp as a texel of the layer." });
  return t;
}

const vtkShadowTechniqueRegistration hard(Hard());
const vtkShadowTechniqueRegistration soft(Soft());
const vtkShadowTechniqueRegistration fake(Fake());
}
