// SPDX-License-Identifier: BSD-3-Clause
// Lights: how large, of what shape, where, and how many.

#include "ExtremeScenes.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkProperty.h"
#include "vtkShadowPass.h"

#include <glm/trigonometric.hpp>

#include <cmath>

namespace
{
using Shape = ExtremeScene::Shape;

// Above the things, so that its plane hits none of them.
vtkAreaLight* AddLamp(ExtremeScene& scene, Shape shape)
{
  return scene.AddLight(shape, { -0.5, -0.4, 5.5 }, { -0.5, -0.4, 0.0 });
}

//------------------------------------------------------------------------------
void Size(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.AddThings();
  vtkAreaLight* light = AddLamp(scene, Shape::Rectangle);
  light->SetWidth(at.Number);
  light->SetHeight(at.Number);
}

void SizeOfSphere(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.AddThings();
  AddLamp(scene, Shape::Sphere)->SetRadius(0.5 * at.Number);
}

void Angle(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.AddThings();
  scene.AddLight(Shape::Directional)->SetAngularDiameter(at.Number);
}

void Stretch(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.AddThings();
  vtkAreaLight* light = AddLamp(scene, at.Word == "point" ? Shape::Point : Shape::Rectangle);
  light->SetWidth(1.2);
  light->SetHeight(at.Word == "line" ? 0.0 : 1.2 / std::max(at.Number, 1.0));
}

//------------------------------------------------------------------------------
// As large to the eye as it goes away.
void Away(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.AddThings();
  vtkAreaLight* light = scene.AddLight(Shape::Rectangle, at.Number * glm::dvec3(-2.5, -2.0, 5.5));
  light->SetWidth(1.2 * at.Number);
  light->SetHeight(0.8 * at.Number);
}

// A small lamp above the box's top, ever nearer to it.
void Near(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.AddThings();
  vtkAreaLight* light =
    scene.AddLight(Shape::Rectangle, { -0.8, 0.3, 1.2 + at.Number }, { -0.8, 0.3, 0.0 });
  light->SetWidth(0.1);
  light->SetHeight(0.1);
}

void Inside(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.AddThings();
  const glm::dvec3 place = at.Word == "box"      ? glm::dvec3(-0.8, 0.3, 0.6)
                           : at.Word == "sphere" ? glm::dvec3(0.9, -0.5, 1.3)
                                                 : glm::dvec3(-2.5, -2.0, 5.5);
  scene.AddLight(Shape::Sphere, place, { 0.0, 0.0, 0.0 })->SetRadius(0.1);
}

void Room(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.AddThings();
  const double side = at.Number; // of half of it
  scene.AddBox({ 0.0, 0.0, 4.0 }, { 2.0 * side, 2.0 * side, 8.02 });
  scene.AddLight(Shape::Rectangle);
}

void Below(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.AddThings();
  scene.AddLight(Shape::Rectangle, { -1.0, -1.0, at.Number }, { 0.0, 0.0, 0.5 });
}

// A sun of so many diameters of the moon, in the same place of the sky.
void Eclipse(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.AddFloor(2.0);
  scene.AddSphere({ 0.0, 0.0, 80.0 }, 0.5, 96);
  const double distance = 110.0 * at.Number;
  scene.AddLight(Shape::Sphere, { 0.0, 0.0, 80.0 + distance }, { 0.0, 0.0, 0.0 })
    ->SetRadius(0.5 * at.Number);
  scene.LookAt({ 0.0, -0.01, 6.0 }, { 0.0, 0.0, 0.0 }, 30.0);
}

//------------------------------------------------------------------------------
void Grazing(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.AddThings();
  const double angle = glm::radians(at.Number);
  scene
    .AddLight(Shape::Directional,
      10.0 * glm::dvec3(-std::cos(angle) * 0.8, -std::cos(angle) * 0.6, std::sin(angle)))
    ->SetAngularDiameter(0.0);
}

// Along the plane of a square that stands on the floor, and off it by so many degrees. What the light
// grazes it does not light: the floor alone counts.
void AlongPlane(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.AddFloor();
  vtkShadowPass::SetReceiving(
    scene.AddQuad({ 0.0, -1.0, 0.0 }, { 0.0, 2.0, 0.0 }, { 0.0, 0.0, 2.0 }), false);
  const double angle = glm::radians(at.Number);
  scene.AddLight(Shape::Directional, 10.0 * glm::dvec3(std::sin(angle), -0.5, std::cos(angle)))
    ->SetAngularDiameter(0.0);
  scene.LookAt({ 3.5, -6.5, 4.5 }, { 0.2, 0.2, 0.3 });
}

// Along the upright edges of the boxes.
void AlongEdge(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.AddThings();
  const double angle = glm::radians(at.Number);
  scene
    .AddLight(Shape::Directional,
      10.0 * glm::dvec3(0.7 * std::sin(angle), -0.7 * std::sin(angle), std::cos(angle)))
    ->SetAngularDiameter(0.0);
  scene.Counts = [](const glm::dvec3&) { return true; }; // nor on the sides that it grazes
}

// VTK's cone angle is half of the cone, and none from 90 on. Where nothing shines nothing is promised.
void Cone(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.AddThings();
  const glm::dvec3 place(-0.2, -0.1, 5.5);
  scene.AddLight(Shape::Point, place, { place.x, place.y, 0.0 })->SetConeAngle(0.5 * at.Number);
  const double radius = place.z * std::tan(glm::radians(0.5 * at.Number));
  scene.Counts = [=](const glm::dvec3& p)
  { return std::hypot(p.x - place.x, p.y - place.y) < radius; };
  if (at.Number < 10.0)
  {
    scene.LookAt({ 3.5, -6.5, 4.5 }, { place.x, place.y, 0.0 }, std::max(0.8 * at.Number, 0.5));
  }
}

void Lights(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.AddThings();
  const int count = static_cast<int>(at.Number);
  for (int i = 0; i < count; ++i)
  {
    const double turn = 6.283185307 * i / count - 2.467;
    scene.AddLight(Shape::Rectangle, { 3.2 * std::cos(turn), 3.2 * std::sin(turn), 5.5 })
      ->SetIntensity(1.0 / count);
  }
}
}

//------------------------------------------------------------------------------
void ExtremeScenes::AddLights(ExtremeBuilders& builders)
{
  builders["light-size"] = Size;
  builders["light-size-of-sphere"] = SizeOfSphere;
  builders["light-angle"] = Angle;
  builders["light-stretch"] = Stretch;
  builders["light-away"] = Away;
  builders["light-near"] = Near;
  builders["light-inside"] = Inside;
  builders["light-in-room"] = Room;
  builders["light-below"] = Below;
  builders["eclipse"] = Eclipse;
  builders["grazing"] = Grazing;
  builders["along-plane"] = AlongPlane;
  builders["along-edge"] = AlongEdge;
  builders["cone"] = Cone;
  builders["lights"] = Lights;
}
