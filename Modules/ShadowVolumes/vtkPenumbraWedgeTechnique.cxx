// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPenumbraWedgeTechnique.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPenumbraAreaFS.h"
#include "vtkPenumbraCountFS.h"
#include "vtkPenumbraLoopsFS.h"
#include "vtkPenumbraSamplesFS.h"
#include "vtkPenumbraSumFS.h"
#include "vtkPenumbraWedgeVS.h"
#include "vtkShaderProgram.h"
#include "vtkShadowCasters.h"
#include "vtkShadowFrame.h"
#include "vtkShadowMessages.h"
#include "vtkShadowOpenGL.h"
#include "vtkVisibilityBuffer.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace
{
using Shape = vtkShadowLight::Shape;

/** A light without width is a narrow one: no formula has a limit of its own. */
constexpr double Narrowest = 1e-4;

/** So many loops are combined one by one; the rest, the shortest of the last casters, are one more. */
constexpr std::size_t MostLoops = 256;

/** A light's area, or one of side x side parts of it around a place. */
vtkShadowWedgeLight MakeArea(const vtkShadowLight& light, const glm::dvec4& place, int side)
{
  vtkShadowWedgeLight area;
  area.Kind = light.Kind;
  area.Place = place;
  area.U = light.U / static_cast<double>(side);
  area.V = light.V / static_cast<double>(side);
  if (light.IsDirectional())
  {
    // A part's disk stands across its own direction.
    const glm::dvec3 towards = glm::normalize(glm::dvec3(place));
    area.Place = glm::dvec4(towards, 0.0);
    area.U -= glm::dot(area.U, towards) * towards;
    area.V = glm::cross(towards, area.U);
  }
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
int vtkPenumbraWedgeTechnique::GetSamples()
{
  return this->Settings.GetChoice("overlap") == "count" ? vtkShadowTechnique::GetSamples() : 0;
}

//------------------------------------------------------------------------------
bool vtkPenumbraWedgeTechnique::UpdateLightData(vtkShadowFrame& frame)
{
  const std::string overlap = this->Settings.GetChoice("overlap");
  if (overlap != "count") // the others take the silhouettes that the light's centre sees
  {
    frame.Counts["lightsTooLarge"] = frame.CountLargeLights();
  }
  const int samples = this->Settings.GetInteger("samples");
  const int split = overlap == "count" ? 1 : this->Settings.GetInteger("split");
  vtkShadowVolumeSettings settings;
  settings.Silhouettes.Samples = split * split;
  settings.Silhouettes.Split = true;
  settings.Silhouettes.KeepLines = true;
  settings.Silhouettes.Loops = overlap == "loops";
  settings.Silhouettes.EnoughNested = vtkPenumbraSamples::LeastMost;
  this->Volumes.Update(frame, settings);
  for (const char* name : { "wedges", "wedgesDrawn", "wedgesCulled", "linesMerged", "loops" })
  {
    frame.Counts[name] = 0;
  }
  const std::string bounds = this->Settings.GetChoice("bounds");
  if (bounds != this->Bounds || overlap != this->Overlap || samples != this->Samples)
  {
    this->Bounds = bounds;
    this->Overlap = overlap;
    this->Samples = samples;
    this->ReleaseParts(frame.Window, 0);
  }
  this->ReleaseParts(frame.Window, frame.Parts.size());
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
  const std::size_t areas = light.IsPoint() ? 0 : silhouettes.GetSamples(part).size();
  const int side = static_cast<int>(std::lround(std::sqrt(areas)));
  const auto getArea = [&](std::size_t k)
  { return MakeArea(light, silhouettes.GetPlace(part, static_cast<int>(k)), side); };
  std::vector<std::vector<double>> moves;
  const double pixels = this->Settings.GetReal("merge");
  if (pixels > 0.0 && this->Overlap != "count")
  {
    for (std::size_t k = 0; k < areas; ++k)
    {
      moves.push_back(vtkPenumbraLines::FindMoves(
        frame, this->Volumes, silhouettes.GetCasters(part), getArea(k), pixels));
    }
  }
  // Wedges end at the box around what receives.
  const auto version =
    std::make_pair(silhouettes.GetVersion(part), frame.Casters->GetReceiverVersion());
  if (version != state.Version || moves != state.Moves)
  {
    state.Version = version;
    state.Moves = moves;
    while (state.Areas.size() > areas)
    {
      state.Areas.back()->Release(frame.Window);
      state.Areas.pop_back();
    }
    state.Samples.Count = 0;
    const bool counts = this->Overlap == "count";
    this->UpdateEmissions(frame, part, side);
    const auto bounds =
      this->Bounds == "sphere" ? vtkShadowWedge::Bounds::Sphere : vtkShadowWedge::Bounds::Tight;
    for (std::size_t k = 0; k < areas; ++k)
    {
      const int place = static_cast<int>(k);
      if (state.Areas.size() == k)
      {
        state.Areas.push_back(std::make_unique<vtkPenumbraWedges>());
      }
      vtkPenumbraWedges& wedges = *state.Areas[k];
      const vtkShadowSilhouetteCache::Batch& batch = this->Volumes.GetBatch(frame, part, place);
      wedges.SetLight(getArea(k));
      wedges.SetEmission(this->IsColor(part) ? state.Emissions[k].get() : nullptr);
      wedges.GetLines().Make(
        frame, batch, place, wedges.GetLight(), moves.empty() ? std::vector<double>() : moves[k]);
      if (counts)
      {
        state.Samples.Set(light, this->Samples, vtkShadowSilhouetteCache::Get(batch, 0).MostNested);
        wedges.MakeOfEdges(
          frame, silhouettes.GetAdjacencies(), silhouettes.GetCasters(part), bounds);
      }
      else
      {
        wedges.MakeOfSilhouette(frame, bounds);
      }
    }
  }
  for (const auto& area : state.Areas)
  {
    frame.Counts["wedges"] += static_cast<double>(area->GetNumberOfWedges());
    frame.Counts["linesMerged"] += static_cast<double>(area->GetLines().GetMerged());
  }
}

//------------------------------------------------------------------------------
void vtkPenumbraWedgeTechnique::UpdateEmissions(vtkShadowFrame& frame, int part, int side)
{
  PartState& state = this->Parts[part];
  const vtkShadowLight& light = frame.Parts[part].Light;
  const std::size_t areas =
    light.Emission && this->Overlap != "count" ? static_cast<std::size_t>(side) * side : 0;
  if (areas == state.Emissions.size() &&
      (areas == 0 || (light.Emission == state.Image && light.EmissionTime == state.ImageTime)))
  {
    return;
  }
  for (const auto& emission : state.Emissions)
  {
    emission->Release(frame.Window);
  }
  state.Emissions.clear();
  state.Image = light.Emission;
  state.ImageTime = light.EmissionTime;
  for (std::size_t k = 0; k < areas; ++k)
  {
    // In the order of vtkShadowCasters::GetMiddles.
    const glm::dvec2 low(k % side, k / side);
    state.Emissions.push_back(std::make_unique<vtkPenumbraEmission>());
    state.Emissions.back()->Set(
      frame.Window, light, low / double(side), (low + 1.0) / double(side));
  }
}

//------------------------------------------------------------------------------
glm::vec3 vtkPenumbraWedgeTechnique::GetShare(int part, int area) const
{
  const PartState& state = this->Parts[part];
  const double even = 1.0 / static_cast<double>(state.Areas.size());
  if (!this->IsColor(part))
  {
    return glm::vec3(static_cast<float>(even));
  }
  glm::dvec3 whole(0.0);
  for (const auto& emission : state.Emissions)
  {
    whole += emission->GetWhole();
  }
  const glm::dvec3 own = state.Emissions[area]->GetWhole();
  glm::vec3 share;
  for (int c = 0; c < 3; ++c)
  {
    // A channel without emission is that of an evenly bright light.
    share[c] = static_cast<float>(whole[c] > 0.0 ? own[c] / whole[c] : even);
  }
  return share;
}

//------------------------------------------------------------------------------
void vtkPenumbraWedgeTechnique::AddWedges(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer,
  const std::vector<const vtkShadowTexture*>& targets, int layer, int part,
  vtkPenumbraWedges& wedges, const char* shader, const std::string& definitions,
  const std::function<void(vtkShaderProgram*)>& setParameters, const std::vector<int>* some)
{
  const vtkShadowPrograms::Sources sources{ vtkPenumbraWedgeVS, nullptr, shader,
    frame.GetLightsGLSL(definitions) + vtkShadowReceivers::GetGLSL() + wedges.GetLightGLSL(),
    false };
  vtkShadowTexture& receivers = buffer.GetReceivers().GetTexture();
  receivers.Activate(frame.Window);
  wedges.Activate(frame.Window);
  this->Volumes.AddBehind(
    frame, buffer, targets, layer,
    [&](const glm::dmat4& SWCToDraw, float farthest, const glm::vec2& retreat)
    {
      wedges.Draw(
        frame, this->Volumes, SWCToDraw, farthest, retreat, sources,
        [&](vtkShaderProgram* program)
        {
          program->SetUniformi("shadowReceivers", receivers.GetUnit());
          program->SetUniformi("shadowLight", part);
          frame.SetLights(program);
          if (setParameters)
          {
            setParameters(program);
          }
        },
        some);
    },
    buffer.GetQuantity() == "wedges");
  wedges.Deactivate(frame.Window);
  receivers.Deactivate(frame.Window);
}

//------------------------------------------------------------------------------
void vtkPenumbraWedgeTechnique::DrawOver(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer,
  const vtkShadowTexture& target, int layer, bool adds, vtkShadowTexture& sums,
  const vtkPenumbraWedges& wedges, const char* shader, const std::string& definitions,
  const std::function<void(vtkShaderProgram*)>& setParameters)
{
  std::string source = shader;
  vtkShaderProgram::Substitute(source, "//VTK::Output::Dec",
    "//VTK::Output::Dec\n" + frame.GetLightsGLSL(definitions) + vtkShadowReceivers::GetGLSL() +
      wedges.GetLightGLSL());
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunction(state);
  vtkShadowFramebuffer::Scope scope(frame.Window, buffer.GetFramebuffer(), &target, nullptr, layer);
  state->vtkglDisable(GL_DEPTH_TEST);
  adds ? state->vtkglEnable(GL_BLEND) : state->vtkglDisable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  vtkShadowTexture& receivers = buffer.GetReceivers().GetTexture();
  receivers.Activate(frame.Window);
  wedges.Activate(frame.Window);
  sums.Activate(frame.Window);
  frame.Quad->Draw(frame.Window, source,
    [&](vtkShaderProgram* program)
    {
      program->SetUniformi("shadowReceivers", receivers.GetUnit());
      program->SetUniformi("shadowSums", sums.GetUnit());
      wedges.SetLight(frame, program);
      setParameters(program);
    });
  sums.Deactivate(frame.Window);
  wedges.Deactivate(frame.Window);
  receivers.Deactivate(frame.Window);
}

//------------------------------------------------------------------------------
void vtkPenumbraWedgeTechnique::CountCentre(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer,
  int part, int area, const std::vector<int>* some)
{
  {
    vtkShadowFramebuffer::Scope scope(
      frame.Window, buffer.GetFramebuffer(), &this->Sums, nullptr, 0);
    const float none[] = { 0.0f, 0.0f, 0.0f, 0.0f };
    glClearBufferfv(GL_COLOR, 0, none);
  }
  this->Volumes.AddCounts(
    frame, buffer, this->Sums, 0, part, area, this->Parts[part].Areas[area]->GetLines(), some);
}

//------------------------------------------------------------------------------
std::vector<std::vector<int>> vtkPenumbraWedgeTechnique::GetLoops(
  vtkShadowFrame& frame, int part, int area)
{
  const glm::dvec4& place = this->Volumes.GetSilhouettes().GetPlace(part, area);
  const auto& parts =
    vtkShadowSilhouetteCache::Get(this->Volumes.GetBatch(frame, part, area), area).Parts;
  std::vector<std::vector<int>> loops;
  std::vector<int> rest;
  bool capped = false;
  for (int i = 0; i < static_cast<int>(parts.size()); ++i)
  {
    const bool same = i > 0 && parts[i].Caster == parts[i - 1].Caster;
    capped = same ? capped : this->Volumes.HasCaps(frame.Casters->Get()[parts[i].Caster], place);
    if (capped && same)
    {
      loops.back().push_back(i);
    }
    else if (capped || loops.size() < MostLoops)
    {
      loops.push_back({ i });
    }
    else
    {
      rest.push_back(i);
    }
  }
  if (!rest.empty())
  {
    loops.push_back(rest);
  }
  return loops;
}

//------------------------------------------------------------------------------
void vtkPenumbraWedgeTechnique::CombineLoops(
  vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int part, int area)
{
  vtkPenumbraWedges& wedges = *this->Parts[part].Areas[area];
  const int channels = this->IsColor(part) ? 3 : 1;
  for (auto& texture : this->Loops)
  {
    texture.Allocate(frame.Window, vtkShadowTexture::Format::Float2, buffer.GetWidth(),
      buffer.GetHeight(), channels);
  }
  int last = 0; // which holds what is combined
  const auto loops = this->GetLoops(frame, part, area);
  frame.Counts["loops"] += static_cast<double>(loops.size());
  const auto combine = [&](const char* definitions)
  {
    this->Loops[last].Activate(frame.Window);
    for (int c = 0; c < channels; ++c)
    {
      this->DrawOver(frame, buffer, this->Loops[1 - last], c, false, this->Sums, wedges,
        vtkPenumbraLoopsFS, definitions,
        [&](vtkShaderProgram* program)
        {
          program->SetUniformi("shadowLoops", this->Loops[last].GetUnit());
          program->SetUniformi("shadowChannel", c);
        });
    }
    this->Loops[last].Deactivate(frame.Window);
    last = 1 - last;
  };
  for (int c = 0; c < channels; ++c)
  {
    vtkShadowFramebuffer::Scope scope(
      frame.Window, buffer.GetFramebuffer(), &this->Loops[last], nullptr, c);
    const float none[] = { 0.0f, 0.0f, 0.0f, 0.0f };
    glClearBufferfv(GL_COLOR, 0, none);
  }
  for (const auto& loop : loops)
  {
    this->CountCentre(frame, buffer, part, area, &loop);
    this->AddWedges(
      frame, buffer, { &this->Sums }, 0, part, wedges, vtkPenumbraSumFS, "", nullptr, &loop);
    combine("");
  }
  if (last != 0)
  {
    combine("#define SHADOW_COPY\n");
  }
}

//------------------------------------------------------------------------------
void vtkPenumbraWedgeTechnique::AddArea(
  vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int part, int area)
{
  vtkPenumbraWedges& wedges = *this->Parts[part].Areas[area];
  const bool loops = this->Overlap == "loops";
  if (loops)
  {
    this->CombineLoops(frame, buffer, part, area);
  }
  else
  {
    this->CountCentre(frame, buffer, part, area);
    this->AddWedges(frame, buffer, { &this->Sums }, 0, part, wedges, vtkPenumbraSumFS, "", nullptr);
  }
  const glm::vec3 share = this->GetShare(part, area);
  this->DrawOver(frame, buffer, buffer.GetTarget(), part, true, loops ? this->Loops[0] : this->Sums,
    wedges, vtkPenumbraAreaFS, loops ? "#define SHADOW_COMBINED\n" : "",
    [&](vtkShaderProgram* program)
    { program->SetUniform3f("shadowShare", glm::value_ptr(share)); });
}

//------------------------------------------------------------------------------
void vtkPenumbraWedgeTechnique::AddQuantity(
  vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int part, int area)
{
  const std::string& quantity = buffer.GetQuantity();
  vtkPenumbraWedges& wedges = *this->Parts[part].Areas[area];
  if (quantity == "centre")
  {
    this->Volumes.AddCounts(frame, buffer, buffer.GetTarget(), part, part, area, wedges.GetLines());
    return;
  }
  const std::string shown = quantity == "inner"   ? "#define SHADOW_WEDGE_HALF 1\n"
                            : quantity == "outer" ? "#define SHADOW_WEDGE_HALF 0\n"
                            : quantity == "edges" ? "#define SHADOW_WEDGE_EDGES\n"
                                                  : "#define SHADOW_QUANTITY\n";
  const bool counts = this->CountsSamples(part);
  this->AddWedges(frame, buffer, { &buffer.GetTarget() }, part, part, wedges,
    counts ? vtkPenumbraCountFS : vtkPenumbraSumFS,
    counts ? this->Parts[part].Samples.GetDefinitions(0) + "#define SHADOW_QUANTITY\n"
           : "#define SHADOW_WEDGE_VIEW\n" + shown,
    nullptr);
}

//------------------------------------------------------------------------------
void vtkPenumbraWedgeTechnique::AddSamples(
  vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int part)
{
  const vtkPenumbraSamples& samples = this->Parts[part].Samples;
  vtkPenumbraWedges& wedges = *this->Parts[part].Areas[0];
  this->CountCentre(frame, buffer, part, 0);
  for (int pass = 0; pass < samples.GetPasses(); ++pass)
  {
    const int targets = samples.GetTargets(pass);
    std::vector<const vtkShadowTexture*> counts;
    for (int t = 0; t < targets; ++t)
    {
      this->Counts[t].Allocate(
        frame.Window, vtkShadowTexture::Format::Float4, buffer.GetWidth(), buffer.GetHeight(), 1);
      counts.push_back(&this->Counts[t]);
    }
    {
      vtkShadowFramebuffer::Scope scope(frame.Window, buffer.GetFramebuffer(), counts, nullptr, 0);
      const float none[] = { 0.0f, 0.0f, 0.0f, 0.0f };
      for (int t = 0; t < targets; ++t)
      {
        glClearBufferfv(GL_COLOR, t, none);
      }
    }
    const std::string definitions = samples.GetDefinitions(pass);
    const auto setParameters = [&](vtkShaderProgram* program)
    {
      samples.SetParameters(program, pass);
      for (int t = 0; t < targets; ++t)
      {
        const std::string name = "shadowCounts" + std::to_string(t);
        if (program->IsUniformUsed(name.c_str()))
        {
          program->SetUniformi(name.c_str(), this->Counts[t].GetUnit());
        }
      }
    };
    this->AddWedges(
      frame, buffer, counts, 0, part, wedges, vtkPenumbraCountFS, definitions, setParameters);
    for (int t = 0; t < targets; ++t)
    {
      this->Counts[t].Activate(frame.Window);
    }
    this->DrawOver(frame, buffer, buffer.GetTarget(), part, true, this->Sums, wedges,
      vtkPenumbraSamplesFS, definitions, setParameters);
    for (int t = 0; t < targets; ++t)
    {
      this->Counts[t].Deactivate(frame.Window);
    }
  }
}

//------------------------------------------------------------------------------
void vtkPenumbraWedgeTechnique::FillVisibility(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer)
{
  const bool cost = !buffer.GetQuantity().empty();
  this->Most = 0.0;
  bool memory = this->Volumes.UpdateDepth(frame, buffer);
  const bool color = std::any_of(this->Parts.begin(), this->Parts.end(),
    [](const PartState& state) { return !state.Emissions.empty(); });
  memory = memory && this->Sums.Allocate(frame.Window,
                       color ? vtkShadowTexture::Format::Float4 : vtkShadowTexture::Format::Float2,
                       buffer.GetWidth(), buffer.GetHeight(), 1);
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
      cost                     ? this->AddQuantity(frame, buffer, i, k)
      : this->CountsSamples(i) ? this->AddSamples(frame, buffer, i)
                               : this->AddArea(frame, buffer, i, k);
    }
    if (cost)
    {
      const auto values = buffer.ReadTarget(frame.Window, i);
      this->Most = std::max<double>(this->Most, *std::max_element(values.begin(), values.end()));
      const std::string name = buffer.GetQuantity() == "cost" ? "wedge" : buffer.GetQuantity();
      frame.Counts[name + "Pixels"] += std::accumulate(values.begin(), values.end(), 0.0);
    }
  }
  if (!memory)
  {
    frame.Messages->Error("no memory for wedges over " + std::to_string(buffer.GetWidth()) + " x " +
                          std::to_string(buffer.GetHeight()) + " pixels; drawn without shadows.");
  }
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::size_t>> vtkPenumbraWedgeTechnique::GetBytes()
{
  auto bytes = this->Volumes.GetBytes();
  std::size_t wedges = 0;
  std::size_t emissions = 0;
  for (const auto& state : this->Parts)
  {
    for (const auto& area : state.Areas)
    {
      wedges += area->GetBytes();
    }
    for (const auto& emission : state.Emissions)
    {
      emissions += emission->GetTexture().GetBytes();
    }
  }
  bytes.emplace_back("wedges", wedges);
  bytes.emplace_back("emissions", emissions);
  std::size_t counts =
    this->Sums.GetBytes() + this->Loops[0].GetBytes() + this->Loops[1].GetBytes();
  for (const auto& target : this->Counts)
  {
    counts += target.GetBytes();
  }
  bytes.emplace_back("wedgeSums", counts);
  return bytes;
}

//------------------------------------------------------------------------------
void vtkPenumbraWedgeTechnique::ReleaseParts(vtkOpenGLRenderWindow* window, std::size_t first)
{
  for (std::size_t i = first; i < this->Parts.size(); ++i)
  {
    for (const auto& area : this->Parts[i].Areas)
    {
      area->Release(window);
    }
    for (const auto& emission : this->Parts[i].Emissions)
    {
      emission->Release(window);
    }
  }
  this->Parts.resize(std::min(first, this->Parts.size()));
}

//------------------------------------------------------------------------------
void vtkPenumbraWedgeTechnique::Release(vtkOpenGLRenderWindow* window)
{
  this->ReleaseParts(window, 0);
  this->Sums.Release(window);
  this->Loops[0].Release(window);
  this->Loops[1].Release(window);
  for (auto& target : this->Counts)
  {
    target.Release(window);
  }
  this->Volumes.Release(window);
}
