// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAreaLightActor
 * @brief   Shows a light: its shape as lines, and the samples of it as points.
 *
 * @code{.cpp}
 * vtkNew<vtkAreaLightActor> shown;
 * shown->SetLight(light); // a vtkAreaLight, or any other light
 * renderer->AddViewProp(shown);
 * @endcode
 *
 * A sphere is three circles, a disk a circle, a rectangle its sides; of those that face something a line
 * shows where to. A directional light is the disk at the light's position that is seen from its focal point under its
 * angle. The points are where techniques that take samples of the light (map-soft, planar-soft,
 * volume-soft) put them, as seen from the light's focal point. What is shown follows the light. It neither
 * casts nor receives shadows, and nothing shades it.
 */

#ifndef vtkAreaLightActor_h
#define vtkAreaLightActor_h

#include "vtkProp3D.h"
#include "vtkSoftShadowsCoreModule.h" // For export macro

#include <memory> // For Internal

class vtkLight;
class vtkProperty;

class VTKSOFTSHADOWSCORE_EXPORT vtkAreaLightActor : public vtkProp3D
{
public:
  static vtkAreaLightActor* New();
  vtkTypeMacro(vtkAreaLightActor, vtkProp3D);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The light that is shown. Default: none. */
  void SetLight(vtkLight* light);
  vtkLight* GetLight();
  ///@}

  ///@{
  /** How many samples are shown, 0 to 4096. Default: 64. */
  vtkSetClampMacro(Samples, int, 0, 4096);
  vtkGetMacro(Samples, int);
  ///@}

  /** Colour, and the width of lines and size of points in pixels. Default: amber, 2 and 4. */
  vtkProperty* GetProperty();

  ///@{
  /** A prop's part in VTK's rendering. */
  double* GetBounds() override;
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  vtkTypeBool HasTranslucentPolygonalGeometry() override { return 0; }
  void ReleaseGraphicsResources(vtkWindow* window) override;
  vtkMTimeType GetMTime() override;
  ///@}

protected:
  vtkAreaLightActor();
  ~vtkAreaLightActor() override;

  int Samples = 64;

private:
  vtkAreaLightActor(const vtkAreaLightActor&) = delete;
  void operator=(const vtkAreaLightActor&) = delete;

  void Update();

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
