// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAccumulatedShadowMapPass
 * @brief   Technique map-soft: the mean of hard shadow maps from N samples of the light.
 *
 * Heckbert and Herf, Simulating soft shadows with graphics hardware, 1997; Zapotocky, Soft shadows
 * on GPU, 2007, section 3.1 (brute force) and table 5.4. Converges to the true visibility with N, up
 * to the maps' resolution; a textured light's samples are weighted by its emission.
 *
 * Stages: 1. N maps where light or casters changed; 2. receivers; 3. the mean of N compares, once a
 * pixel. Maps that do not fit into the parameter "memory" are drawn in batches in every frame.
 * Textures: see vtkShadowMaps.
 */

#ifndef vtkAccumulatedShadowMapPass_h
#define vtkAccumulatedShadowMapPass_h

#include "vtkShadowPass.h"
#include "vtkSoftShadowsShadowMapsModule.h" // For export macro

class VTKSOFTSHADOWSSHADOWMAPS_EXPORT vtkAccumulatedShadowMapPass : public vtkShadowPass
{
public:
  static vtkAccumulatedShadowMapPass* New();
  vtkTypeMacro(vtkAccumulatedShadowMapPass, vtkShadowPass);

protected:
  vtkAccumulatedShadowMapPass();
  ~vtkAccumulatedShadowMapPass() override;

private:
  vtkAccumulatedShadowMapPass(const vtkAccumulatedShadowMapPass&) = delete;
  void operator=(const vtkAccumulatedShadowMapPass&) = delete;
};

#endif
