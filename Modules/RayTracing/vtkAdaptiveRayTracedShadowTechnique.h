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
  ///@{ Find what is open of a part of a light: on the GPU, which goes on by itself; or here, among all pixels.
  void Select(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, std::size_t part);
  const std::vector<vtkShadowSelection::Pixel>& Choose(
    vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, std::size_t part);
  ///@}
  ///@{ Give the buffer what was traced: as points; or as a picture, with all that was known.
  void Scatter(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, std::size_t part,
    const Receivers& receivers, const std::vector<vtkShadowRaySeen>& seen);
  void PutBack(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, std::size_t part,
    const Receivers& receivers, const std::vector<vtkShadowRaySeen>& seen);
  ///@}

  vtkShadowDepthBounds Bounds;
  std::array<vtkShadowSelection, 2> Selections; // of a part of a light, and of the next one
  vtkShadowVertices Values;
  ///@{ Of all pixels, where they are not chosen on the GPU.
  const std::vector<glm::vec4>* Texels = nullptr; // those of the receivers
  std::vector<float> Known;
  std::vector<vtkShadowSelection::Pixel> Chosen;
  ///@}
};

#endif
