// SPDX-License-Identifier: BSD-3-Clause
// Depth maps as slabs: what each texel's first layer is a plane of, and where the body ends that it belongs
// to. So a ray can be followed through a map, in front of it and behind.
//
//   slabs   RGBA32F             resolution^2, a layer each map: depth of the first layer in the texel's
//                               middle, depth where its body ends; the plane's slope, depth over a texel
//   first   RGBA32F             resolution^2: which side of which caster the first layer shows, its slope
//   second  DEPTH_COMPONENT32F  the same: where that caster next shows its other side
//
// A body ends where the caster of the first layer next shows its other side. A sheet, and what is open there,
// is as thick as its plane rises within a texel, so that planes beside each other leave no gap.

#ifndef vtkShadowMapSlabs_h
#define vtkShadowMapSlabs_h

#include "vtkShadowGL.h"                    // For textures
#include "vtkSoftShadowsShadowMapsModule.h" // For export macro

#include <cstddef>
#include <functional>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
struct vtkLightView;
struct vtkShadowFrame;

class VTKSOFTSHADOWSSHADOWMAPS_EXPORT vtkShadowMapSlabs
{
public:
  /** Make them fit maps. False when out of memory. */
  bool Allocate(vtkOpenGLRenderWindow* window, const vtkShadowTexture& maps);
  /** Draw a layer of the maps, and its slabs. `clear` clears the depth that is bound. */
  void Draw(vtkShadowFrame& frame, const vtkLightView& view, const vtkShadowTexture& maps,
    int layer, const std::function<void()>& clear);

  const vtkShadowTexture& GetTexture() const { return this->Slabs; }
  void Activate(vtkOpenGLRenderWindow* window) { this->Slabs.Activate(window); }
  void Deactivate(vtkOpenGLRenderWindow* window) { this->Slabs.Deactivate(window); }
  /** The uniform shadowSlabs. */
  void SetParameters(vtkShaderProgram* program);

  std::size_t GetBytes() const
  {
    return this->Slabs.GetBytes() + this->First.GetBytes() + this->Second.GetBytes();
  }
  void Release(vtkOpenGLRenderWindow* window);

private:
  vtkShadowTexture Slabs;
  vtkShadowTexture First;
  vtkShadowTexture Second;
  vtkShadowSampler Maps; // without compare
  vtkShadowFramebuffer Framebuffer;
};

#endif
