// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkOcclusionTexturePass
 * @brief   Technique occlusion-textures: slices of the casters, prefiltered over the light's footprint.
 *
 * Eisemann and Decoret, Occlusion textures for plausible soft shadows, Computer Graphics Forum 27(1), 2008.
 * The casters are cut into slices parallel to the light, each of them flattened onto its plane and kept as a
 * binary texture. What of the light a slice hides from a receiver is the slice's mean over a rectangle, the
 * light as the receiver sees it through the plane (equation 4). Prefiltered, that costs the same for every
 * size of the light. Slices are combined as if each hid another part of it (equation 5); or, beyond the
 * paper, sample by sample (combine=bits).
 *
 * Stages: 1. where lights or casters changed, all slices of a light in one draw (section 3.4); 2. their
 * prefiltering (section 3.2); 3. the look-up, a rectangle a slice, in each prop's shader.
 * Textures: see vtkOcclusionTextures.
 *
 * The receiver's own slice is left out, and the slice above it counts the less, the nearer the receiver
 * comes to its plane. What these two would hide, and what hides a light within a texel, a map tells of what is
 * nearest to the light, which is drawn along with the slices.
 *
 * Debug views: "slices", side by side; "levels", the widest level of the N-buffers; "kernel", the
 * longer side of the widest rectangle in texels; "slices-read".
 * Statistics: counts "slices", "levels", "slicesDrawn", "mapsDrawn" (views of lights); bytes "slices", "prefilter".
 */

#ifndef vtkOcclusionTexturePass_h
#define vtkOcclusionTexturePass_h

#include "vtkShadowPass.h"
#include "vtkSoftShadowsOcclusionTexturesModule.h" // For export macro

class VTKSOFTSHADOWSOCCLUSIONTEXTURES_EXPORT vtkOcclusionTexturePass : public vtkShadowPass
{
public:
  static vtkOcclusionTexturePass* New();
  vtkTypeMacro(vtkOcclusionTexturePass, vtkShadowPass);

protected:
  vtkOcclusionTexturePass();
  ~vtkOcclusionTexturePass() override;

private:
  vtkOcclusionTexturePass(const vtkOcclusionTexturePass&) = delete;
  void operator=(const vtkOcclusionTexturePass&) = delete;
};

#endif
