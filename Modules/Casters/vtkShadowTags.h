// SPDX-License-Identifier: BSD-3-Clause
// What users say of single props and lights: who casts, receives and catches shadows; and the parts of a
// prop, for which its tags hold. vtkShadowPass shows these to users and documents them.

#ifndef vtkShadowTags_h
#define vtkShadowTags_h

#include "vtkSoftShadowsCastersModule.h" // For export macro

#include <functional>

class vtkInformationIntegerKey;
class vtkLight;
class vtkMatrix4x4;
class vtkProp;

class VTKSOFTSHADOWSCASTERS_EXPORT vtkShadowTags
{
public:
  ///@{ In a prop's property keys, or a light's information.
  static vtkInformationIntegerKey* CASTS_SHADOW();
  static vtkInformationIntegerKey* RECEIVES_SHADOW();
  static vtkInformationIntegerKey* SHADOW_CATCHER();
  ///@}

  static void SetCasting(vtkProp* prop, bool casts);
  static bool GetCasting(vtkProp* prop);
  static void SetReceiving(vtkProp* prop, bool receives);
  static bool GetReceiving(vtkProp* prop);
  static void SetShadowCatcher(vtkProp* prop, bool catches);
  static bool GetShadowCatcher(vtkProp* prop);
  static void SetLightCasting(vtkLight* light, bool casts);
  static bool GetLightCasting(vtkLight* light);
  /**
   * Whether a fill light answers for how dark this light's shadows are: the parameter "darkness" is then the
   * fill's, so that shadows and unlit sides agree. Default: no.
   */
  static void SetFilled(vtkLight* light, bool filled);
  static bool GetFilled(vtkLight* light);

  /**
   * Call a function with each prop in space that a prop draws, and its matrix: itself, the visible
   * parts of an assembly, or the chosen level of detail of a vtkLODProp3D.
   */
  static void ForEachPart(
    vtkProp* prop, const std::function<void(vtkProp*, vtkMatrix4x4*)>& function);
};

#endif
