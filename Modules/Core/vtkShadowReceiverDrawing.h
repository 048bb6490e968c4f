// SPDX-License-Identifier: BSD-3-Clause
// Draws a renderer's props into receivers: by VTK's own mappers, with the code that a vtkShadowInjector puts
// into their shaders.

#ifndef vtkShadowReceiverDrawing_h
#define vtkShadowReceiverDrawing_h

#include "vtkShadowInjector.h"

namespace vtkShadowReceiverDrawing
{
/** Which of the props' surfaces. */
struct Which
{
  bool Translucent = false; // the nearest translucent surfaces, instead of the opaque ones
  bool Catchers = false;    // shadow catchers too, which are translucent
};

/**
 * Draw the receivers of the screen that is written in the injector's use, for a pass whose keys the props
 * get meanwhile.
 */
void Draw(vtkShadowInjector& injector, const vtkShadowInjector::Use& use, vtkOpenGLRenderPass* pass,
  const std::vector<vtkSmartPointer<vtkProp>>& props, const Which& which);
}

#endif
