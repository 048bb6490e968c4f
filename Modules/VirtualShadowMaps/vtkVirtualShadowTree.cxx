// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVirtualShadowTree.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
/** The virtual map is never finer than so many halvings of a map of one texel: floats end there. */
constexpr int MostHalvings = 18;

constexpr int CellHalvings = 6;
static_assert(1 << CellHalvings == vtkVirtualShadowTree::Cells, "the grid is a power of two");

/** What is off by rounding is no finer. */
constexpr double Tolerance = 1.0 + 1e-6;

/** Cells of a rectangle along an axis: from the first to before the end. */
glm::ivec2 GetCells(int halvings, int number)
{
  if (halvings <= CellHalvings)
  {
    const int width = 1 << (CellHalvings - halvings);
    return { number * width, (number + 1) * width };
  }
  const int cell = number >> (halvings - CellHalvings);
  return { cell, cell + 1 };
}
}

//------------------------------------------------------------------------------
void vtkVirtualShadowTree::Start(int views)
{
  this->Grids.assign(views, std::vector<glm::vec2>(static_cast<std::size_t>(Cells) * Cells,
                              glm::vec2(std::numeric_limits<float>::infinity())));
  this->Nodes.clear();
  this->Tiles.clear();
  this->FirstNodes.assign(views + 1, 0);
}

//------------------------------------------------------------------------------
std::size_t vtkVirtualShadowTree::AddRequests(const std::vector<glm::vec4>& requests)
{
  std::size_t count = 0;
  for (const glm::vec4& request : requests)
  {
    // Comparisons that what is not finite fails.
    const int views = static_cast<int>(this->Grids.size());
    constexpr float most = static_cast<float>(Cells * Cells) * (Cells * Cells);
    if (!(request.z >= 1.0f && request.z < 8388608.0f && request.x >= 0.0f && request.x < most &&
          request.y > 0.0f && request.w > 0.0f))
    {
      continue;
    }
    const int view = (static_cast<int>(request.z) & 7) - 1;
    if (view < 0 || view >= views)
    {
      continue;
    }
    ++count;
    const int both = static_cast<int>(request.x);
    const int low = both % (Cells * Cells);
    const int high = both / (Cells * Cells);
    const glm::vec2 texel(request.y, request.w);
    auto& grid = this->Grids[view];
    for (int y = low / Cells; y <= high / Cells; ++y)
    {
      for (int x = low % Cells; x <= high % Cells; ++x)
      {
        glm::vec2& cell = grid[y * Cells + x];
        cell = glm::min(cell, texel);
      }
    }
  }
  return count;
}

//------------------------------------------------------------------------------
glm::dvec2 vtkVirtualShadowTree::FindLeast(
  int view, const glm::ivec2& first, const glm::ivec2& end) const
{
  glm::vec2 least(std::numeric_limits<float>::infinity());
  for (int y = first.y; y < end.y; ++y)
  {
    for (int x = first.x; x < end.x; ++x)
    {
      least = glm::min(least, this->Grids[view][y * Cells + x]);
    }
  }
  return least;
}

//------------------------------------------------------------------------------
void vtkVirtualShadowTree::Build(const Options& options)
{
  this->Nodes.clear();
  this->Tiles.clear();
  const int views = static_cast<int>(this->Grids.size());
  for (int view = 0; view < views; ++view)
  {
    this->FirstNodes[view] = static_cast<int>(this->Nodes.size());
    this->AddNode(view, { 0, 0, 0, 0 }, options);
  }
  this->FirstNodes[views] = static_cast<int>(this->Nodes.size());
}

//------------------------------------------------------------------------------
void vtkVirtualShadowTree::AddNode(
  int view, const std::array<int, 4>& place, const Options& options)
{
  const std::size_t index = this->Nodes.size();
  Node node;
  const glm::dvec2 size(std::ldexp(1.0, -place[0]), std::ldexp(1.0, -place[1]));
  node.Low = size * glm::dvec2(place[2], place[3]);
  node.High = node.Low + size;
  const glm::ivec2 columns = GetCells(place[0], place[2]);
  const glm::ivec2 rows = GetCells(place[1], place[3]);
  const glm::dvec2 least = this->FindLeast(view, { columns.x, rows.x }, { columns.y, rows.y });
  node.Leaf = !std::isfinite(least.x);
  if (node.Leaf)
  {
    node.Next = static_cast<int>(index) + 1;
    this->Nodes.push_back(node);
    return;
  }
  // How many times finer the map would have to be.
  const glm::dvec2 lack = options.Fixed
                            ? glm::dvec2(0.0)
                            : size / (static_cast<double>(options.Side) * least * Tolerance);
  const auto canSplit = [&](int axis)
  { return lack[axis] > 1.0 && place[axis] + std::log2(options.Side) < MostHalvings; };
  if (!canSplit(0) && !canSplit(1))
  {
    glm::ivec2 texels(options.Side);
    if (!options.Fixed)
    {
      // As many as are asked for, of what is asked for.
      glm::ivec2 first(columns.y, rows.y);
      glm::ivec2 end(columns.x, rows.x);
      for (int y = rows.x; y < rows.y; ++y)
      {
        for (int x = columns.x; x < columns.y; ++x)
        {
          if (std::isfinite(this->Grids[view][y * Cells + x].x))
          {
            first = glm::min(first, glm::ivec2(x, y));
            end = glm::max(end, glm::ivec2(x + 1, y + 1));
          }
        }
      }
      node.Low = glm::max(node.Low, glm::dvec2(first) / static_cast<double>(Cells));
      node.High = glm::min(node.High, glm::dvec2(end) / static_cast<double>(Cells));
      const glm::dvec2 wanted = glm::ceil((node.High - node.Low) / (least * Tolerance));
      texels = glm::ivec2(
        glm::clamp(wanted, glm::dvec2(1.0), glm::dvec2(static_cast<double>(options.Side))));
    }
    node.Leaf = true;
    node.Next = static_cast<int>(index) + 1;
    node.Tile = static_cast<int>(this->Tiles.size());
    vtkVirtualShadowTile tile(view, place, options.Side);
    tile.Low = node.Low;
    tile.High = node.High;
    tile.Size = texels;
    this->Tiles.push_back(tile);
    this->Nodes.push_back(node);
    return;
  }
  this->Nodes.push_back(node);
  const int axis = canSplit(0) && (!canSplit(1) || lack.x >= lack.y) ? 0 : 1;
  for (int half = 0; half < 2; ++half)
  {
    std::array<int, 4> child = place;
    ++child[axis];
    child[2 + axis] = 2 * place[2 + axis] + half;
    this->AddNode(view, child, options);
  }
  this->Nodes[index].Next = static_cast<int>(this->Nodes.size());
}

//------------------------------------------------------------------------------
std::vector<glm::vec4> vtkVirtualShadowTree::GetNodes() const
{
  std::vector<glm::vec4> vectors;
  vectors.reserve(3 * this->Nodes.size());
  for (const Node& node : this->Nodes)
  {
    vectors.emplace_back(glm::vec2(node.Low), glm::vec2(node.High));
    const vtkVirtualShadowTile none;
    const vtkVirtualShadowTile& tile = node.Tile < 0 ? none : this->Tiles[node.Tile];
    const int kind = node.Tile < 0 ? (node.Leaf ? 1 : 0) : 2;
    vectors.emplace_back(node.Next, kind, tile.Layer, tile.Batch);
    vectors.emplace_back(glm::vec2(tile.Corner), glm::vec2(tile.Size));
  }
  return vectors;
}
