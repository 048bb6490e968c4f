// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPercentageCloserFilteringPass
 * @brief   Technique map-pcf: the mean of n x n compares around the receiver.
 *
 * Reeves, Salesin and Cook, Rendering antialiased shadows with depth maps, SIGGRAPH 1987; Zapotocky,
 * Soft shadows on GPU, 2007, section 3.2 (7 x 7). The kernel is the light's footprint past a blocker
 * that lies in front of the receiver by an assumed share of the casters' extent (parameter "width"):
 * penumbrae are as wide everywhere.
 *
 * Stages and textures: see vtkFilteredShadowMapTechnique.
 */

#ifndef vtkPercentageCloserFilteringPass_h
#define vtkPercentageCloserFilteringPass_h

#include "vtkShadowPass.h"
#include "vtkSoftShadowsShadowMapsModule.h" // For export macro

class VTKSOFTSHADOWSSHADOWMAPS_EXPORT vtkPercentageCloserFilteringPass : public vtkShadowPass
{
public:
  static vtkPercentageCloserFilteringPass* New();
  vtkTypeMacro(vtkPercentageCloserFilteringPass, vtkShadowPass);

protected:
  vtkPercentageCloserFilteringPass();
  ~vtkPercentageCloserFilteringPass() override;

private:
  vtkPercentageCloserFilteringPass(const vtkPercentageCloserFilteringPass&) = delete;
  void operator=(const vtkPercentageCloserFilteringPass&) = delete;
};

#endif
