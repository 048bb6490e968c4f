// SPDX-License-Identifier: BSD-3-Clause
#include "BenchStage.h"

#include "Errors.h"

#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderer.h"
#include "vtkTransform.h"

#include <cmath>

namespace
{
void ScaleLight(vtkAreaLight* light, double scale)
{
  light->SetRadius(light->GetRadius() * scale);
  light->SetWidth(light->GetWidth() * scale);
  light->SetHeight(light->GetHeight() * scale);
  light->SetAngularDiameter(light->GetAngularDiameter() * scale);
}
}

//------------------------------------------------------------------------------
BenchStage::BenchStage(const BenchCase& one)
  : Window(one.Scene.Size.data(), one.Scene.SamplesPerPixel)
  , Built(one.Scene.Build(Window.GetRenderer()))
{
  for (vtkAreaLight* light : this->Built.Lights)
  {
    ScaleLight(light, one.LightScale);
  }
  this->PlaceLights(one);
  vtkRenderer* renderer = this->Window.GetRenderer();
  if (one.Camera)
  {
    renderer->GetActiveCamera()->SetPosition(one.Camera->Position.data());
    renderer->GetActiveCamera()->SetFocalPoint(one.Camera->Focus.data());
    renderer->ResetCameraClippingRange();
  }
  Messages::Check();
}

//------------------------------------------------------------------------------
void BenchStage::PlaceLights(const BenchCase& one)
{
  vtkAreaLight* first = this->Built.Light;
  this->Lights = this->Built.Lights;
  const double* up = this->Window.GetRenderer()->GetActiveCamera()->GetViewUp();
  const double* target = first->GetFocalPoint();
  for (int i = 1; i < one.Lights; ++i)
  {
    vtkNew<vtkTransform> turn;
    turn->Translate(target);
    turn->RotateWXYZ(360.0 * i / one.Lights, up);
    turn->Translate(-target[0], -target[1], -target[2]);
    vtkNew<vtkAreaLight> light;
    light->DeepCopy(first);
    light->SetPosition(turn->TransformDoublePoint(first->GetPosition()));
    this->Window.GetRenderer()->AddLight(light);
    this->Lights.push_back(light);
  }
  for (vtkAreaLight* light : this->Lights)
  {
    light->SetIntensity(light->GetIntensity() / one.Lights);
  }
}

//------------------------------------------------------------------------------
void BenchStage::MoveCamera()
{
  this->Window.GetRenderer()->GetActiveCamera()->Azimuth(this->CameraMoved ? -1.0 : 1.0);
  this->CameraMoved = !this->CameraMoved;
  this->Window.GetRenderer()->ResetCameraClippingRange();
}

//------------------------------------------------------------------------------
void BenchStage::MoveLights()
{
  const double share = this->LightsMoved ? -1e-3 : 1e-3;
  this->LightsMoved = !this->LightsMoved;
  for (vtkAreaLight* light : this->Lights)
  {
    double position[3];
    light->GetPosition(position);
    const double distance =
      std::sqrt(vtkMath::Distance2BetweenPoints(position, light->GetFocalPoint()));
    light->SetPosition(position[0] + share * distance, position[1], position[2]);
  }
}
