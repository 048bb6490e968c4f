// SPDX-License-Identifier: BSD-3-Clause
// The technique of vtkHardShadowMapPass: see there.

#ifndef vtkHardShadowMapTechnique_h
#define vtkHardShadowMapTechnique_h

#include "vtkDepthMapTechnique.h"

class vtkHardShadowMapTechnique : public vtkDepthMapTechnique
{
public:
  using vtkDepthMapTechnique::vtkDepthMapTechnique;

  bool UpdateLightData(vtkShadowFrame& frame) override;
};

#endif
