// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAutomaticShadowPass
 * @brief   Technique auto: the technique that an error or a time asks for, chosen on the scene itself.
 *
 * Takes techniques and settings from what is declared (vtkShadowTechniques), whichever modules are linked.
 *
 * Stages: 1. where nothing is chosen, and where the scene is another in kind (lights that come, go or
 * change their shape; twice or half the triangles or pixels; a parameter): candidates, at few settings each, draw
 * the frame's visibility, several times, and rays from some two thousand receivers tell their error
 * (vtkShadowPass::GetErrorEstimate); 2. what was chosen draws this frame and the following ones. Time is that of
 * light data and visibility, until the GPU is done; of a technique that makes its light data anew for
 * each camera with it, so that those that keep theirs are preferred.
 *
 * Parameters: "error" (default 0.05, 0 to 1, of V; 0: as small as "time" lets it be), RMSE in penumbrae: the
 * fastest candidate is chosen that is within it by the upper end of a 95 % interval; "time" (default 0,
 * none, to 10000 ms): of those within it the best, another one while lights or casters move. With both, while anything
 * moves, time is kept; once nothing does, frames of a technique that samples the lights add up
 * (vtkShadowPass::IsFinished) until the error is reached.
 *
 * Textures: those of the techniques that were chosen, two or three at most; while it chooses, those of one
 * candidate more.
 */

#ifndef vtkAutomaticShadowPass_h
#define vtkAutomaticShadowPass_h

#include "vtkShadowPass.h"
#include "vtkSoftShadowsAutomaticModule.h" // For export macro

class VTKSOFTSHADOWSAUTOMATIC_EXPORT vtkAutomaticShadowPass : public vtkShadowPass
{
public:
  static vtkAutomaticShadowPass* New();
  vtkTypeMacro(vtkAutomaticShadowPass, vtkShadowPass);

protected:
  vtkAutomaticShadowPass();
  ~vtkAutomaticShadowPass() override;

private:
  vtkAutomaticShadowPass(const vtkAutomaticShadowPass&) = delete;
  void operator=(const vtkAutomaticShadowPass&) = delete;
};

#endif
