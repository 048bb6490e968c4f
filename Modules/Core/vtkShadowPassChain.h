// SPDX-License-Identifier: BSD-3-Clause
// Passes within passes: where in a renderer's chain a pass stands, and another put in its place.
//
// VTK's passes hold others as delegates (vtkCameraPass, vtkSSAAPass, all of vtkImageProcessingPass),
// in a collection (vtkSequencePass), or as steps (vtkRenderStepsPass, the depth peelings). What other
// classes hold is not seen.

#ifndef vtkShadowPassChain_h
#define vtkShadowPassChain_h

#include <functional>

class vtkRenderPass;
class vtkRenderer;

namespace vtkShadowPassChain
{
/** The first pass that is meant: this one itself, or one within it; nullptr if there is none. */
vtkRenderPass* Find(vtkRenderPass* root, const std::function<bool(vtkRenderPass*)>& isMeant);
/** Whether a pass is this one, or within it. */
bool Holds(vtkRenderPass* root, vtkRenderPass* pass);
/**
 * Put a pass wherever another one stands in a renderer's chain. nullptr leaves the renderer without a
 * pass, and stands for VTK's own steps within another pass, which has to have one.
 */
void Replace(vtkRenderer* renderer, vtkRenderPass* pass, vtkRenderPass* other);
}

#endif
