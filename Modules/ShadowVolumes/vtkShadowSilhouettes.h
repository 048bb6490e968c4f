// SPDX-License-Identifier: BSD-3-Clause
// Silhouettes of casters as some places on a light see them, and the caps of their volumes.
//
// A volume holds what lies behind a set of faces, all turned towards the light. Its sides stand on
// the edges where the set's boundary runs: an edge counts the signed sum of its faces, each as it
// runs along the edge once it is turned.
//   - Of a closed body the set is the faces that face away. Its boundary is the silhouette, each edge
//     counting once, and its cap is nowhere a surface that light reaches. But the volume begins at the
//     body's far side: what lies inside of it counts as lit.
//   - Of all else the set is every face, so that holes, sheets and any winding are right. Where two
//     faces meet in a silhouette, the edge counts twice.
//
// Where the inside of bodies is seen, their caps are others (vtkShadowCap). What faces the light and
// what faces away have the same boundary, so that all stand on the same edges.
//
// For up to 64 places at once, one word a face says which of them it faces; words of most edges' two
// faces are equal, which leaves the edge out for all places together.

#ifndef vtkShadowSilhouettes_h
#define vtkShadowSilhouettes_h

#include "vtkShadowCasterDrawing.h"            // For vtkShadowCasterPart
#include "vtkSoftShadowsShadowVolumesModule.h" // For export macro

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

class vtkShadowAdjacencies;
struct vtkShadowAdjacency;

/** Which faces of closed bodies are in a cap. */
enum class vtkShadowCap
{
  Away,   // those that face away: right outside of the body
  Facing, // those that face the light: inside too, if the light is outside
  All     // right everywhere; the sides are drawn twice, and so are the faces of what is not closed
};

/** What one place on a light sees. */
struct vtkShadowSilhouette
{
  /** Pairs of vertices: parts of the line list of vtkShadowSilhouettes::Lines. */
  std::vector<vtkShadowCasterPart> Parts;
  /** No point lies in more volumes than this: by edges in slabs of the light's view. */
  std::size_t MostNested = 0;
};

/** The planes of a caster's faces in SWC, as its adjacency winds them. */
class VTKSOFTSHADOWSSHADOWVOLUMES_EXPORT vtkShadowFacePlanes
{
public:
  vtkShadowFacePlanes(const vtkShadowCaster& caster, const vtkShadowAdjacency& adjacency);
  /** Of unit normal, positive before the face. What has no normal is seen from before everywhere. */
  glm::dvec4 Get(std::uint32_t face) const;
  /** The caster's matrix turns left into right. */
  bool IsMirrored() const { return this->Mirrored; }

private:
  const vtkShadowAdjacency& Adjacency;
  glm::dmat4 MeshToSWC; // of planes
  bool Mirrored;
};

class VTKSOFTSHADOWSSHADOWVOLUMES_EXPORT vtkShadowSilhouettes
{
public:
  /** Places are handled in words of this many. */
  static constexpr int MostPlaces = 64;

  /**
   * Find the silhouettes of casters (indices into Get(), with adjacencies) from up to 64 places:
   * positions in SWC (w 1) or directions towards the light (w 0). A bound on nested volumes need not be
   * lower than what is enough. By loops, a caster has a part for each loop of its lines: lines that meet.
   */
  void Find(const vtkShadowCasters& casters, const vtkShadowAdjacencies& adjacencies,
    const std::vector<int>& which, const glm::dvec4* places, int numberOfPlaces,
    std::size_t enoughNested = 255, bool loops = false);

  /** One for each place. */
  const std::vector<vtkShadowSilhouette>& Get() const { return this->Silhouettes; }
  /** Directed so that the volume lies to the left, seen from the light with the caster above. */
  const std::vector<std::uint32_t>& GetLines() const { return this->Lines; }
  /** Once they lie on the GPU. */
  void ReleaseLines() { std::vector<std::uint32_t>().swap(this->Lines); }

  /** Add the triangles of a caster's cap, turned to the light, to a list. */
  static void AddCap(const vtkShadowCaster& caster, const vtkShadowAdjacency& adjacency,
    const glm::dvec4& place, vtkShadowCap cap, std::vector<std::uint32_t>& triangles);

private:
  std::size_t FindMostNested(const vtkShadowCasters& casters, const std::vector<int>& which,
    const glm::dvec4& place, const std::vector<vtkShadowCasterPart>& parts,
    std::size_t enough) const;

  std::vector<vtkShadowSilhouette> Silhouettes;
  std::vector<std::uint32_t> Lines;
};

#endif
