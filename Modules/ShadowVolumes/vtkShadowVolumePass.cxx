#include "vtkShadowVolumePass.h"

#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkShadowFrame.h"
#include "vtkShadowVTKVersion.h"
#include "vtkShadowVolumeSurfaceFS.h"
#include "vtkShadowVolumes.h"
#include "vtkVisibilityBuffer.h"

#include <algorithm>

vtkStandardNewMacro(vtkShadowVolumePass);

//------------------------------------------------------------------------------
vtkShadowVolumePass::vtkShadowVolumePass()
  : Volumes(new vtkShadowVolumes)
{
  this->SetTechnique("volume-hard");
}

//------------------------------------------------------------------------------
vtkShadowVolumePass::~vtkShadowVolumePass()
{
  this->Detach();
}

//------------------------------------------------------------------------------
bool vtkShadowVolumePass::UpdateLightData(vtkShadowFrame& frame)
{
  using Counting = vtkShadowVolumeSettings::Counting;
  vtkShadowVolumeSettings settings;
  const std::string counting = this->GetText("counting");
  settings.Method = counting == "z-pass"   ? Counting::ZPass
                    : counting == "z-fail" ? Counting::ZFail
                    : counting == "xor"    ? Counting::Xor
                                           : Counting::Auto;
  if (this->HasParameter("samples"))
  {
    settings.Samples = this->GetInteger("samples");
    settings.MemoryLimit = static_cast<std::size_t>(this->GetReal("memory") * 1048576.0);
  }
  this->Volumes->Update(frame, settings);
  if (const std::size_t count = frame.Casters->GetNumberWithHoles())
  {
    this->WarnOnce(std::to_string(count) +
                   " casters have holes by alpha within their triangles, which silhouettes do not "
                   "know: only triangles that are clear all over cast nothing.");
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkShadowVolumePass::FillVisibility(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer)
{
  const bool cost = !buffer.GetQuantity().empty();
  const float start[] = { 1.0f, 1.0f, 1.0f, 1.0f };
  const float none[] = { 0.0f, 0.0f, 0.0f, 0.0f };
  std::string surface = vtkShadowVolumeSurfaceFS;
  vtkShaderProgram::Substitute(surface, "//SHADOW::Declarations", this->GetLightsGLSL());
  vtkOpenGLState* state = frame.Window->GetState();
  this->MostFaces = 0.0;
  const bool counts = this->Volumes->UpdateDepth(frame, buffer);
  bool whole = true;
  for (int i = 0; i < static_cast<int>(frame.Lights.size()); ++i)
  {
    {
      vtkShadowFramebuffer::Scope target(
        frame.Window, buffer.GetFramebuffer(), &buffer.GetTarget(), nullptr, i);
      glClearBufferfv(GL_COLOR, 0, cost ? none : start);
    }
    const int samples = counts ? static_cast<int>(this->Volumes->GetSamples(i).size()) : 0;
    for (int sample = 0; sample < samples; ++sample)
    {
      if (cost)
      {
        this->Volumes->AddFaces(frame, buffer, i, sample);
      }
      else
      {
        whole = this->Volumes->Subtract(frame, buffer, i, sample) && whole;
      }
    }
    if (cost)
    {
      const auto faces = buffer.ReadTarget(frame.Window, i);
      this->MostFaces =
        std::max<double>(this->MostFaces, *std::max_element(faces.begin(), faces.end()));
      continue;
    }
    vtkShadowFramebuffer::Scope target(
      frame.Window, buffer.GetFramebuffer(), &buffer.GetTarget(), nullptr, i);
    vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
    state->vtkglDisable(GL_DEPTH_TEST);
    buffer.GetReceivers().Activate(frame.Window);
    this->DrawQuad(surface,
      [&](vtkShaderProgram* program)
      {
        program->SetUniformi("shadowReceivers", buffer.GetReceivers().GetUnit());
        program->SetUniformi("shadowLight", i);
        this->SetLightParameters(program);
      });
    buffer.GetReceivers().Deactivate(frame.Window);
  }
  const std::string size =
    std::to_string(buffer.GetWidth()) + " x " + std::to_string(buffer.GetHeight()) + " pixels";
  if (!counts)
  {
    this->ErrorOnce("no memory for the depth of " + size + "; drawn without shadows.");
  }
  else if (!whole)
  {
    this->ErrorOnce("no memory for wide counts of " + size +
                    "; where a multiple of 256 volumes nest, they are drawn as light.");
  }
}

//------------------------------------------------------------------------------
double vtkShadowVolumePass::GetMaximumCost()
{
  return this->MostFaces;
}

//------------------------------------------------------------------------------
std::string vtkShadowVolumePass::GetDebugViews()
{
  return this->Superclass::GetDebugViews() + " volumes";
}

//------------------------------------------------------------------------------
void vtkShadowVolumePass::DrawDebugView(vtkShadowFrame& frame, const std::string&)
{
  for (int i = 0; i < static_cast<int>(frame.Lights.size()); ++i)
  {
    if (!this->Volumes->GetSamples(i).empty())
    {
      this->Volumes->DrawView(frame, i, 0);
    }
  }
}

//------------------------------------------------------------------------------
void vtkShadowVolumePass::ReleaseLightData(vtkRenderWindow* window)
{
  this->Volumes->Release(vtkOpenGLRenderWindow::SafeDownCast(window));
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::size_t>> vtkShadowVolumePass::GetLightDataBytes()
{
  return this->Volumes->GetBytes();
}
