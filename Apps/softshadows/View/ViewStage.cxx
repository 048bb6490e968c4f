// SPDX-License-Identifier: BSD-3-Clause
#include "ViewStage.h"

#include "Values.h"

#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkPropCollection.h"
#include "vtkShadowNumber.h"
#include "vtkShadowStudio.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace
{
std::string Print(const double v[3])
{
  return vtkShadowNumber::Print(v[0]) + "," + vtkShadowNumber::Print(v[1]) + "," +
         vtkShadowNumber::Print(v[2]);
}

glm::dvec3 GetAxis(int up)
{
  glm::dvec3 axis(0.0);
  axis[up] = 1.0;
  return axis;
}
}

//------------------------------------------------------------------------------
ViewStage::ViewStage(const SceneOptions& options)
  : Options(options)
  , Up(options.GetUpAxis())
{
  // What is turned and shown here goes on being so by other means than Build's.
  this->Options.ShowLights = false;
  this->Options.Turn = 0.0;
  // What VTK takes where there is a window already, as in render: else depths are rounded otherwise.
  this->Renderer->SetNearClippingPlaneTolerance(0.001);
  this->Built = this->Options.Build(this->Renderer);
  this->Casters = std::make_unique<Turntable>(this->Renderer, this->Up);
  this->Size = this->Casters->GetSize();
  this->TurnCasters(options.Turn);
  if (this->Options.UsesStudio())
  {
    PlaceBeside(this->Built.Light, this->Renderer);
  }
  this->Other->SetActiveCamera(vtkSmartPointer<vtkCamera>::New());
  this->Other->AutomaticLightCreationOff();
  this->Other->InteractiveOff();
  this->Start = vtkSmartPointer<vtkCamera>::New();
  this->Start->DeepCopy(this->Renderer->GetActiveCamera());
  for (vtkAreaLight* light : this->Built.Lights)
  {
    this->Shown.emplace_back(vtkSmartPointer<vtkAreaLightActor>::New());
    this->Shown.back()->SetLight(light);
  }
}

//------------------------------------------------------------------------------
// The props and lights of the scene are drawn by the other renderer, too: those of the studio come and
// go.
void ViewStage::Share()
{
  vtkCollectionSimpleIterator iterator;
  vtkPropCollection* props = this->Renderer->GetViewProps();
  vtkLightCollection* lights = this->Renderer->GetLights();
  if (const auto time = props->GetMTime(); time != this->PropsTime)
  {
    this->PropsTime = time;
    this->Other->RemoveAllViewProps();
    props->InitTraversal(iterator);
    while (vtkProp* prop = props->GetNextProp(iterator))
    {
      this->Other->AddViewProp(prop);
    }
  }
  if (const auto time = lights->GetMTime(); time != this->LightsTime)
  {
    this->LightsTime = time;
    this->Other->RemoveAllLights();
    lights->InitTraversal(iterator);
    while (vtkLight* light = lights->GetNextLight(iterator))
    {
      this->Other->AddLight(light);
    }
  }
  this->Other->SetBackground(this->Renderer->GetBackground());
  this->Other->SetBackground2(this->Renderer->GetBackground2());
  this->Other->SetGradientBackground(this->Renderer->GetGradientBackground());
  this->Other->SetAmbient(this->Renderer->GetAmbient());
}

//------------------------------------------------------------------------------
void ViewStage::Prepare(double divider)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const bool split = divider < 1.0;
  // Each side shows its part of the one picture: a window beside the line of sight.
  this->Renderer->SetViewport(0.0, 0.0, divider, 1.0);
  camera->SetWindowCenter(split ? (divider - 1.0) / divider : 0.0, 0.0);
  this->Renderer->ResetCameraClippingRange();
  this->Share();
  this->Other->SetViewport(split ? divider : 0.0, 0.0, 1.0, 1.0);
  vtkCamera* other = this->Other->GetActiveCamera();
  other->DeepCopy(camera);
  other->SetWindowCenter(split ? divider / (1.0 - divider) : 0.0, 0.0);
}

//------------------------------------------------------------------------------
void ViewStage::Turn(double right, double up)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->Azimuth(-right);
  // Not over the pole, where the way up would turn round.
  const glm::dvec3 ahead = glm::make_vec3(camera->GetDirectionOfProjection());
  const double now = glm::degrees(
    std::asin(std::clamp(-glm::dot(ahead, glm::make_vec3(camera->GetViewUp())), -1.0, 1.0)));
  constexpr double steepest = 89.0;
  camera->Elevation(std::clamp(now - up, -steepest, steepest) - now);
}

//------------------------------------------------------------------------------
void ViewStage::Zoom(double factor)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  if (camera->GetParallelProjection())
  {
    camera->SetParallelScale(camera->GetParallelScale() / factor);
  }
  else
  {
    camera->Dolly(factor);
  }
}

//------------------------------------------------------------------------------
void ViewStage::ResetCamera()
{
  this->Renderer->GetActiveCamera()->DeepCopy(this->Start);
}

//------------------------------------------------------------------------------
void ViewStage::MoveLight(double right, double away)
{
  vtkAreaLight* light = this->Built.Light;
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const glm::dvec3 up = GetAxis(this->Up);
  glm::dvec3 across = glm::cross(
    glm::make_vec3(camera->GetDirectionOfProjection()), glm::make_vec3(camera->GetViewUp()));
  across -= up * glm::dot(across, up);
  across = glm::length(across) > 1e-6 ? glm::normalize(across) : GetAxis((this->Up + 1) % 3);
  const glm::dvec3 ahead = glm::cross(up, across);
  const glm::dvec3 target = glm::make_vec3(light->GetFocalPoint());
  glm::dvec3 way = glm::make_vec3(light->GetPosition()) - target;
  const double distance = glm::length(way);
  const double unit = light->GetPositional() ? this->Size : distance;
  way += unit * (right * across + away * ahead);
  if (!light->GetPositional())
  {
    way *= distance / glm::length(way);
  }
  light->SetPosition(glm::value_ptr(target + way));
}

//------------------------------------------------------------------------------
void ViewStage::RaiseLight(double share)
{
  vtkAreaLight* light = this->Built.Light;
  const glm::dvec3 target = glm::make_vec3(light->GetFocalPoint());
  glm::dvec3 way = glm::make_vec3(light->GetPosition()) - target;
  const double distance = glm::length(way);
  way += GetAxis(this->Up) * (share * (light->GetPositional() ? this->Size : distance));
  if (!light->GetPositional())
  {
    way *= distance / glm::length(way);
  }
  light->SetPosition(glm::value_ptr(target + way));
}

//------------------------------------------------------------------------------
void ViewStage::ScaleLight(double factor)
{
  if (vtkShadowStudio* studio = vtkShadowStudio::FindOn(this->Renderer))
  {
    studio->SetSoftness(studio->GetSoftness() * factor);
    return;
  }
  vtkAreaLight* light = this->Built.Light;
  light->SetRadius(light->GetRadius() * factor);
  light->SetWidth(light->GetWidth() * factor);
  light->SetHeight(light->GetHeight() * factor);
  light->SetAngularDiameter(light->GetAngularDiameter() * factor);
}

//------------------------------------------------------------------------------
void ViewStage::TurnCasters(double degrees)
{
  this->Angle += degrees;
  this->Casters->SetAngle(this->Angle);
}

//------------------------------------------------------------------------------
void ViewStage::ShowLights(bool shown, int samples)
{
  for (const auto& light : this->Shown)
  {
    light->SetSamples(samples);
    if (shown && !this->LightsShown)
    {
      this->Renderer->AddViewProp(light);
    }
    else if (!shown && this->LightsShown)
    {
      this->Renderer->RemoveViewProp(light);
    }
  }
  this->LightsShown = shown;
}

//------------------------------------------------------------------------------
std::vector<std::string> ViewStage::GetLightOptions() const
{
  if (vtkShadowStudio* studio = vtkShadowStudio::FindOn(this->Renderer))
  {
    double way[3];
    vtkMath::Subtract(this->Built.Light->GetPosition(), this->Built.Light->GetFocalPoint(), way);
    return { "--studio-key", Print(way), "--studio-softness",
      vtkShadowNumber::Print(studio->GetSoftness()) };
  }
  std::vector<std::string> words;
  for (vtkAreaLight* light : this->Built.Lights)
  {
    const std::string shape = GetShapeName(light);
    const auto number = [](const char* name, double value)
    { return std::string(name) + vtkShadowNumber::Print(value); };
    std::string text = shape;
    if (shape == "sphere" || shape == "disk")
    {
      text += number(":radius=", light->GetRadius());
    }
    else if (shape == "rectangle")
    {
      text += number(":width=", light->GetWidth()) + number(":height=", light->GetHeight());
    }
    else if (shape == "directional")
    {
      text += number(":angle=", light->GetAngularDiameter());
    }
    text += ":position=" + Print(light->GetPosition()) + ":target=" + Print(light->GetFocalPoint());
    text += ":color=" + Print(light->GetDiffuseColor());
    words.insert(words.end(), { "--light", text + number(":intensity=", light->GetIntensity()) });
  }
  return words;
}

//------------------------------------------------------------------------------
std::vector<std::string> ViewStage::GetOptions(const int size[2]) const
{
  std::vector<std::string> words = this->Options.Models;
  const auto add = [&words](const std::vector<std::string>& more)
  { words.insert(words.end(), more.begin(), more.end()); };
  if (!this->Options.Builtin.empty())
  {
    add({ "--scene", this->Options.Builtin });
  }
  if (this->Options.Triangles > 0)
  {
    add({ "--triangles", std::to_string(this->Options.Triangles) });
  }
  if (this->Options.Ground)
  {
    add({ "--ground" });
  }
  if (!this->Options.Up.empty())
  {
    add({ "--up", this->Options.Up });
  }
  if (this->Angle != 0.0)
  {
    add({ "--turn", vtkShadowNumber::Print(this->Angle) });
  }
  add({ "--size", std::to_string(size[0]) + "x" + std::to_string(size[1]), "--samples-per-pixel",
    std::to_string(this->Options.SamplesPerPixel) });
  if (this->Options.Background)
  {
    add({ "--background", Print(this->Options.Background->data()) });
  }
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  add({ "--camera-position", Print(camera->GetPosition()), "--camera-target",
    Print(camera->GetFocalPoint()), "--view-up", Print(camera->GetViewUp()) });
  add(camera->GetParallelProjection() ? std::vector<std::string>{ "--parallel-scale",
                                          vtkShadowNumber::Print(camera->GetParallelScale()) }
                                      : std::vector<std::string>{ "--view-angle",
                                          vtkShadowNumber::Print(camera->GetViewAngle()) });
  add(this->GetLightOptions());
  if (this->LightsShown)
  {
    add({ "--show-lights" });
  }
  return words;
}
