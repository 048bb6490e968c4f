// SPDX-License-Identifier: BSD-3-Clause
// The technique of vtkPercentageCloserSoftShadowPass: see there.

#ifndef vtkPercentageCloserSoftShadowTechnique_h
#define vtkPercentageCloserSoftShadowTechnique_h

#include "vtkFilteredShadowMapTechnique.h"

class vtkPercentageCloserSoftShadowTechnique : public vtkFilteredShadowMapTechnique
{
public:
  using vtkFilteredShadowMapTechnique::vtkFilteredShadowMapTechnique;

  void UpdatePatterns(vtkShadowFrame& frame) override;
  std::string GetFilterGLSL() override;
};

#endif
