// SPDX-License-Identifier: BSD-3-Clause
// The virtual maps of all parts of lights: one view each, or up to six of a light among its
// casters; and of each a coarse map, conservatively rasterized, that tells where blockers may be
// and how deep on average. Kept while light and casters are unchanged; none of this depends on the
// camera.
//
//   coarse   DEPTH_COMPONENT32F  side^2, two layers each view, of triangles that are turned either
//                                way, the two sides of bodies: the least depth of what touches
//                                the texel
//   pyramid                      see vtkShadowDepthPyramid

#ifndef vtkVirtualShadowViews_h
#define vtkVirtualShadowViews_h

#include "vtkLightFrusta.h"                        // For vtkLightView
#include "vtkShadowChanges.h"                      // For what is kept
#include "vtkShadowDepthPyramid.h"                 // For the pyramid
#include "vtkShadowGL.h"                           // For textures
#include "vtkSoftShadowsVirtualShadowMapsModule.h" // For export macro

#include <cstddef>
#include <string>
#include <vector>

class vtkShaderProgram;
struct vtkShadowFrame;

class VTKSOFTSHADOWSVIRTUALSHADOWMAPS_EXPORT vtkVirtualShadowViews
{
public:
  /** So many views a light has at most. */
  static constexpr int Most = 6;

  /** Bring views and coarse maps up to date. False when out of memory. */
  bool Update(vtkShadowFrame& frame, int side);

  /** Some of a part's views, of which at most one shows a receiver. */
  struct Turn
  {
    int First = 0;
    int Count = 0;
  };
  /** All faces of a cube at once; of views of groups of casters one after another. */
  std::vector<Turn> GetTurns(int part) const;
  /** Of a part of a light, by its index. */
  const std::vector<vtkLightView>& GetViews(int part) const { return this->Parts[part].Views; }
  /** Some caster is nearer to a light among its casters than its cube's faces overlap for. */
  bool IsOverlapExceeded() const;

  // /@{ Around drawing; and the uniforms of vtkVirtualViewsFS.glsl.
  void Activate(vtkShadowFrame& frame);
  void Deactivate(vtkShadowFrame& frame);
  void SetParameters(
    vtkShaderProgram* program, const vtkShadowFrame& frame, int part, const Turn& turn);
  // /@}
  /** GLSL of a receiver's place over the maps, and of the pyramid. */
  static std::string GetGLSL();

  std::size_t GetBytes() const { return this->Coarse.GetBytes() + this->Pyramid.GetBytes(); }
  void Release(vtkOpenGLRenderWindow* window);

private:
  struct Part
  {
    std::vector<vtkLightView> Views;
    int FirstLayer = 0;
    bool Exceeded = false;
  };

  void Draw(vtkShadowFrame& frame, const Part& part);

  vtkShadowChanges Changes;
  std::vector<Part> Parts;
  vtkShadowTexture Coarse;
  vtkShadowDepthPyramid Pyramid;
  vtkShadowFramebuffer Framebuffer;
};

#endif
