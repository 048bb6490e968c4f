// SPDX-License-Identifier: BSD-3-Clause
// Which faces of a caster's mesh meet at which edge: what silhouettes are found from.
//
// Built once for a mesh, from OpenMesh's half-edges, and kept as flat arrays. Vertices at the same
// place are one. Any triangles will do: a face that the half-edge structure cannot take (a third one
// at an edge, or one that touches others at a vertex only) gets vertices of its own, and edges are
// then joined by their end points. Of faces with the same three corners one is kept.
//
// 16 bytes an edge (24 a triangle in a closed mesh) and 17 bytes a triangle; an open edge takes 24.

#ifndef vtkShadowAdjacency_h
#define vtkShadowAdjacency_h

#include "vtkSoftShadowsShadowVolumesModule.h" // For export macro

#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

class vtkShadowCasters;
struct vtkShadowMesh;

struct VTKSOFTSHADOWSSHADOWVOLUMES_EXPORT vtkShadowAdjacency
{
  /** An edge that two faces run along in opposite directions, Faces[0] from From to To. */
  struct Edge
  {
    std::uint32_t From = 0; // vertices of the mesh
    std::uint32_t To = 0;
    std::uint32_t Faces[2] = { 0, 0 }; // triangles of the mesh
  };
  /** Any other edge: of one face, of more than two, or of two that run in the same direction. */
  struct IrregularEdge
  {
    std::uint32_t From = 0;
    std::uint32_t To = 0;
    std::uint32_t First = 0; // of its faces in IrregularFaces
    std::uint32_t Count = 0;
  };
  /** A face of an irregular edge, and whether it runs from To to From. */
  struct IrregularFace
  {
    std::uint32_t Face = 0;
    bool Backward = false;
  };
  enum Flag : std::uint8_t
  {
    Closed = 1,   // part of a body without irregular edges, wound outwards
    Reversed = 2, // wound the other way than in the mesh
    Left = 4      // left out: another face has the same corners, or two of its own are one
  };

  std::vector<Edge> Edges;
  std::vector<IrregularEdge> IrregularEdges;
  std::vector<IrregularFace> IrregularFaces;
  /** Of each triangle: normal (not of unit length), and its product with a corner. */
  std::vector<glm::vec4> Planes;
  /** Of each triangle: flags. */
  std::vector<std::uint8_t> Flags;

  // What was found.
  std::size_t OpenEdges = 0;         // of one face
  std::size_t NonManifoldEdges = 0;  // of more than two that are no pairs
  std::size_t InconsistentEdges = 0; // of two that are wound differently
  std::size_t DuplicateFaces = 0;

  std::size_t GetBytes() const;

  static std::shared_ptr<const vtkShadowAdjacency> Make(const vtkShadowMesh& mesh);
};

/** The adjacencies of casters' meshes, each made when it is first wanted and kept with its mesh. */
class VTKSOFTSHADOWSSHADOWVOLUMES_EXPORT vtkShadowAdjacencies
{
public:
  /** Make those of some casters (indices into Get()) that are not there. Gives how many. */
  int Add(const vtkShadowCasters& casters, const std::vector<int>& wanted);
  /** Forget those whose meshes no caster has any more. */
  void Prune(const vtkShadowCasters& casters);
  /** That of a caster's mesh, which Add has made. */
  const vtkShadowAdjacency& Get(const std::shared_ptr<const vtkShadowMesh>& mesh) const
  {
    return *this->Adjacencies.at(mesh);
  }
  const std::map<std::shared_ptr<const vtkShadowMesh>, std::shared_ptr<const vtkShadowAdjacency>>&
  GetAll() const
  {
    return this->Adjacencies;
  }
  void Clear() { this->Adjacencies.clear(); }

private:
  std::map<std::shared_ptr<const vtkShadowMesh>, std::shared_ptr<const vtkShadowAdjacency>>
    Adjacencies;
};

#endif
