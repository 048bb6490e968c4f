// SPDX-License-Identifier: BSD-3-Clause
// The techniques of vtkShadowVolumePass: see there.

#ifndef vtkShadowVolumeTechnique_h
#define vtkShadowVolumeTechnique_h

#include "vtkShadowTechnique.h"
#include "vtkShadowVolumes.h"

class vtkShadowVolumeTechnique : public vtkShadowTechnique
{
public:
  using vtkShadowTechnique::vtkShadowTechnique;

  bool UpdateLightData(vtkShadowFrame& frame) override;
  void FillVisibility(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer) override;
  double GetMaximumCost() override { return this->MostFaces; }
  void DrawDebugView(vtkShadowFrame& frame, const std::string& view) override;
  void Release(vtkOpenGLRenderWindow* window) override { this->Volumes.Release(window); }
  std::vector<std::pair<std::string, std::size_t>> GetBytes() override
  {
    return this->Volumes.GetBytes();
  }

private:
  vtkShadowVolumes Volumes;
  double MostFaces = 0.0; // drawn over a pixel, when the cost was last shown
};

#endif
