// SPDX-License-Identifier: BSD-3-Clause
// The wedges of one light, or of a part of its area: made from edges that casters end at, kept on
// the GPU.
//
//   wedges  vertex buffer    60 bytes a corner, 92 of all edges; about 50 corners a wedge

#ifndef vtkPenumbraWedges_h
#define vtkPenumbraWedges_h

#include "vtkPenumbraLines.h"  // For lines
#include "vtkShadowVertices.h" // For vertices
#include "vtkShadowVolumes.h"  // For what they are drawn over
#include "vtkShadowWedges.h"   // For bounds

#include <glm/vec3.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

class vtkPenumbraEmission;
class vtkShaderProgram;
class vtkShadowAdjacencies;
class vtkShadowCasters;
class vtkVisibilityBuffer;
struct vtkShadowAdjacency;
struct vtkShadowCaster;
struct vtkShadowFrame;

class vtkPenumbraWedges
{
public:
  /** Of which light, or part of its area. */
  void SetLight(const vtkShadowWedgeLight& light) { this->Light = light; }
  /** Tables of what it emits, which outlive these; null where it emits evenly. */
  void SetEmission(vtkPenumbraEmission* emission) { this->Emission = emission; }
  const vtkShadowWedgeLight& GetLight() const { return this->Light; }

  /** The lines of the silhouettes of the light's centre: what is counted, and stood on by wedges. */
  vtkPenumbraLines& GetLines() { return this->Lines; }
  const vtkPenumbraLines& GetLines() const { return this->Lines; }
  /** Make the wedges of these lines. */
  void MakeOfSilhouette(vtkShadowFrame& frame, vtkShadowWedge::Bounds bounds);
  /**
   * Make those of all edges that casters (indices of vtkShadowCasters::Get()) may end at, as any point of
   * the light sees them.
   */
  void MakeOfEdges(vtkShadowFrame& frame, const vtkShadowAdjacencies& adjacencies,
    const std::vector<int>& casters, vtkShadowWedge::Bounds bounds);

  /**
   * Draw those that may be seen, for vtkShadowVolumes::AddBehind; counts in the frame. Of some parts of the
   * silhouette alone, if these are named.
   */
  void Draw(vtkShadowFrame& frame, const vtkShadowVolumes& volumes, const glm::dmat4& SWCToDraw,
    float farthest, const glm::vec2& retreat, const vtkShadowPrograms::Sources& sources,
    const std::function<void(vtkShaderProgram*)>& setParameters,
    const std::vector<int>* some = nullptr);
  ///@{ Bind the tables of what it emits, around what is drawn with SetLight.
  void Activate(vtkOpenGLRenderWindow* window) const;
  void Deactivate(vtkOpenGLRenderWindow* window) const;
  ///@}
  /** Set what vtkPenumbraLightFS.glsl needs; and what it is to begin with. */
  void SetLight(const vtkShadowFrame& frame, vtkShaderProgram* program) const;
  std::string GetLightGLSL() const;

  std::size_t GetNumberOfWedges() const { return this->Wedges; }
  std::size_t GetBytes() const { return this->Vertices.GetBytes() + this->Lines.GetBytes(); }
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
  void Start(const vtkShadowFrame& frame, bool ofEdges);
  void StartPart(int caster);
  void AddWedge(const vtkShadowWedgeEdge& edge, vtkShadowWedge::Bounds bounds);
  void Upload();
  /** Which side of a face the light sees: 1 or -1, or 0 where that depends on the point. */
  int FindSide(const glm::dvec4& plane) const;
  void AddEdges(const vtkShadowCaster& caster, const vtkShadowAdjacency& adjacency,
    vtkShadowWedge::Bounds bounds);
  /** Planes of the box around all that may be shadowed, positive inside; none where nothing may. */
  static std::vector<glm::dvec4> GetReceivers(const vtkShadowCasters& casters);
  std::vector<glm::dvec4> GetExtremes() const;

  vtkShadowWedgeLight Light;
  vtkPenumbraEmission* Emission = nullptr;
  vtkShadowVertices Vertices;
  vtkPenumbraLines Lines;
  std::vector<Part> Parts;
  bool OfEdges = false; // with faces
  std::size_t Wedges = 0;
  std::size_t Culled = 0;            // that no receiver lies in
  std::vector<glm::dvec4> Receivers; // while wedges are made
  std::vector<float> Values;
};

#endif
