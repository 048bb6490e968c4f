// SPDX-License-Identifier: BSD-3-Clause
// The technique of vtkBlurredShadowMapPass: see there.

#ifndef vtkBlurredShadowMapTechnique_h
#define vtkBlurredShadowMapTechnique_h

#include "vtkPercentageCloserFilteringTechnique.h"

class vtkShadowTexture;

class vtkBlurredShadowMapTechnique : public vtkPercentageCloserFilteringTechnique
{
public:
  explicit vtkBlurredShadowMapTechnique(const vtkShadowSettings& settings);
  ~vtkBlurredShadowMapTechnique() override;

  bool UpdateLightData(vtkShadowFrame& frame) override;
  void UpdatePatterns(vtkShadowFrame& frame) override;
  std::string GetKernelDefinitions() override;
  bool CanEvaluateForward() override { return this->Hard; }
  void FillVisibility(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer) override;
  void Release(vtkOpenGLRenderWindow* window) override;
  std::vector<std::pair<std::string, std::size_t>> GetBytes() override;

private:
  void Blur(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int light, vtkShadowTexture& mask,
    const float step[2]);

  std::unique_ptr<vtkShadowTexture> Masks[2];
};

#endif
