// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTracedShadowMapPass
 * @brief   Technique map-trace: rays to N points of the light, followed through one depth map.
 *
 * As EEVEE (Blender 4.2) and Unreal Engine 5 (shadow map ray tracing, for virtual shadow maps) do: instead
 * of taking one mean blocker, the light's own form is sampled. Rays are followed hierarchically, as in Tevs, Ihrke and Seidel, Maximum mipmaps for fast, accurate, and
 * scalable dynamic height field rendering, I3D 2008, with the least and greatest depth of cells. Points
 * differ within a tile of pixels and are averaged over it where surfaces go on: Keller and Heidrich,
 * Interleaved sampling, EGRW 2001.
 *
 * In a map's space a ray is a straight line along which the depth falls linearly. It is hidden where it
 * crosses the first layer, which is a piece of a plane in each texel, and within the body behind it, which
 * ends where its prop next shows its other side. Behind bodies rays go on; where one comes out and
 * the surface that shows there lies in front of where it went behind, its plane too, that surface is taken to go on
 * behind the body, and the ray is hidden. A receiver's own plane hides nothing from it: there is no
 * bias but a quarter of its rise within a texel, for folds.
 *
 * Stages: 1. a map where light or casters changed, its slabs (see vtkShadowMapSlabs) and their pyramid;
 * 2. receivers; 3. N rays a pixel, none where the pyramid tells that all find the same; 4. with denoise=on
 * the mean over a tile of pixels, of what lies on the same surface.
 * Textures: see vtkShadowMaps and vtkShadowMapSlabs; pattern, RGBA32F, 16 N texels; emission of textured
 * lights, the same for each light; with denoise=on a mask as the visibility.
 *
 * Debug views: "map"; "penumbra-width" of the nearest blocker; "blocker-depth", its distance from the light.
 */

#ifndef vtkTracedShadowMapPass_h
#define vtkTracedShadowMapPass_h

#include "vtkShadowPass.h"
#include "vtkSoftShadowsShadowMapsModule.h" // For export macro

class VTKSOFTSHADOWSSHADOWMAPS_EXPORT vtkTracedShadowMapPass : public vtkShadowPass
{
public:
  static vtkTracedShadowMapPass* New();
  vtkTypeMacro(vtkTracedShadowMapPass, vtkShadowPass);

protected:
  vtkTracedShadowMapPass();
  ~vtkTracedShadowMapPass() override;

private:
  vtkTracedShadowMapPass(const vtkTracedShadowMapPass&) = delete;
  void operator=(const vtkTracedShadowMapPass&) = delete;
};

#endif
