// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFilteredShadowMapTechnique
 * @brief   Base of the techniques that soften one depth map a light: look-ups around each receiver.
 *
 * Where an area light's points lie over the map as a receiver sees them is the same for all of them
 * (vtkShadowMapKernelFS.glsl); they differ in how wide they look, and in what pattern. Sizes follow
 * from the light's true size in world units: neither frustum, nor scene's unit, nor map's resolution
 * changes them. A frame whose lights have no size takes the path of map-hard.
 *
 * Leaving out (parameter "skipping"): a depth pyramid tells receivers that are fully lit or in
 * umbra, conservatively. They need no look-up; the picture is the same without.
 *
 * Stages: 1. a map and its pyramid where light or casters changed; 2. the filter, in each
 * prop's shader, or with evaluation=screen once a pixel of the receivers. Textures: see
 * vtkShadowMaps; patterns, RGBA32F, a texel a point.
 *
 * Debug views: "map"; "penumbra-width", world units; where blockers are searched, "blocker-depth",
 * their mean distance from the light, world units (0 where skipping needs neither). White is
 * GetStatistics()'s "debugViewWhite".
 */

#ifndef vtkFilteredShadowMapTechnique_h
#define vtkFilteredShadowMapTechnique_h

#include "vtkDepthMapTechnique.h"

class vtkShadowLayers;
class vtkShadowMapPattern;

class vtkFilteredShadowMapTechnique : public vtkDepthMapTechnique
{
public:
  explicit vtkFilteredShadowMapTechnique(const vtkShadowSettings& settings);
  ~vtkFilteredShadowMapTechnique() override;

  std::string FindUnsupported(vtkOpenGLRenderWindow* window) override;
  bool UpdateLightData(vtkShadowFrame& frame) override;
  std::string GetVisibilityGLSL() override;
  bool PrefersForward(const vtkShadowFrame& frame) override;
  std::string GetDebugQuantity(const std::string& view) override;
  /** All look-ups in patterns, and those of the pyramid. */
  double GetMaximumCost() override;
  void Release(vtkOpenGLRenderWindow* window) override;
  std::vector<std::pair<std::string, std::size_t>> GetBytes() override;
  void Activate(vtkShadowFrame& frame) override;
  void Deactivate(vtkShadowFrame& frame) override;
  void SetVisibilityParameters(vtkShaderProgram* program) override;

protected:
  /** The GLSL of the technique: what defines shadowVisibility, such as vtkShadowMapFilterFS and a shadowFilter. */
  virtual std::string GetFilterGLSL() = 0;
  /** `#define`s that it wants of vtkShadowMapKernelFS.glsl. */
  virtual std::string GetKernelDefinitions() { return ""; }
  /** Make the patterns anew: a parameter has changed, or they were released. */
  virtual void UpdatePatterns(vtkShadowFrame& frame) = 0;
  /** Not one mean blocker for all that hides a light. */
  virtual bool FollowsLayers() const { return false; }
  void SetMapSettings(vtkShadowMapSettings& settings) override;
  /** Two depths of blockers are told apart: parameter "blockers", of techniques that search some. */
  bool HasLayers() const;
  /** The pattern of the search, by that and the parameters "search" and "samples". */
  void UpdateSearch(vtkShadowFrame& frame);
  /** At most so many for a point of the light. */
  int GetLookUps() const;

  bool Hard = false;                           // no light of this frame has a size
  std::unique_ptr<vtkShadowMapPattern> Search; // of blockers
  std::unique_ptr<vtkShadowMapPattern> Filter;

private:
  std::unique_ptr<vtkShadowLayers> Layers;
  vtkMTimeType PatternTime = 0; // of the parameters that the patterns were made from
};

#endif
