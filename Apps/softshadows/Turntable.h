// SPDX-License-Identifier: BSD-3-Clause
// Turns what stands on the ground.

#ifndef Turntable_h
#define Turntable_h

#include "vtkMatrix4x4.h"
#include "vtkProp3D.h"
#include "vtkSmartPointer.h"

#include <utility>
#include <vector>

class vtkRenderer;

class Turntable
{
public:
  /** All props that are there now, but for grounds. The axis is x, y or z: 0, 1, 2. */
  Turntable(vtkRenderer* renderer, int axis);

  /** From how they stood, about the axis through the middle of all. */
  void SetAngle(double degrees);

  double GetSize() const { return this->Size; }

private:
  std::vector<std::pair<vtkSmartPointer<vtkProp3D>, vtkSmartPointer<vtkMatrix4x4>>> Props;
  double Middle[3] = { 0.0, 0.0, 0.0 };
  double Size = 0.0;
  int Axis;
};

#endif
