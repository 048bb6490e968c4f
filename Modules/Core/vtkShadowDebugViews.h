// SPDX-License-Identifier: BSD-3-Clause
// The debug views of a pass: see vtkShadowPass::SetDebugView.

#ifndef vtkShadowDebugViews_h
#define vtkShadowDebugViews_h

#include <string>
#include <vector>

class vtkShadowTechnique;
struct vtkShadowDeclaration;
struct vtkShadowFrame;
struct vtkShadowScreen;

namespace vtkShadowDebugViews
{
/** The views of a technique, those that all have first; nullptr: these alone. */
std::vector<std::string> GetNames(const vtkShadowDeclaration* declaration);

/**
 * Draw one over the viewport that is set, of a screen whose visibility is valid, with the light data
 * bound. What its white stands for is counted in the frame: "debugViewWhite".
 */
void Draw(vtkShadowFrame& frame, vtkShadowTechnique& technique, vtkShadowScreen& screen,
  const std::string& view);
}

#endif
