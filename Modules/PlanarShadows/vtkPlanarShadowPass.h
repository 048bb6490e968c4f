// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPlanarShadowPass
 * @brief   Techniques planar-hard, planar-soft, planar-fake: shadows projected onto planes.
 *
 * Blinn, Me and my (fake) shadow, IEEE CG&A 1988; Zapotocky, Soft shadows on GPU, 2007, section 2.2
 * (equations 2.1 to 2.4) and appendix A.3. The casters between a light and a plane are projected onto
 * it, into light data: receivers that lie in the plane look it up there. So lit shading stays VTK's
 * own, a shadow ends where its receiver does, overlapping shadows are not darker, and nothing lies in
 * the depth buffer to fight the receiver.
 *
 *   planar-hard   a mask of the picture's pixels, from the light's centre: exact at each pixel
 *   planar-soft   the mean of N samples of the light, in a texture along the plane
 *   planar-fake   the shadow from the light's centre, filtered as widely as the light's size and the
 *                 casters' height above the plane spread it
 *
 * Only planes receive. A curved surface, a body's own faces and planes beyond the limit see all of
 * the light: visibility is 1 there (0 where a casting surface faces away from the light).
 *
 * Planes are the user's (AddPlane) or, without any, those of flat props that receive, the largest
 * first, up to the parameter "planes". Statistics: "planesFound", "planes" in use, "planesLeftOut".
 *
 * Stages: 1. the planes; 2. layers of (light, plane) that changed (of planar-hard, all that are in
 * view, when the camera moved); 3. the look-up, in each prop's shader.
 * Textures: see vtkPlanarShadowMaps.
 *
 * Debug view "map": the layers, side by side.
 */

#ifndef vtkPlanarShadowPass_h
#define vtkPlanarShadowPass_h

#include "vtkShadowPass.h"
#include "vtkSoftShadowsPlanarShadowsModule.h" // For export macro

#include <memory> // For Planes

class vtkShadowPlanes;

class VTKSOFTSHADOWSPLANARSHADOWS_EXPORT vtkPlanarShadowPass : public vtkShadowPass
{
public:
  static vtkPlanarShadowPass* New();
  vtkTypeMacro(vtkPlanarShadowPass, vtkShadowPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Planes that receive, by a point and a normal of any length and either direction, in the world.
   * Default: none, which takes those of flat props. False, with an error, where it is no plane.
   */
  bool AddPlane(double ox, double oy, double oz, double nx, double ny, double nz);
  void RemoveAllPlanes();
  int GetNumberOfPlanes();
  ///@}

protected:
  vtkPlanarShadowPass();
  ~vtkPlanarShadowPass() override;

  void PrepareTechnique(vtkShadowTechnique& technique) override;
  void CopySettings(vtkShadowPass* other) override;

private:
  vtkPlanarShadowPass(const vtkPlanarShadowPass&) = delete;
  void operator=(const vtkPlanarShadowPass&) = delete;

  std::unique_ptr<vtkShadowPlanes> Planes; // the user's
};

#endif
