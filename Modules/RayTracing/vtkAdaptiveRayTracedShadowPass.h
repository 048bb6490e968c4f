// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAdaptiveRayTracedShadowPass
 * @brief   Technique ray-adaptive: rays to the light only where they matter.
 *
 * Rays as ray-traced has them, the same ones for each pixel, but for pixels whose answer is known without, or
 * from a few of them: most of a picture sees all of the light, or nothing. After the classification of
 * penumbrae before tracing (Hasselgren and Akenine-Moeller, Conservative rasterization, GPU Gems 2,
 * chapter 42, 2005) and adaptive sampling by disagreement (Mitchell, Generating antialiased images at low
 * sampling densities, SIGGRAPH 1987).
 *
 * Stages: 1. maps of the casters from the lights' centres, rasterized conservatively, and a pyramid over
 * them, kept while lights and casters are unchanged (maps, DEPTH_COMPONENT32F; pyramid, RG32F);
 * 2. receivers; 3. each pixel that surely sees all of a light is 1, in the visibility's own texture;
 * 4. the others are chosen on the GPU and read back, while those of the light before are traced; or on the
 * CPU, among all, where that makes the pixels;
 * 5. a few stratified rays each, and where these or the neighbours' disagree the rest, until the standard
 * error or the number of samples that is asked for; so on around each pixel that turns out to be of a
 * penumbra; 6. visibility, drawn from a list, or put back as a picture.
 *
 * Parameters: samples (64; 1 to 16384 rays): at most; error (0; 0 to 0.5): standard error of V at which a
 * pixel needs no more, 0: all samples; seed (0; 0 to 65535); map-resolution (0, automatic; 16 to 16384 texels)
 * of the maps; selection (auto; gpu, cpu): where pixels are chosen; packet (16; 1, 4, 8, 16), structure (auto;
 * instanced, flat): as ray-traced.
 */

#ifndef vtkAdaptiveRayTracedShadowPass_h
#define vtkAdaptiveRayTracedShadowPass_h

#include "vtkShadowPass.h"
#include "vtkSoftShadowsRayTracingModule.h" // For export macro

class VTKSOFTSHADOWSRAYTRACING_EXPORT vtkAdaptiveRayTracedShadowPass : public vtkShadowPass
{
public:
  static vtkAdaptiveRayTracedShadowPass* New();
  vtkTypeMacro(vtkAdaptiveRayTracedShadowPass, vtkShadowPass);

protected:
  vtkAdaptiveRayTracedShadowPass();
  ~vtkAdaptiveRayTracedShadowPass() override;

private:
  vtkAdaptiveRayTracedShadowPass(const vtkAdaptiveRayTracedShadowPass&) = delete;
  void operator=(const vtkAdaptiveRayTracedShadowPass&) = delete;
};

#endif
