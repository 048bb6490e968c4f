// SPDX-License-Identifier: BSD-3-Clause
// The technique of vtkPenumbraWedgePass: see there.

#ifndef vtkPenumbraWedgeTechnique_h
#define vtkPenumbraWedgeTechnique_h

#include "vtkPenumbraEmission.h"
#include "vtkPenumbraSamples.h"
#include "vtkPenumbraWedges.h"
#include "vtkShadowTechnique.h"
#include "vtkShadowVolumes.h"

#include <array>
#include <functional>
#include <memory>
#include <string>

class vtkPenumbraWedgeTechnique : public vtkShadowTechnique
{
public:
  using vtkShadowTechnique::vtkShadowTechnique;

  int GetSamples() override;
  bool UpdateLightData(vtkShadowFrame& frame) override;
  void FillVisibility(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer) override;
  double GetMaximumCost() override { return this->Most; }
  std::string GetDebugQuantity(const std::string& view) override
  {
    return view == "cost" || view == "centre" || view == "inner" || view == "outer" ||
               view == "edges" || view == "wedges"
             ? view
             : "";
  }
  std::vector<std::pair<std::string, std::size_t>> GetBytes() override;
  void Release(vtkOpenGLRenderWindow* window) override;

private:
  /** Wedges of a part of a light: one set for each part of its area. */
  struct PartState
  {
    vtkPenumbraSamples Samples; // that are counted one by one

    std::vector<std::unique_ptr<vtkPenumbraWedges>> Areas;
    std::pair<unsigned long, unsigned long> Version; // of silhouettes and receivers, then
    std::vector<std::vector<double>> Moves;          // see vtkPenumbraLines, of each area

    std::vector<std::unique_ptr<vtkPenumbraEmission>> Emissions; // of the areas of a textured light
    vtkSmartPointer<vtkImageData> Image;                         // they are made of
    vtkMTimeType ImageTime = 0;
  };

  /** Forget the parts of lights from the first one on. */
  void ReleaseParts(vtkOpenGLRenderWindow* window, std::size_t first);
  void UpdatePart(vtkShadowFrame& frame, int part);
  /** Make the tables of what side x side areas of a textured light emit; none of others. */
  void UpdateEmissions(vtkShadowFrame& frame, int part, int side);
  /** An area's share of what the light emits, of each channel. */
  glm::vec3 GetShare(int part, int area) const;
  /** Add what an area's edges let through and hide to a layer of a target. */
  void AddWedges(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer,
    const std::vector<const vtkShadowTexture*>& targets, int layer, int part,
    vtkPenumbraWedges& wedges, const char* shader, const std::string& definitions,
    const std::function<void(vtkShaderProgram*)>& setParameters,
    const std::vector<int>* some = nullptr);
  /** Count how often the centre of an area is hidden, in the sums' first channel. */
  void CountCentre(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int part, int area,
    const std::vector<int>* some = nullptr);
  /** Combine what the loops of an area's silhouettes hide, each for itself, into Loops[0]. */
  void CombineLoops(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int part, int area);
  /** Parts of an area's silhouettes that are summed up: each loop, or what has caps together. */
  std::vector<std::vector<int>> GetLoops(vtkShadowFrame& frame, int part, int area);
  /** Take away what is hidden of an area: by the sum of its edges, or by counts of its samples. */
  void AddArea(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int part, int area);
  /** What a debug view shows of an area. */
  void AddQuantity(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int part, int area);
  void AddSamples(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int part);
  /** Draw a shader over a layer of a target, of what sums hold; added up, or in its place. */
  void DrawOver(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, const vtkShadowTexture& target,
    int layer, bool adds, vtkShadowTexture& sums, const vtkPenumbraWedges& wedges,
    const char* shader, const std::string& definitions,
    const std::function<void(vtkShaderProgram*)>& setParameters);
  bool CountsSamples(int part) const { return this->Parts[part].Samples.Count > 0; }
  bool IsColor(int part) const { return !this->Parts[part].Emissions.empty(); }

  vtkShadowVolumes Volumes;
  std::vector<PartState> Parts;
  std::string Bounds;
  std::string Overlap;
  int Samples = 0;
  vtkShadowTexture Loops[2];                                            // combined, by turns
  vtkShadowTexture Sums;                                                // of one area
  std::array<vtkShadowTexture, vtkPenumbraSamples::MostTargets> Counts; // of samples
  double Most = 0.0; // of a quantity, when it was last shown
};

#endif
