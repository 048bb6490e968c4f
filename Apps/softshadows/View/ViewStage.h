// SPDX-License-Identifier: BSD-3-Clause
// The viewer's scene: its camera, lights and casters, what moves them, and the options that say it again.

#ifndef ViewStage_h
#define ViewStage_h

#include "SceneOptions.h"
#include "Turntable.h"

#include "vtkAreaLightActor.h"
#include "vtkCamera.h"
#include "vtkNew.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <string>
#include <vector>

class ViewStage
{
public:
  /** The scene, with one renderer for each side of the window. Failure where it cannot be had. */
  explicit ViewStage(const SceneOptions& options);

  vtkRenderer* GetRenderer() { return this->Renderer; }
  /** The same scene once more, for the right side of a split window, or beneath. */
  vtkRenderer* GetOther() { return this->Other; }
  const Scene& GetScene() const { return this->Built; }

  /**
   * Before each frame: the left side's part of the window (1: all of it), the other renderer's camera
   * and lights, and clipping ranges.
   */
  void Prepare(double divider);

  ///@{
  /** Move the camera: angles in degrees, a factor of nearness. */
  void Turn(double right, double up);
  void Zoom(double factor);
  void ResetCamera();
  ///@}

  ///@{
  /**
   * Move the first light, in shares of the scene: over the plane of its height, as the camera sees it,
   * and up. A directional one turns about the scene.
   */
  void MoveLight(double right, double away);
  void RaiseLight(double share);
  void ScaleLight(double factor);
  ///@}

  /** Turn the casters by so many degrees more. */
  void TurnCasters(double degrees);

  ///@{
  void ShowLights(bool shown, int samples);
  bool AreLightsShown() const { return this->LightsShown; }
  ///@}

  /** Models and options of the command that set up what is seen now, in a picture of that size. */
  std::vector<std::string> GetOptions(const int size[2]) const;

private:
  void Share();
  std::vector<std::string> GetLightOptions() const;

  SceneOptions Options;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderer> Other;
  Scene Built;
  int Up;
  double Size; // of what is seen, without its ground
  std::unique_ptr<Turntable> Casters;
  double Angle = 0.0;
  std::vector<vtkSmartPointer<vtkAreaLightActor>> Shown;
  bool LightsShown = false;
  // When what the other renderer shares was changed last.
  vtkMTimeType PropsTime = 0;
  vtkMTimeType LightsTime = 0;
  vtkSmartPointer<vtkCamera> Start;
};

#endif
