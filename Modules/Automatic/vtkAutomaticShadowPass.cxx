// SPDX-License-Identifier: BSD-3-Clause
// The pass under the technique's name, and the technique's declaration.

#include "vtkAutomaticShadowPass.h"

#include "vtkAutomaticShadowTechnique.h"
#include "vtkObjectFactory.h"
#include "vtkShadowDeclaration.h"

vtkShadowPassOfTechniqueMacro(vtkAutomaticShadowPass, "auto");
vtkShadowTechniqueAutoInit(VTKSOFTSHADOWSAUTOMATIC_EXPORT, vtkSoftShadowsAutomatic);

namespace
{
vtkShadowDeclaration Automatic()
{
  vtkShadowDeclaration t;
  t.Name = "auto";
  t.Title = "Chosen by error and time";
  t.Paper = "the project's own: candidates are measured on the scene itself, their error by rays";
  t.SetClasses<vtkAutomaticShadowTechnique, vtkAutomaticShadowPass>("vtkAutomaticShadowPass");
  t.Traits.CameraDependent = true; // what it chooses may be
  t.Traits.Forward = true;
  t.LightShapes.fill(vtkShadowShapeSupport::Approximate);
  t.LightShapes[0] = vtkShadowShapeSupport::Exact;
  t.Parameters = {
    vtkShadowParameter::Real("error", 0.05, 0.0, 1.0,
      "RMSE of V in penumbrae that is wanted; the fastest is chosen that has it. 0: as "
      "small as time lets it be")
      .At({ 0.1, 0.1, 0.05, 0.02 }),
    vtkShadowParameter::Real("time", 0.0, 0.0, 10000.0,
      "What light data and visibility of a frame may take while anything moves; 0: as long as the "
      "error needs. With both, frames add up to the error once nothing moves")
      .In("ms")
  };
  t.Resources = { "what the chosen techniques hold, up to three" };
  t.Limits = { "The first frame, and each after a change in kind, takes as long as all candidates.",
    "Errors are told by rays: without the technique ray-traced none are known, and map-pcss is "
    "taken.",
    "What is drawn beside light data and visibility, such as receivers in screen space, is not in "
    "the time.",
    "Techniques for planes alone are not tried; hard ones only where no light has a size." };
  return t;
}

const vtkShadowTechniqueRegistration registration(Automatic());
}
