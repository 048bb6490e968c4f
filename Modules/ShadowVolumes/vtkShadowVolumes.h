// SPDX-License-Identifier: BSD-3-Clause
// The stencil counting of shadow volumes, which stand on the silhouettes of a vtkShadowSilhouetteCache,
// over the receivers' depth.
//
//   caps     index buffer  12 bytes a triangle (24 of an open mesh with the light within and its inside
//                          in sight), where volumes are counted by z-fail: of one sample, made anew
//                          for the next
//   depth    DEPTH32F_STENCIL8  viewport size; the receivers' depth and the count, which wraps
//   counts   R32F          viewport size; instead of the stencil where more than 255 volumes may nest
//
// A volume's sides reach from the edge to infinity (w = 0); in a parallel projection, which sees
// nothing of infinity, as far as the picture goes.
//
// The depth is one of our own, made from the receivers' positions: near / distance, which in floats
// is as fine at any distance, whatever the clipping range is. VTK's 24 bits of a range of 1 : 1000 are
// too coarse for sides that leave a surface at a grazing angle, and those are a soft light's.

#ifndef vtkShadowVolumes_h
#define vtkShadowVolumes_h

#include "vtkNew.h"                            // For buffers
#include "vtkOpenGLBufferObject.h"             // For buffers
#include "vtkShadowGL.h"                       // For textures
#include "vtkShadowSilhouetteCache.h"          // For silhouettes
#include "vtkSoftShadowsShadowVolumesModule.h" // For export macro

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

class vtkPenumbraLines;
class vtkShaderProgram;
class vtkVisibilityBuffer;
struct vtkShadowFrame;

struct vtkShadowVolumeSettings
{
  enum class Counting
  {
    Auto,  // z-pass, but z-fail for casters whose volume the near rectangle may lie in
    ZPass, // entered less left between the eye and the surface: wrong where the eye is in a volume
    ZFail, // left less entered behind it: right everywhere, needs caps
    Xor    // parity, as z-pass: also wrong where volumes overlap
  };
  Counting Method = Counting::Auto;
  vtkShadowSilhouetteCache::Options Silhouettes;
};

class VTKSOFTSHADOWSSHADOWVOLUMES_EXPORT vtkShadowVolumes
{
public:
  /** Bring silhouettes up to date; what was done is counted in the frame. */
  void Update(vtkShadowFrame& frame, const vtkShadowVolumeSettings& settings);

  /** The places on a light. */
  const std::vector<vtkLightSample>& GetSamples(int part) const
  {
    return this->Silhouettes.GetSamples(part);
  }

  const vtkShadowSilhouetteCache& GetSilhouettes() const { return this->Silhouettes; }
  /** Likewise, of a place's batch; valid until the next call of anything here. */
  const vtkShadowSilhouetteCache::Batch& GetBatch(vtkShadowFrame& frame, int part, int sample)
  {
    return this->Silhouettes.GetBatch(frame, part, sample);
  }

  /** Make the depth that volumes are counted over; before Subtract. False when out of memory. */
  bool UpdateDepth(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer);
  /**
   * Count the volumes of a light's place over the receivers' depth, and take the place's weight away
   * where the count is not zero, in a layer of the buffer's target. False where wide counts were
   * wanted and there was no memory for them: multiples of 256 are then light.
   */
  bool Subtract(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int part, int sample);
  /**
   * Add how many volumes of a place hold the receiver to the first channel of a layer of a target: those
   * on lines of its silhouettes. Of sides, planes and the receiver's position tell it; of caps, depths.
   * Of some parts of the lines alone, if these are named; of a caster with caps all or none.
   */
  void AddCounts(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, const vtkShadowTexture& target,
    int layer, int part, int sample, vtkPenumbraLines& lines,
    const std::vector<int>* some = nullptr);
  /** How far from the eye the picture begins, in what w is of clip coordinates. */
  double GetNearest() const { return this->Nearest; }
  /** Whether a caster's volume is counted with caps. */
  bool HasCaps(const vtkShadowCaster& caster, const glm::dvec4& place) const;
  /**
   * Add up what is drawn, where the back faces of something lie behind the receivers, in a layer of
   * targets. What draws gets the matrix to draw with, the clip coordinate of what is farthest, and what to
   * move back by: a share of the depth, and a depth.
   * Or the outlines of faces, where they lie before the receiver.
   */
  void AddBehind(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer,
    const std::vector<const vtkShadowTexture*>& targets, int layer,
    const std::function<void(
      const glm::dmat4& SWCToDraw, float farthest, const glm::vec2& retreat)>& draw,
    bool outlines = false);
  /** Whether all that is behind a caster, from some places on a light, lies outside of the view. */
  bool IsOutOfView(const vtkShadowCaster& caster, const std::vector<glm::dvec4>& places) const;
  /** Add one where a face of a volume is drawn, in a layer of the buffer's target. */
  void AddFaces(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int part, int sample);
  /** Draw a place's volumes over the picture: front faces blue, back faces orange, silhouettes. */
  void DrawView(vtkShadowFrame& frame, int part, int sample);

  /** Bytes on the GPU, by name. */
  std::vector<std::pair<std::string, std::size_t>> GetBytes() const;
  void Release(vtkOpenGLRenderWindow* window);

private:
  /** A caster, and its cap. */
  using CappedCaster = std::pair<int, vtkShadowCap>;
  /** What a frame draws of one sample. */
  struct Selection
  {
    const vtkShadowSilhouetteCache::Batch* Lines = nullptr;
    std::vector<vtkShadowCasterPart> ZPass;
    std::vector<vtkShadowCasterPart> ZFail; // twice where the sides are
    bool Wide = false;                      // counts may pass 255
  };

  void SetView(const vtkShadowFrame& frame);
  /** Of other lines than all of the silhouette's, if these are given. */
  Selection Select(vtkShadowFrame& frame, int part, int sample,
    const std::vector<vtkShadowCasterPart>* others = nullptr);
  /** Planes around what can shadow the near rectangle: the pyramid over it with the light on top. */
  std::vector<glm::dvec4> GetShadingPlanes(const glm::dvec4& place) const;
  /** The eye may see the inside of a body: through its surface, or where the near plane cuts it. */
  bool IsLookedInto(const vtkShadowCaster& caster) const;
  void UpdateCaps(
    vtkShadowFrame& frame, int part, int sample, const std::vector<CappedCaster>& casters);

  void SetExtrusion(vtkShaderProgram* program, const vtkShadowCaster& caster,
    const glm::dvec4& place, const glm::dmat4& matrix) const;
  /** How far a face that stands in a surface is moved back: a share of its depth, a depth. */
  glm::vec2 GetRetreat() const;
  void SetFrontFace(bool reversed) const;
  void DrawSides(vtkShadowFrame& frame, const glm::dvec4& place, const Selection& selection,
    const std::vector<vtkShadowCasterPart>& parts, bool counted, const char* shader,
    const std::function<void(vtkShaderProgram*)>& setParameters);
  void DrawCaps(vtkShadowFrame& frame, const glm::dvec4& place, const char* shader,
    const std::function<void(vtkShaderProgram*)>& setParameters);
  using Sides = std::function<void(const std::vector<vtkShadowCasterPart>& parts,
    const std::function<void(vtkShaderProgram*)>& setParameters)>;
  /**
   * By z-pass, then by z-fail; setCounter(by z-pass?) prepares, and gives what sets uniforms. With sides
   * these draw the sides, whatever their depth.
   */
  template <typename SetCounter>
  void DrawVolumes(vtkShadowFrame& frame, const glm::dvec4& place, const Selection& selection,
    const char* shader, SetCounter setCounter, const Sides& sides = nullptr);

  vtkShadowVolumeSettings::Counting Method = vtkShadowVolumeSettings::Counting::Auto;
  vtkShadowSilhouetteCache Silhouettes;

  // The frame's view.
  glm::dmat4 SWCToClip{ 1.0 };
  glm::dmat4 SWCToDraw{ 1.0 }; // to the clip coordinates that are drawn in, with a depth of our own
  glm::dvec4 DepthRow{ 0.0 };  // of the matrix from VC to them: depth x w
  glm::dvec4 WRow{ 0.0 };
  bool ClipControl = false;               // their z runs from 0 to w
  std::vector<glm::dvec4> FrustumPlanes;  // inside is positive
  std::vector<glm::dvec3> FrustumCorners; // near ones first
  double Nearest = 0.0;
  bool Parallel = false;
  bool Mirrored = false;

  vtkNew<vtkOpenGLBufferObject> Caps;
  std::size_t CapBytes = 0;
  int CapLight = -1;            // whose caps the buffer holds
  unsigned long CapVersion = 0; // of the silhouettes then
  int CapSample = -1;
  std::vector<CappedCaster> CapCasters;
  std::vector<vtkShadowCasterPart> CapParts;
  vtkShadowTexture Depth;
  vtkShadowTexture Counts;
};

#endif
