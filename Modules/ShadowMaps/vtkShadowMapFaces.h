// SPDX-License-Identifier: BSD-3-Clause
// Draws only those faces of casters that are turned to the light, or away from it, while it lives. Flat
// casters have no other side, and are drawn both ways.

#ifndef vtkShadowMapFaces_h
#define vtkShadowMapFaces_h

#include "vtkShadowCasterDrawing.h"

#include <glm/mat4x4.hpp>

#include <string>

class vtkOpenGLState;

class vtkShadowMapFaces
{
public:
  enum class Which
  {
    Both,
    Front,
    Back
  };

  static Which Read(const std::string& choice);

  vtkShadowMapFaces(vtkOpenGLState* state, Which which, const glm::dmat4& SWCToClip);
  ~vtkShadowMapFaces();
  vtkShadowMapFaces(const vtkShadowMapFaces&) = delete;
  void operator=(const vtkShadowMapFaces&) = delete;

  /** How casters are to be drawn. */
  const vtkShadowCasterDraw& Get() const { return this->How; }

private:
  vtkOpenGLState* State;
  vtkShadowCasterDraw How;
};

#endif
