// SPDX-License-Identifier: BSD-3-Clause
// Every kind of light casts the shadow of its place: against the oracle, for lights without size.
// Pixels that differ lie on edges, 500 of 25,600, where a texel and a pixel see different points.

#include "ShadowOracle.h"
#include "ShadowTest.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkProperty.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>

namespace
{
constexpr double EdgeShare = 0.015;
const Parameters Fine = { { "resolution", "1024" }, { "samples", "4" } };

/** Boxes around the middle, with room for a light. */
void AddRing(ShadowStage& stage)
{
  stage.AddFloor();
  stage.AddBox({ -1.4, 0.2, 0.5 }, { 0.5, 1.2, 1.0 });
  stage.AddBox({ 1.2, 0.4, 0.6 }, { 0.4, 0.7, 1.2 });
  stage.AddBox({ 0.0, 1.5, 0.4 }, { 1.5, 0.3, 0.8 });
  stage.AddBox({ -0.1, -1.3, 0.2 }, { 0.6, 0.3, 0.4 });
  stage.AddBox({ 0.1, 0.2, 1.6 }, { 0.5, 0.6, 0.1 });
  stage.LookAt({ 3.0, -6.5, 5.5 }, { 0.0, 0.2, 0.2 });
}

void CheckAgainstOracle(const std::string& technique, ShadowStage& stage, vtkLight* light,
  const std::string& what, bool darkSomewhere = true)
{
  if (!stage.Pass)
  {
    stage.SetPass(technique, Fine);
  }
  stage.Render(); // which lets lights that go with the camera find their place
  const Visibility truth = ShadowOracle(stage).GetHard(light, technique);
  const Visibility visibility = stage.GetVisibility(light);
  const Difference difference = Compare(visibility, truth, 0.5);
  ShadowTest::CheckAtMost(difference.Share, EdgeShare, what + ": pixels that differ");
  ShadowTest::CheckAtMost(difference.MaskShare, 0.001, what + ": receivers that differ");
  if (darkSomewhere)
  {
    ShadowTest::CheckEqual(GetRange(visibility).first, 0.0, what + ": there is a shadow");
  }
}
}

//------------------------------------------------------------------------------
SHADOW_TEST(LightKinds, PointOutside, Each)
{
  ShadowStage stage;
  AddRing(stage);
  CheckAgainstOracle(
    technique, stage, stage.AddPlainLight(true, { -3.0, -2.0, 5.0 }), "from above");
  stage.Renderer->RemoveAllLights();
  CheckAgainstOracle(technique, stage, stage.AddPlainLight(true, { 4.5, 1.0, 0.5 }), "from aside");
  stage.Renderer->RemoveAllLights();
  CheckAgainstOracle(technique, stage, stage.AddPlainLight(true, { 0.5, 0.2, -3.0 }), "below");
}

//------------------------------------------------------------------------------
SHADOW_TEST(LightKinds, PointAmongCasters, Each)
{
  ShadowStage stage;
  AddRing(stage);
  CheckAgainstOracle(technique, stage, stage.AddPlainLight(true, { 0.05, 0.1, 0.7 }), "between");
  stage.Renderer->RemoveAllLights();
  CheckAgainstOracle(
    technique, stage, stage.AddPlainLight(true, { 0.3, -0.4, 0.05 }), "just above the floor");
}

//------------------------------------------------------------------------------
// VTK's cone opens at the light's centre. What a receiver within it sees of the rest of the light
// must not depend on it.
SHADOW_TEST(LightKinds, SpotWithASize, Each)
{
  ShadowStage stage;
  AddRing(stage);
  const glm::dvec3 place(-1.2, -1.5, 2.2);
  vtkAreaLight* light = stage.AddLight(LightKind::Rectangle, place, glm::dvec3(0.0));
  light->SetWidth(3.0);
  light->SetHeight(3.0);
  stage.SetPass(technique, Fine);
  stage.Render();
  const Visibility open = stage.GetVisibility();
  const ShadowOracle oracle(stage);
  std::vector<unsigned char> inside;
  for (const auto& pixel : oracle.GetPixels())
  {
    const glm::dvec3 ray = pixel.Position - place;
    inside.push_back(
      pixel.Actor &&
      glm::dot(ray, -place) > std::cos(glm::radians(29.9)) * glm::length(ray) * glm::length(place));
  }
  light->SetConeAngle(30.0);
  stage.Render();
  const Difference difference = Compare(stage.GetVisibility(), open, 0.1, inside);
  ShadowTest::CheckAtLeast(static_cast<double>(difference.Pixels), 5000.0, "pixels in the cone");
  ShadowTest::CheckAtMost(difference.Share, EdgeShare, "pixels that differ");
}

//------------------------------------------------------------------------------
// Within the cone; what lies outside gets no light, with or without a shadow.
SHADOW_TEST(LightKinds, Spot, Each)
{
  ShadowStage stage;
  AddRing(stage);
  vtkLight* light =
    stage.AddPlainLight(true, { -1.2, -1.5, 2.2 }); // so near that the ring exceeds the cone
  light->SetConeAngle(30.0);
  stage.SetPass(technique, Fine);
  stage.Render();
  const ShadowOracle oracle(stage);
  std::vector<unsigned char> inside;
  const glm::dvec3 place(-1.2, -1.5, 2.2);
  for (const auto& pixel : oracle.GetPixels())
  {
    const glm::dvec3 ray = pixel.Position - place;
    inside.push_back(
      pixel.Actor &&
      glm::dot(ray, -place) > std::cos(glm::radians(29.9)) * glm::length(ray) * glm::length(place));
  }
  const Visibility visibility = stage.GetVisibility();
  const Difference difference = Compare(visibility, oracle.GetHard(light, technique), 0.5, inside);
  ShadowTest::CheckAtLeast(static_cast<double>(difference.Pixels), 5000.0, "pixels in the cone");
  ShadowTest::CheckAtMost(difference.Share, EdgeShare, "pixels that differ");
  ShadowTest::CheckEqual(GetRange(visibility).first, 0.0, "there is a shadow");
}

//------------------------------------------------------------------------------
SHADOW_TEST(LightKinds, Directional, Each)
{
  ShadowStage stage;
  AddRing(stage);
  CheckAgainstOracle(
    technique, stage, stage.AddPlainLight(false, { -0.3, -0.2, 0.5 }), "from above");
  stage.Renderer->RemoveAllLights();
  CheckAgainstOracle(
    technique, stage, stage.AddPlainLight(false, { 1.0, 0.1, 0.1 }), "near the horizon");
}

//------------------------------------------------------------------------------
// A headlight hides nothing that is seen, but a directional one does in a perspective picture.
SHADOW_TEST(LightKinds, Headlight, Each)
{
  ShadowStage stage;
  AddRing(stage);
  vtkLight* light = stage.AddPlainLight(true, { 0.0, 0.0, 1.0 });
  light->SetLightTypeToHeadlight();
  CheckAgainstOracle(technique, stage, light, "positional", false);
  light->PositionalOff();
  CheckAgainstOracle(technique, stage, light, "directional");
  stage.LookAt({ -3.0, -6.0, 4.0 }, { 0.0, 0.2, 0.2 });
  CheckAgainstOracle(technique, stage, light, "after the camera moved");
}

//------------------------------------------------------------------------------
SHADOW_TEST(LightKinds, CameraLight, Each)
{
  ShadowStage stage;
  AddRing(stage);
  vtkLight* light = stage.AddPlainLight(true, { -0.6, 0.8, 1.0 });
  light->SetLightTypeToCameraLight();
  CheckAgainstOracle(technique, stage, light, "positional");
  light->PositionalOff();
  CheckAgainstOracle(technique, stage, light, "directional");
  stage.LookAt({ -3.0, -6.0, 4.0 }, { 0.0, 0.2, 0.2 });
  CheckAgainstOracle(technique, stage, light, "after the camera moved");
}

//------------------------------------------------------------------------------
SHADOW_TEST(LightKinds, TransformedLight, Each)
{
  ShadowStage stage;
  AddRing(stage);
  vtkLight* light = stage.AddPlainLight(true, { 2.0, -2.0, 4.0 });
  vtkNew<vtkMatrix4x4> turn; // a quarter about z: to (2, 2, 4)
  const double elements[16] = { 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
  turn->DeepCopy(elements);
  light->SetTransformMatrix(turn);
  CheckAgainstOracle(technique, stage, light, "turned by its matrix");
}

//------------------------------------------------------------------------------
// One that is off comes first and must not shift the others; one does not cast; one casts a shadow
// of half strength. V of each, and the picture: the sum of what each alone gives, times its factor.
SHADOW_TEST(LightKinds, SeveralLights, Each)
{
  ShadowStage stage;
  AddRing(stage);
  stage.Renderer->SetBackground(0.0, 0.0, 0.0);
  vtkPropCollection* props = stage.Renderer->GetViewProps();
  for (int i = 0; i < props->GetNumberOfItems(); ++i)
  {
    vtkProperty* property = vtkActor::SafeDownCast(props->GetItemAsObject(i))->GetProperty();
    property->SetAmbient(0.0);
    property->SetDiffuse(1.0);
  }
  vtkLight* off = stage.AddPlainLight(true, { 2.0, 3.0, 5.0 });
  off->SwitchOff();
  vtkLight* first = stage.AddPlainLight(true, { -3.0, -2.0, 5.0 });
  vtkLight* plain = stage.AddPlainLight(false, { 1.0, -1.0, 2.0 });
  vtkShadowPass::SetLightCasting(plain, false);
  vtkLight* half = stage.AddPlainLight(false, { 2.0, 0.5, 2.0 });
  half->SetShadowAttenuation(0.5);
  first->SetColor(0.4, 0.1, 0.1);
  plain->SetColor(0.1, 0.3, 0.1);
  half->SetColor(0.1, 0.1, 0.4);
  vtkLight* const lights[] = { first, plain, half };

  std::vector<Picture> alone;
  for (vtkLight* only : lights)
  {
    for (vtkLight* light : lights)
    {
      light->SetSwitch(light == only);
    }
    stage.Render();
    alone.push_back(stage.GetPicture());
  }
  for (vtkLight* light : lights)
  {
    light->SwitchOn();
  }
  CheckAgainstOracle(technique, stage, first, "the first");
  CheckAgainstOracle(technique, stage, half, "the third");
  const auto lit = GetRange(stage.GetVisibility(plain));
  ShadowTest::CheckEqual(lit.first, 1.0, "V of the light that does not cast");

  // By place among the casting lights, as well as by itself.
  ShadowTest::Check(Same(stage.GetVisibility(0), stage.GetVisibility(first)), "number 0");
  ShadowTest::Check(Same(stage.GetVisibility(1), stage.GetVisibility(half)), "number 1");

  const Visibility v[] = { stage.GetVisibility(first), stage.GetVisibility(plain),
    stage.GetVisibility(half) };
  const double strength[] = { 1.0, 1.0, 0.5 };
  const Picture picture = stage.GetPicture();
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < v[0].V.size(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      double sum = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        sum += alone[k].RGB[3 * i + c] * (1.0 - strength[k] * (1.0 - v[k].V[i]));
      }
      // Four roundings to 8 bits of at most a half each.
      if (std::abs(sum - picture.RGB[3 * i + c]) > 2.0)
      {
        ++wrong;
        break;
      }
    }
  }
  ShadowTest::CheckAtMost(
    static_cast<double>(wrong), 10.0, "pixels that are not the sum of the lights");
}

//------------------------------------------------------------------------------
// Plain positional lights take the pass's radius, in world units, and are spheres then.
SHADOW_TEST(LightKinds, DefaultRadius, Each)
{
  if (!ShadowStage::Supports(technique, LightKind::Sphere))
  {
    return;
  }
  Visibility visibility[2];
  for (int area = 0; area < 2; ++area)
  {
    ShadowStage stage;
    AddRing(stage);
    if (area)
    {
      stage.AddLight(LightKind::Sphere, { -3.0, -2.0, 5.0 }, { 0.0, 0.0, 0.0 })->SetRadius(0.6);
    }
    else
    {
      stage.AddPlainLight(true, { -3.0, -2.0, 5.0 });
    }
    stage.SetPass(technique, { { "samples", "64" } })->SetDefaultLightRadius(area ? 0.0 : 0.6);
    stage.Render();
    visibility[area] = stage.GetVisibility();
  }
  // Their samples may be turned against each other: noise of 64 samples, 0.5 * 64^-0.75 = 0.02.
  ShadowTest::CheckAtMost(
    Compare(visibility[0], visibility[1]).RMSE, 0.02, "RMSE to a sphere of that radius");
}
