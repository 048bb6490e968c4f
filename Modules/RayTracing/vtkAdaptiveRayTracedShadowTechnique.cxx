// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAdaptiveRayTracedShadowTechnique.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkShadowFrame.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowRayFront.h"
#include "vtkShadowScatterFS.h"
#include "vtkShadowScatterVS.h"
#include "vtkShadowSelectUnknownGS.h"
#include "vtkVisibilityBuffer.h"

#include <algorithm>
#include <chrono>

namespace
{
using Clock = std::chrono::steady_clock;

double GetMilliseconds(Clock::time_point start)
{
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/** What a pixel gets: its visibility, or what it took. */
glm::vec3 GetValue(const vtkVisibilityBuffer& buffer, const vtkShadowRaySeen& seen, bool textured)
{
  return buffer.GetQuantity().empty() ? seen.GetVisibility(textured)
                                      : glm::vec3(static_cast<float>(seen.Samples));
}

constexpr int LeastResolution = 16;
constexpr int AutomaticResolution = 1024;
}

//------------------------------------------------------------------------------
bool vtkAdaptiveRayTracedShadowTechnique::UpdateLightData(vtkShadowFrame& frame)
{
  if (!this->vtkRayTracedShadowTechnique::UpdateLightData(frame))
  {
    return false;
  }
  this->Bounds.Update(frame, frame.ChooseResolution(this->Settings.GetInteger("map-resolution"),
                               LeastResolution, AutomaticResolution));
  return true;
}

//------------------------------------------------------------------------------
std::string vtkAdaptiveRayTracedShadowTechnique::GetVisibilityGLSL()
{
  return vtkShadowDepthBounds::GetGLSL();
}

//------------------------------------------------------------------------------
void vtkAdaptiveRayTracedShadowTechnique::Activate(vtkShadowFrame& frame)
{
  this->Bounds.Activate(frame);
}

//------------------------------------------------------------------------------
void vtkAdaptiveRayTracedShadowTechnique::Deactivate(vtkShadowFrame& frame)
{
  this->Bounds.Deactivate(frame);
}

//------------------------------------------------------------------------------
void vtkAdaptiveRayTracedShadowTechnique::SetVisibilityParameters(vtkShaderProgram* program)
{
  this->Bounds.SetParameters(program);
}

//------------------------------------------------------------------------------
void vtkAdaptiveRayTracedShadowTechnique::FillVisibility(
  vtkShadowFrame& frame, vtkVisibilityBuffer& buffer)
{
  auto start = Clock::now();
  // What is known; the rest is -1.
  this->vtkRayTracedShadowTechnique::vtkShadowTechnique::FillVisibility(frame, buffer);
  const std::string selection = this->Settings.GetChoice("selection");
  const bool onGPU = selection == "gpu" || (selection == "auto" && !frame.IsSoftware);
  const std::size_t parts = frame.Parts.size();
  const double error = this->Settings.GetReal("error");
  const auto steps = vtkShadowRayFront::GetSteps(this->Settings.GetInteger("samples"), error > 0.0);
  if (onGPU && parts > 0)
  {
    this->Select(frame, buffer, 0);
  }
  for (std::size_t i = 0; i < parts; ++i)
  {
    if (onGPU && i + 1 < parts)
    {
      this->Select(frame, buffer, i + 1); // while this part is traced
    }
    const auto& chosen = onGPU ? this->Selections[i % 2].Finish() : this->Choose(frame, buffer, i);
    Receivers receivers(chosen.size());
    vtkShadowRayTracer::ForAll(chosen.size(), 1024,
      [&](std::size_t first, std::size_t end)
      {
        for (std::size_t k = first; k < end; ++k)
        {
          receivers[k] = MakeReceiver(frame, chosen[k].Receiver, chosen[k].Number);
        }
      });
    this->FindPositions(frame, buffer.GetWidth(), buffer.GetHeight(), receivers);
    const vtkShadowRayTracer::Target target = this->GetTarget(frame, i, steps);
    vtkShadowRayFront front(
      *this->Tracer, target, buffer.GetWidth(), buffer.GetHeight(), receivers);
    const double setUp = GetMilliseconds(start);
    start = Clock::now();
    front.Trace(error);
    if (buffer.GetQuantity().empty())
    {
      CountRays(frame, front.GetRays(), GetMilliseconds(start));
      frame.Counts["setUpMilliseconds"] += setUp;
      frame.Counts["pixelsTraced"] += static_cast<double>(receivers.size());
      frame.Counts["pixelsRefined"] += static_cast<double>(front.GetRefined());
    }
    start = Clock::now();
    if (onGPU)
    {
      this->Scatter(frame, buffer, i, receivers, front.GetSeen());
    }
    else
    {
      this->PutBack(frame, buffer, i, receivers, front.GetSeen());
    }
  }
}

//------------------------------------------------------------------------------
void vtkAdaptiveRayTracedShadowTechnique::Select(
  vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, std::size_t part)
{
  vtkShadowTimers::Scope timer(*frame.Timers, "selection");
  vtkShadowTexture& known = buffer.GetTarget();
  known.Activate(frame.Window);
  this->Selections[part % 2].Start(frame, buffer.GetReceivers(), vtkShadowSelectUnknownGS,
    [&](vtkShaderProgram* program)
    {
      program->SetUniformi("shadowKnown", known.GetUnit());
      program->SetUniformi("shadowLayer", static_cast<int>(part));
    });
  known.Deactivate(frame.Window);
}

//------------------------------------------------------------------------------
const std::vector<vtkShadowSelection::Pixel>& vtkAdaptiveRayTracedShadowTechnique::Choose(
  vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, std::size_t part)
{
  if (part == 0)
  {
    this->Texels = &buffer.GetReceivers().Read(frame.Window);
  }
  this->Known = buffer.ReadTarget(frame.Window, static_cast<int>(part));
  const std::size_t components = this->Known.size() / this->Texels->size();
  this->Chosen.clear();
  for (std::size_t i = 0; i < this->Texels->size(); ++i)
  {
    const glm::vec4& texel = (*this->Texels)[i];
    if (this->Known[components * i] < 0.0f && vtkShadowReceiver::IsOne(texel))
    {
      this->Chosen.push_back({ texel, static_cast<std::int32_t>(i) });
    }
  }
  return this->Chosen;
}

//------------------------------------------------------------------------------
void vtkAdaptiveRayTracedShadowTechnique::PutBack(vtkShadowFrame& frame,
  vtkVisibilityBuffer& buffer, std::size_t part, const Receivers& receivers,
  const std::vector<vtkShadowRaySeen>& seen)
{
  const bool textured = frame.Parts[part].Light.Emission != nullptr;
  const std::size_t components = this->Known.size() / this->Texels->size();
  for (std::size_t i = 0; i < receivers.size(); ++i)
  {
    const glm::vec3 value = GetValue(buffer, seen[i], textured);
    float* known = &this->Known[components * static_cast<std::size_t>(receivers[i].Pixel)];
    std::copy_n(&value.x, std::min<std::size_t>(components, 3), known);
  }
  buffer.GetTarget().UploadLayer(frame.Window, static_cast<int>(part), this->Known.data());
}

//------------------------------------------------------------------------------
void vtkAdaptiveRayTracedShadowTechnique::Scatter(vtkShadowFrame& frame,
  vtkVisibilityBuffer& buffer, std::size_t part, const Receivers& receivers,
  const std::vector<vtkShadowRaySeen>& seen)
{
  const bool textured = frame.Parts[part].Light.Emission != nullptr;
  const float width = static_cast<float>(buffer.GetWidth());
  const float height = static_cast<float>(buffer.GetHeight());
  std::vector<float> values;
  values.reserve(5 * receivers.size());
  for (std::size_t i = 0; i < receivers.size(); ++i)
  {
    const int x = receivers[i].Pixel % buffer.GetWidth();
    const int y = receivers[i].Pixel / buffer.GetWidth();
    const glm::vec3 value = GetValue(buffer, seen[i], textured);
    values.insert(values.end(),
      { (2.0f * static_cast<float>(x) + 1.0f) / width - 1.0f,
        (2.0f * static_cast<float>(y) + 1.0f) / height - 1.0f, value.x, value.y, value.z });
  }
  this->Values.Upload(values, { { "placeDC", 2 }, { "value", 3 } });
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglPointSize(1.0f);
  vtkShadowFramebuffer::Scope target(
    frame.Window, buffer.GetFramebuffer(), &buffer.GetTarget(), nullptr, static_cast<int>(part));
  this->Values.Draw(frame.Window, GL_POINTS, 0, this->Values.GetCount(),
    { vtkShadowScatterVS, nullptr, vtkShadowScatterFS, "", false }, nullptr);
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::size_t>> vtkAdaptiveRayTracedShadowTechnique::GetBytes()
{
  // The list of values is a frame's, and no longer than its pixels that are open.
  auto bytes = this->Bounds.GetBytes();
  bytes.emplace_back("selection", this->Selections[0].GetBytes() + this->Selections[1].GetBytes());
  return bytes;
}

//------------------------------------------------------------------------------
void vtkAdaptiveRayTracedShadowTechnique::Release(vtkOpenGLRenderWindow* window)
{
  this->Bounds.Release(window);
  for (auto& selection : this->Selections)
  {
    selection.Release();
  }
  this->Values.Release();
  std::vector<float>().swap(this->Known);
  std::vector<vtkShadowSelection::Pixel>().swap(this->Chosen);
  this->vtkRayTracedShadowTechnique::Release(window);
}
