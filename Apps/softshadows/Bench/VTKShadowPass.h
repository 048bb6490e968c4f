// SPDX-License-Identifier: BSD-3-Clause
// VTK's own shadows as one pass.

#ifndef VTKShadowPass_h
#define VTKShadowPass_h

#include "vtkCameraPass.h"
#include "vtkNew.h"
#include "vtkRenderPassCollection.h"
#include "vtkSequencePass.h"
#include "vtkShadowMapBakerPass.h"
#include "vtkShadowMapPass.h"
#include "vtkSmartPointer.h"

/** vtkShadowMapPass with what it needs around it; maps of resolution x resolution texels. */
inline vtkSmartPointer<vtkRenderPass> MakeVTKShadowPass(int resolution)
{
  vtkNew<vtkShadowMapPass> shadows;
  shadows->GetShadowMapBakerPass()->SetResolution(resolution);
  vtkNew<vtkRenderPassCollection> passes;
  passes->AddItem(shadows->GetShadowMapBakerPass());
  passes->AddItem(shadows);
  vtkNew<vtkSequencePass> sequence;
  sequence->SetPasses(passes);
  vtkNew<vtkCameraPass> camera;
  camera->SetDelegatePass(sequence);
  return camera.Get();
}

#endif
