// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCombinedShadowMapPass
 * @brief   Technique map-combined: the blockers of map-pcss, the jittered branching of map-jitter.
 *
 * Zapotocky, Soft shadows on GPU, 2007, section 4.4.3: 1. blocker search; 2. the penumbra's width;
 * 3. jittered compares over that width, of which the outer ring decides whether the others are needed.
 *
 * Stages and textures: see vtkJitteredShadowMapPass and vtkPercentageCloserSoftShadowPass.
 */

#ifndef vtkCombinedShadowMapPass_h
#define vtkCombinedShadowMapPass_h

#include "vtkShadowPass.h"
#include "vtkSoftShadowsShadowMapsModule.h" // For export macro

class VTKSOFTSHADOWSSHADOWMAPS_EXPORT vtkCombinedShadowMapPass : public vtkShadowPass
{
public:
  static vtkCombinedShadowMapPass* New();
  vtkTypeMacro(vtkCombinedShadowMapPass, vtkShadowPass);

protected:
  vtkCombinedShadowMapPass();
  ~vtkCombinedShadowMapPass() override;

private:
  vtkCombinedShadowMapPass(const vtkCombinedShadowMapPass&) = delete;
  void operator=(const vtkCombinedShadowMapPass&) = delete;
};

#endif
