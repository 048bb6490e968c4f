// SPDX-License-Identifier: BSD-3-Clause
// VTK's own shadows, vtkShadowMapPass, to measure the techniques beside.

#ifndef VTKShadows_h
#define VTKShadows_h

#include "vtkImageData.h"
#include "vtkRenderPass.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class OffscreenWindow;
class vtkAreaLight;
class vtkLight;
class vtkRenderer;

class VTKShadows
{
public:
  /** Maps of resolution x resolution texels. */
  explicit VTKShadows(int resolution);

  /** Why VTK's pass draws no shadow of this light, or "". */
  static std::string FindUnsupported(vtkAreaLight* light);

  /**
   * Set the pass. VTK's pass takes spots and parallel light alone: while it is set, such lights stand
   * in the places of these, each with a cone that holds all of the scene.
   */
  void Enter(vtkRenderer* renderer, const std::vector<vtkAreaLight*>& lights);
  /** The lights have moved. */
  void Follow();
  void Leave(vtkRenderer* renderer);

  /**
   * Visibility of the first light in the frame that is drawn, like that of a shadow pass. VTK's pass
   * keeps none: it is the quotient of what the light adds to the picture with the pass and without,
   * in 8 bits, hence good to about 1/100; where it adds next to nothing, it is taken as right.
   */
  vtkSmartPointer<vtkImageData> GetVisibility(OffscreenWindow& window, vtkImageData* right);

private:
  vtkSmartPointer<vtkRenderPass> Pass;
  std::vector<vtkSmartPointer<vtkAreaLight>> Lights; // which the renderer does without meanwhile
  std::vector<vtkSmartPointer<vtkLight>> StandIns;
  double Bounds[6];
};

#endif
