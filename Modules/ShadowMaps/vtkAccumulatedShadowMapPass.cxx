#include "vtkAccumulatedShadowMapPass.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShadowFrame.h"
#include "vtkShadowMaps.h"
#include "vtkShadowVTKVersion.h"
#include "vtkVisibilityBuffer.h"

vtkStandardNewMacro(vtkAccumulatedShadowMapPass);

//------------------------------------------------------------------------------
vtkAccumulatedShadowMapPass::vtkAccumulatedShadowMapPass()
{
  this->SetTechnique("map-soft");
}

//------------------------------------------------------------------------------
bool vtkAccumulatedShadowMapPass::UpdateLightData(vtkShadowFrame& frame)
{
  return this->UpdateMaps(frame, this->GetInteger("samples"), this->GetReal("memory"));
}

//------------------------------------------------------------------------------
bool vtkAccumulatedShadowMapPass::CanEvaluateForward()
{
  return this->Maps->AreResident();
}

//------------------------------------------------------------------------------
void vtkAccumulatedShadowMapPass::FillVisibility(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer)
{
  if (this->Maps->AreResident())
  {
    this->Superclass::FillVisibility(frame, buffer);
    return;
  }
  // Each batch takes its occlusion away from full visibility.
  const float start[4] = { 1.0f, 1.0f, 1.0f, 1.0f };
  const float none[4] = { 0.0f, 0.0f, 0.0f, 0.0f };
  for (std::size_t i = 0; i < frame.Lights.size(); ++i)
  {
    vtkShadowFramebuffer::Scope target(
      frame.Window, buffer.GetFramebuffer(), &buffer.GetTarget(), nullptr, static_cast<int>(i));
    glClearBufferfv(GL_COLOR, 0, buffer.GetQuantity().empty() ? start : none);
  }
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
    for (std::size_t i = 0; i < frame.Lights.size(); ++i)
    {
      const double share = this->Maps->GetBatchShare(static_cast<int>(i));
      if (share > 0.0)
      {
        target.SetLayer(static_cast<int>(i));
        this->DrawEvaluation(frame, buffer, static_cast<int>(i), share);
      }
    }
  }
}
