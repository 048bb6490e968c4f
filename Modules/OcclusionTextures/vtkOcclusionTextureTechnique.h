// SPDX-License-Identifier: BSD-3-Clause
// The technique of vtkOcclusionTexturePass: see there.

#ifndef vtkOcclusionTextureTechnique_h
#define vtkOcclusionTextureTechnique_h

#include "vtkOcclusionTextures.h"
#include "vtkShadowTechnique.h"

class vtkOcclusionTextureTechnique : public vtkShadowTechnique
{
public:
  using vtkShadowTechnique::vtkShadowTechnique;

  bool UpdateLightData(vtkShadowFrame& frame) override;
  std::string GetVisibilityGLSL() override { return this->Textures.GetGLSL(); }
  bool PrefersForward(const vtkShadowFrame& frame) override;
  void Activate(vtkShadowFrame& frame) override { this->Textures.Activate(frame); }
  void Deactivate(vtkShadowFrame& frame) override { this->Textures.Deactivate(frame); }
  void SetVisibilityParameters(vtkShaderProgram* program) override
  {
    this->Textures.SetParameters(program);
  }
  double GetMaximumCost() override { return this->Textures.GetMaximumCost(); }
  std::string GetDebugQuantity(const std::string& view) override;
  void DrawDebugView(vtkShadowFrame& frame, const std::string& view) override;
  void Release(vtkOpenGLRenderWindow* window) override { this->Textures.Release(window); }
  std::vector<std::pair<std::string, std::size_t>> GetBytes() override
  {
    return this->Textures.GetBytes();
  }

private:
  vtkOcclusionTextures Textures;
};

#endif
