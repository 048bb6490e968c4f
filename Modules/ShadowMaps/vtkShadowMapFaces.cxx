// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowMapFaces.h"

#include "vtkOpenGLState.h"
#include "vtkShadowCasters.h"
#include "vtkShadowMesh.h"
#include "vtkShadowOpenGL.h"

#include <glm/matrix.hpp>

//------------------------------------------------------------------------------
vtkShadowMapFaces::Which vtkShadowMapFaces::Read(const std::string& choice)
{
  return choice == "front" ? Which::Front : choice == "back" ? Which::Back : Which::Both;
}

//------------------------------------------------------------------------------
vtkShadowMapFaces::vtkShadowMapFaces(
  vtkOpenGLState* state, Which which, const glm::dmat4& SWCToClip)
  : State(state)
{
  if (which == Which::Both)
  {
    return;
  }
  this->How.SetCasterParameters = [=](vtkShaderProgram*, const vtkShadowCaster& caster)
  {
    if (caster.Mesh->Sheet)
    {
      state->vtkglDisable(GL_CULL_FACE);
      return;
    }
    state->vtkglEnable(GL_CULL_FACE);
    // The usual projection has a negative determinant, and shows fronts counterclockwise.
    const bool usual = glm::determinant(SWCToClip * caster.MeshToSWC) < 0.0;
    state->vtkglCullFace(usual == (which == Which::Front) ? GL_BACK : GL_FRONT);
  };
}

//------------------------------------------------------------------------------
vtkShadowMapFaces::~vtkShadowMapFaces()
{
  if (this->How.SetCasterParameters)
  {
    this->State->vtkglCullFace(GL_BACK);
    this->State->vtkglDisable(GL_CULL_FACE);
  }
}
