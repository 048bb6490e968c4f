// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowVolumePass
 * @brief   Techniques volume-hard and volume-soft: stencil shadow volumes from silhouettes.
 *
 * Crow, Shadow algorithms for computer graphics, SIGGRAPH 1977; Heidmann, Real shadows, real time,
 * 1991; Zapotocky, Soft shadows on GPU, 2007, section 2.4 (depth-pass, depth-fail, exclusive-or) and
 * chapter 5 (the paragon). Visibility is exact to the pixel and to the depth buffer: volume-hard that
 * of the light's centre, volume-soft the mean over N samples of the light.
 *
 * Stages: 1. adjacency of each caster's mesh, once (OpenMesh); 2. silhouettes from all samples, where
 * light or casters changed; 3. receivers; 4. for each sample, volumes counted in the stencil over the
 * receivers' depth, and the sample's weight taken away where the count is not zero.
 *
 * Debug view "volumes": those of the first sample, front faces blue, back faces orange, silhouettes.
 *
 * Textures and buffers: see vtkShadowSilhouetteCache and vtkShadowVolumes.
 */

#ifndef vtkShadowVolumePass_h
#define vtkShadowVolumePass_h

#include "vtkShadowPass.h"
#include "vtkSoftShadowsShadowVolumesModule.h" // For export macro

class VTKSOFTSHADOWSSHADOWVOLUMES_EXPORT vtkShadowVolumePass : public vtkShadowPass
{
public:
  static vtkShadowVolumePass* New();
  vtkTypeMacro(vtkShadowVolumePass, vtkShadowPass);

protected:
  vtkShadowVolumePass();
  ~vtkShadowVolumePass() override;

private:
  vtkShadowVolumePass(const vtkShadowVolumePass&) = delete;
  void operator=(const vtkShadowVolumePass&) = delete;
};

#endif
