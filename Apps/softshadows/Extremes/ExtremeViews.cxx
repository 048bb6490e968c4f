// SPDX-License-Identifier: BSD-3-Clause
// Eye, camera, picture and map, and what changes from frame to frame.

#include "ExtremeScenes.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <cstdio>
#include <random>

namespace
{
using Shape = ExtremeScene::Shape;

void AddOrdinary(ExtremeScene& scene)
{
  scene.AddThings();
  scene.AddLight(Shape::Rectangle);
}

vtkCamera* GetCamera(ExtremeScene& scene)
{
  return scene.GetRenderer()->GetActiveCamera();
}

//------------------------------------------------------------------------------
void Eye(ExtremeScene& scene, const ExtremeValue& at)
{
  AddOrdinary(scene);
  if (at.Word == "volume") // behind the box, as its shadow falls
  {
    scene.LookAt({ -0.3, 0.7, 0.3 }, { 1.5, -1.0, 0.2 }, 60.0);
  }
  else if (at.Word == "penumbra")
  {
    scene.LookAt({ 0.15, 0.9, 0.1 }, { -0.8, 0.3, 0.6 }, 60.0);
  }
  else if (at.Word == "caster")
  {
    scene.LookAt({ -0.8, 0.3, 0.6 }, { -0.8, 0.8, 0.3 }, 90.0);
  }
  else if (at.Word == "light")
  {
    scene.LookAt({ -2.5, -2.0, 5.5 }, { 0.0, 0.0, 0.0 }, 50.0);
  }
  GetCamera(scene)->SetClippingRange(0.01, 30.0);
}

// Into the box's shadow.
void ViewAngle(ExtremeScene& scene, const ExtremeValue& at)
{
  AddOrdinary(scene);
  scene.LookAt({ 3.5, -6.5, 4.5 }, { -0.2, 0.9, 0.0 }, at.Number);
}

void Camera(ExtremeScene& scene, const ExtremeValue& at)
{
  AddOrdinary(scene);
  vtkCamera* camera = GetCamera(scene);
  if (at.Word == "parallel")
  {
    camera->ParallelProjectionOn();
    camera->SetParallelScale(2.6);
  }
  else if (at.Word == "off-axis")
  {
    camera->SetWindowCenter(0.4, -0.3);
  }
  else if (at.Word == "mirrored")
  {
    vtkNew<vtkMatrix4x4> mirror;
    mirror->SetElement(0, 0, -1.0);
    camera->SetModelTransformMatrix(mirror);
  }
  else if (at.Word == "explicit")
  {
    vtkNew<vtkMatrix4x4> projection;
    projection->DeepCopy(camera->GetProjectionTransformMatrix(1.0, -1.0, 1.0));
    projection->SetElement(0, 1, 0.2);
    camera->SetExplicitProjectionTransformMatrix(projection);
    camera->UseExplicitProjectionTransformMatrixOn();
  }
  else if (at.Word == "tile") // one of 3 x 3 of a large picture
  {
    scene.GetWindow()->SetTileScale(3, 3);
    scene.GetWindow()->SetTileViewport(1.0 / 3.0, 1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0);
  }
}

void Screen(ExtremeScene& scene, const ExtremeValue& at)
{
  AddOrdinary(scene);
  int width = 0;
  int height = 0;
  if (std::sscanf(at.Word.c_str(), "%dx%d", &width, &height) == 2)
  {
    scene.GetWindow()->SetSize(width, height);
  }
}

// Another size in each frame, and the first in the last.
void Resized(ExtremeScene& scene, const ExtremeValue& at)
{
  AddOrdinary(scene);
  scene.Frames = static_cast<int>(at.Number);
  vtkRenderWindow* window = scene.GetWindow();
  const int width = window->GetSize()[0];
  const int height = window->GetSize()[1];
  scene.BeforeFrame = [=, frames = scene.Frames](int frame)
  {
    const bool last = frame == frames - 1;
    window->SetSize(last ? width : 20 + 37 * frame % 211, last ? height : 20 + 53 * frame % 197);
  };
}

void Map(ExtremeScene& scene, const ExtremeValue& at)
{
  AddOrdinary(scene);
  if (at.Number > 0.0)
  {
    scene.Settings = { { "resolution", std::to_string(static_cast<int>(at.Number)) } };
  }
}

//------------------------------------------------------------------------------
void MoveCamera(ExtremeScene& scene, const ExtremeValue& at)
{
  AddOrdinary(scene);
  scene.LookAt({ 3.5 + at.Number, -6.5, 4.5 }, { 0.2 + at.Number, 0.2, 0.3 });
}

void MoveLight(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.AddThings();
  scene.AddLight(Shape::Rectangle, { -2.5 + at.Number, -2.0, 5.5 });
}

void MoveCaster(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.AddThings();
  scene.AddSphere({ -1.5 + at.Number, -1.5, 1.0 }, 0.4);
  scene.AddLight(Shape::Rectangle);
}

void MoveWire(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.AddThings();
  scene.AddBox({ -1.5 + at.Number, -1.5, 1.0 }, { 0.01, 2.0, 0.01 });
  scene.AddLight(Shape::Rectangle);
}

// Whatever the frames before it changed, the last one is the ordinary case's.
void Changes(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.AddThings();
  vtkActor* moved = scene.AddSphere({ -1.5, -1.5, 1.0 }, 0.4);
  vtkAreaLight* light = scene.AddLight(Shape::Rectangle);
  scene.Frames = static_cast<int>(at.Number);
  scene.BeforeFrame = [=, frames = scene.Frames, random = std::minstd_rand(22)](int frame) mutable
  {
    const bool last = frame == frames - 1;
    const auto any = [&](double most)
    { return last ? 0.0 : most * (2.0 * random() / std::minstd_rand::max() - 1.0); };
    moved->SetPosition(any(2.0), any(2.0), any(0.5));
    moved->SetVisibility(last || random() % 5 != 0);
    light->SetPosition(-2.5 + any(1.0), -2.0 + any(1.0), 5.5 + any(1.0));
    light->SetSwitch(last || random() % 7 != 0);
  };
}
}

//------------------------------------------------------------------------------
void ExtremeScenes::AddViews(ExtremeBuilders& builders)
{
  builders["eye"] = Eye;
  builders["view-angle"] = ViewAngle;
  builders["camera"] = Camera;
  builders["screen"] = Screen;
  builders["resized"] = Resized;
  builders["map"] = Map;
  builders["move-camera"] = MoveCamera;
  builders["move-light"] = MoveLight;
  builders["move-caster"] = MoveCaster;
  builders["move-wire"] = MoveWire;
  builders["changes"] = Changes;
}
