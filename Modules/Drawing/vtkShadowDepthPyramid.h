// SPDX-License-Identifier: BSD-3-Clause
// The least and the greatest depth of every region of depth maps (hierarchical min/max depth): tells
// conservatively which receivers are fully lit or in umbra, without looking at single texels.
//
//   pyramid  RG32F, side = the maps' half rounded up to a power of two, all levels, a layer each map:
//            least and greatest depth of 2^(level+1) squared texels (2.7 bytes a texel of a
//            map whose side is a power of two, up to four times as much of another)
//
// vtkShadowDepthRangeFS.glsl asks it. Conservative: what it says of a region holds for every texel
// that a look-up there can read, so that what it lets skip changes no picture.

#ifndef vtkShadowDepthPyramid_h
#define vtkShadowDepthPyramid_h

#include "vtkShadowGL.h"                 // For textures
#include "vtkSoftShadowsDrawingModule.h" // For export macro

#include <cstddef>
#include <string>

class vtkShaderProgram;
struct vtkShadowFrame;

class VTKSOFTSHADOWSDRAWING_EXPORT vtkShadowDepthPyramid
{
public:
  /** Make it fit maps of this many layers. False when out of memory. */
  bool Allocate(vtkOpenGLRenderWindow* window, const vtkShadowTexture& maps);
  int GetLevels() const { return this->Pyramid.GetLevels(); }
  /**
   * Build the levels of some layers of the maps that it was allocated for. Maps of four numbers a texel hold
   * slabs: a depth, or 1e30 for nothing; another one behind it; the slope over a texel of a plane through the
   * first. The greatest depth is then that of slabs, and negative where there also is nothing.
   */
  void Build(vtkShadowFrame& frame, const vtkShadowTexture& maps, int first, int count);

  void Activate(vtkOpenGLRenderWindow* window) { this->Pyramid.Activate(window); }
  void Deactivate(vtkOpenGLRenderWindow* window) { this->Pyramid.Deactivate(window); }
  /** GLSL that asks it: `vec2 shadowDepthRange(float layer, vec2 low, vec2 high)`. */
  static std::string GetGLSL();
  void SetParameters(vtkShaderProgram* program);

  std::size_t GetBytes() const { return this->Pyramid.GetBytes(); }
  void Release(vtkOpenGLRenderWindow* window);

private:
  int Resolution = 0; // of the maps
  vtkShadowTexture Pyramid;
  vtkShadowSampler Maps;
  vtkShadowFramebuffer Framebuffer;
};

#endif
