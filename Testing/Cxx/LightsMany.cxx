// SPDX-License-Identifier: BSD-3-Clause
// Many lights at once, cones of every width, and lights that change between frames. Single lights of
// each kind are LightKinds.cxx's.

#include "ShadowOracle.h"
#include "ShadowTest.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkLightKit.h"
#include "vtkProperty.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
// Pixels on edges, where a texel and a pixel see different points: a third of what LightKinds.cxx,
// with lights among its casters, allows.
constexpr double EdgeShare = 0.005;
const Parameters Fine = { { "resolution", "1024" }, { "samples", "4" } };

/** V against the oracle's; a shadow of more than an edge is there. Gives how many pixels are dark. */
std::size_t CheckLight(const std::string& technique, ShadowStage& stage, const ShadowOracle& oracle,
  vtkLight* light, const std::string& what, const std::vector<unsigned char>& use = {})
{
  const Visibility visibility = stage.GetVisibility(light);
  const Visibility truth = oracle.GetHard(light, technique);
  ShadowTest::CheckAtMost(
    Compare(visibility, truth, 0.5, use).Share, EdgeShare, what + ": pixels that differ");
  const std::size_t dark = std::count(truth.V.begin(), truth.V.end(), 0.0f);
  if (dark > 500)
  {
    ShadowTest::CheckEqual(GetRange(visibility).first, 0.0, what + ": there is a shadow");
  }
  return dark;
}

/** Diffuse alone, so that a picture is a sum over lights. */
void MakeDiffuse(ShadowStage& stage)
{
  stage.Renderer->SetBackground(0.0, 0.0, 0.0);
  vtkPropCollection* props = stage.Renderer->GetViewProps();
  for (int i = 0; i < props->GetNumberOfItems(); ++i)
  {
    vtkProperty* property = vtkActor::SafeDownCast(props->GetItemAsObject(i))->GetProperty();
    property->SetAmbient(0.0);
    property->SetDiffuse(1.0);
  }
}

/** Fifteen all around, positional and directional in turn, and a spot. */
std::vector<vtkLight*> AddSixteen(ShadowStage& stage)
{
  std::vector<vtkLight*> lights;
  for (int i = 0; i < 15; ++i)
  {
    const double angle = glm::radians(24.0 * i);
    const double height = i % 3 == 0 ? 2.5 : 4.5;
    lights.push_back(
      stage.AddPlainLight(i % 2 == 0, { 4.0 * std::cos(angle), 4.0 * std::sin(angle), height }));
  }
  lights.push_back(stage.AddPlainLight(true, { -2.0, -3.0, 5.0 }));
  lights.back()->SetConeAngle(40.0);
  for (vtkLight* light : lights)
  {
    light->SetDiffuseColor(0.06, 0.06, 0.06);
  }
  return lights;
}
}

//------------------------------------------------------------------------------
// VTK's kit: five directional lights that go with the camera. Each casts the shadow of its place,
// after the camera has moved too.
SHADOW_TEST(LightsMany, Kit, Each)
{
  ShadowStage stage;
  stage.AddThings();
  vtkNew<vtkLightKit> kit;
  kit->AddLightsToRenderer(stage.Renderer);
  kit->Update();
  stage.SetPass(technique, Fine);
  vtkLightCollection* lights = stage.Renderer->GetLights();
  ShadowTest::CheckEqual(lights->GetNumberOfItems(), 5.0, "lights of the kit");
  for (int view = 0; view < 2; ++view)
  {
    stage.Render();
    const ShadowOracle oracle(stage);
    std::size_t dark = 0;
    for (int i = 0; i < lights->GetNumberOfItems(); ++i)
    {
      dark +=
        CheckLight(technique, stage, oracle, vtkLight::SafeDownCast(lights->GetItemAsObject(i)),
          "view " + std::to_string(view) + ", light " + std::to_string(i));
    }
    ShadowTest::CheckAtLeast(static_cast<double>(dark), 5000.0, "dark pixels of all five");
    stage.LookAt({ -4.5, -5.0, 4.0 }, { 0.2, 0.2, 0.3 });
  }
}

//------------------------------------------------------------------------------
// As many as there may be: each has its own shadow, and the picture is the sum of all lights, times
// what is seen of each. One more gets no shadow, with one warning, and takes none from the others.
SHADOW_TEST(LightsMany, SixteenAndOne, Each)
{
  ShadowStage stage(100, 100);
  stage.AddThings();
  MakeDiffuse(stage);
  const auto lights = AddSixteen(stage);
  std::vector<Picture> alone;
  for (vtkLight* only : lights)
  {
    for (vtkLight* light : lights)
    {
      light->SetSwitch(light == only);
    }
    only->SetIntensity(10.0); // or rounding to 8 bits would be much of it
    stage.Render();
    alone.push_back(stage.GetPicture());
    only->SetIntensity(1.0);
  }
  for (vtkLight* light : lights)
  {
    light->SwitchOn();
  }
  stage.SetPass(technique, { { "resolution", "512" }, { "samples", "4" } });
  stage.Render();
  const Picture picture = stage.GetPicture();
  const ShadowOracle oracle(stage);
  std::vector<double> sum(picture.RGB.size(), 0.0);
  std::vector<Visibility> visibilities;
  for (std::size_t k = 0; k < lights.size(); ++k)
  {
    std::vector<unsigned char> use;
    if (lights[k]->GetConeAngle() < 90.0)
    {
      for (const auto& pixel : oracle.GetPixels())
      {
        const glm::dvec3 place(-2.0, -3.0, 5.0);
        const glm::dvec3 ray = pixel.Position - place;
        use.push_back(glm::dot(ray, -place) >
                      std::cos(glm::radians(39.9)) * glm::length(ray) * glm::length(place));
      }
    }
    // A 100th of a picture's side is more than a 160th, and so is a texel of 512 than one of 1024.
    const Visibility visibility = stage.GetVisibility(lights[k]);
    const std::string what = "light " + std::to_string(k);
    ShadowTest::CheckAtMost(
      Compare(visibility, oracle.GetHard(lights[k], technique), 0.5, use).Share, 2.0 * EdgeShare,
      what + ": pixels that differ");
    ShadowTest::CheckEqual(GetRange(visibility).first, 0.0, what + ": there is a shadow");
    visibilities.push_back(visibility);
    for (std::size_t i = 0; i < sum.size(); ++i)
    {
      sum[i] += 0.1 * alone[k].RGB[i] * visibility.V[i / 3];
    }
  }
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < sum.size(); ++i)
  {
    // A half of rounding, and sixteen of a twentieth.
    wrong += std::abs(sum[i] - picture.RGB[i]) > 1.5;
  }
  ShadowTest::CheckEqual(static_cast<double>(wrong), 0.0, "values that are not the sum");
  ShadowTest::CheckNoMessage("sixteen");

  vtkLight* more = stage.AddPlainLight(true, { 0.5, -4.0, 5.0 });
  more->SetDiffuseColor(0.1, 0.1, 0.1);
  for (int frame = 0; frame < 2; ++frame)
  {
    stage.Render();
  }
  ShadowTest::CheckOneMessage(ShadowTest::Message::Warning, { "16" }, "seventeen");
  ShadowTest::CheckEqual(GetRange(stage.GetVisibility(more)).first, 1.0, "V of the seventeenth");
  for (std::size_t k = 0; k < lights.size(); ++k)
  {
    ShadowTest::Check(Same(stage.GetVisibility(lights[k]), visibilities[k]),
      "V of light " + std::to_string(k) + " changes with the seventeenth");
  }
  // One that is off makes room.
  lights[3]->SwitchOff();
  stage.Render();
  CheckLight(technique, stage, oracle, more, "in another's room");
  ShadowTest::CheckNoMessage("at the end");
}

//------------------------------------------------------------------------------
// With their sizes, and all kinds that the technique takes: what is seen of a light does not depend
// on the others, but that soft code then runs for those without a size too.
SHADOW_TEST(LightsMany, KindsTogether, Each)
{
  ShadowStage stage(120, 120);
  stage.AddThings();
  std::vector<vtkAreaLight*> lights;
  for (int i = 0; i < 16; ++i)
  {
    const LightKind kind = LightKinds[i % 6];
    const double angle = glm::radians(22.5 * i);
    lights.push_back(
      stage.AddLight(ShadowStage::Supports(technique, kind) ? kind : LightKind::Point,
        { 4.0 * std::cos(angle), 4.0 * std::sin(angle), 4.5 }, glm::dvec3(0.0)));
    lights.back()->SetDiffuseColor(0.06, 0.06, 0.06);
  }
  stage.SetPass(technique);
  stage.Render();
  std::vector<Visibility> together;
  for (vtkLight* light : lights)
  {
    together.push_back(stage.GetVisibility(light));
  }
  for (const int alone : { 1, 6, 8, 9, 10, 11 }) // each kind once
  {
    for (vtkLight* light : lights)
    {
      light->SetSwitch(light == lights[alone]);
    }
    stage.Render();
    const std::string what = "light " + std::to_string(alone);
    const Difference difference = Compare(stage.GetVisibility(lights[alone]), together[alone]);
    ShadowTest::CheckAtMost(difference.RMSE, 0.01, what + ", RMSE");
    ShadowTest::CheckAtMost(difference.Share, 0.002, what + ", pixels that differ");
    ShadowTest::CheckEqual(GetRange(together[alone]).first, 0.0, what + ": there is a shadow");
  }
}

//------------------------------------------------------------------------------
// VTK's cone angle is from its axis to its edge, and none from 90 degrees on. Within the cone V is
// that of the oracle.
SHADOW_TEST(LightsMany, Cones, Each)
{
  for (const double angle : { 1.0, 20.0, 60.0, 89.0, 91.0, 120.0, 170.0, 179.0 })
  {
    ShadowStage stage;
    stage.AddThings();
    // A narrow one stands so far away that its spot covers the box and part of its shadow.
    const glm::dvec3 focus(0.0, 0.4, 0.6);
    const double distance = angle < 10.0 ? 90.0 : 2.6;
    const glm::dvec3 place = focus + distance * glm::normalize(glm::dvec3(-0.9, -0.7, 1.0));
    vtkLight* light = stage.AddPlainLight(true, place);
    light->SetFocalPoint(focus.x, focus.y, focus.z);
    light->SetConeAngle(angle);
    stage.SetPass(technique, Fine);
    stage.Render();
    const ShadowOracle oracle(stage);
    std::vector<unsigned char> inside;
    const double limit = angle < 90.0 ? std::cos(glm::radians(0.995 * angle)) : -2.0;
    for (const auto& pixel : oracle.GetPixels())
    {
      const glm::dvec3 ray = pixel.Position - place;
      inside.push_back(pixel.Actor && glm::dot(ray, focus - place) >
                                        limit * glm::length(ray) * glm::length(focus - place));
    }
    const std::string what = std::to_string(static_cast<int>(angle)) + " degrees";
    const Difference difference =
      Compare(stage.GetVisibility(light), oracle.GetHard(light, technique), 0.5, inside);
    ShadowTest::CheckAtLeast(static_cast<double>(difference.Pixels), 2000.0, what + ": pixels");
    ShadowTest::CheckAtMost(difference.Share, EdgeShare, what + ": pixels that differ");
    ShadowTest::CheckEqual(
      GetRange(stage.GetVisibility(light)).first, 0.0, what + ": there is a shadow");
    ShadowTest::CheckNoMessage(what);
  }
}

//------------------------------------------------------------------------------
// Lights of the camera and of the scene at once; then they are switched off and on, one that is off
// comes first, and they move: V is that of a new pass each time, and of the light that was asked for.
SHADOW_TEST(LightsMany, ChangesBetweenFrames, Each)
{
  ShadowStage stage;
  stage.AddThings();
  vtkLight* head = stage.AddPlainLight(false, { 0.0, 0.0, 1.0 });
  head->SetLightTypeToHeadlight();
  vtkLight* camera = stage.AddPlainLight(true, { -0.8, 0.6, 0.4 });
  camera->SetLightTypeToCameraLight();
  vtkLight* scene = stage.AddPlainLight(true, { -2.5, -2.0, 5.5 });
  std::vector<vtkLight*> lights = { head, camera, scene };
  const std::pair<const char*, std::function<void()>> changes[] = {
    { "all three", [] {} },
    { "the first off", [&] { head->SwitchOff(); } },
    { "the second off", [&] { camera->SwitchOff(); } },
    { "the second on", [&] { camera->SwitchOn(); } },
    { "the camera moved",
      [&] {
        stage.LookAt({ -4.0, -6.0, 4.0 }, { 0.2, 0.2, 0.3 });
      } },
    { "the scene's moved", [&] { scene->SetPosition(3.0, -1.0, 5.0); } },
    { "the first on, the last off",
      [&]
      {
        head->SwitchOn();
        scene->SwitchOff();
      } },
    { "the scene's made directional, and on",
      [&]
      {
        scene->PositionalOff();
        scene->SwitchOn();
      } },
    { "the second black", [&] { camera->SetIntensity(0.0); } },
    { "the second removed",
      [&]
      {
        stage.Renderer->RemoveLight(camera);
        lights.erase(lights.begin() + 1); // there is nothing to ask for
      } },
  };
  stage.SetPass(technique, Fine);
  const vtkSmartPointer<vtkShadowPass> pass = stage.Pass;
  const vtkSmartPointer<vtkLight> kept = camera;
  for (const auto& change : changes)
  {
    change.second();
    stage.Pass = pass;
    stage.Renderer->SetPass(pass);
    stage.Render();
    const ShadowOracle oracle(stage);
    std::vector<Visibility> visibilities;
    for (vtkLight* light : lights)
    {
      const bool casts = light->GetSwitch() && light->GetIntensity() > 0.0;
      visibilities.push_back(stage.GetVisibility(light));
      const std::string what =
        std::string(change.first) + ", light " + std::to_string(visibilities.size());
      if (casts)
      {
        CheckLight(technique, stage, oracle, light, what);
      }
      else
      {
        ShadowTest::CheckEqual(GetRange(visibilities.back()).first, 1.0, what + ", V");
      }
    }
    const Picture picture = stage.GetPicture();
    stage.SetPass(technique, Fine);
    stage.Render();
    for (std::size_t i = 0; i < lights.size(); ++i)
    {
      ShadowTest::Check(Same(stage.GetVisibility(lights[i]), visibilities[i]),
        std::string(change.first) + ": V of light " + std::to_string(i + 1) +
          " is not that of a new pass");
    }
    ShadowTest::Check(Same(stage.GetPicture(), picture),
      std::string(change.first) + ": the picture is not that of a new pass");
    ShadowTest::CheckNoMessage(change.first);
  }
}

//------------------------------------------------------------------------------
// The picture is the plain one, times 1 - A (1 - V), whatever the light's colour and intensity.
SHADOW_TEST(LightsMany, AttenuationAndColour, Each)
{
  ShadowStage stage;
  stage.AddThings();
  MakeDiffuse(stage);
  auto* light = stage.AddLight(
    ShadowStage::Supports(technique, LightKind::Sphere) ? LightKind::Sphere : LightKind::Point);
  struct Case
  {
    double Attenuation, Intensity, Color[3];
  };
  const Case cases[] = { { 0.0, 1.0, { 1.0, 1.0, 1.0 } }, { 0.3, 1.0, { 1.0, 0.5, 0.2 } },
    { 0.3, 0.4, { 0.3, 1.0, 1.0 } }, { 1.0, 0.4, { 1.0, 1.0, 1.0 } },
    { 1.0, 1.0, { 0.2, 0.0, 1.0 } } };
  for (const Case& values : cases)
  {
    light->SetShadowAttenuation(values.Attenuation);
    light->SetIntensity(values.Intensity);
    light->SetDiffuseColor(values.Color[0], values.Color[1], values.Color[2]);
    stage.Renderer->SetPass(nullptr);
    stage.Render();
    const Picture plain = stage.GetPicture();
    // In screen space, the V that is asked for is the one that shades.
    for (const char* evaluation : { "auto", "screen" })
    {
      const bool same = std::string(evaluation) == "screen";
      stage.SetPass(technique, { { "evaluation", evaluation } });
      stage.Render();
      const Picture picture = stage.GetPicture();
      const Visibility v = stage.GetVisibility(light);
      std::ostringstream text;
      text << evaluation << ", attenuation " << values.Attenuation << ", intensity "
           << values.Intensity;
      std::size_t wrong = 0;
      std::size_t shadowed = 0;
      for (std::size_t i = 0; i < picture.RGB.size(); ++i)
      {
        const double factor = 1.0 - values.Attenuation * (1.0 - v.V[i / 3]);
        wrong += std::abs(factor * plain.RGB[i] - picture.RGB[i]) > 1.01; // two roundings
        shadowed += factor < 0.8 && plain.RGB[i] > 20;
      }
      // Forward, normals are not packed into a buffer: a few look-ups near a threshold differ.
      ShadowTest::CheckAtMost(static_cast<double>(wrong), same ? 0.0 : 10.0,
        text.str() + ", values that are not the product");
      ShadowTest::CheckAtLeast(static_cast<double>(shadowed),
        values.Attenuation > 0.0 ? 1000.0 : 0.0, text.str() + ", values that are much darker");
    }
  }
}
