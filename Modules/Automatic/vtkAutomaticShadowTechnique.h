// SPDX-License-Identifier: BSD-3-Clause
// The technique of vtkAutomaticShadowPass: see there. It is what it has chosen, in all that a pass asks.

#ifndef vtkAutomaticShadowTechnique_h
#define vtkAutomaticShadowTechnique_h

#include "vtkShadowChanges.h"
#include "vtkShadowChoice.h"
#include "vtkShadowTechnique.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

class vtkAutomaticShadowTechnique : public vtkShadowTechnique
{
public:
  using vtkShadowTechnique::vtkShadowTechnique;

  vtkShadowTraits GetTraits() override;
  int GetSamples() override;
  int GetWantedSamples() override;
  void BeginFrame(bool still) override;
  std::string GetReport() override;
  bool UpdateLightData(vtkShadowFrame& frame) override;
  std::string GetVisibilityGLSL() override;
  bool CanEvaluateForward() override;
  bool PrefersForward(const vtkShadowFrame& frame) override;
  void Activate(vtkShadowFrame& frame) override;
  void Deactivate(vtkShadowFrame& frame) override;
  void SetVisibilityParameters(vtkShaderProgram* program) override;
  void FillVisibility(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer) override;
  double GetMaximumCost() override;
  std::string GetDebugQuantity(const std::string& view) override;
  void DrawDebugView(vtkShadowFrame& frame, const std::string& view) override;
  std::vector<std::pair<std::string, std::size_t>> GetBytes() override;
  void Release(vtkOpenGLRenderWindow* window) override;

private:
  /** What kind of a scene it was chosen for. */
  struct Kind
  {
    std::vector<int> Shapes; // of parts of lights
    bool Hard = false;
    double Triangles = 0.0;
    double Pixels = 0.0;

    bool IsLike(const Kind& other) const;
  };
  static Kind Describe(const vtkShadowFrame& frame);

  bool IsDecided() const;
  /** What draws this frame; nullptr where nothing is chosen. */
  vtkShadowTechnique* Get() const;

  vtkShadowChoice Choice;
  bool Decided = false;
  vtkMTimeType Time = 0; // of the settings that it was made by
  Kind Of;
  vtkShadowChanges Changes;
  bool Moved = false;  // lights or casters, in the last frame that was drawn
  bool Moving = false; // as it is taken for in this frame
  bool Still = false;
};

#endif
