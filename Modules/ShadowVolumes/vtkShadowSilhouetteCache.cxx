// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowSilhouetteCache.h"

#include "vtkLightFrusta.h"
#include "vtkShadowFrame.h"
#include "vtkShadowOpenGL.h"

#include <algorithm>
#include <chrono>
#include <utility>

//------------------------------------------------------------------------------
void vtkShadowSilhouetteCache::Update(vtkShadowFrame& frame, const Options& options)
{
  this->Changes.Update(frame, !(options == this->Wanted));
  this->Wanted = options;
  for (const char* name : { "adjacenciesBuilt", "silhouettesFound", "silhouettesReused" })
  {
    frame.Counts[name] = 0;
  }
  if (this->Changes.IsAll())
  {
    std::for_each(this->Parts.begin(), this->Parts.end(), &ReleaseBatches);
    this->Parts.clear();
  }
  this->Parts.resize(frame.Parts.size());
  std::size_t bytes = 0; // what stays counts first
  for (const auto& state : this->Parts)
  {
    for (const auto& batch : state.Batches)
    {
      bytes += batch->Bytes;
    }
  }
  for (int i = 0; i < static_cast<int>(this->Parts.size()); ++i)
  {
    const bool same = this->Changes.IsSame(i);
    if (!same || this->Changes.HaveReceiversMoved())
    {
      auto casters = vtkLightFrusta(frame.Parts[i], *frame.Casters).GetCasters();
      if (!same || casters != this->Parts[i].Casters)
      {
        this->UpdatePart(frame, i, std::move(casters), bytes);
        continue;
      }
    }
    for (const auto& batch : this->Parts[i].Batches)
    {
      frame.Counts["silhouettesReused"] += static_cast<double>(batch->Silhouettes.Get().size());
    }
  }
  this->Adjacencies.Prune(*frame.Casters);
  for (const auto& entry : this->Adjacencies.GetAll())
  {
    frame.Counts["adjacencyBytes"] += static_cast<double>(entry.second->GetBytes());
    frame.Counts["adjacencyTriangles"] += static_cast<double>(entry.second->Flags.size());
    frame.Counts["edgesOpen"] += static_cast<double>(entry.second->OpenEdges);
    frame.Counts["edgesNonManifold"] += static_cast<double>(entry.second->NonManifoldEdges);
    frame.Counts["edgesInconsistent"] += static_cast<double>(entry.second->InconsistentEdges);
    frame.Counts["trianglesDuplicate"] += static_cast<double>(entry.second->DuplicateFaces);
  }
}

//------------------------------------------------------------------------------
void vtkShadowSilhouetteCache::UpdatePart(
  vtkShadowFrame& frame, int index, std::vector<int> casters, std::size_t& bytes)
{
  PartState& state = this->Parts[index];
  const vtkShadowLight& light = frame.Parts[index].Light;
  bytes -= ReleaseBatches(state);
  this->UnkeptLight = -1;
  state.Version = ++this->Version;
  state.Casters = std::move(casters);
  state.Samples.clear();
  state.Places.clear();
  if (!state.Casters.empty())
  {
    state.Samples = this->Wanted.Split
                      ? frame.Casters->GetMiddles(light, this->Wanted.Samples, state.Casters)
                      : frame.Casters->GetPlaces(light, this->Wanted.Samples, state.Casters);
  }
  for (const auto& sample : state.Samples)
  {
    state.Places.push_back(light.IsDirectional()
                             ? glm::dvec4(sample.Point, 0.0)
                             : glm::dvec4(sample.Point - frame.Casters->GetOrigin(), 1.0));
  }
  frame.Counts["adjacenciesBuilt"] += this->Adjacencies.Add(*frame.Casters, state.Casters);
  constexpr int most = vtkShadowSilhouettes::MostPlaces;
  const int batches = (static_cast<int>(state.Samples.size()) + most - 1) / most;
  for (int k = 0; k < batches && bytes < this->Wanted.MemoryLimit; ++k)
  {
    auto batch = std::make_unique<Batch>();
    this->Find(frame, state, k, *batch);
    bytes += batch->Bytes;
    if (bytes > this->Wanted.MemoryLimit)
    {
      batch->Lines->ReleaseGraphicsResources();
      break;
    }
    state.Batches.push_back(std::move(batch));
  }
}

//------------------------------------------------------------------------------
void vtkShadowSilhouetteCache::Find(
  vtkShadowFrame& frame, const PartState& state, int batch, Batch& result)
{
  const std::size_t first = static_cast<std::size_t>(batch) * vtkShadowSilhouettes::MostPlaces;
  const std::size_t count =
    std::min<std::size_t>(vtkShadowSilhouettes::MostPlaces, state.Places.size() - first);
  const auto start = std::chrono::steady_clock::now();
  result.Silhouettes.Find(*frame.Casters, this->Adjacencies, state.Casters,
    state.Places.data() + first, static_cast<int>(count), this->Wanted.EnoughNested,
    this->Wanted.Loops);
  const auto& lines = result.Silhouettes.GetLines();
  frame.Counts["silhouetteMilliseconds"] +=
    std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  frame.Counts["silhouetteEdges"] += 0.5 * static_cast<double>(lines.size());
  result.Bytes = lines.size() * sizeof(std::uint32_t);
  glBindVertexArray(0); // or the buffer would become that array's
  result.Lines->Upload(lines, vtkOpenGLBufferObject::ElementArrayBuffer);
  if (!this->Wanted.KeepLines)
  {
    result.Silhouettes.ReleaseLines();
  }
  frame.Counts["silhouettesFound"] += static_cast<double>(count);
}

//------------------------------------------------------------------------------
const vtkShadowSilhouetteCache::Batch& vtkShadowSilhouetteCache::GetBatch(
  vtkShadowFrame& frame, int light, int sample)
{
  const PartState& state = this->Parts[light];
  const int index = sample / vtkShadowSilhouettes::MostPlaces;
  if (index < static_cast<int>(state.Batches.size()))
  {
    return *state.Batches[index];
  }
  if (this->UnkeptLight != light || this->UnkeptBatch != index)
  {
    this->Find(frame, state, index, this->Unkept);
    this->UnkeptLight = light;
    this->UnkeptBatch = index;
  }
  return this->Unkept;
}

//------------------------------------------------------------------------------
// Gives how many bytes that frees.
std::size_t vtkShadowSilhouetteCache::ReleaseBatches(PartState& state)
{
  std::size_t bytes = 0;
  for (const auto& batch : state.Batches)
  {
    batch->Lines->ReleaseGraphicsResources();
    bytes += batch->Bytes;
  }
  state.Batches.clear();
  return bytes;
}

//------------------------------------------------------------------------------
std::size_t vtkShadowSilhouetteCache::GetBytes() const
{
  std::size_t bytes = this->Unkept.Bytes;
  for (const auto& state : this->Parts)
  {
    for (const auto& batch : state.Batches)
    {
      bytes += batch->Bytes;
    }
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkShadowSilhouetteCache::Release()
{
  std::for_each(this->Parts.begin(), this->Parts.end(), &ReleaseBatches);
  this->Parts.clear();
  this->Unkept.Lines->ReleaseGraphicsResources();
  this->Unkept.Bytes = 0;
  this->UnkeptLight = -1;
  this->Adjacencies.Clear();
  this->Changes.Reset();
  ++this->Version;
}
