// SPDX-License-Identifier: BSD-3-Clause
// The scene of a benchmark's case in its window, and what moves in it.

#ifndef BenchStage_h
#define BenchStage_h

#include "BenchPlan.h"
#include "OffscreenWindow.h"

#include <vector>

class vtkAreaLight;

class BenchStage
{
public:
  explicit BenchStage(const BenchCase& one);

  OffscreenWindow& GetWindow() { return this->Window; }
  const Scene& GetScene() const { return this->Built; }
  /** The scene's light first. */
  const std::vector<vtkAreaLight*>& GetLights() const { return this->Lights; }

  /** Turn the camera by a degree about its target, there and back. */
  void MoveCamera();
  /** Move the lights by a thousandth of their distance, there and back. */
  void MoveLights();

private:
  void PlaceLights(const BenchCase& one);

  OffscreenWindow Window;
  Scene Built;
  std::vector<vtkAreaLight*> Lights;
  bool CameraMoved = false;
  bool LightsMoved = false;
};

#endif
