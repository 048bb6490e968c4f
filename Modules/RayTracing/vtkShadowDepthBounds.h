// SPDX-License-Identifier: BSD-3-Clause
// What receivers surely see of lights: nothing that casts lies between them and the whole light.
//
// Maps of the casters from the lights' centres, in which each texel that a triangle touches, however thin
// it is, holds at most the least depth that it has there. What the pyramid over it tells of a box is then
// true of everything in it. Kept while lights and casters are unchanged.
//
//   maps     DEPTH_COMPONENT32F  resolution^2, a layer each view (4 bytes a texel)
//   pyramid                      see vtkShadowDepthPyramid
//   views    RGBA32F buffer      six texels a view (see vtkShadowSeesAllFS.glsl)
//
// Of a light among its casters, which sees them in all directions, nothing is known.

#ifndef vtkShadowDepthBounds_h
#define vtkShadowDepthBounds_h

#include "vtkLightFrusta.h"
#include "vtkShadowChanges.h"
#include "vtkShadowDepthPyramid.h"
#include "vtkShadowGL.h"
#include "vtkShadowVectors.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

class vtkShaderProgram;
struct vtkShadowFrame;

class vtkShadowDepthBounds
{
public:
  /** Bring the maps up to date; what was drawn is counted in the frame ("mapsDrawn", "mapsHeld"). */
  void Update(vtkShadowFrame& frame, int resolution);

  /** GLSL of a shadowVisibility that is 1 where all of the light is surely seen, else -1. */
  static std::string GetGLSL();
  void Activate(vtkShadowFrame& frame);
  void Deactivate(vtkShadowFrame& frame);
  void SetParameters(vtkShaderProgram* program);

  /** Bytes of all, by name. */
  std::vector<std::pair<std::string, std::size_t>> GetBytes() const;
  void Release(vtkOpenGLRenderWindow* window);

private:
  /** The views of a part of a light. */
  struct Part
  {
    int First = 0;
    bool Known = true;
    std::vector<vtkLightView> Views;

    bool IsSame(const Part& other) const;
  };

  Part MakePart(const vtkShadowFrame& frame, int index, int first) const;
  void Draw(vtkShadowFrame& frame, const Part& part);
  void UpdateVectors(vtkShadowFrame& frame);

  int Resolution = 0;
  vtkShadowChanges Changes;
  std::vector<Part> Parts;
  vtkShadowTexture Maps;
  vtkShadowDepthPyramid Pyramid;
  vtkShadowVectors Vectors;
  vtkShadowFramebuffer Framebuffer;
};

#endif
