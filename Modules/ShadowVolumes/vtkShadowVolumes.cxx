// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowVolumes.h"

#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPlaneCollection.h"
#include "vtkProperty.h"
#include "vtkShadowFrame.h"
#include "vtkShadowOpenGL.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
using Counting = vtkShadowVolumeSettings::Counting;

/** How close to a plane counts as on both sides, as a share of the lengths involved. */
constexpr double Nearness = 1e-6;

double Side(const glm::dvec4& plane, const glm::dvec3& point)
{
  return glm::dot(plane, glm::dvec4(point, 1.0));
}

/** No plane has all of the caster's box outside. */
bool MayReachInto(
  const std::vector<glm::dvec4>& planes, const vtkShadowCaster& caster, double slack = 0.0)
{
  return std::none_of(planes.begin(), planes.end(),
    [&](const glm::dvec4& plane)
    {
      return std::all_of(caster.Corners.begin(), caster.Corners.end(),
        [&](const glm::dvec3& corner) { return Side(plane, corner) < -slack; });
    });
}

/** A light may be within a body: it is in the box around its own, along the world's axes. */
bool MayHold(const vtkShadowCaster& caster, const glm::dvec4& place)
{
  glm::dvec3 low = caster.Corners[0];
  glm::dvec3 high = low;
  for (const auto& corner : caster.Corners)
  {
    low = glm::min(low, corner);
    high = glm::max(high, corner);
  }
  const glm::dvec3 light(place);
  return place.w != 0.0 && glm::all(glm::lessThanEqual(low, light)) &&
         glm::all(glm::lessThanEqual(light, high));
}

/** A plane of unit normal through a point. */
glm::dvec4 MakePlane(const glm::dvec3& normal, const glm::dvec3& point)
{
  const glm::dvec3 unit = glm::normalize(normal);
  return { unit, -glm::dot(unit, point) };
}
}

//------------------------------------------------------------------------------
void vtkShadowVolumes::Update(vtkShadowFrame& frame, const vtkShadowVolumeSettings& settings)
{
  this->Method = settings.Method;
  for (const char* name : { "volumesZPass", "volumesZFail", "volumesOutOfView", "wideCounts" })
  {
    frame.Counts[name] = 0;
  }
  this->Silhouettes.Update(frame, settings.Silhouettes);
  if (this->CapVersion != this->Silhouettes.GetVersion())
  {
    this->CapVersion = this->Silhouettes.GetVersion();
    this->CapLight = -1;
  }
  this->SetView(frame);
}

//------------------------------------------------------------------------------
void vtkShadowVolumes::SetView(const vtkShadowFrame& frame)
{
  this->SWCToClip = frame.VCToClip * frame.GetSWCToVC();
  // A camera that mirrors turns all faces around; the usual projection has a negative determinant.
  this->Mirrored = glm::determinant(this->SWCToClip) > 0.0;
  this->Parallel = frame.IsParallel();
  this->FrustumPlanes.clear();
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double sign : { 1.0, -1.0 })
    {
      const glm::dvec4 plane =
        glm::row(this->SWCToClip, 3) + sign * glm::row(this->SWCToClip, axis);
      this->FrustumPlanes.push_back(plane / glm::length(glm::dvec3(plane)));
    }
  }
  const glm::dmat4 clipToSWC = glm::inverse(this->SWCToClip);
  this->FrustumCorners.clear();
  for (const double z : { -1.0, 1.0 })
  {
    for (const glm::dvec2& corner : { glm::dvec2(-1.0, -1.0), glm::dvec2(1.0, -1.0),
           glm::dvec2(1.0, 1.0), glm::dvec2(-1.0, 1.0) })
    {
      const glm::dvec4 p = clipToSWC * glm::dvec4(corner, z, 1.0);
      this->FrustumCorners.push_back(glm::dvec3(p) / p.w);
    }
  }
  // Depth falls from 1 at the near plane: near / distance, or evenly to the far plane. The near plane
  // is the projection's, which need not be that of the camera's clipping range.
  this->WRow = glm::row(frame.VCToClip, 3);
  this->Nearest = std::numeric_limits<double>::max();
  for (int i = 0; i < 4; ++i)
  {
    const glm::dvec4 corner(this->FrustumCorners[i], 1.0);
    this->Nearest = std::min(this->Nearest, glm::dot(glm::row(this->SWCToClip, 3), corner));
  }
  this->DepthRow = this->Parallel ? 0.5 * (this->WRow - glm::row(frame.VCToClip, 2))
                                  : glm::dvec4(0.0, 0.0, 0.0, this->Nearest);
  this->ClipControl = VTK_SHADOW_HAS_GL(ARB_clip_control) || VTK_SHADOW_HAS_GL(VERSION_4_5);
  const glm::dmat4 VCToDraw = glm::row(
    frame.VCToClip, 2, this->ClipControl ? this->DepthRow : 2.0 * this->DepthRow - this->WRow);
  this->SWCToDraw = VCToDraw * frame.GetSWCToVC();
}

//------------------------------------------------------------------------------
std::vector<glm::dvec4> vtkShadowVolumes::GetShadingPlanes(const glm::dvec4& place) const
{
  const glm::dvec3 light(place);
  const auto& corners = this->FrustumCorners;
  const glm::dvec3 middle = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
  const glm::dvec3 ahead = glm::dvec3(this->FrustumPlanes[4]);
  const double size = glm::length(corners[2] - corners[0]);
  std::vector<glm::dvec4> planes;
  const auto add = [&](const glm::dvec3& normal, const glm::dvec3& point, const glm::dvec3& inside)
  {
    // A pyramid without height keeps the planes that are sure.
    if (!(glm::length(normal) > 0.0))
    {
      return;
    }
    const glm::dvec4 plane = MakePlane(normal, point);
    const double side = Side(plane, inside);
    const double slack = Nearness * (size + glm::length(inside - point));
    if (std::abs(side) > slack)
    {
      planes.push_back((side > 0.0 ? plane : -plane) + glm::dvec4(0.0, 0.0, 0.0, slack));
    }
  };
  const bool positional = place.w != 0.0;
  for (int i = 0; i < 4; ++i)
  {
    const glm::dvec3& a = corners[i];
    const glm::dvec3& b = corners[(i + 1) % 4];
    add(positional ? glm::cross(a - light, b - light) : glm::cross(light, b - a), a, middle);
  }
  const glm::dvec3 inside = positional ? light : middle + size * light;
  add(ahead, middle, inside);
  if (positional)
  {
    add(ahead, light, middle);
  }
  return planes;
}

//------------------------------------------------------------------------------
bool vtkShadowVolumes::HasCaps(const vtkShadowCaster& caster, const glm::dvec4& place) const
{
  return this->Method == Counting::ZFail ||
         (this->Method == Counting::Auto &&
           (this->IsLookedInto(caster) || MayReachInto(this->GetShadingPlanes(place), caster)));
}

//------------------------------------------------------------------------------
vtkShadowVolumes::Selection vtkShadowVolumes::Select(
  vtkShadowFrame& frame, int light, int sample, const std::vector<vtkShadowCasterPart>* others)
{
  const glm::dvec4& place = this->Silhouettes.GetPlace(light, sample);
  Selection selection;
  selection.Lines = &this->Silhouettes.GetBatch(frame, light, sample);
  const vtkShadowSilhouette& silhouette = vtkShadowSilhouetteCache::Get(*selection.Lines, sample);
  const auto shading = this->GetShadingPlanes(place);
  std::vector<CappedCaster> capped;
  std::size_t mostNested = silhouette.MostNested;
  for (const auto& part : others ? *others : silhouette.Parts)
  {
    const vtkShadowCaster& caster = frame.Casters->Get()[part.Caster];
    if (this->IsOutOfView(caster, { place }))
    {
      ++frame.Counts["volumesOutOfView"];
    }
    else if (this->Method == Counting::ZPass || this->Method == Counting::Xor)
    {
      selection.ZPass.push_back(part);
    }
    else if (const bool inside = this->IsLookedInto(caster);
             inside || this->Method == Counting::ZFail || MayReachInto(shading, caster))
    {
      const vtkShadowCap cap = !inside                  ? vtkShadowCap::Away
                               : MayHold(caster, place) ? vtkShadowCap::All
                                                        : vtkShadowCap::Facing;
      selection.ZFail.push_back(part);
      if (cap == vtkShadowCap::All)
      {
        selection.ZFail.push_back(part);
        mostNested = 2 * silhouette.MostNested;
      }
      if (capped.empty() || capped.back().first != part.Caster) // not for each of its loops
      {
        capped.emplace_back(part.Caster, cap);
      }
    }
    else
    {
      selection.ZPass.push_back(part);
    }
  }
  frame.Counts["volumesZPass"] += static_cast<double>(selection.ZPass.size());
  frame.Counts["volumesZFail"] += static_cast<double>(capped.size());
  selection.Wide = this->Method != Counting::Xor && mostNested > 255;
  frame.Counts["wideCounts"] += selection.Wide ? 1 : 0;
  if (!capped.empty())
  {
    this->UpdateCaps(frame, light, sample, capped);
  }
  return selection;
}

//------------------------------------------------------------------------------
bool vtkShadowVolumes::IsOutOfView(
  const vtkShadowCaster& caster, const std::vector<glm::dvec4>& places) const
{
  return std::any_of(this->FrustumPlanes.begin(), this->FrustumPlanes.end(),
    [&](const glm::dvec4& plane)
    {
      // All of the caster is outside, and the light not further out: then so is all that is behind.
      double outermost = std::numeric_limits<double>::max();
      bool directional = false;
      for (const auto& place : places)
      {
        directional = place.w == 0.0;
        outermost = std::min(outermost, glm::dot(plane, place));
      }
      return std::all_of(caster.Corners.begin(), caster.Corners.end(),
        [&](const glm::dvec3& corner)
        {
          const double side = Side(plane, corner);
          return side < 0.0 && (directional ? outermost >= 0.0 : side <= outermost);
        });
    });
}

//------------------------------------------------------------------------------
bool vtkShadowVolumes::IsLookedInto(const vtkShadowCaster& caster) const
{
  if (auto* actor = vtkActor::SafeDownCast(caster.Prop))
  {
    vtkPlaneCollection* clipping = actor->GetMapper()->GetClippingPlanes();
    if (actor->GetProperty()->GetBackfaceCulling() || actor->GetProperty()->GetFrontfaceCulling() ||
        (clipping && clipping->GetNumberOfItems() > 0) ||
        actor->HasTranslucentPolygonalGeometry() ||
        actor->GetMapper()->IsA("vtkPointGaussianMapper") || caster.Mesh->Holes ||
        caster.Mesh->Clear > 0 || caster.Mesh->NotFinite > 0) // VTK culls what has such bounds
    {
      return true;
    }
  }
  // The near rectangle, which is what the frustum has in the near plane, may cut the caster's box.
  const auto& corners = caster.Corners;
  const glm::dvec4& ahead = this->FrustumPlanes[4];
  const double slack = Nearness * glm::length(corners[7] - corners[0]);
  return std::any_of(corners.begin(), corners.end(),
           [&](const glm::dvec3& corner) { return Side(ahead, corner) <= slack; }) &&
         MayReachInto(this->FrustumPlanes, caster, slack);
}

//------------------------------------------------------------------------------
void vtkShadowVolumes::UpdateCaps(
  vtkShadowFrame& frame, int light, int sample, const std::vector<CappedCaster>& casters)
{
  if (light == this->CapLight && sample == this->CapSample && casters == this->CapCasters)
  {
    return;
  }
  std::vector<std::uint32_t> triangles;
  this->CapParts.clear();
  for (const auto& [index, cap] : casters)
  {
    const vtkShadowCaster& caster = frame.Casters->Get()[index];
    const std::size_t first = triangles.size();
    vtkShadowSilhouettes::AddCap(caster, this->Silhouettes.GetAdjacencies().Get(caster.Mesh),
      this->Silhouettes.GetPlace(light, sample), cap, triangles);
    this->CapParts.push_back({ index, first, triangles.size() - first });
  }
  glBindVertexArray(0);
  this->Caps->Upload(triangles, vtkOpenGLBufferObject::ElementArrayBuffer);
  this->CapBytes = triangles.size() * sizeof(std::uint32_t);
  this->CapLight = light;
  this->CapSample = sample;
  this->CapCasters = casters;
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::size_t>> vtkShadowVolumes::GetBytes() const
{
  return { { "silhouettes", this->Silhouettes.GetBytes() }, { "caps", this->CapBytes },
    { "depth", this->Depth.GetBytes() }, { "counts", this->Counts.GetBytes() } };
}

//------------------------------------------------------------------------------
void vtkShadowVolumes::Release(vtkOpenGLRenderWindow* window)
{
  this->Silhouettes.Release();
  this->CapLight = -1;
  this->Caps->ReleaseGraphicsResources();
  this->CapBytes = 0;
  this->Depth.Release(window);
  this->Counts.Release(window);
}
