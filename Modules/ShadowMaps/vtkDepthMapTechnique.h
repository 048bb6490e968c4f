// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDepthMapTechnique
 * @brief   Base of the techniques that look up depth maps: the family's map resource, and its use.
 *
 * (VTK has a class vtkShadowMapPass of its own.) A map is drawn from the casters' own buffers,
 * through frusta that hug them (see vtkLightFrusta). It is read with an automatic depth bias
 * (vtkShadowMapViewsFS.glsl): what the receiver's plane can rise within the texels that one look-up reads.
 *
 * Debug view "map": the depth maps, side by side.
 */

#ifndef vtkDepthMapTechnique_h
#define vtkDepthMapTechnique_h

#include "vtkShadowTechnique.h"

#include <memory>

class vtkShadowMaps;
struct vtkShadowMapSettings;

class vtkDepthMapTechnique : public vtkShadowTechnique
{
public:
  explicit vtkDepthMapTechnique(const vtkShadowSettings& settings);
  ~vtkDepthMapTechnique() override;

  std::string GetVisibilityGLSL() override;
  void Activate(vtkShadowFrame& frame) override;
  void Deactivate(vtkShadowFrame& frame) override;
  void SetVisibilityParameters(vtkShaderProgram* program) override;
  double GetMaximumCost() override;
  void DrawDebugView(vtkShadowFrame& frame, const std::string& view) override;
  void Release(vtkOpenGLRenderWindow* window) override;
  std::vector<std::pair<std::string, std::size_t>> GetBytes() override;

protected:
  /**
   * Update the maps with the parameters "resolution" (0: from the picture's size), "filter" and
   * "midpoint", N samples, and a limit.
   */
  bool UpdateMaps(vtkShadowFrame& frame, int samples, double megabytes);

  /** What a technique wants else of its maps. */
  virtual void SetMapSettings(vtkShadowMapSettings&) {}

  std::unique_ptr<vtkShadowMaps> Maps;
};

#endif
