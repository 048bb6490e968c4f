// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHardShadowMapPass
 * @brief   Technique map-hard: one depth map from the light's centre, one compare a pixel.
 *
 * Williams, Casting curved shadows on curved surfaces, SIGGRAPH 1978; Zapotocky, Soft shadows on
 * GPU, 2007, section 2.3. Visibility is that of the light's centre, whatever its size; with the
 * parameter filter=bilinear the edge is smoothed over one texel of the map.
 *
 * Stages: 1. a map where light or casters changed; 2. the look-up, in each prop's shader.
 * Textures: see vtkShadowMaps.
 */

#ifndef vtkHardShadowMapPass_h
#define vtkHardShadowMapPass_h

#include "vtkShadowPass.h"
#include "vtkSoftShadowsShadowMapsModule.h" // For export macro

class VTKSOFTSHADOWSSHADOWMAPS_EXPORT vtkHardShadowMapPass : public vtkShadowPass
{
public:
  static vtkHardShadowMapPass* New();
  vtkTypeMacro(vtkHardShadowMapPass, vtkShadowPass);

protected:
  vtkHardShadowMapPass();
  ~vtkHardShadowMapPass() override;

private:
  vtkHardShadowMapPass(const vtkHardShadowMapPass&) = delete;
  void operator=(const vtkHardShadowMapPass&) = delete;
};

#endif
