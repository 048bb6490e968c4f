// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAccumulatedShadowMapTechnique.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShadowFrame.h"
#include "vtkShadowMaps.h"
#include "vtkShadowOpenGL.h"
#include "vtkVisibilityBuffer.h"

//------------------------------------------------------------------------------
bool vtkAccumulatedShadowMapTechnique::UpdateLightData(vtkShadowFrame& frame)
{
  return this->UpdateMaps(
    frame, this->Settings.GetInteger("samples"), this->Settings.GetInteger("memory"));
}

//------------------------------------------------------------------------------
bool vtkAccumulatedShadowMapTechnique::CanEvaluateForward()
{
  return this->Maps->AreResident();
}

//------------------------------------------------------------------------------
void vtkAccumulatedShadowMapTechnique::FillVisibility(
  vtkShadowFrame& frame, vtkVisibilityBuffer& buffer)
{
  if (this->Maps->AreResident())
  {
    vtkDepthMapTechnique::FillVisibility(frame, buffer);
    return;
  }
  // Each batch takes its occlusion away from full visibility.
  buffer.Clear(frame);
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction(state);
  for (int batch = 0; batch < this->Maps->GetNumberOfBatches(); ++batch)
  {
    this->Maps->DrawBatch(frame, batch);
    this->Maps->Activate(frame);
    vtkShadowFramebuffer::Scope target(
      frame.Window, buffer.GetFramebuffer(), &buffer.GetTarget(), nullptr, 0);
    state->vtkglEnable(GL_BLEND);
    state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
    for (std::size_t i = 0; i < frame.Parts.size(); ++i)
    {
      const double share = this->Maps->GetBatchShare(static_cast<int>(i));
      if (share > 0.0)
      {
        target.SetLayer(static_cast<int>(i));
        this->DrawEvaluation(frame, buffer, static_cast<int>(i), share);
      }
    }
  }
  buffer.Resolve(frame);
}
