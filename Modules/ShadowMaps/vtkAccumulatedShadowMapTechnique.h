// SPDX-License-Identifier: BSD-3-Clause
// The technique of vtkAccumulatedShadowMapPass: see there.

#ifndef vtkAccumulatedShadowMapTechnique_h
#define vtkAccumulatedShadowMapTechnique_h

#include "vtkDepthMapTechnique.h"

class vtkAccumulatedShadowMapTechnique : public vtkDepthMapTechnique
{
public:
  using vtkDepthMapTechnique::vtkDepthMapTechnique;

  bool UpdateLightData(vtkShadowFrame& frame) override;
  bool CanEvaluateForward() override;
  bool PrefersForward(const vtkShadowFrame&) override { return false; }
  void FillVisibility(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer) override;
};

#endif
