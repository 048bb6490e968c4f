// SPDX-License-Identifier: BSD-3-Clause
// The technique of vtkTracedShadowMapPass: see there.

#ifndef vtkTracedShadowMapTechnique_h
#define vtkTracedShadowMapTechnique_h

#include "vtkFilteredShadowMapTechnique.h"

class vtkShadowTexture;

class vtkTracedShadowMapTechnique : public vtkFilteredShadowMapTechnique
{
public:
  explicit vtkTracedShadowMapTechnique(const vtkShadowSettings& settings);
  ~vtkTracedShadowMapTechnique() override;

  bool UpdateLightData(vtkShadowFrame& frame) override;
  void UpdatePatterns(vtkShadowFrame& frame) override;
  std::string GetKernelDefinitions() override;
  std::string GetFilterGLSL() override;
  bool FollowsLayers() const override { return true; }
  bool CanEvaluateForward() override;
  bool PrefersForward(const vtkShadowFrame&) override { return this->Hard; }
  double GetMaximumCost() override;
  void FillVisibility(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer) override;
  void Activate(vtkShadowFrame& frame) override;
  void Deactivate(vtkShadowFrame& frame) override;
  void SetVisibilityParameters(vtkShaderProgram* program) override;
  void Release(vtkOpenGLRenderWindow* window) override;
  std::vector<std::pair<std::string, std::size_t>> GetBytes() override;

protected:
  void SetMapSettings(vtkShadowMapSettings& settings) override;

private:
  void UpdateEmission(vtkShadowFrame& frame);
  void Denoise(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int part);

  std::unique_ptr<vtkShadowTexture> Emission;
  std::unique_ptr<vtkShadowTexture> Mask;
  bool Color = false;  // of the last frame
  bool ToMask = false; // what is evaluated now
};

#endif
