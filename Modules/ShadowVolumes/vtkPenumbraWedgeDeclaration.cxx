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
  t.LightShapes = { Support::Exact, Support::Approximate, Support::Approximate,
    Support::Approximate, Support::Approximate, Support::Unsupported };
  t.Parameters = { vtkShadowParameter::Choice("overlap", "sum", { "sum", "count" },
                     "How the edges' shares of a light add up: as if no caster hid what another hides "
                     "(sum), or by counts for each sample of the light (count)"),
    vtkShadowParameter::Integer("samples", 64, 1, 256, "Samples of the light that overlap=count counts for"),
    vtkShadowParameter::Integer("split", 1, 1, 4,
                     "The light's area is cut into split x split parts, each with silhouettes of "
                     "its own"),
    vtkShadowParameter::Choice("bounds", "tight", { "tight", "sphere" },
      "What bounds a wedge: the hull of the light's own corners, or four planes around a sphere "
      "that holds the light; the picture is the same") };
  t.Resources = { "on the CPU: adjacency, about 41 bytes a triangle of a closed mesh, once a mesh" };
  t.Limits = { "" };
  return t;
}

const vtkShadowTechniqueRegistration wedges(Wedges());
}
