// SPDX-License-Identifier: BSD-3-Clause
// The techniques of vtkPlanarShadowPass: see there.

#ifndef vtkPlanarShadowTechnique_h
#define vtkPlanarShadowTechnique_h

#include "vtkPlanarShadowMaps.h"
#include "vtkShadowPlanes.h"
#include "vtkShadowTechnique.h"

class vtkPlanarShadowTechnique : public vtkShadowTechnique
{
public:
  using Kind = vtkPlanarShadowSettings::Kind;

  vtkPlanarShadowTechnique(const vtkShadowSettings& settings, Kind kind);

  /** The user's planes, beside what the frame holds. */
  void SetGivenPlanes(const vtkShadowPlanes& planes) { this->Planes.SetGiven(planes); }

  bool UpdateLightData(vtkShadowFrame& frame) override;
  std::string GetVisibilityGLSL() override;
  bool PrefersForward(const vtkShadowFrame& frame) override;
  void Activate(vtkShadowFrame& frame) override;
  void Deactivate(vtkShadowFrame& frame) override;
  void SetVisibilityParameters(vtkShaderProgram* program) override;
  double GetMaximumCost() override;
  void DrawDebugView(vtkShadowFrame& frame, const std::string& view) override;
  void Release(vtkOpenGLRenderWindow* window) override;
  std::vector<std::pair<std::string, std::size_t>> GetBytes() override;

private:
  const Kind Technique;
  vtkShadowPlanes Planes;
  vtkPlanarShadowMaps Maps;
};

#endif
