/**
 * @class   vtkPercentageCloserFilteringPass
 * @brief   Technique map-pcf: the mean of n x n compares around the receiver.
 *
 * Reeves, Salesin and Cook, Rendering antialiased shadows with depth maps, SIGGRAPH 1987; Zapotocky,
 * Soft shadows on GPU, 2007, section 3.2 (7 x 7). The kernel is the light's footprint past a blocker
 * that lies in front of the receiver by an assumed share of the casters' extent (parameter "width"):
 * penumbrae are as wide everywhere.
 *
 * Stages and textures: see vtkFilteredShadowMapPass.
 */

#ifndef vtkPercentageCloserFilteringPass_h
#define vtkPercentageCloserFilteringPass_h

#include "vtkFilteredShadowMapPass.h"

class VTKSOFTSHADOWSSHADOWMAPS_EXPORT vtkPercentageCloserFilteringPass
  : public vtkFilteredShadowMapPass
{
public:
  static vtkPercentageCloserFilteringPass* New();
  vtkTypeMacro(vtkPercentageCloserFilteringPass, vtkFilteredShadowMapPass);

protected:
  vtkPercentageCloserFilteringPass();
  ~vtkPercentageCloserFilteringPass() override = default;

  void UpdatePatterns(vtkShadowFrame& frame) override;
  std::string GetFilterGLSL() override;

private:
  vtkPercentageCloserFilteringPass(const vtkPercentageCloserFilteringPass&) = delete;
  void operator=(const vtkPercentageCloserFilteringPass&) = delete;
};

#endif
