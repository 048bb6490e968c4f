// SPDX-License-Identifier: BSD-3-Clause
// The light data of the planar techniques: an array texture with a layer for each light and plane
// that casters between them darken.
//
//   hard  R8              viewport size: visibility at each pixel, drawn for each camera
//   soft  R32F, RGBA32F   resolution^2 over a window of the plane: visibility, a colour if textured
//         depth, stencil  resolution^2, once: which texels a sample of the light has darkened
//   fake  RG32F, levels   resolution^2 over a window of the plane: coverage from the light's centre,
//                         and 1 - s: s is the spread of the caster next to the plane, h / (H - h), as
//                         a share of the largest
//   records RGBA32F buffer, or uniforms if few: see vtkPlanarShadowFS.glsl
//
// Those along a plane do not depend on the camera, and are kept while light, plane, casters and
// settings are unchanged.

#ifndef vtkPlanarShadowMaps_h
#define vtkPlanarShadowMaps_h

#include "vtkPlanarShadow.h"                   // For shadows
#include "vtkShadowChanges.h"                  // For what is kept
#include "vtkShadowGL.h"                       // For textures
#include "vtkShadowVectors.h"                  // For records
#include "vtkSoftShadowsPlanarShadowsModule.h" // For export macro

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

class vtkOpenGLState;
class vtkShaderProgram;
class vtkShadowPlanes;
struct vtkShadowFrame;

struct vtkPlanarShadowSettings
{
  enum class Kind
  {
    Hard,
    Soft,
    Fake
  };
  Kind Technique = Kind::Hard;
  int Resolution = 1024; // of soft and fake
  int Samples = 64;      // of soft
  int Kernel = 7;        // taps a side of fake

  bool operator==(const vtkPlanarShadowSettings& other) const;
};

class VTKSOFTSHADOWSPLANARSHADOWS_EXPORT vtkPlanarShadowMaps
{
public:
  /**
   * Bring the layers up to date; counted in the frame: "planarMapsDrawn", "planarMapsReused",
   * "planarMapsOutOfView". False where they cannot be had.
   */
  bool Update(vtkShadowFrame& frame, const vtkShadowPlanes& planes, bool planesChanged,
    const vtkPlanarShadowSettings& settings);

  void Activate(vtkShadowFrame& frame);
  void Deactivate(vtkShadowFrame& frame);
  std::string GetGLSL() const;
  void SetParameters(vtkShaderProgram* program);
  /** The most look-ups of a pixel. */
  double GetMaximumCost() const;

  vtkShadowTexture& GetTexture() { return this->Maps; }
  int GetNumberOfLayers() const { return this->Layers; }
  std::vector<std::pair<std::string, std::size_t>> GetBytes() const;
  void Release(vtkOpenGLRenderWindow* window);

private:
  using Kind = vtkPlanarShadowSettings::Kind;
  /** What is kept of a light, a plane and a side of it. */
  struct Entry
  {
    vtkPlanarShadow Shadow;
    int Layer = -1;
    bool Drawn = false; // the layer holds it
    bool InView = true; // hard alone
  };

  /** Entries of before that stay where they are and show the same are kept, if `keep`. */
  void MakeEntries(vtkShadowFrame& frame, const vtkShadowPlanes& planes, int mostGroups, bool keep);
  std::vector<vtkLightSample> GetSamples(const vtkShadowLightPart& part,
    const vtkShadowPlane& plane, const vtkShadowCasters& casters) const;
  bool Allocate(vtkShadowFrame& frame);
  void ReleaseTextures(vtkOpenGLRenderWindow* window);
  void UpdateCamera(vtkShadowFrame& frame);
  void Draw(vtkShadowFrame& frame);
  void DrawLayer(vtkShadowFrame& frame, const vtkPlanarShadow& shadow);
  void DrawProjected(vtkShadowFrame& frame, const vtkPlanarShadow& shadow,
    const vtkLightSample& sample, const glm::dmat4& SWCToClip);
  void UpdateRecords(vtkShadowFrame& frame);
  void AddFakeVectors(const vtkPlanarShadow& shadow);
  int GetRecordSize() const;

  vtkPlanarShadowSettings Current;
  // What the entries were made from.
  vtkShadowChanges Changes;
  std::vector<vtkShadowPlane> Planes;
  bool Color = false;

  int Sides = 1;              // 2 where a light reaches through a plane
  int Groups = 1;             // the most of a plane's side
  std::vector<Entry> Entries; // by light, plane, side, group
  int Layers = 0;
  glm::dmat4 SWCToClip{ 0.0 }; // of the camera, for hard
  glm::dmat4 VCToSWC{ 0.0 };
  vtkShadowVectors Records;
  vtkShadowTexture Maps;
  vtkShadowTexture Stencil;
  vtkShadowFramebuffer Framebuffer;
};

#endif
