// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowSilhouettes.h"

#include "vtkShadowAdjacency.h"
#include "vtkShadowLight.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>

namespace
{
/** Slabs of the light's view, for the bound on nested volumes. */
constexpr int Slabs = 256;

/** A place as a mesh sees it: the sign of (normal, plane offset) . Light says which way a face turns. */
struct LocalPlace
{
  glm::dvec4 Light{ 0.0 };
  bool Mirrored = false;
};

/**
 * By the adjugate instead of the inverse, so that a matrix that flattens the mesh will do: a plane's
 * side is n . adj(A)(L - t) - det(A) (n . p).
 */
LocalPlace ToMesh(const vtkShadowCaster& caster, const glm::dvec4& place)
{
  const glm::dmat3 axes(caster.MeshToSWC);
  const glm::dvec3 light = glm::dvec3(place) - place.w * glm::dvec3(caster.MeshToSWC[3]);
  const glm::dvec3 rows[3] = { glm::cross(axes[1], axes[2]), glm::cross(axes[2], axes[0]),
    glm::cross(axes[0], axes[1]) };
  const double determinant = glm::dot(axes[0], rows[0]);
  LocalPlace local;
  local.Mirrored = determinant < 0.0;
  local.Light = { glm::dot(rows[0], light), glm::dot(rows[1], light), glm::dot(rows[2], light),
    -place.w * determinant };
  local.Light *= local.Mirrored ? -1.0 : 1.0;
  return local;
}

/**
 * For each face a word: bit i where it faces place i. A face whose plane is clear of the box around
 * all places is decided by its middle.
 */
template <typename Word>
void FindFacings(const vtkShadowAdjacency& adjacency, const std::vector<LocalPlace>& places,
  std::vector<Word>& facings)
{
  glm::dvec4 low = places[0].Light;
  glm::dvec4 high = low;
  for (const auto& place : places)
  {
    low = glm::min(low, place.Light);
    high = glm::max(high, place.Light);
  }
  const glm::dvec4 middle = 0.5 * (low + high);
  // A hair more for the rounding of both.
  const glm::dvec4 half = 0.5 * (high - low) + 1e-12 * glm::abs(middle);
  const Word all = static_cast<Word>(~Word(0));
  facings.resize(adjacency.Planes.size());
  for (std::size_t f = 0; f < facings.size(); ++f)
  {
    const glm::dvec4 plane(adjacency.Planes[f]);
    const double side = glm::dot(plane, middle);
    Word word = side > 0.0 ? all : Word(0);
    if (std::abs(side) <= glm::dot(glm::abs(plane), half))
    {
      word = 0;
      for (std::size_t i = 0; i < places.size(); ++i)
      {
        word = static_cast<Word>(word | (Word(glm::dot(plane, places[i].Light) > 0.0) << i));
      }
    }
    facings[f] = word;
  }
}

/** Lines of one caster for each place. */
template <typename Word>
void FindLines(const vtkShadowAdjacency& adjacency, const std::vector<LocalPlace>& places,
  std::vector<std::vector<std::uint32_t>>& lines)
{
  std::vector<Word> facings;
  FindFacings(adjacency, places, facings);
  const bool mirrored = places[0].Mirrored;
  const auto add = [&](int place, std::uint32_t from, std::uint32_t to, int times)
  {
    auto& list = lines[place];
    for (int k = std::abs(times); k > 0; --k)
    {
      const bool forward = (times > 0) != mirrored;
      list.push_back(forward ? from : to);
      list.push_back(forward ? to : from);
    }
  };
  const int count = static_cast<int>(places.size());
  for (const auto& edge : adjacency.Edges)
  {
    const Word first = facings[edge.Faces[0]];
    const Word differ = static_cast<Word>(first ^ facings[edge.Faces[1]]);
    if (differ == 0)
    {
      continue;
    }
    const int times = adjacency.Flags[edge.Faces[0]] & vtkShadowAdjacency::Closed ? 1 : 2;
    for (int i = 0; i < count; ++i)
    {
      if (differ >> i & 1)
      {
        add(i, edge.From, edge.To, first >> i & 1 ? times : -times);
      }
    }
  }
  for (const auto& edge : adjacency.IrregularEdges)
  {
    for (int i = 0; i < count; ++i)
    {
      int times = 0;
      for (std::uint32_t k = edge.First; k < edge.First + edge.Count; ++k)
      {
        const auto& face = adjacency.IrregularFaces[k];
        times += (facings[face.Face] >> i & 1) != face.Backward ? 1 : -1;
      }
      add(i, edge.From, edge.To, times);
    }
  }
}
}

//------------------------------------------------------------------------------
namespace
{
/** Sort the lines of the last part by loops, the longest first, and make it one part for each. */
void SplitLoops(std::vector<std::uint32_t>& lines, std::vector<vtkShadowCasterPart>& parts)
{
  const vtkShadowCasterPart whole = parts.back();
  std::unordered_map<std::uint32_t, std::uint32_t> parents; // of vertices that meet
  const auto find = [&parents](std::uint32_t vertex)
  {
    auto parent = parents.emplace(vertex, vertex).first->second;
    while (parent != vertex)
    {
      vertex = parent;
      parent = parents[vertex];
    }
    return vertex;
  };
  for (std::size_t i = whole.First; i < whole.First + whole.Count; i += 2)
  {
    const std::uint32_t from = find(lines[i]);
    parents[from] = find(lines[i + 1]);
  }
  std::map<std::uint32_t, std::vector<std::uint32_t>> loops;
  for (std::size_t i = whole.First; i < whole.First + whole.Count; i += 2)
  {
    auto& loop = loops[find(lines[i])];
    loop.push_back(lines[i]);
    loop.push_back(lines[i + 1]);
  }
  std::vector<const std::vector<std::uint32_t>*> order;
  for (const auto& loop : loops)
  {
    order.push_back(&loop.second);
  }
  std::stable_sort(
    order.begin(), order.end(), [](const auto* a, const auto* b) { return a->size() > b->size(); });
  parts.pop_back();
  std::size_t at = whole.First;
  for (const auto* loop : order)
  {
    parts.push_back({ whole.Caster, at, loop->size() });
    std::copy(loop->begin(), loop->end(), lines.begin() + static_cast<std::ptrdiff_t>(at));
    at += loop->size();
  }
}
}

//------------------------------------------------------------------------------
vtkShadowFacePlanes::vtkShadowFacePlanes(
  const vtkShadowCaster& caster, const vtkShadowAdjacency& adjacency)
  : Adjacency(adjacency)
{
  // ToMesh is linear in the place: its columns turn planes.
  const glm::dvec4 axes[] = { { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 }, { 0, 0, 0, 1 } };
  for (int c = 0; c < 4; ++c)
  {
    const LocalPlace local = ToMesh(caster, axes[c]);
    this->MeshToSWC[c] = local.Light;
    this->Mirrored = local.Mirrored;
  }
}

//------------------------------------------------------------------------------
glm::dvec4 vtkShadowFacePlanes::Get(std::uint32_t face) const
{
  const glm::dvec4 plane = glm::dvec4(this->Adjacency.Planes[face]) * this->MeshToSWC;
  const double length = glm::length(glm::dvec3(plane));
  return length > 0.0 ? plane / length : glm::dvec4(0.0, 0.0, 0.0, 1.0);
}

//------------------------------------------------------------------------------
void vtkShadowSilhouettes::Find(const vtkShadowCasters& casters,
  const vtkShadowAdjacencies& adjacencies, const std::vector<int>& which, const glm::dvec4* places,
  int numberOfPlaces, std::size_t enoughNested, bool loops)
{
  this->Silhouettes.assign(numberOfPlaces, {});
  std::vector<std::vector<std::uint32_t>> lines(numberOfPlaces);
  for (const int i : which)
  {
    const vtkShadowCaster& caster = casters.Get()[i];
    const vtkShadowAdjacency& adjacency = adjacencies.Get(caster.Mesh);
    std::vector<LocalPlace> local;
    for (int k = 0; k < numberOfPlaces; ++k)
    {
      this->Silhouettes[k].Parts.push_back({ i, lines[k].size(), 0 });
      local.push_back(ToMesh(caster, places[k]));
    }
    numberOfPlaces == 1 ? FindLines<std::uint8_t>(adjacency, local, lines)
                        : FindLines<std::uint64_t>(adjacency, local, lines);
    for (int k = 0; k < numberOfPlaces; ++k)
    {
      auto& parts = this->Silhouettes[k].Parts;
      parts.back().Count = lines[k].size() - parts.back().First;
      if (loops && parts.back().Count > 0)
      {
        SplitLoops(lines[k], parts);
      }
    }
  }
  this->Lines.clear();
  for (int k = 0; k < numberOfPlaces; ++k)
  {
    auto& parts = this->Silhouettes[k].Parts;
    for (auto& part : parts)
    {
      part.First += this->Lines.size();
    }
    this->Lines.insert(this->Lines.end(), lines[k].begin(), lines[k].end());
    this->Silhouettes[k].MostNested =
      this->FindMostNested(casters, which, places[k], this->Silhouettes[k].Parts, enoughNested);
  }
}

//------------------------------------------------------------------------------
std::size_t vtkShadowSilhouettes::FindMostNested(const vtkShadowCasters& casters,
  const std::vector<int>& which, const glm::dvec4& place,
  const std::vector<vtkShadowCasterPart>& parts, std::size_t enough) const
{
  std::size_t lines = 0;
  for (const auto& part : parts)
  {
    lines += part.Count / 2;
  }
  // Seen from the light, casters lie within a half-plane of the view's infinity, where nothing is:
  // walking there from any point, up or down, crosses an edge for each volume that is left.
  const glm::dvec3 light(place);
  glm::dvec3 axis = place.w == 0.0 ? -light : casters.GetMiddle(which) - light;
  const double length = glm::length(axis);
  std::size_t triangles = 0;
  bool ahead = length > 0.0;
  axis /= length;
  for (const int i : which)
  {
    const vtkShadowCaster& caster = casters.Get()[i];
    triangles += caster.Mesh->GetNumberOfTriangles();
    for (const auto& corner : caster.Corners)
    {
      ahead = ahead && (place.w == 0.0 || glm::dot(corner - light, axis) > 1e-6 * length);
    }
  }
  if (!ahead)
  {
    return triangles; // every face, at worst
  }
  if (lines / 2 <= enough)
  {
    return lines / 2; // as good as anything less
  }
  const glm::dvec3 across[2] = { vtkShadowLight::Perpendicular(axis),
    glm::cross(axis, vtkShadowLight::Perpendicular(axis)) };
  std::size_t most = triangles;
  std::vector<float> ends(2 * lines);
  for (const auto& direction : across)
  {
    std::size_t at = 0;
    float low = std::numeric_limits<float>::max();
    float high = std::numeric_limits<float>::lowest();
    for (const auto& part : parts)
    {
      const vtkShadowCaster& caster = casters.Get()[part.Caster];
      const glm::dmat3 axes(caster.MeshToSWC);
      const glm::dvec3 offset = glm::dvec3(caster.MeshToSWC[3]) - place.w * light;
      const glm::dvec4 along(direction * axes, glm::dot(direction, offset));
      const glm::dvec4 depth(
        place.w * (axis * axes), place.w == 0.0 ? 1.0 : glm::dot(axis, offset));
      for (std::size_t i = part.First; i < part.First + part.Count; ++i)
      {
        const float* p = &caster.Mesh->Positions[3 * this->Lines[i]];
        const glm::dvec4 position(p[0], p[1], p[2], 1.0);
        const auto end = static_cast<float>(glm::dot(along, position) / glm::dot(depth, position));
        low = std::min(low, end);
        high = std::max(high, end);
        ends[at++] = end;
      }
    }
    const float scale = high > low ? Slabs / (high - low) : 0.0f;
    const auto slab = [&](float end)
    { return std::clamp(static_cast<int>((end - low) * scale), 0, Slabs - 1); };
    std::vector<long> changes(Slabs + 1, 0);
    for (std::size_t i = 0; i < at; i += 2)
    {
      const auto range = std::minmax({ slab(ends[i]), slab(ends[i + 1]) });
      ++changes[range.first];
      --changes[range.second + 1];
    }
    long count = 0;
    long worst = 0;
    for (const long change : changes)
    {
      count += change;
      worst = std::max(worst, count);
    }
    most = std::min(most, static_cast<std::size_t>(worst / 2));
  }
  return most;
}

//------------------------------------------------------------------------------
void vtkShadowSilhouettes::AddCap(const vtkShadowCaster& caster,
  const vtkShadowAdjacency& adjacency, const glm::dvec4& place, vtkShadowCap cap,
  std::vector<std::uint32_t>& triangles)
{
  const LocalPlace local = ToMesh(caster, place);
  const auto& indices = caster.Mesh->Indices;
  for (std::size_t f = 0; f < adjacency.Planes.size(); ++f)
  {
    const std::uint8_t flags = adjacency.Flags[f];
    const bool facing = glm::dot(glm::dvec4(adjacency.Planes[f]), local.Light) > 0.0;
    const bool closed = (flags & vtkShadowAdjacency::Closed) != 0;
    const bool other = closed && (facing ? cap == vtkShadowCap::Away : cap == vtkShadowCap::Facing);
    if (flags & vtkShadowAdjacency::Left || other)
    {
      continue;
    }
    const bool turn = (!facing != ((flags & vtkShadowAdjacency::Reversed) != 0)) != local.Mirrored;
    for (int times = !closed && cap == vtkShadowCap::All ? 2 : 1; times > 0; --times)
    {
      triangles.push_back(indices[3 * f]);
      triangles.push_back(indices[3 * f + (turn ? 2 : 1)]);
      triangles.push_back(indices[3 * f + (turn ? 1 : 2)]);
    }
  }
}
