// SPDX-License-Identifier: BSD-3-Clause
// The wedges of one light, or of a part of its area: made from edges that casters end at, kept on the GPU.
//
//   wedges  vertex buffer    68 bytes a corner, 45 to 60 corners a wedge
//   planes  RGBA32F buffer   a texel a line of the silhouettes' batch: through the light's centre and the
//                            edge, in SWC, positive where the caster is

#ifndef vtkPenumbraWedges_h
#define vtkPenumbraWedges_h

#include "vtkShadowGL.h"       // For planes
#include "vtkShadowVertices.h" // For vertices
#include "vtkShadowVolumes.h"  // For what they are drawn over
#include "vtkShadowWedges.h"   // For bounds

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

class vtkShaderProgram;
class vtkShadowCasters;
class vtkVisibilityBuffer;
struct vtkShadowFrame;

class vtkPenumbraWedges
{
public:
  /** Of which light, or part of its area. */
  void SetLight(const vtkShadowWedgeLight& light) { this->Light = light; }
  const vtkShadowWedgeLight& GetLight() const { return this->Light; }

  /** Make those of the silhouettes of a light's place, and the planes of all of the batch's lines. */
  void MakeOfSilhouette(vtkShadowFrame& frame, const vtkShadowSilhouetteCache::Batch& batch,
    int place, vtkShadowWedge::Bounds bounds);

  /** Draw those that may be seen, for vtkShadowVolumes::AddBehind; counts in the frame. */
  void Draw(vtkShadowFrame& frame, const vtkShadowVolumes& volumes, const glm::dmat4& SWCToDraw,
    float farthest, const vtkShadowPrograms::Sources& sources,
    const std::function<void(vtkShaderProgram*)>& setParameters);
  /** Set what vtkPenumbraLightFS.glsl needs; and what it is to begin with. */
  void SetLight(const vtkShadowFrame& frame, vtkShaderProgram* program) const;
  std::string GetLightGLSL() const;

  vtkShadowTexture& GetPlanes() { return this->Planes; }
  std::size_t GetNumberOfWedges() const { return this->Wedges; }
  std::size_t GetBytes() const { return this->Vertices.GetBytes() + this->Planes.GetBytes(); }
  void Release(vtkOpenGLRenderWindow* window);

private:
  /** Corners of a caster's wedges. */
  struct Part
  {
    int Caster;
    std::size_t First;
    std::size_t Count;
    std::size_t Wedges;
  };
  using Boxes = std::vector<std::array<glm::dvec3, 8>>;

  void AddWedge(const vtkShadowWedgeEdge& edge, vtkShadowWedge::Bounds bounds, const Boxes& boxes,
    std::vector<float>& values);
  /** What may be shadowed; none where there is too much of it to be asked for each wedge. */
  static Boxes GetReceivers(const vtkShadowCasters& casters);
  std::vector<glm::dvec4> GetExtremes() const;

  vtkShadowWedgeLight Light;
  vtkShadowVertices Vertices;
  vtkShadowTexture Planes;
  std::vector<Part> Parts;
  std::size_t Wedges = 0;
  std::size_t Culled = 0; // that no receiver lies in
};

#endif
