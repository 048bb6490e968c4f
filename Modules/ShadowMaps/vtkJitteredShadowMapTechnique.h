// SPDX-License-Identifier: BSD-3-Clause
// The technique of vtkJitteredShadowMapPass: see there.

#ifndef vtkJitteredShadowMapTechnique_h
#define vtkJitteredShadowMapTechnique_h

#include "vtkFilteredShadowMapTechnique.h"

class vtkShadowTexture;

class vtkJitteredShadowMapTechnique : public vtkFilteredShadowMapTechnique
{
public:
  explicit vtkJitteredShadowMapTechnique(const vtkShadowSettings& settings);
  ~vtkJitteredShadowMapTechnique() override;

  void UpdatePatterns(vtkShadowFrame& frame) override;
  std::string GetFilterGLSL() override;
  std::string GetKernelDefinitions() override;
  double GetMaximumCost() override;
  void Release(vtkOpenGLRenderWindow* window) override;
  std::vector<std::pair<std::string, std::size_t>> GetBytes() override;
  void Activate(vtkShadowFrame& frame) override;
  void Deactivate(vtkShadowFrame& frame) override;
  void SetVisibilityParameters(vtkShaderProgram* program) override;

private:
  std::unique_ptr<vtkShadowTexture> Jitter;
  int Samples = 0;
  int Estimates = 0; // of the outer ring
};

#endif
