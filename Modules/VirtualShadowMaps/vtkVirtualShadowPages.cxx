// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVirtualShadowPages.h"

#include "vtkLightFrusta.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShadowCasterDrawing.h"
#include "vtkShadowDepthState.h"
#include "vtkShadowFrame.h"
#include "vtkShadowOpenGL.h"

#include <glm/common.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace
{
/** So much is allocated at first, if the budget allows, and then twice as much each time. */
constexpr std::size_t LeastBytes = std::size_t(1) << 25;

/** What turns clip coordinates of a view into those of a tile of it. */
glm::dmat4 GetTileOfClip(const vtkVirtualShadowTile& tile)
{
  const glm::dvec2 scale = 1.0 / (tile.High - tile.Low);
  const glm::dvec2 middle = tile.Low + tile.High - 1.0; // in [-1,1]
  glm::dmat4 matrix(1.0);
  for (int axis = 0; axis < 2; ++axis)
  {
    matrix[axis][axis] = scale[axis];
    matrix[3][axis] = -scale[axis] * middle[axis];
  }
  // Columns: x' = scale x - scale middle w.
  return matrix;
}

/** Where two meshes differ: of each chunk of their triangles the box around those that do. */
std::vector<std::array<glm::dvec3, 8>> FindChanges(
  const vtkShadowMesh& a, const vtkShadowMesh& b, const glm::dmat4& MeshToSWC)
{
  const auto isSame = [&](std::size_t corner)
  {
    const float* p = &a.Positions[3 * std::size_t(a.Indices[corner])];
    const float* q = &b.Positions[3 * std::size_t(b.Indices[corner])];
    return p[0] == q[0] && p[1] == q[1] && p[2] == q[2];
  };
  std::vector<std::array<glm::dvec3, 8>> boxes;
  constexpr std::size_t size = 3 * vtkShadowCasterDrawing::ChunkTriangles;
  const std::size_t most = std::max(a.Indices.size(), b.Indices.size());
  const std::size_t common = std::min(a.Indices.size(), b.Indices.size());
  for (std::size_t first = 0; first < most; first += size)
  {
    constexpr double far = std::numeric_limits<double>::max();
    glm::dvec3 low(far);
    glm::dvec3 high(-far);
    for (std::size_t i = first; i < std::min(first + size, most); i += 3)
    {
      if (i < common && isSame(i) && isSame(i + 1) && isSame(i + 2))
      {
        continue;
      }
      for (const vtkShadowMesh* mesh : { &a, &b })
      {
        for (std::size_t corner = i; corner < i + 3 && corner < mesh->Indices.size(); ++corner)
        {
          const float* p = &mesh->Positions[3 * std::size_t(mesh->Indices[corner])];
          low = glm::min(low, glm::dvec3(p[0], p[1], p[2]));
          high = glm::max(high, glm::dvec3(p[0], p[1], p[2]));
        }
      }
    }
    if (low.x <= high.x)
    {
      std::array<glm::dvec3, 8> corners;
      for (int i = 0; i < 8; ++i)
      {
        corners[i] =
          glm::dvec3(MeshToSWC * glm::dvec4((i & 1) ? high.x : low.x, (i & 2) ? high.y : low.y,
                                   (i & 4) ? high.z : low.z, 1.0));
      }
      boxes.push_back(corners);
    }
  }
  return boxes;
}
}

//------------------------------------------------------------------------------
bool vtkVirtualShadowPages::Seen::operator<(const Seen& other) const
{
  if (this->Mesh != other.Mesh)
  {
    return this->Mesh < other.Mesh;
  }
  const double* a = glm::value_ptr(this->MeshToSWC);
  const double* b = glm::value_ptr(other.MeshToSWC);
  return std::lexicographical_compare(a, a + 16, b, b + 16);
}

//------------------------------------------------------------------------------
int vtkVirtualShadowPages::SetLimits(int side, std::size_t bytes, bool kept)
{
  int layers = 256;
  glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &layers);
  const std::size_t page = std::size_t(4) * side * side;
  const int most =
    kept ? static_cast<int>(std::clamp<std::size_t>(bytes / page, 1, std::max(1, layers))) : 1;
  if (side != this->Side || most != this->Most || kept != this->Kept)
  {
    this->DropAll();
    this->Side = side;
    this->Most = most;
    this->Kept = kept;
  }
  return most;
}

//------------------------------------------------------------------------------
void vtkVirtualShadowPages::DropAll()
{
  this->Pages.clear();
  this->FreeSlots.clear();
  for (int slot = this->Tiles.GetLayers() - 1; slot >= 0; --slot)
  {
    this->FreeSlots.push_back(slot);
  }
}

//------------------------------------------------------------------------------
void vtkVirtualShadowPages::Follow(
  vtkShadowFrame& frame, int part, const std::vector<vtkLightView>& views)
{
  for (int i = 0; i < static_cast<int>(views.size()); ++i)
  {
    View now;
    now.SWCToClip = views[i].SWCToClip;
    for (const int caster : views[i].Casters)
    {
      const vtkShadowCaster& one = frame.Casters->Get()[caster];
      now.Casters.push_back({ one.Mesh, one.MeshToSWC, one.Corners });
    }
    std::sort(now.Casters.begin(), now.Casters.end());
    View& last = this->Views[{ part, i }];
    if (last.SWCToClip != now.SWCToClip)
    {
      const auto from = this->Pages.lower_bound(Key{ part, i, 0, 0, 0, 0 });
      const auto to = this->Pages.lower_bound(Key{ part, i + 1, 0, 0, 0, 0 });
      std::for_each(
        from, to, [this](const auto& page) { this->FreeSlots.push_back(page.second.Slot); });
      this->Pages.erase(from, to);
    }
    else
    {
      this->DropChanges({ part, i }, last, now);
    }
    last = std::move(now);
  }
  // Views that the part no longer has.
  const auto from =
    this->Pages.lower_bound(Key{ part, static_cast<int>(views.size()), 0, 0, 0, 0 });
  const auto to = this->Pages.lower_bound(Key{ part + 1, 0, 0, 0, 0, 0 });
  std::for_each(
    from, to, [this](const auto& page) { this->FreeSlots.push_back(page.second.Slot); });
  this->Pages.erase(from, to);
  this->Views.erase(this->Views.lower_bound({ part, static_cast<int>(views.size()) }),
    this->Views.lower_bound({ part + 1, 0 }));
}

//------------------------------------------------------------------------------
void vtkVirtualShadowPages::FollowEnd(int part)
{
  const auto from = this->Pages.lower_bound(Key{ part, 0, 0, 0, 0, 0 });
  std::for_each(from, this->Pages.end(),
    [this](const auto& page) { this->FreeSlots.push_back(page.second.Slot); });
  this->Pages.erase(from, this->Pages.end());
  this->Views.erase(this->Views.lower_bound({ part, 0 }), this->Views.end());
}

//------------------------------------------------------------------------------
void vtkVirtualShadowPages::DropChanges(
  const std::array<int, 2>& whose, const View& last, const View& now)
{
  std::vector<Seen> gone;
  std::vector<Seen> come;
  std::set_difference(last.Casters.begin(), last.Casters.end(), now.Casters.begin(),
    now.Casters.end(), std::back_inserter(gone));
  std::set_difference(now.Casters.begin(), now.Casters.end(), last.Casters.begin(),
    last.Casters.end(), std::back_inserter(come));
  for (const Seen& old : gone)
  {
    // In the same place: its points have moved, and perhaps few of them.
    const auto same = std::find_if(come.begin(), come.end(),
      [&old](const Seen& other)
      { return other.MeshToSWC == old.MeshToSWC && !old.Mesh->Holes && !other.Mesh->Holes; });
    if (same == come.end())
    {
      this->Drop(whose, now.SWCToClip, old.Corners);
      continue;
    }
    for (const auto& corners : FindChanges(*old.Mesh, *same->Mesh, old.MeshToSWC))
    {
      this->Drop(whose, now.SWCToClip, corners);
    }
    come.erase(same);
  }
  for (const Seen& seen : come)
  {
    this->Drop(whose, now.SWCToClip, seen.Corners);
  }
}

//------------------------------------------------------------------------------
void vtkVirtualShadowPages::Drop(const std::array<int, 2>& whose, const glm::dmat4& SWCToClip,
  const std::array<glm::dvec3, 8>& corners)
{
  glm::dvec2 low(1.0);
  glm::dvec2 high(0.0);
  for (const glm::dvec3& corner : corners)
  {
    const glm::dvec4 p = SWCToClip * glm::dvec4(corner, 1.0);
    if (p.w <= 0.0)
    {
      low = glm::dvec2(0.0); // reaches behind the light: may be anywhere
      high = glm::dvec2(1.0);
      break;
    }
    const glm::dvec2 place = 0.5 * glm::dvec2(p) / p.w + 0.5;
    low = glm::min(low, place);
    high = glm::max(high, place);
  }
  const auto [part, view] = whose;
  auto page = this->Pages.lower_bound(Key{ part, view, 0, 0, 0, 0 });
  while (page != this->Pages.end() && page->first[0] == part && page->first[1] == view)
  {
    const Key& key = page->first;
    bool over = true;
    for (int axis = 0; axis < 2; ++axis)
    {
      // A texel more, for what the rasterizer rounds.
      const double size = std::ldexp(1.0, -key[2 + axis]);
      const double texel = size / this->Side;
      over = over && high[axis] >= key[4 + axis] * size - texel &&
             low[axis] <= (key[4 + axis] + 1) * size + texel;
    }
    if (over)
    {
      this->FreeSlots.push_back(page->second.Slot);
      page = this->Pages.erase(page);
    }
    else
    {
      ++page;
    }
  }
}

//------------------------------------------------------------------------------
bool vtkVirtualShadowPages::Allocate(vtkShadowFrame& frame, int slots)
{
  const auto least = static_cast<int>(LeastBytes / (std::size_t(4) * this->Side * this->Side));
  int layers = std::max({ 1, least, this->Tiles.GetLayers() });
  while (layers < slots)
  {
    layers *= 2;
  }
  layers = std::min(layers, this->Most);
  const unsigned long before = this->Tiles.GetGeneration();
  const bool made = this->Tiles.Allocate(
    frame.Window, vtkShadowTexture::Format::Depth, this->Side, this->Side, layers);
  if (before != this->Tiles.GetGeneration() || !made)
  {
    this->DropAll();
  }
  return made;
}

//------------------------------------------------------------------------------
bool vtkVirtualShadowPages::Place(
  vtkShadowFrame& frame, int part, std::vector<vtkVirtualShadowTile>& tiles)
{
  ++this->Time;
  this->Batches = 1;
  return this->Kept ? this->PlacePages(frame, part, tiles) : this->PlaceInTurn(frame, tiles);
}

//------------------------------------------------------------------------------
bool vtkVirtualShadowPages::PlacePages(
  vtkShadowFrame& frame, int part, std::vector<vtkVirtualShadowTile>& tiles)
{
  const auto getKey = [part](const vtkVirtualShadowTile& tile) {
    return Key{ part, tile.View, tile.Place[0], tile.Place[1], tile.Place[2], tile.Place[3] };
  };
  std::size_t missing = 0;
  for (const auto& tile : tiles)
  {
    missing += this->Pages.count(getKey(tile)) == 0 ? 1 : 0;
  }
  // Room for what other parts and the last frames used too, within the budget.
  if (!this->Allocate(frame, static_cast<int>(this->Pages.size() + missing)))
  {
    return false;
  }
  for (const auto& tile : tiles)
  {
    const auto page = this->Pages.find(getKey(tile));
    if (page != this->Pages.end())
    {
      page->second.Used = this->Time;
    }
  }
  // What was not used for longest goes.
  std::vector<std::map<Key, Page>::iterator> old;
  for (auto page = this->Pages.begin(); page != this->Pages.end(); ++page)
  {
    if (page->second.Used != this->Time)
    {
      old.push_back(page);
    }
  }
  std::stable_sort(old.begin(), old.end(),
    [](const auto& a, const auto& b) { return a->second.Used > b->second.Used; });
  for (auto& tile : tiles)
  {
    const Key key = getKey(tile);
    auto page = this->Pages.find(key);
    tile.Kept = page != this->Pages.end();
    if (!tile.Kept)
    {
      if (this->FreeSlots.empty() && old.empty())
      {
        return false;
      }
      if (this->FreeSlots.empty())
      {
        this->FreeSlots.push_back(old.back()->second.Slot);
        this->Pages.erase(old.back());
        old.pop_back();
      }
      page = this->Pages.emplace(key, Page{ this->FreeSlots.back(), this->Time }).first;
      this->FreeSlots.pop_back();
    }
    // A layer each: at another corner of a larger one, the rasterizer would round otherwise.
    tile.Layer = page->second.Slot;
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkVirtualShadowPages::PlaceInTurn(
  vtkShadowFrame& frame, std::vector<vtkVirtualShadowTile>& tiles)
{
  if (!this->Allocate(frame, 1))
  {
    return false;
  }
  // Rows of tiles, the highest first.
  std::vector<vtkVirtualShadowTile*> order;
  for (auto& tile : tiles)
  {
    order.push_back(&tile);
  }
  std::stable_sort(
    order.begin(), order.end(), [](const auto* a, const auto* b) { return a->Size.y > b->Size.y; });
  int batch = 0;
  int height = 0;
  glm::ivec2 corner(0);
  for (vtkVirtualShadowTile* tile : order)
  {
    if (corner.x + tile->Size.x > this->Side)
    {
      corner = { 0, corner.y + height };
      height = 0;
    }
    if (corner.y + tile->Size.y > this->Side)
    {
      ++batch;
      corner = glm::ivec2(0);
      height = 0;
    }
    tile->Batch = batch;
    tile->Layer = 0;
    tile->Corner = corner;
    tile->Kept = false;
    corner.x += tile->Size.x;
    height = std::max(height, tile->Size.y);
  }
  this->Batches = batch + 1;
  return true;
}

//------------------------------------------------------------------------------
void vtkVirtualShadowPages::Draw(vtkShadowFrame& frame, const std::vector<vtkLightView>& views,
  const std::vector<vtkVirtualShadowTile>& tiles, int batch)
{
  vtkShadowTimers::Scope timer(*frame.Timers, "tiles");
  vtkShadowDepthState depthState(frame.Window->GetState());
  vtkShadowFramebuffer::Scope target(frame.Window, this->Framebuffer, nullptr, &this->Tiles, 0);
  const std::size_t before = frame.Drawing->GetDrawnTriangles();
  const std::size_t chunksBefore = frame.Drawing->GetDrawnChunks();
  for (const auto& tile : tiles)
  {
    if (tile.Batch != batch || tile.Kept)
    {
      continue;
    }
    target.SetLayer(tile.Layer);
    target.SetRectangle(tile.Corner.x, tile.Corner.y, tile.Size.x, tile.Size.y);
    const float farthest = 1.0f;
    glClearBufferfv(GL_DEPTH, 0, &farthest); // of the rectangle
    const vtkLightView& view = views[tile.View];
    frame.Drawing->Draw(frame.Window, GetTileOfClip(tile) * view.SWCToClip, view.Casters);
    frame.Counts["tilesDrawn"] += 1.0;
  }
  frame.Counts["tileTrianglesDrawn"] +=
    static_cast<double>(frame.Drawing->GetDrawnTriangles() - before);
  frame.Counts["tileChunksDrawn"] +=
    static_cast<double>(frame.Drawing->GetDrawnChunks() - chunksBefore);
}

//------------------------------------------------------------------------------
void vtkVirtualShadowPages::Release(vtkOpenGLRenderWindow* window)
{
  this->Tiles.Release(window);
  this->Framebuffer.Release(window);
  this->Pages.clear();
  this->FreeSlots.clear();
  this->Views.clear();
  this->Side = 0;
}
