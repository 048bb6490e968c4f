// SPDX-License-Identifier: BSD-3-Clause
// The lines of the silhouettes that a light's place sees, as volumes' sides and wedges stand on: runs of
// lines that are nearly straight are one, as far as the picture does not tell.
//
//   lines   index buffer  8 bytes a line: pairs of the casters' vertices
//   planes  RGBA32F       two texels a line, Width a row: the plane through the light's centre and the
//                         line, in SWC, positive where the caster is; and the penumbra's half width
//
// A run moves by an angle that the light sees, its vertices against the line between its ends, and so does
// its shadow. What a pixel is as such an angle depends on where the shadow falls: the least of all places
// behind a caster's box that the view holds is allowed to all of its lines. It is rounded down to a power
// of two, so that a camera that moves a little changes nothing.

#ifndef vtkPenumbraLines_h
#define vtkPenumbraLines_h

#include "vtkNew.h"                   // For the buffer
#include "vtkOpenGLBufferObject.h"    // For the buffer
#include "vtkShadowGL.h"              // For planes
#include "vtkShadowSilhouetteCache.h" // For silhouettes
#include "vtkShadowWedges.h"          // For lights

#include <cstddef>
#include <cstdint>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkShadowVolumes;
struct vtkShadowCaster;
struct vtkShadowFrame;

class vtkPenumbraLines
{
public:
  /** Texels in a row of the planes' texture: even. */
  static constexpr int Width = 1024;

  /** A vertex of a caster's mesh in SWC. */
  static glm::dvec3 GetVertex(const vtkShadowCaster& caster, std::uint32_t vertex);

  /**
   * How far each of some casters' lines may move, as an angle that the light sees, or as a length of a
   * directional one: by so many pixels. 0 where the volume has caps, whose border stays.
   */
  static std::vector<double> FindMoves(const vtkShadowFrame& frame, const vtkShadowVolumes& volumes,
    const std::vector<int>& casters, const vtkShadowWedgeLight& light, double pixels);

  /**
   * Make those of a place's silhouettes; with moves (for each caster of vtkShadowCasters::Get()) runs are
   * merged.
   */
  void Make(vtkShadowFrame& frame, const vtkShadowSilhouetteCache::Batch& batch, int place,
    const vtkShadowWedgeLight& light, const std::vector<double>& moves);

  /** Pairs of vertices, those that count several times one after another. */
  const std::vector<std::uint32_t>& Get() const { return this->Lines; }
  /** Of the casters, or of their loops, in the order of the silhouette's. */
  const std::vector<vtkShadowCasterPart>& GetParts() const { return this->Parts; }
  /** So many lines of silhouettes are in others. */
  std::size_t GetMerged() const { return this->Merged; }

  vtkOpenGLBufferObject* GetBuffer() const { return this->Buffer; }
  vtkShadowTexture& GetPlanes() { return this->Planes; }
  std::size_t GetBytes() const;
  void Release(vtkOpenGLRenderWindow* window);

private:
  std::vector<std::uint32_t> Lines;
  std::vector<vtkShadowCasterPart> Parts;
  std::size_t Merged = 0;
  vtkNew<vtkOpenGLBufferObject> Buffer;
  vtkShadowTexture Planes;
};

#endif
