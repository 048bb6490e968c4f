// SPDX-License-Identifier: BSD-3-Clause
// The visibility of the last frame, for whoever asks a vtkShadowPass for it.

#include "vtkCuller.h"
#include "vtkCullerCollection.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLState.h"
#include "vtkPointData.h"
#include "vtkPropCollection.h"
#include "vtkShadowPassInternals.h"

#include <algorithm>
#include <chrono>
#include <vector>

namespace
{
//------------------------------------------------------------------------------
// The props that a frame of the renderer would draw: visible, and not taken out by its cullers, which
// take out what has no bounds, such as a prop whose mapper has no input.
std::vector<vtkProp*> GetDrawnProps(vtkRenderer* renderer)
{
  std::vector<vtkProp*> drawn;
  vtkCollectionSimpleIterator cookie;
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal(cookie);
  while (vtkProp* prop = props->GetNextProp(cookie))
  {
    if (prop->GetVisibility())
    {
      drawn.push_back(prop);
    }
  }
  int count = static_cast<int>(drawn.size());
  int initialized = 0;
  vtkCullerCollection* cullers = renderer->GetCullers();
  cullers->InitTraversal(cookie);
  while (vtkCuller* culler = count > 0 ? cullers->GetNextCuller(cookie) : nullptr)
  {
    culler->Cull(renderer, drawn.data(), count, initialized);
  }
  drawn.resize(count);
  return drawn;
}
}

//------------------------------------------------------------------------------
vtkImageData* vtkShadowPass::GetVisibility(vtkLight* light)
{
  if (vtkShadowPass* copy = this->Internal->At.Copy)
  {
    return copy->GetVisibility(light);
  }
  if (!this->UpdateVisibility())
  {
    return nullptr;
  }
  const auto lights = this->Internal->Stages.GetLights();
  if (std::find(lights.begin(), lights.end(), light) == lights.end())
  {
    vtkErrorMacro("GetVisibility: the light is not in the renderer, which has "
                  << std::to_string(lights.size()) << ".");
    return nullptr;
  }
  return this->MakeVisibility(light);
}

//------------------------------------------------------------------------------
vtkImageData* vtkShadowPass::GetVisibility(int light)
{
  if (vtkShadowPass* copy = this->Internal->At.Copy)
  {
    return copy->GetVisibility(light);
  }
  if (!this->UpdateVisibility())
  {
    return nullptr;
  }
  const auto lights = this->Internal->Stages.GetLights();
  const int count = static_cast<int>(lights.size());
  if (count == 0 && light == 0)
  {
    return this->MakeVisibility(nullptr); // nothing is lit
  }
  if (light < 0 || light >= count)
  {
    vtkErrorMacro(
      "GetVisibility: there is no light "
      << std::to_string(light) << ". "
      << (count == 0 ? "The renderer has none."
                     : "Those of the renderer are 0 to " + std::to_string(count - 1) + "."));
    return nullptr;
  }
  return this->MakeVisibility(lights[light]);
}

//------------------------------------------------------------------------------
bool vtkShadowPass::UpdateVisibility()
{
  Internals& my = *this->Internal;
  if (!my.At.Window || !my.At.Renderer || !my.At.Holding)
  {
    vtkErrorMacro("GetVisibility: there is no frame; render with this pass first.");
    return false;
  }
  my.At.Window->MakeCurrent();
  my.BufferAskedFor = true;
  vtkShadowScreen& screen = my.Stages.Opaque;
  if (!screen.Valid || my.HasCatchers)
  {
    // Of what is in the renderer now, whatever the frame showed.
    const auto drawn = GetDrawnProps(my.At.Renderer);
    my.Props.assign(drawn.begin(), drawn.end());
    vtkOpenGLState* state = my.At.Window->GetState();
    state->Push();
    my.ReleaseRetired(my.At.Window);
    vtkShadowFrame& frame = my.Stages.GetFrame();
    const auto counts = frame.Counts; // statistics are about the frame
    my.Active = this->PrepareShadows(my.At.Renderer, false);
    if (!my.Active)
    {
      frame.Parts.clear();
    }
    this->EvaluateVisibility(true);
    my.Stages.Finish();
    my.Props.clear();
    frame.Counts = counts;
    state->Pop();
  }
  return screen.Valid; // EvaluateVisibility has reported why not
}

//------------------------------------------------------------------------------
vtkImageData* vtkShadowPass::MakeVisibility(vtkLight* light)
{
  vtkShadowStages& stages = this->Internal->Stages;
  return this->Internal->Readback.Make(stages.GetFrame(), stages.Opaque, light, stages.GetLights());
}

//------------------------------------------------------------------------------
std::string vtkShadowPass::GetErrorEstimate(vtkLight* light)
{
  if (vtkShadowPass* copy = this->Internal->At.Copy)
  {
    return copy->GetErrorEstimate(light);
  }
  vtkImageData* visibility = this->GetVisibility(light);
  const auto lights = this->Internal->Stages.GetLights();
  const auto found = std::find(lights.begin(), lights.end(), light);
  return visibility ? this->EstimateError(visibility, static_cast<int>(found - lights.begin()))
                    : "";
}

//------------------------------------------------------------------------------
std::string vtkShadowPass::GetErrorEstimate(int light)
{
  if (vtkShadowPass* copy = this->Internal->At.Copy)
  {
    return copy->GetErrorEstimate(light);
  }
  vtkImageData* visibility = this->GetVisibility(light);
  return visibility ? this->EstimateError(visibility, light) : "";
}

//------------------------------------------------------------------------------
std::string vtkShadowPass::EstimateError(vtkImageData* visibility, int light)
{
  Internals& my = *this->Internal;
  if (!vtkShadowErrorEstimate::IsPossible())
  {
    vtkErrorMacro(
      "GetErrorEstimate: this program has no rays to compare with: the technique ray-traced "
      "is missing (module RayTracing, which needs Embree).");
    return "";
  }
  const auto start = std::chrono::steady_clock::now();
  const auto lights = my.Stages.GetLights();
  vtkOpenGLState* state = my.At.Window->GetState();
  state->Push();
  auto* values = vtkFloatArray::SafeDownCast(visibility->GetPointData()->GetScalars());
  const vtkShadowErrorEstimate::Shown shown = { { values->Begin(), values->End() },
    values->GetNumberOfComponents() };
  const bool asked = my.Error.Ask(my.Stages.GetFrame(), my.Stages.Opaque.Receivers, shown,
    lights.empty() ? nullptr : lights[light]);
  state->Pop();
  if (!asked)
  {
    return "";
  }
  auto json = my.Error.Judge(shown);
  json["milliseconds"] =
    std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  if (my.ErrorFrame != my.Frames)
  {
    my.Errors = nlohmann::ordered_json::object();
    my.ErrorFrame = my.Frames;
  }
  my.Errors[std::to_string(light)] = json;
  return json.dump(2);
}
