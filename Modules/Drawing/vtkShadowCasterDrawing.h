// SPDX-License-Identifier: BSD-3-Clause
// Draws vtkShadowCasters on the GPU, from buffers that are made when something is first drawn.
//
//   vertices  buffer        12 bytes a vertex of each mesh
//   indices   buffer        12 bytes a triangle
//   places    buffer        of meshes with holes, 12 bytes a vertex
//   maps      R8 textures   of these meshes' alpha
//
// A caster is one draw call with its matrix, composed in double with the light's: on llvmpipe that took
// half the time of one call for all with the matrices in a texture. Large meshes lie in chunks with
// bounds. What a view does not show is not drawn. Casters with holes come first in the buffers; they
// alone are drawn by a shader that discards.

#ifndef vtkShadowCasterDrawing_h
#define vtkShadowCasterDrawing_h

#include "vtkShadowCasters.h"            // For casters
#include "vtkShadowPrograms.h"           // For programs
#include "vtkSoftShadowsDrawingModule.h" // For export macro

#include <glm/mat4x4.hpp>

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

class vtkOpenGLBufferObject;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

struct vtkShadowCasterPart;

/** How casters are drawn: by default their depth alone. */
struct vtkShadowCasterDraw
{
  /**
   * GLSL in constants, such as those of glsl/: programs are found by where it lies (vtkShadowPrograms), so
   * that a text made for one draw call would be taken for another. nullptr for the vertex or fragment shader of
   * depth, or for no geometry shader. Of casters with holes the marks //VTK::ShadowHoles::Dec and ::Impl
   * in both shaders are replaced, by what discards fragments.
   */
  const char* VertexShader = nullptr;
  const char* GeometryShader = nullptr;
  const char* FragmentShader = nullptr;
  /** What the fragment shader begins with, for constants that choose among its variants. */
  std::string Definitions;
  /** Draw holes too: for shaders without those marks. */
  bool FillHoles = false;
  /** Set uniforms, once; and for each caster, before its draw calls. */
  std::function<void(vtkShaderProgram*)> SetParameters;
  std::function<void(vtkShaderProgram*, const vtkShadowCaster&)> SetCasterParameters;
  /** And for each part, of DrawParts. */
  std::function<void(vtkShaderProgram*, const vtkShadowCasterPart&)> SetPartParameters;
};

/** Elements of another index buffer that stand for a part of a caster: numbers of its mesh's vertices. */
struct vtkShadowCasterPart
{
  int Caster = 0;        // index into vtkShadowCasters::Get()
  std::size_t First = 0; // index in the buffer
  std::size_t Count = 0;
};

class VTKSOFTSHADOWSDRAWING_EXPORT vtkShadowCasterDrawing
{
public:
  /** Of casters that outlive it. */
  explicit vtkShadowCasterDrawing(const vtkShadowCasters& casters);
  ~vtkShadowCasterDrawing();
  vtkShadowCasterDrawing(const vtkShadowCasterDrawing&) = delete;
  void operator=(const vtkShadowCasterDrawing&) = delete;

  /**
   * Draw the triangles of casters (indices into Get()), but for their holes, into the bound
   * framebuffer. Left out are casters, and chunks of large ones, that lie beyond a side of the picture.
   */
  void Draw(vtkOpenGLRenderWindow* window, const glm::dmat4& SWCToClip,
    const std::vector<int>& casters, const vtkShadowCasterDraw& how = {});
  /**
   * Draw parts of casters, holes and all, by 32-bit indices of a primitive type of OpenGL's. None is
   * left out: shaders may move them into the picture.
   */
  void DrawParts(vtkOpenGLRenderWindow* window, const glm::dmat4& SWCToClip, unsigned int primitive,
    vtkOpenGLBufferObject* indices, const std::vector<vtkShadowCasterPart>& parts,
    const vtkShadowCasterDraw& how);

  /** Triangles of a chunk, the last one's may be fewer. */
  static constexpr std::size_t ChunkTriangles = 2048;
  /** Triangles that Draw has sent, and has left out, since the last Reset. */
  std::size_t GetDrawnTriangles() const { return this->Drawn; }
  std::size_t GetCulledTriangles() const { return this->Culled; }
  /** Chunks that Draw has sent; of a small mesh one. */
  std::size_t GetDrawnChunks() const { return this->DrawnChunks; }
  /** Whether anything was drawn since the last Reset. */
  bool IsUsed() const { return this->Used; }
  void ResetCounts()
  {
    this->Drawn = this->Culled = this->DrawnChunks = 0;
    this->Used = false;
  }

  /** Bytes held on the GPU. */
  std::size_t GetBytes() const;
  /** Forget the programs, which are those of a technique. */
  void ReleasePrograms();
  void Release(vtkOpenGLRenderWindow* window);

private:
  class Buffers;

  void Upload(vtkOpenGLRenderWindow* window);
  vtkShadowPrograms::Program* Bind(vtkOpenGLRenderWindow* window, vtkOpenGLBufferObject* indices,
    const vtkShadowCasterDraw& how, bool holes);
  void SetCaster(vtkShaderProgram* program, const glm::dmat4& MCToClip,
    const vtkShadowCaster& caster, const vtkShadowCasterDraw& how);
  void DrawVisible(std::size_t caster, const glm::dmat4& MCToClip);

  const vtkShadowCasters& Casters;
  std::unique_ptr<Buffers> GPU;
  std::size_t Drawn = 0;
  std::size_t Culled = 0;
  std::size_t DrawnChunks = 0;
  bool Used = false;
};

#endif
