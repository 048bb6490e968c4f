// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPenumbraWedgeTechnique.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShadowCasters.h"
#include "vtkShadowFrame.h"
#include "vtkShadowMessages.h"

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
