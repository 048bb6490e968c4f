// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowAdjacency.h"

#include "vtkShadowCasters.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/System/omstream.hh>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <map>
#include <numeric>
#include <set>
#include <unordered_map>
#include <unordered_set>

namespace
{
using HalfEdges = OpenMesh::TriMesh_ArrayKernelT<>;
using Key = std::array<std::uint32_t, 3>;

struct HashKey
{
  std::size_t operator()(const Key& key) const
  {
    std::uint64_t hash = 0x9e3779b97f4a7c15u;
    for (const std::uint32_t word : key)
    {
      hash = (hash ^ word) * 0xff51afd7ed558ccdu;
      hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash);
  }
};

/** Sets of faces that edges connect. */
class Bodies
{
public:
  explicit Bodies(std::size_t count)
    : Parents(count)
  {
    std::iota(this->Parents.begin(), this->Parents.end(), 0u);
  }
  std::uint32_t Find(std::uint32_t face)
  {
    while (this->Parents[face] != face)
    {
      face = this->Parents[face] = this->Parents[this->Parents[face]];
    }
    return face;
  }
  void Join(std::uint32_t a, std::uint32_t b) { this->Parents[this->Find(a)] = this->Find(b); }

private:
  std::vector<std::uint32_t> Parents;
};

/** For each vertex of the mesh, the first one at the same place. */
std::vector<std::uint32_t> Weld(const vtkShadowMesh& mesh)
{
  std::vector<std::uint32_t> first(mesh.GetNumberOfVertices());
  std::unordered_map<Key, std::uint32_t, HashKey> places(first.size());
  for (std::uint32_t v = 0; v < first.size(); ++v)
  {
    Key key;
    for (int c = 0; c < 3; ++c)
    {
      const float x = mesh.Positions[3 * v + c] + 0.0f; // -0 is 0
      std::memcpy(&key[c], &x, sizeof(x));
    }
    first[v] = places.emplace(key, v).first->second;
  }
  return first;
}

/** Whether the half-edge structure can take a face: all its half-edges are free. */
bool Fits(const HalfEdges& mesh, const std::array<OpenMesh::VertexHandle, 3>& corners)
{
  for (int i = 0; i < 3; ++i)
  {
    const auto edge = mesh.find_halfedge(corners[i], corners[(i + 1) % 3]);
    if (!mesh.is_boundary(corners[i]) || (edge.is_valid() && !mesh.is_boundary(edge)))
    {
      return false;
    }
  }
  return true;
}

/** The half-edge structure of a mesh, and what its parts are in the mesh. */
struct Structure
{
  HalfEdges Mesh;
  std::vector<std::uint32_t> Triangles; // of each face
  std::vector<std::uint32_t> Vertices;  // of each vertex, the first at its place

  void Add(const vtkShadowMesh& mesh, vtkShadowAdjacency& result)
  {
    const auto first = Weld(mesh);
    this->Mesh.reserve(first.size(), mesh.Indices.size() / 2, mesh.GetNumberOfTriangles());
    std::vector<OpenMesh::VertexHandle> handles(first.size());
    for (std::uint32_t v = 0; v < first.size(); ++v)
    {
      handles[v] = first[v] == v ? this->AddVertex(v) : handles[first[v]];
    }
    std::unordered_set<Key, HashKey> known(mesh.GetNumberOfTriangles());
    for (std::uint32_t t = 0; t < mesh.GetNumberOfTriangles(); ++t)
    {
      std::array<OpenMesh::VertexHandle, 3> corners;
      Key key;
      for (int i = 0; i < 3; ++i)
      {
        key[i] = first[mesh.Indices[3 * t + i]];
        corners[i] = handles[key[i]];
      }
      std::sort(key.begin(), key.end());
      if (key[0] == key[1] || key[1] == key[2])
      {
        result.Flags[t] |= vtkShadowAdjacency::Left; // of no area once its corners are floats
        continue;
      }
      if (!known.insert(key).second)
      {
        result.Flags[t] |= vtkShadowAdjacency::Left;
        ++result.DuplicateFaces;
        continue;
      }
      auto face = OpenMesh::FaceHandle();
      if (Fits(this->Mesh, corners))
      {
        face = this->Mesh.add_face(corners[0], corners[1], corners[2]);
      }
      else
      {
        std::swap(corners[1], corners[2]);
        if (Fits(this->Mesh, corners))
        {
          face = this->Mesh.add_face(corners[0], corners[1], corners[2]);
        }
        if (face.is_valid())
        {
          result.Flags[t] |= vtkShadowAdjacency::Reversed;
        }
        else
        {
          std::swap(corners[1], corners[2]);
        }
      }
      if (!face.is_valid())
      {
        for (auto& corner : corners)
        {
          corner = this->AddVertex(this->Vertices[corner.idx()]);
        }
        this->Mesh.add_face(corners[0], corners[1], corners[2]);
      }
      this->Triangles.push_back(t);
    }
  }

private:
  OpenMesh::VertexHandle AddVertex(std::uint32_t vertex)
  {
    this->Vertices.push_back(vertex);
    return this->Mesh.add_vertex(HalfEdges::Point(0.0f)); // places stay in the vtkShadowMesh
  }
};

/** OpenMesh says on a stream of its own what it cannot link; here that is no error. */
class Quiet
{
public:
  Quiet() { omerr().disable(); }
  ~Quiet() { omerr().enable(); }
  Quiet(const Quiet&) = delete;
  void operator=(const Quiet&) = delete;
};

void FindEdges(const Structure& structure, vtkShadowAdjacency& result)
{
  const HalfEdges& mesh = structure.Mesh;
  const auto vertex = [&](OpenMesh::VertexHandle v) { return structure.Vertices[v.idx()]; };
  const auto triangle = [&](OpenMesh::FaceHandle f) { return structure.Triangles[f.idx()]; };
  const auto arePair = [](const std::vector<vtkShadowAdjacency::IrregularFace>& faces)
  { return faces.size() == 2 && faces[0].Backward != faces[1].Backward; };
  // Edges with a free side, by their end points: faces that were given vertices of their own meet
  // their neighbours again, or else the two that already share that edge.
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<vtkShadowAdjacency::IrregularFace>>
    free;
  result.Edges.reserve(mesh.n_edges());
  for (const bool shared : { false, true })
  {
    for (const auto edge : mesh.edges())
    {
      const auto a = mesh.halfedge_handle(edge, 0);
      const auto b = mesh.halfedge_handle(edge, 1);
      const std::uint32_t from = vertex(mesh.from_vertex_handle(a));
      const std::uint32_t to = vertex(mesh.to_vertex_handle(a));
      if (shared != (!mesh.is_boundary(a) && !mesh.is_boundary(b)))
      {
        continue;
      }
      const bool forward = from < to;
      const auto same = shared ? free.find(std::minmax(from, to)) : free.end();
      if (shared && (same == free.end() || arePair(same->second)))
      {
        result.Edges.push_back(
          { from, to, { triangle(mesh.face_handle(a)), triangle(mesh.face_handle(b)) } });
        continue;
      }
      auto& faces = shared ? same->second : free[std::minmax(from, to)];
      if (!mesh.is_boundary(a))
      {
        faces.push_back({ triangle(mesh.face_handle(a)), !forward });
      }
      if (!mesh.is_boundary(b))
      {
        faces.push_back({ triangle(mesh.face_handle(b)), forward });
      }
    }
  }
  for (const auto& entry : free)
  {
    const auto& faces = entry.second;
    if (arePair(faces))
    {
      const int forward = faces[0].Backward ? 1 : 0;
      result.Edges.push_back({ entry.first.first, entry.first.second,
        { faces[forward].Face, faces[1 - forward].Face } });
      continue;
    }
    ++(faces.size() == 1   ? result.OpenEdges
       : faces.size() == 2 ? result.InconsistentEdges
                           : result.NonManifoldEdges);
    result.IrregularEdges.push_back({ entry.first.first, entry.first.second,
      static_cast<std::uint32_t>(result.IrregularFaces.size()),
      static_cast<std::uint32_t>(faces.size()) });
    result.IrregularFaces.insert(result.IrregularFaces.end(), faces.begin(), faces.end());
  }
}

/** Mark what belongs to closed bodies, and wind those outwards. */
void FindBodies(const vtkShadowMesh& mesh, vtkShadowAdjacency& result)
{
  Bodies bodies(mesh.GetNumberOfTriangles());
  for (const auto& edge : result.Edges)
  {
    bodies.Join(edge.Faces[0], edge.Faces[1]);
  }
  std::vector<bool> open(mesh.GetNumberOfTriangles(), false);
  for (const auto& edge : result.IrregularEdges)
  {
    for (std::uint32_t i = 0; i < edge.Count; ++i)
    {
      open[bodies.Find(result.IrregularFaces[edge.First + i].Face)] = true;
    }
  }
  // Six times the volume that the faces of a body enclose.
  std::vector<double> volumes(mesh.GetNumberOfTriangles(), 0.0);
  const auto corner = [&](std::uint32_t t, int i)
  {
    const float* p = &mesh.Positions[3 * mesh.Indices[3 * t + i]];
    return glm::dvec3(p[0], p[1], p[2]);
  };
  for (std::uint32_t t = 0; t < volumes.size(); ++t)
  {
    const double volume = glm::dot(corner(t, 0), glm::cross(corner(t, 1), corner(t, 2)));
    volumes[bodies.Find(t)] += result.Flags[t] & vtkShadowAdjacency::Reversed ? -volume : volume;
  }
  for (std::uint32_t t = 0; t < volumes.size(); ++t)
  {
    const std::uint32_t body = bodies.Find(t);
    if (!open[body] && !(result.Flags[t] & vtkShadowAdjacency::Left))
    {
      result.Flags[t] |= vtkShadowAdjacency::Closed;
      result.Flags[t] ^= volumes[body] < 0.0 ? vtkShadowAdjacency::Reversed : 0;
    }
    const glm::dvec3 a = corner(t, 0);
    glm::dvec3 normal = glm::cross(corner(t, 1) - a, corner(t, 2) - a);
    // Scaled, or a small unit's squares would underflow.
    const double size = std::max({ std::abs(normal.x), std::abs(normal.y), std::abs(normal.z) });
    normal /= size > 0.0 ? size : 1.0;
    normal = result.Flags[t] & vtkShadowAdjacency::Reversed ? -normal : normal;
    result.Planes.emplace_back(normal, glm::dot(glm::dvec3(glm::vec3(normal)), a));
  }
  for (auto& edge : result.Edges)
  {
    const std::uint32_t body = bodies.Find(edge.Faces[0]);
    if (!open[body] && volumes[body] < 0.0)
    {
      std::swap(edge.Faces[0], edge.Faces[1]);
    }
  }
}
}

//------------------------------------------------------------------------------
std::shared_ptr<const vtkShadowAdjacency> vtkShadowAdjacency::Make(const vtkShadowMesh& mesh)
{
  auto result = std::make_shared<vtkShadowAdjacency>();
  result->Flags.assign(mesh.GetNumberOfTriangles(), 0);
  result->Planes.reserve(mesh.GetNumberOfTriangles());
  {
    const Quiet quiet;
    Structure structure;
    structure.Add(mesh, *result);
    FindEdges(structure, *result);
  }
  FindBodies(mesh, *result);
  result->Edges.shrink_to_fit();
  return result;
}

//------------------------------------------------------------------------------
std::size_t vtkShadowAdjacency::GetBytes() const
{
  return this->Edges.size() * sizeof(Edge) + this->IrregularEdges.size() * sizeof(IrregularEdge) +
         this->IrregularFaces.size() * sizeof(IrregularFace) +
         this->Planes.size() * sizeof(this->Planes[0]) + this->Flags.size();
}

//------------------------------------------------------------------------------
int vtkShadowAdjacencies::Add(const vtkShadowCasters& casters, const std::vector<int>& wanted)
{
  int made = 0;
  for (const int i : wanted)
  {
    auto& adjacency = this->Adjacencies[casters.Get()[i].Mesh];
    if (!adjacency)
    {
      adjacency = vtkShadowAdjacency::Make(*casters.Get()[i].Mesh);
      ++made;
    }
  }
  return made;
}

//------------------------------------------------------------------------------
void vtkShadowAdjacencies::Prune(const vtkShadowCasters& casters)
{
  std::set<std::shared_ptr<const vtkShadowMesh>> meshes;
  for (const auto& caster : casters.Get())
  {
    meshes.insert(caster.Mesh);
  }
  for (auto entry = this->Adjacencies.begin(); entry != this->Adjacencies.end();)
  {
    entry = meshes.count(entry->first) ? std::next(entry) : this->Adjacencies.erase(entry);
  }
}
