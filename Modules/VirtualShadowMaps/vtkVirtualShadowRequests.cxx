// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVirtualShadowRequests.h"

#include <glm/vec3.hpp>

#include <algorithm>

namespace
{
constexpr int Numbers = 1 << vtkVirtualShadowRequests::MostHalvings;

/** As in vtkVirtualTilesFS.glsl. */
std::uint32_t Hash(std::uint32_t number, std::uint32_t code)
{
  std::uint32_t hash = number * 73856093u ^ code * 19349663u;
  hash ^= hash >> 15;
  return hash * 2654435761u >> 8;
}
}

//------------------------------------------------------------------------------
std::size_t vtkVirtualShadowRequests::Read(const std::vector<glm::vec4>& requests)
{
  this->Pages.clear();
  std::size_t count = 0;
  glm::vec3 last(0.0f);
  for (const glm::vec4& request : requests)
  {
    // Comparisons that what is not finite fails.
    constexpr float most = static_cast<float>(Numbers) * Numbers;
    if (!(request.z >= 0.5f && request.z < 8388608.0f && request.x >= 0.0f && request.x < most &&
          request.y >= 0.0f && request.y < most))
    {
      continue;
    }
    ++count;
    // What tells of the page, without what the kernel is else.
    const glm::vec3 asked(
      request.x, request.y, static_cast<float>(static_cast<int>(request.z) & 8191));
    if (asked == last)
    {
      continue; // neighbours mostly ask for the same
    }
    last = asked;
    const int x = static_cast<int>(request.x);
    const int y = static_cast<int>(request.y);
    const auto code = static_cast<std::uint64_t>(asked.z) << 32;
    for (int j = y % Numbers; j <= y / Numbers; ++j)
    {
      for (int i = x % Numbers; i <= x / Numbers; ++i)
      {
        this->Pages.insert(code | static_cast<std::uint64_t>(i + Numbers * j));
      }
    }
  }
  return count;
}

//------------------------------------------------------------------------------
std::vector<vtkVirtualShadowTile> vtkVirtualShadowRequests::GetTiles(int side, int coarser) const
{
  std::vector<std::array<int, 5>> places;
  places.reserve(this->Pages.size());
  for (const std::uint64_t page : this->Pages)
  {
    const auto code = static_cast<int>(page >> 32);
    const auto number = static_cast<int>(page & 0xffffffffu);
    std::array<int, 5> place = { (code & 7) - 1, code >> 3 & 31, code >> 8, number % Numbers,
      number / Numbers };
    for (int axis = 0; axis < 2; ++axis)
    {
      const int less = std::min(coarser, place[1 + axis]);
      place[1 + axis] -= less;
      place[3 + axis] >>= less;
    }
    places.push_back(place);
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  std::vector<vtkVirtualShadowTile> tiles;
  tiles.reserve(places.size());
  for (const auto& place : places)
  {
    tiles.emplace_back(
      place[0], std::array<int, 4>{ place[1], place[2], place[3], place[4] }, side);
  }
  return tiles;
}

//------------------------------------------------------------------------------
std::vector<glm::vec4> vtkVirtualShadowRequests::GetTable(
  const std::vector<vtkVirtualShadowTile>& tiles, int firstView)
{
  std::size_t size = 4;
  while (size < 2 * tiles.size())
  {
    size *= 2;
  }
  std::vector<glm::vec4> table(size, glm::vec4(0.0f));
  for (const auto& tile : tiles)
  {
    const auto& place = tile.Place;
    const auto number = static_cast<std::uint32_t>(place[2] + Numbers * place[3]);
    const auto code =
      static_cast<std::uint32_t>(tile.View - firstView + 1 + 8 * place[0] + 256 * place[1]);
    std::size_t slot = Hash(number, code) & (size - 1);
    while (table[slot].y != 0.0f)
    {
      slot = (slot + 1) & (size - 1);
    }
    table[slot] = glm::vec4(number, code, tile.Layer, tile.Kept ? 1.0f : 0.0f);
  }
  return table;
}
