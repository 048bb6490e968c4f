// SPDX-License-Identifier: BSD-3-Clause
// The depth maps of a pass: views from samples of the lights, drawn into the layers of one array
// texture and kept while light, casters and settings are unchanged.
//
//   maps    DEPTH_COMPONENT32F  resolution^2, a layer each view (4 bytes a texel)
//   views   RGBA32F buffer      see vtkLightViewVectors: seven texels a view, twelve for
//                               neighbours; uniforms if few
//   pyramid                     for neighbours: see vtkShadowDepthPyramid
//   layers  DEPTH_COMPONENT32F  resolution^2, of midpoint maps: first and second layer
//   sides   R32F                the same: which side of their faces they show
//   slabs                       for rays: see vtkShadowMapSlabs
//
// Where the layers do not fit into the memory allowed, the maps are drawn in batches, every frame.

#ifndef vtkShadowMaps_h
#define vtkShadowMaps_h

#include "vtkLightFrusta.h"                 // For vtkLightView
#include "vtkShadowChanges.h"               // For what is kept
#include "vtkShadowDepthPyramid.h"          // For what is fully lit or in umbra
#include "vtkShadowGL.h"                    // For textures
#include "vtkShadowLight.h"                 // For vtkShadowLight
#include "vtkShadowMapFaces.h"              // For which faces are drawn
#include "vtkShadowMapSlabs.h"              // For what rays cross
#include "vtkShadowVectors.h"               // For the views in shaders
#include "vtkSoftShadowsShadowMapsModule.h" // For export macro

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

class vtkOpenGLState;
class vtkShaderProgram;
struct vtkShadowFrame;

struct vtkShadowMapSettings
{
  int Resolution = 1024;
  int Samples = 1;         // of each light that has a size
  bool Bilinear = true;    // hardware filtering of the four nearest compares
  bool Midpoint = false;   // the middle of the casters' first two layers instead of the first
  bool Slabs = false;      // planes and bodies for rays: see vtkShadowMapSlabs
  bool Neighbours = false; // for look-ups all around a point: vtkShadowMapKernelFS.glsl
  double Separation =
    0.16; // assumed between blocker and receiver, as a share of the casters' extent
  std::size_t MemoryLimit = std::size_t(1) << 32;                  // bytes for all layers
  vtkShadowMapFaces::Which Faces = vtkShadowMapFaces::Which::Both; // where Midpoint is false

  bool operator==(const vtkShadowMapSettings& other) const;
};

class VTKSOFTSHADOWSSHADOWMAPS_EXPORT vtkShadowMaps
{
public:
  /**
   * Bring the maps up to date; what was drawn is counted in the frame ("mapsDrawn", "mapsHeld").
   * False where not even one map can be had.
   */
  bool Update(vtkShadowFrame& frame, const vtkShadowMapSettings& settings);

  /** All maps are held at once. Else GetNumberOfBatches() and DrawBatch() are to be used. */
  bool AreResident() const { return this->Batches <= 1; }
  int GetNumberOfBatches() const { return this->Batches; }
  /** Draw a batch's maps, and let SetParameters speak of them. */
  void DrawBatch(vtkShadowFrame& frame, int batch);
  /** The share of all views that the batch of the last DrawBatch holds for a light. */
  double GetBatchShare(int light) const;

  void Activate(vtkShadowFrame& frame);
  void Deactivate(vtkShadowFrame& frame);
  /** GLSL that all look-ups share, with the `#define`s that it wants. */
  std::string GetGLSL() const;
  /** Its uniforms. */
  void SetParameters(vtkShaderProgram* program);

  vtkShadowTexture& GetTexture() { return this->Maps; }
  int GetNumberOfViews() const { return static_cast<int>(this->Views.size()); }
  /** Each part of a light has a view from its centre, and no others. */
  bool HasViewOfEach() const;
  /** Some light's look-ups reach further than its views show, and are drawn in. */
  bool IsOverlapExceeded() const;
  /** What vtkShadowMapSettings::Separation makes of a light's casters, in world units. */
  double GetSeparation(int light) const;
  /** Bytes of all, by name. */
  std::vector<std::pair<std::string, std::size_t>> GetBytes() const;
  void Release(vtkOpenGLRenderWindow* window);

private:
  struct View
  {
    vtkLightView Frustum;
    glm::dvec3 Weight{ 1.0 };
    int Light = 0;
  };
  /** The views of a part of a light. */
  struct PartState
  {
    int First = 0;
    int Count = 0;
    std::vector<int> Casters;
    double Extent = 0.0;   // of these
    bool Exceeded = false; // vtkLightFrusta::IsOverlapExceeded
  };

  std::vector<View> MakeViews(vtkShadowFrame& frame, int light, PartState& state) const;
  void Draw(vtkShadowFrame& frame, int first, int count);
  /** Clear the layer that is bound, and keep its border so where there are look-ups beyond it. */
  void ClearLayer(vtkOpenGLState* state);
  bool AllocateLayers(vtkOpenGLRenderWindow* window);
  void ReleaseUnused(vtkOpenGLRenderWindow* window);
  void DrawMidpoint(vtkShadowFrame& frame, int view);
  void UpdateViewVectors(vtkShadowFrame& frame, bool changed);

  vtkShadowMapSettings Current;
  vtkShadowChanges Changes;
  std::vector<View> Views;
  std::vector<PartState> Parts;
  int Batches = 0;
  int BatchSize = 0;
  int BatchFirst = 0; // the view in layer 0
  int BatchCount = 0;
  vtkShadowVectors ViewVectors; // of vtkLightViewVectors, for the camera of this frame
  glm::dmat4 VCToSWC{ 0.0 };    // that camera
  vtkShadowTexture Maps;
  vtkShadowSampler Depths;       // the maps without compare
  vtkShadowDepthPyramid Pyramid; // of the maps, or of the slabs
  vtkShadowMapSlabs Slabs;
  vtkShadowTexture Layers[2];
  vtkShadowTexture Sides[2];
  vtkShadowFramebuffer Framebuffer;
};

#endif
