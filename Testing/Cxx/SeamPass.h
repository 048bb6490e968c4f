// SPDX-License-Identifier: BSD-3-Clause
// A technique of a test's own, on a stage.

#ifndef SeamPass_h
#define SeamPass_h

#include "ShadowStage.h"

#include "vtkShadowDeclaration.h"
#include "vtkShadowPass.h"
#include "vtkShadowTechniques.h"

/** Register a technique under a name, and give the stage a pass that has it. */
template <typename Technique>
vtkShadowPass* SetPass(ShadowStage& stage, const char* name, const vtkShadowTraits& traits)
{
  vtkShadowDeclaration declaration;
  declaration.Name = name;
  declaration.SetClasses<Technique, vtkShadowPass>("vtkShadowPass");
  declaration.Traits = traits;
  const vtkShadowTechniqueRegistration registration(declaration);
  stage.Pass.TakeReference(vtkShadowTechniques::Create(name));
  stage.Pass->SetParameter("terminator", "facets");
  stage.Renderer->SetPass(stage.Pass);
  return stage.Pass;
}

#endif
