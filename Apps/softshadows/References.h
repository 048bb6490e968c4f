// SPDX-License-Identifier: BSD-3-Clause
// What the techniques are measured against: rays.

#ifndef References_h
#define References_h

#include "vtkImageData.h"
#include "vtkShadowPass.h"
#include "vtkSmartPointer.h"

class OffscreenWindow;
class vtkAreaLight;

/** The technique that is the reference. */
extern const char* const ReferenceTechnique;

/** A scene as it should be. */
struct Reference
{
  vtkSmartPointer<vtkImageData> Frame; // unsigned char RGB
  vtkSmartPointer<vtkImageData>
    Visibility; // of the light, as vtkShadowPass::GetVisibility gives it
  double Milliseconds = 0.0;
};

namespace References
{
/** The reference's pass; Failure where this build has none, or it cannot take so many rays. */
vtkSmartPointer<vtkShadowPass> MakePass(int samples);

/** Draw the window's scene, with progress. The pass stays set. */
Reference Draw(OffscreenWindow& window, vtkShadowPass* pass, vtkAreaLight* light);

/** An image of one's own; Failure if VTK has reported an error on the way to it. */
vtkSmartPointer<vtkImageData> Copy(vtkImageData* image);

/** Visibility as the pass that is set has it, else like the image; of no pass 1 everywhere. */
vtkSmartPointer<vtkImageData> GetVisibility(
  vtkShadowPass* pass, vtkAreaLight* light, vtkImageData* like);
}

#endif
