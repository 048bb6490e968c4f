// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowMeshes.h"

#include "vtkPolyData.h"

//------------------------------------------------------------------------------
std::shared_ptr<const vtkShadowMesh> vtkShadowMeshes::Find(
  const vtkShadowSurface& surface, double threshold, const vtkShadowMeshes& before)
{
  Entry& entry = this->Entries[surface.From];
  if (entry.Mesh)
  {
    return entry.Mesh;
  }
  const auto old = before.Entries.find(surface.From);
  const bool sameShape = old != before.Entries.end() && old->second.Time == surface.Time;
  entry.Time = surface.Time;
  entry.AlphaTime = surface.AlphaTime;
  entry.Threshold = surface.AlphaTime > 0 ? threshold : 0.0;
  // Also where the mesh stays, so that the map is there for the next frame.
  const auto map = surface.Map ? this->FindMap(surface, before) : nullptr;
  if (sameShape && old->second.AlphaTime == entry.AlphaTime &&
      old->second.Threshold == entry.Threshold)
  {
    entry.Mesh = old->second.Mesh;
    return entry.Mesh;
  }
  // What is exactly as low as the threshold is there, also when it is interpolated.
  const double least = entry.Threshold - 1e-5;
  entry.Mesh = vtkShadowMesh::Make(surface.MakePolygons(least), map, static_cast<float>(least));
  if (sameShape && entry.Mesh->IsSame(*old->second.Mesh))
  {
    entry.Mesh = old->second.Mesh; // other colours, the same holes
  }
  return entry.Mesh;
}

//------------------------------------------------------------------------------
std::shared_ptr<const vtkShadowAlphaMap> vtkShadowMeshes::FindMap(
  const vtkShadowSurface& surface, const vtkShadowMeshes& before)
{
  MapEntry& entry = this->Maps[surface.Map];
  if (entry.Time != surface.MapTime)
  {
    const auto old = before.Maps.find(surface.Map);
    const bool same = old != before.Maps.end() && old->second.Time == surface.MapTime;
    entry = same ? old->second : MapEntry{ surface.MapTime, surface.MakeMap() };
  }
  return entry.Map;
}
