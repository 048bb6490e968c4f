// SPDX-License-Identifier: BSD-3-Clause
// The technique of vtkCombinedShadowMapPass: see there.

#ifndef vtkCombinedShadowMapTechnique_h
#define vtkCombinedShadowMapTechnique_h

#include "vtkJitteredShadowMapTechnique.h"

class vtkCombinedShadowMapTechnique : public vtkJitteredShadowMapTechnique
{
public:
  using vtkJitteredShadowMapTechnique::vtkJitteredShadowMapTechnique;

  void UpdatePatterns(vtkShadowFrame& frame) override;
  std::string GetFilterGLSL() override;
};

#endif
