// SPDX-License-Identifier: BSD-3-Clause
// The technique of vtkAdaptiveRayTracedShadowPass: see there.

#ifndef vtkAdaptiveRayTracedShadowTechnique_h
#define vtkAdaptiveRayTracedShadowTechnique_h

#include "vtkRayTracedShadowTechnique.h"
#include "vtkShadowDepthBounds.h"
#include "vtkShadowSelection.h"
#include "vtkShadowVertices.h"

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

class vtkAdaptiveRayTracedShadowTechnique : public vtkRayTracedShadowTechnique
{
public:
  using vtkRayTracedShadowTechnique::vtkRayTracedShadowTechnique;

  bool UpdateLightData(vtkShadowFrame& frame) override;
  void FillVisibility(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer) override;
  std::string GetVisibilityGLSL() override;
  void Activate(vtkShadowFrame& frame) override;
  void Deactivate(vtkShadowFrame& frame) override;
  void SetVisibilityParameters(vtkShaderProgram* program) override;
  std::vector<std::pair<std::string, std::size_t>> GetBytes() override;
  void Release(vtkOpenGLRenderWindow* window) override;

private:
  void Select(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, std::size_t part);
  void Scatter(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, std::size_t part,
    const Receivers& receivers, const std::vector<vtkShadowRaySeen>& seen);

  vtkShadowDepthBounds Bounds;
  std::array<vtkShadowSelection, 2> Selections; // of a part of a light, and of the next one
  vtkShadowVertices Values;
};

#endif
