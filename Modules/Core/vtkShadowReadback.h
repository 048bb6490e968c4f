// SPDX-License-Identifier: BSD-3-Clause
// Visibility as images, for whoever asks a pass for it.

#ifndef vtkShadowReadback_h
#define vtkShadowReadback_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <map>
#include <vector>

class vtkLight;
struct vtkShadowFrame;
struct vtkShadowScreen;

class vtkShadowReadback
{
public:
  /**
   * The visibility of a light at the pixels of a screen, as vtkShadowPass::GetVisibility gives it: the sum
   * of its parts, 1 of a light that has none. It is kept until the next call for the same light, as long
   * as that is among the lights that there are.
   */
  vtkImageData* Make(const vtkShadowFrame& frame, vtkShadowScreen& screen, const vtkLight* light,
    const std::vector<vtkLight*>& lights);

private:
  std::map<const vtkLight*, vtkSmartPointer<vtkImageData>> Images;
};

#endif
