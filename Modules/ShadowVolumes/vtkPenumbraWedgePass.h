// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPenumbraWedgePass
 * @brief   Technique wedges: soft shadow volumes by penumbra wedges.
 *
 * Assarsson, Dougherty, Mounier and Akenine-Moeller, An optimized soft shadow volume algorithm with
 * real-time performance, EGSR 2003.
 *
 * Stages: 1. silhouettes from the light's centre (vtkShadowSilhouetteCache); 2. a bound of the space in
 * which each of their edges hides a part of the light (vtkShadowWedge); 3. receivers; 4. the count of
 * volumes that hold a receiver, as the light's centre is hidden; 5. over each wedge, what its edge lets
 * through of the light where the centre is hidden, and hides where it is not; 6. the sum, clamped.
 *
 * Textures and buffers: see vtkShadowSilhouetteCache, vtkShadowVolumes and vtkPenumbraWedges.
 */

#ifndef vtkPenumbraWedgePass_h
#define vtkPenumbraWedgePass_h

#include "vtkShadowPass.h"
#include "vtkSoftShadowsShadowVolumesModule.h" // For export macro

class VTKSOFTSHADOWSSHADOWVOLUMES_EXPORT vtkPenumbraWedgePass : public vtkShadowPass
{
public:
  static vtkPenumbraWedgePass* New();
  vtkTypeMacro(vtkPenumbraWedgePass, vtkShadowPass);

protected:
  vtkPenumbraWedgePass();
  ~vtkPenumbraWedgePass() override;

private:
  vtkPenumbraWedgePass(const vtkPenumbraWedgePass&) = delete;
  void operator=(const vtkPenumbraWedgePass&) = delete;
};

#endif
