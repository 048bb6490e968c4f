// The depth maps of a pass: views from samples of the lights, drawn into the layers of one array
// texture and kept while light, casters and settings are unchanged.
//
//   maps    DEPTH_COMPONENT32F  resolution^2, a layer each view (4 bytes a texel)
//   views   RGBA32F buffer      seven texels a view (see vtkShadowMapsFS.glsl), uniforms if few
//
// Where the layers do not fit into the memory allowed, the maps are drawn in batches, every frame.

#ifndef vtkShadowMaps_h
#define vtkShadowMaps_h

#include "vtkLightFrusta.h"                 // For vtkLightView
#include "vtkShadowGL.h"                    // For textures
#include "vtkShadowLight.h"                 // For vtkShadowLight
#include "vtkSoftShadowsShadowMapsModule.h" // For export macro

#include <cstddef>
#include <string>
#include <vector>

class vtkShaderProgram;
struct vtkShadowFrame;

class VTKSOFTSHADOWSSHADOWMAPS_EXPORT vtkShadowMaps
{
public:
  struct Settings
  {
    int Resolution = 1024;
    int Samples = 1;      // of each light that has a size
    bool Bilinear = true; // hardware filtering of the four nearest compares
    std::size_t MemoryLimit = std::size_t(1) << 32; // bytes for all layers

    bool operator==(const Settings& other) const;
  };

  /**
   * Bring the maps up to date; what was drawn is counted in the frame ("mapsDrawn", "mapsHeld").
   * False where not even one map can be had.
   */
  bool Update(vtkShadowFrame& frame, const Settings& settings);

  /** All maps are held at once. Else GetNumberOfBatches() and DrawBatch() are to be used. */
  bool AreResident() const { return this->Batches <= 1; }
  int GetNumberOfBatches() const { return this->Batches; }
  /** Draw a batch's maps, and let SetParameters speak of them. */
  void DrawBatch(vtkShadowFrame& frame, int batch);
  /** The share of all views that the batch of the last DrawBatch holds for a light. */
  double GetBatchShare(int light) const;

  void Activate(vtkShadowFrame& frame);
  void Deactivate(vtkShadowFrame& frame);
  /** `#define`s that vtkShadowMapsFS.glsl wants. */
  std::string GetDefinitions() const;
  /** Uniforms of vtkShadowMapsFS.glsl. */
  void SetParameters(vtkShaderProgram* program);

  vtkShadowTexture& GetTexture() { return this->Maps; }
  int GetNumberOfViews() const { return static_cast<int>(this->Views.size()); }
  std::size_t GetBytes() const { return this->Maps.GetBytes() + this->ViewBuffer.GetBytes(); }
  void Release(vtkOpenGLRenderWindow* window);

private:
  struct View
  {
    vtkLightView Frustum;
    glm::dvec3 Weight{ 1.0 };
    int Light = 0;
  };
  /** What a light's views were made from. */
  struct LightState
  {
    vtkShadowLight Light;
    int First = 0;
    int Count = 0;
    std::vector<int> Casters;
  };

  std::vector<View> MakeViews(vtkShadowFrame& frame, int light, std::vector<int>& casters) const;
  void Draw(vtkShadowFrame& frame, int first, int count);
  void UpdateViewVectors(vtkShadowFrame& frame, bool changed);

  Settings Current;
  unsigned long CasterVersion = 0;
  unsigned long ReceiverVersion = 0;
  std::vector<View> Views;
  std::vector<LightState> Lights;
  int Batches = 0;
  int BatchSize = 0;
  int BatchFirst = 0; // the view in layer 0
  int BatchCount = 0;
  bool Few = false;                   // views are uniforms
  std::vector<glm::vec4> ViewVectors; // of vtkShadowMapsFS.glsl, for the camera of this frame
  glm::dmat4 VCToWC{ 0.0 };           // that camera
  vtkShadowTexture Maps;
  vtkShadowTexture ViewBuffer; // where the views are no uniforms
  vtkShadowFramebuffer Framebuffer;
};

#endif
