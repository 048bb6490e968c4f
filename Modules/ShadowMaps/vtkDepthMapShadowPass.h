/**
 * @class   vtkDepthMapShadowPass
 * @brief   Base of the techniques that look up depth maps: the family's map resource, and its use.
 *
 * (VTK has a class vtkShadowMapPass of its own.) A map is drawn from the casters' own buffers,
 * through frusta that hug them (see vtkLightFrusta). It is read with a bias that has no knob: the
 * receiver is moved along its geometric normal by what its plane can rise within the texels that one
 * look-up reads.
 *
 * Debug view "map": the depth maps, side by side.
 */

#ifndef vtkDepthMapShadowPass_h
#define vtkDepthMapShadowPass_h

#include "vtkShadowPass.h"
#include "vtkSoftShadowsShadowMapsModule.h" // For export macro

class vtkShadowMaps;
struct vtkShadowMapSettings;

class VTKSOFTSHADOWSSHADOWMAPS_EXPORT vtkDepthMapShadowPass : public vtkShadowPass
{
public:
  vtkTypeMacro(vtkDepthMapShadowPass, vtkShadowPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  std::string GetDebugViews() override;

protected:
  vtkDepthMapShadowPass();
  ~vtkDepthMapShadowPass() override;

  /**
   * Update the maps with the parameters "resolution" (0: from the picture's size), "filter" and
   * "midpoint", N samples, and a limit.
   */
  bool UpdateMaps(vtkShadowFrame& frame, int samples, double megabytes);

  /** What a technique wants else of its maps. */
  virtual void SetMapSettings(vtkShadowMapSettings&) {}

  std::string GetVisibilityGLSL() override;
  void ActivateLightData(vtkShadowFrame& frame) override;
  void DeactivateLightData(vtkShadowFrame& frame) override;
  void SetVisibilityParameters(vtkShaderProgram* program) override;
  double GetMaximumCost() override;
  void DrawDebugView(vtkShadowFrame& frame, const std::string& view) override;
  void ReleaseLightData(vtkRenderWindow* window) override;
  std::vector<std::pair<std::string, std::size_t>> GetLightDataBytes() override;

  std::unique_ptr<vtkShadowMaps> Maps;

private:
  vtkDepthMapShadowPass(const vtkDepthMapShadowPass&) = delete;
  void operator=(const vtkDepthMapShadowPass&) = delete;
};

#endif
