// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkBlurredShadowMapPass
 * @brief   Technique map-blur: a hard mask in screen space, blurred by a separable Gaussian.
 *
 * Shastry, Soft-edged shadows, 2005; Zapotocky, Soft shadows on GPU, 2007, section 3.3 (3 x 3
 * compares, 15 points twice). By default the Gaussian is one over the light, not over the picture:
 * each point's weight is that of its receiver's place in the light's footprint, and falls with its
 * distance from the middle receiver's plane and the turn of its normal, so that nothing comes over
 * from another surface (parameter blur=aware; cross bilateral). blur=plain is the thesis's: points a
 * pixel apart, receivers or not, with its halo along silhouettes.
 *
 * Stages: 1. as vtkFilteredShadowMapTechnique; 2. receivers; 3. the mask; 4. the blur along x, 5. along y.
 * Textures: see vtkFilteredShadowMapTechnique; masks, two of R32F, viewport size.
 */

#ifndef vtkBlurredShadowMapPass_h
#define vtkBlurredShadowMapPass_h

#include "vtkShadowPass.h"
#include "vtkSoftShadowsShadowMapsModule.h" // For export macro

class VTKSOFTSHADOWSSHADOWMAPS_EXPORT vtkBlurredShadowMapPass : public vtkShadowPass
{
public:
  static vtkBlurredShadowMapPass* New();
  vtkTypeMacro(vtkBlurredShadowMapPass, vtkShadowPass);

protected:
  vtkBlurredShadowMapPass();
  ~vtkBlurredShadowMapPass() override;

private:
  vtkBlurredShadowMapPass(const vtkBlurredShadowMapPass&) = delete;
  void operator=(const vtkBlurredShadowMapPass&) = delete;
};

#endif
