// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowTechnique.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkShadowEvaluateFS.h"
#include "vtkShadowFrame.h"
#include "vtkShadowGL.h"
#include "vtkShadowOpenGL.h"
#include "vtkVisibilityBuffer.h"

//------------------------------------------------------------------------------
vtkShadowTechnique::vtkShadowTechnique(const vtkShadowSettings& settings)
  : Settings(settings)
{
}

//------------------------------------------------------------------------------
vtkShadowTechnique::~vtkShadowTechnique() = default;

//------------------------------------------------------------------------------
void vtkShadowTechnique::FillVisibility(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer)
{
  vtkShadowFramebuffer::Scope target(
    frame.Window, buffer.GetFramebuffer(), &buffer.GetTarget(), nullptr, 0);
  for (int i = 0; i < static_cast<int>(frame.Parts.size()); ++i)
  {
    target.SetLayer(i);
    this->DrawEvaluation(frame, buffer, i);
  }
}

//------------------------------------------------------------------------------
void vtkShadowTechnique::Evaluate(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer)
{
  const bool isSigned = this->GetTraits().SignedShares;
  this->Activate(frame);
  if (isSigned)
  {
    buffer.Clear(frame);
  }
  this->FillVisibility(frame, buffer);
  if (isSigned)
  {
    buffer.Resolve(frame);
  }
  this->Deactivate(frame);
}

//------------------------------------------------------------------------------
void vtkShadowTechnique::DrawEvaluation(
  vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int light, double share)
{
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  state->vtkglDisable(GL_DEPTH_TEST);
  const std::string& quantity = buffer.GetQuantity();
  const std::string definitions =
    (quantity.empty() ? "" : "#define SHADOW_QUANTITY " + quantity + "\n") +
    (share > 0.0 ? "#define SHADOW_OUTPUT_CHANGE\n" : "");
  std::string source = vtkShadowEvaluateFS;
  vtkShaderProgram::Substitute(source, "//SHADOW::Declarations",
    frame.GetLightsGLSL(definitions) + vtkShadowReceivers::GetGLSL() + this->GetVisibilityGLSL());
  vtkShadowTexture& receivers = buffer.GetReceivers().GetTexture();
  receivers.Activate(frame.Window);
  frame.Quad->Draw(frame.Window, source,
    [&](vtkShaderProgram* program)
    {
      program->SetUniformi("shadowReceivers", receivers.GetUnit());
      program->SetUniformi("shadowLight", light);
      program->SetUniformf("shadowShare", static_cast<float>(share));
      frame.SetLights(program);
      this->SetVisibilityParameters(program);
    });
  receivers.Deactivate(frame.Window);
}

//------------------------------------------------------------------------------
vtkShadowTraits vtkShadowTechnique::GetTraits()
{
  return this->Settings.GetDeclaration()->Traits;
}

//------------------------------------------------------------------------------
int vtkShadowTechnique::GetSamples()
{
  return this->GetTraits().SamplesLights ? this->Settings.GetInteger("samples") : 0;
}

//------------------------------------------------------------------------------
int vtkShadowTechnique::GetWantedSamples()
{
  return this->Settings.GetBoolean("accumulate") && this->GetSamples() > 0
           ? this->Settings.GetInteger("accumulate-samples")
           : 0;
}

//------------------------------------------------------------------------------
std::string vtkShadowTechnique::GetDebugQuantity(const std::string& view)
{
  return view == "cost" ? "shadowCost" : "";
}
