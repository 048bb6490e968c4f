// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPercentageCloserSoftShadowPass
 * @brief   Technique map-pcss: penumbrae as wide as the mean blocker makes them.
 *
 * Fernando, Percentage-closer soft shadows, SIGGRAPH 2005 sketches; Zapotocky, Soft shadows on GPU,
 * 2007, section 3.5. Three steps a receiver: 1. blocker search over the light's footprint at the
 * nearest depth that the map has there; 2. the penumbra's width from the mean blocker; 3. a mean of
 * compares over the light's footprint past that blocker, in the light's own form and two axes.
 *
 * With "blockers" (layers by default, or mean as published) layers, the mean, the variance and the skewness of
 * what was found give two depths where they vary, and 3. is a mean over points of the light of what is lit
 * past both: see vtkShadowMapLayersFS.glsl. Where 1. finds nothing, it looks at "samples" points more.
 *
 * Stages and textures: see vtkFilteredShadowMapTechnique.
 */

#ifndef vtkPercentageCloserSoftShadowPass_h
#define vtkPercentageCloserSoftShadowPass_h

#include "vtkShadowPass.h"
#include "vtkSoftShadowsShadowMapsModule.h" // For export macro

class VTKSOFTSHADOWSSHADOWMAPS_EXPORT vtkPercentageCloserSoftShadowPass : public vtkShadowPass
{
public:
  static vtkPercentageCloserSoftShadowPass* New();
  vtkTypeMacro(vtkPercentageCloserSoftShadowPass, vtkShadowPass);

protected:
  vtkPercentageCloserSoftShadowPass();
  ~vtkPercentageCloserSoftShadowPass() override;

private:
  vtkPercentageCloserSoftShadowPass(const vtkPercentageCloserSoftShadowPass&) = delete;
  void operator=(const vtkPercentageCloserSoftShadowPass&) = delete;
};

#endif
