// SPDX-License-Identifier: BSD-3-Clause
// The technique of vtkPenumbraWedgePass: see there.

#ifndef vtkPenumbraWedgeTechnique_h
#define vtkPenumbraWedgeTechnique_h

#include "vtkPenumbraWedges.h"
#include "vtkShadowTechnique.h"
#include "vtkShadowVolumes.h"

#include <memory>

class vtkPenumbraWedgeTechnique : public vtkShadowTechnique
{
public:
  using vtkShadowTechnique::vtkShadowTechnique;

  bool UpdateLightData(vtkShadowFrame& frame) override;
  void FillVisibility(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer) override;
  double GetMaximumCost() override { return this->MostWedges; }
  std::vector<std::pair<std::string, std::size_t>> GetBytes() override;
  void Release(vtkOpenGLRenderWindow* window) override;

private:
  /** Wedges of a part of a light: one set for each part of its area. */
  struct PartState
  {
    std::vector<std::unique_ptr<vtkPenumbraWedges>> Areas;
    unsigned long Version = 0; // of the silhouettes that they were made of
  };

  void UpdatePart(vtkShadowFrame& frame, int part);
  /** Add what an area's edges let through and hide to a layer of a target. */
  void AddWedges(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, const vtkShadowTexture& target,
    int layer, int part, vtkPenumbraWedges& wedges, float share);
  /** The visibility of an area: all that is in the window, less what is hidden, within 0 and 1. */
  void AddArea(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int part, int area);

  vtkShadowVolumes Volumes;
  std::vector<PartState> Parts;
  std::string Bounds;
  vtkShadowTexture Sums; // R32F: of one area
  double MostWedges = 0.0;
};

#endif
