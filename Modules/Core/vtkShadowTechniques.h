// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowTechniques
 * @brief   The shadow techniques by name: make one, list them, describe them.
 *
 * @code{.cpp}
 * auto pass = vtkSmartPointer<vtkShadowPass>::Take(vtkShadowTechniques::Create("map-pcss"));
 * renderer->SetPass(pass);
 * @endcode
 *
 * Which techniques there are depends on the modules that are linked or imported.
 */

#ifndef vtkShadowTechniques_h
#define vtkShadowTechniques_h

#include "vtkObject.h"
#include "vtkSoftShadowsCoreModule.h" // For export macro

#include <string> // For return values

class vtkShadowPass;

class VTKSOFTSHADOWSCORE_EXPORT vtkShadowTechniques : public vtkObject
{
public:
  static vtkShadowTechniques* New();
  vtkTypeMacro(vtkShadowTechniques, vtkObject);

  /**
   * A new pass of the named technique with its default parameters. An unknown name is an error that
   * lists the known ones, and gives nullptr.
   */
  VTK_NEWINSTANCE
  static vtkShadowPass* Create(const std::string& name);

  ///@{
  /**
   * The names, sorted; "", with an error, for a number that is not one of them.
   */
  static int GetNumberOfTechniques();
  static const char* GetName(int i);
  ///@}

  /**
   * JSON: name, title, paper, class; traits, each true or false (hard, planarReceivers, needsReceivers,
   * cameraDependent, forward, signedShares, samplesLights: see vtkShadowTraits); lightShapes (name to exact,
   * approximate or unsupported); parameters (name, type, default, minimum, maximum, choices, unit,
   * meaning, presets); debugViews; resources; limits. An unknown name is an error and gives an empty string.
   */
  static std::string Describe(const std::string& name);

protected:
  vtkShadowTechniques() = default;
  ~vtkShadowTechniques() override = default;

private:
  vtkShadowTechniques(const vtkShadowTechniques&) = delete;
  void operator=(const vtkShadowTechniques&) = delete;
};

#endif
