// SPDX-License-Identifier: BSD-3-Clause
// The state of OpenGL in which casters are drawn into a depth map.

#ifndef vtkShadowDepthState_h
#define vtkShadowDepthState_h

#include "vtkOpenGLState.h"
#include "vtkShadowOpenGL.h"

/** While it lives both sides of faces are drawn, and the nearest is kept; then all is as it was. */
class vtkShadowDepthState
{
public:
  explicit vtkShadowDepthState(vtkOpenGLState* state)
    : DepthMask(state)
    , DepthFunc(state)
    , DepthTest(state, GL_DEPTH_TEST)
    , CullFace(state, GL_CULL_FACE)
  {
    state->vtkglDepthMask(GL_TRUE);
    state->vtkglDepthFunc(GL_LESS);
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDisable(GL_CULL_FACE);
  }

private:
  vtkOpenGLState::ScopedglDepthMask DepthMask;
  vtkOpenGLState::ScopedglDepthFunc DepthFunc;
  vtkOpenGLState::ScopedglEnableDisable DepthTest;
  vtkOpenGLState::ScopedglEnableDisable CullFace;
};

#endif
