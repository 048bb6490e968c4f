// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkJitteredShadowMapPass
 * @brief   Technique map-jitter: stratified compares that differ from pixel to pixel, and branching.
 *
 * Uralsky, Efficient soft-edged shadows using pixel shader branching, GPU Gems 2, 2005, chapter 17;
 * Zapotocky, Soft shadows on GPU, 2007, section 3.4. Points are stratified in angle and radius
 * (equations 3.1 and 3.2; over a square light, around and outwards the same way) and jittered, a set
 * for each pixel of a tile, two points a texel. Those of the outer ring come first: only where they
 * disagree are the others looked up. The kernel's width is that of map-pcf.
 *
 * Textures: see vtkFilteredShadowMapTechnique; jitter, RGBA32F buffer, 16 x 16 texels x samples (half of
 * them for either form of light): a 3D texture by its layout, a buffer since that took a fifth
 * less time on llvmpipe.
 */

#ifndef vtkJitteredShadowMapPass_h
#define vtkJitteredShadowMapPass_h

#include "vtkShadowPass.h"
#include "vtkSoftShadowsShadowMapsModule.h" // For export macro

class VTKSOFTSHADOWSSHADOWMAPS_EXPORT vtkJitteredShadowMapPass : public vtkShadowPass
{
public:
  static vtkJitteredShadowMapPass* New();
  vtkTypeMacro(vtkJitteredShadowMapPass, vtkShadowPass);

protected:
  vtkJitteredShadowMapPass();
  ~vtkJitteredShadowMapPass() override;

private:
  vtkJitteredShadowMapPass(const vtkJitteredShadowMapPass&) = delete;
  void operator=(const vtkJitteredShadowMapPass&) = delete;
};

#endif
