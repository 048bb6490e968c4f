// SPDX-License-Identifier: BSD-3-Clause
// The technique of vtkPercentageCloserFilteringPass: see there.

#ifndef vtkPercentageCloserFilteringTechnique_h
#define vtkPercentageCloserFilteringTechnique_h

#include "vtkFilteredShadowMapTechnique.h"

class vtkPercentageCloserFilteringTechnique : public vtkFilteredShadowMapTechnique
{
public:
  using vtkFilteredShadowMapTechnique::vtkFilteredShadowMapTechnique;

  void UpdatePatterns(vtkShadowFrame& frame) override;
  std::string GetFilterGLSL() override;
};

#endif
