// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPenumbraWedgeTechnique.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPenumbraAreaFS.h"
#include "vtkPenumbraSumFS.h"
#include "vtkPenumbraWedgeVS.h"
#include "vtkShaderProgram.h"
#include "vtkShadowCasters.h"
#include "vtkShadowFrame.h"
#include "vtkShadowMessages.h"
#include "vtkShadowOpenGL.h"
#include "vtkVisibilityBuffer.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace
{
using Shape = vtkShadowLight::Shape;

/** A light without width is a narrow one: no formula has a limit of its own. */
constexpr double Narrowest = 1e-4;

/** A light's area, or one of side x side parts of it around a place. */
vtkShadowWedgeLight MakeArea(const vtkShadowLight& light, const glm::dvec4& place, int side)
{
  vtkShadowWedgeLight area;
  area.Kind = light.Kind;
  area.Place = place;
  area.U = light.U / static_cast<double>(side);
  area.V = light.V / static_cast<double>(side);
  const double u = glm::length(area.U);
  const double v = glm::length(area.V);
  if (u < Narrowest * v)
  {
    area.U = Narrowest * glm::cross(area.V, light.Direction);
  }
  else if (v < Narrowest * u)
  {
    area.V = Narrowest * glm::cross(light.Direction, area.U);
  }
  return area;
}
}

//------------------------------------------------------------------------------
bool vtkPenumbraWedgeTechnique::UpdateLightData(vtkShadowFrame& frame)
{
  const int split = this->Settings.GetInteger("split");
  vtkShadowVolumeSettings settings;
  settings.Silhouettes.Samples = split * split;
  settings.Silhouettes.Split = true;
  settings.Silhouettes.KeepLines = true;
  this->Volumes.Update(frame, settings);
  for (const char* name : { "wedges", "wedgesDrawn", "wedgesCulled" })
  {
    frame.Counts[name] = 0;
  }
  const std::string bounds = this->Settings.GetChoice("bounds");
  if (bounds != this->Bounds)
  {
    this->Bounds = bounds;
    this->Parts.clear();
  }
  this->Parts.resize(frame.Parts.size());
  for (int i = 0; i < static_cast<int>(frame.Parts.size()); ++i)
  {
    this->UpdatePart(frame, i);
  }
  if (const std::size_t count = frame.Casters->GetNumberWithHoles())
  {
    frame.Messages->Warn(
      std::to_string(count) +
      " casters have holes by alpha within their triangles, which silhouettes do not "
      "know: only triangles that are clear all over cast nothing.");
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkPenumbraWedgeTechnique::UpdatePart(vtkShadowFrame& frame, int part)
{
  PartState& state = this->Parts[part];
  const vtkShadowLight& light = frame.Parts[part].Light;
  const vtkShadowSilhouetteCache& silhouettes = this->Volumes.GetSilhouettes();
  const unsigned long version = silhouettes.GetVersion(part);
  if (version != state.Version)
  {
    state.Version = version;
    const std::size_t areas = light.IsPoint() ? 0 : silhouettes.GetSamples(part).size();
    const int side = static_cast<int>(std::lround(std::sqrt(areas)));
    while (state.Areas.size() > areas)
    {
      state.Areas.back()->Release(frame.Window);
      state.Areas.pop_back();
    }
    for (std::size_t k = 0; k < areas; ++k)
    {
      const int place = static_cast<int>(k);
      if (state.Areas.size() == k)
      {
        state.Areas.push_back(std::make_unique<vtkPenumbraWedges>());
      }
      state.Areas[k]->SetLight(MakeArea(light, silhouettes.GetPlace(part, place), side));
      state.Areas[k]->MakeOfSilhouette(frame, this->Volumes.GetBatch(frame, part, place), place,
        this->Bounds == "sphere" ? vtkShadowWedge::Bounds::Sphere : vtkShadowWedge::Bounds::Tight);
    }
  }
  for (const auto& area : state.Areas)
  {
    frame.Counts["wedges"] += static_cast<double>(area->GetNumberOfWedges());
  }
}

//------------------------------------------------------------------------------
void vtkPenumbraWedgeTechnique::AddWedges(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer,
  const vtkShadowTexture& target, int layer, int part, vtkPenumbraWedges& wedges, float share)
{
  const std::string quantity =
    buffer.GetQuantity().empty() ? "" : "#define SHADOW_QUANTITY\n";
  const vtkShadowPrograms::Sources sources{ vtkPenumbraWedgeVS, nullptr, vtkPenumbraSumFS,
    quantity + frame.GetLightsGLSL() + vtkShadowReceivers::GetGLSL() + wedges.GetLightGLSL(),
    false };
  vtkShadowTexture& receivers = buffer.GetReceivers().GetTexture();
  receivers.Activate(frame.Window);
  this->Volumes.AddBehind(frame, buffer, { &target }, layer,
    [&](const glm::dmat4& SWCToDraw, float farthest)
    {
      wedges.Draw(frame, this->Volumes, SWCToDraw, farthest, sources,
        [&](vtkShaderProgram* program)
        {
          program->SetUniformi("shadowReceivers", receivers.GetUnit());
          program->SetUniformi("shadowLight", part);
          program->SetUniformf("shadowShare", share);
          frame.SetLights(program);
        });
    });
  receivers.Deactivate(frame.Window);
}

//------------------------------------------------------------------------------
void vtkPenumbraWedgeTechnique::AddArea(
  vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int part, int area)
{
  PartState& state = this->Parts[part];
  vtkPenumbraWedges& wedges = *state.Areas[area];
  if (state.Areas.size() == 1)
  {
    this->Volumes.AddCounts(
      frame, buffer, buffer.GetTarget(), part, part, area, wedges.GetPlanes(), -1.0f);
    this->AddWedges(frame, buffer, buffer.GetTarget(), part, part, wedges, 1.0f);
    return;
  }
  {
    vtkShadowFramebuffer::Scope scope(
      frame.Window, buffer.GetFramebuffer(), &this->Sums, nullptr, 0);
    const float none[] = { 0.0f, 0.0f, 0.0f, 0.0f };
    glClearBufferfv(GL_COLOR, 0, none);
  }
  this->Volumes.AddCounts(frame, buffer, this->Sums, 0, part, area, wedges.GetPlanes(), 1.0f);
  this->AddWedges(frame, buffer, this->Sums, 0, part, wedges, -1.0f);
  vtkOpenGLState* state2 = frame.Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state2, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction(state2);
  vtkShadowFramebuffer::Scope scope(
    frame.Window, buffer.GetFramebuffer(), &buffer.GetTarget(), nullptr, part);
  state2->vtkglDisable(GL_DEPTH_TEST);
  state2->vtkglEnable(GL_BLEND);
  state2->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  this->Sums.Activate(frame.Window);
  frame.Quad->Draw(frame.Window, vtkPenumbraAreaFS,
    [&](vtkShaderProgram* program)
    {
      program->SetUniformi("shadowSums", this->Sums.GetUnit());
      program->SetUniformf("shadowShare", 1.0f / static_cast<float>(state.Areas.size()));
    });
  this->Sums.Deactivate(frame.Window);
}

//------------------------------------------------------------------------------
void vtkPenumbraWedgeTechnique::FillVisibility(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer)
{
  const bool cost = !buffer.GetQuantity().empty();
  this->MostWedges = 0.0;
  bool memory = this->Volumes.UpdateDepth(frame, buffer);
  memory = memory && (this->Settings.GetInteger("split") == 1 ||
                       this->Sums.Allocate(frame.Window, vtkShadowTexture::Format::Float1,
                         buffer.GetWidth(), buffer.GetHeight(), 1));
  for (int i = 0; memory && i < static_cast<int>(frame.Parts.size()); ++i)
  {
    if (this->Volumes.GetSamples(i).empty())
    {
      continue;
    }
    const PartState& state = this->Parts[i];
    if (state.Areas.empty())
    {
      cost ? this->Volumes.AddFaces(frame, buffer, i, 0)
           : static_cast<void>(this->Volumes.Subtract(frame, buffer, i, 0));
    }
    for (int k = 0; k < static_cast<int>(state.Areas.size()); ++k)
    {
      cost ? this->AddWedges(frame, buffer, buffer.GetTarget(), i, i, *state.Areas[k], 1.0f)
           : this->AddArea(frame, buffer, i, k);
    }
    if (cost)
    {
      const auto wedges = buffer.ReadTarget(frame.Window, i);
      this->MostWedges =
        std::max<double>(this->MostWedges, *std::max_element(wedges.begin(), wedges.end()));
    }
  }
  if (!memory)
  {
    frame.Messages->Error("no memory for wedges over " + std::to_string(buffer.GetWidth()) + " x " +
                          std::to_string(buffer.GetHeight()) +
                          " pixels; drawn without shadows.");
  }
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::size_t>> vtkPenumbraWedgeTechnique::GetBytes()
{
  auto bytes = this->Volumes.GetBytes();
  std::size_t wedges = 0;
  for (const auto& state : this->Parts)
  {
    for (const auto& area : state.Areas)
    {
      wedges += area->GetBytes();
    }
  }
  bytes.emplace_back("wedges", wedges);
  bytes.emplace_back("sums", this->Sums.GetBytes());
  return bytes;
}

//------------------------------------------------------------------------------
void vtkPenumbraWedgeTechnique::Release(vtkOpenGLRenderWindow* window)
{
  for (auto& state : this->Parts)
  {
    for (const auto& area : state.Areas)
    {
      area->Release(window);
    }
  }
  this->Parts.clear();
  this->Sums.Release(window);
  this->Volumes.Release(window);
}
