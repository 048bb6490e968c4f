// SPDX-License-Identifier: BSD-3-Clause
// The ground of a vtkShadowStudio: a disk under what is seen, that fades out towards its rim.

#ifndef vtkShadowGround_h
#define vtkShadowGround_h

#include "vtkActor.h"
#include "vtkNew.h"

#include <glm/vec3.hpp>

class vtkBoundingBox;
class vtkCamera;
class vtkRenderer;

class vtkShadowGround
{
public:
  vtkShadowGround();

  vtkActor* GetActor() { return this->Actor; }
  bool IsOn() const { return this->On; }
  /**
   * Put it into a renderer under what it shows, as a shadow catcher or as a white ground. It is blended over
   * the background before anything else is drawn, as an opaque prop: so edges in front of it stay smooth, for
   * VTK has but one sample a pixel of what is translucent. With SSAO, which takes no blending, it is that.
   */
  void PutOn(vtkRenderer* renderer, const vtkBoundingBox& scene, const glm::dvec3& up, bool catches,
    bool withSSAO);
  void TakeOff(vtkRenderer* renderer);
  /** Widen a range of distances before a camera, so that it shows the ground. */
  void Widen(vtkCamera* camera, double range[2]) const;

private:
  void Place(const vtkBoundingBox& scene, const glm::dvec3& up);

  vtkNew<vtkActor> Actor;
  bool On = false;
  glm::dvec3 Up{ 0.0 };
  glm::dvec3 Center{ 0.0 };
  double Radius = 0.0;
};

#endif
