// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowDebugViews.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkShadowDebugFS.h"
#include "vtkShadowDeclaration.h"
#include "vtkShadowFrame.h"
#include "vtkShadowGL.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowScreen.h"
#include "vtkShadowTechnique.h"

#include <algorithm>

namespace
{
/** The largest value of a quantity, over all parts of lights. */
double FindLargest(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer)
{
  double largest = 0.0;
  for (int i = 0; i < static_cast<int>(frame.Parts.size()); ++i)
  {
    const auto values = buffer.ReadTarget(frame.Window, i);
    largest = std::max<double>(largest, *std::max_element(values.begin(), values.end()));
  }
  return largest;
}

void SetParts(vtkShaderProgram* program, const vtkShadowFrame& frame)
{
  const int count = static_cast<int>(frame.Parts.size());
  int slots[vtkShadowFrame::MostParts] = {};
  float shares[vtkShadowFrame::MostParts] = {};
  for (int i = 0; i < count; ++i)
  {
    slots[i] = frame.Parts[i].Light.Slot;
    shares[i] = static_cast<float>(frame.Parts[i].Share);
  }
  program->SetUniformi("shadowParts", count);
  program->SetUniform1iv("shadowSlots", count, slots);
  program->SetUniform1fv("shadowShares", count, shares);
}
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkShadowDebugViews::GetNames(const vtkShadowDeclaration* declaration)
{
  std::vector<std::string> names = { "none", "visibility", "penumbra", "cost" };
  if (declaration)
  {
    names.insert(names.end(), declaration->DebugViews.begin(), declaration->DebugViews.end());
  }
  return names;
}

//------------------------------------------------------------------------------
void vtkShadowDebugViews::Draw(vtkShadowFrame& frame, vtkShadowTechnique& technique,
  vtkShadowScreen& screen, const std::string& view)
{
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  vtkVisibilityBuffer& buffer = screen.Visibility;
  const std::string quantity = technique.GetDebugQuantity(view);
  const bool penumbra = view == "penumbra";
  if (quantity.empty() && !penumbra && view != "visibility")
  {
    technique.DrawDebugView(frame, view);
    return;
  }
  double white = 1.0;
  if (!quantity.empty())
  {
    buffer.SetQuantity(frame.Window, quantity);
    technique.Evaluate(frame, buffer);
    white = view == "cost" ? technique.GetMaximumCost() : FindLargest(frame, buffer);
    frame.Counts["debugViewWhite"] = white;
  }
  int viewport[4];
  state->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  std::string source = vtkShadowDebugFS;
  vtkShaderProgram::Substitute(source, "//SHADOW::Declarations", frame.GetLightsGLSL());
  screen.Activate(frame.Window);
  frame.Quad->Draw(frame.Window, source,
    [&](vtkShaderProgram* program)
    {
      program->SetUniformi("shadowReceivers", screen.Receivers.GetTexture().GetUnit());
      program->SetUniformi("shadowBuffer", buffer.GetTarget().GetUnit());
      program->SetUniform2i("shadowOrigin", viewport);
      SetParts(program, frame);
      program->SetUniformi("shadowView", quantity.empty() ? (penumbra ? 1 : 0) : 2);
      program->SetUniformf("shadowScale", white > 0.0 ? static_cast<float>(1.0 / white) : 0.0f);
    });
  screen.Deactivate(frame.Window);
  buffer.SetQuantity(frame.Window, "");
}
