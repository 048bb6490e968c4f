// SPDX-License-Identifier: BSD-3-Clause
// The shadow catcher: nothing of it shows but the shadow.

#include "ShadowOracle.h"
#include "ShadowTest.h"

#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkProperty.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace
{
const Parameters Fine = { { "resolution", "1024" }, { "samples", "4" } };

/** Things on a catcher, before a background that is not black. Gives the catcher. */
vtkActor* Build(ShadowStage& stage)
{
  stage.Renderer->SetBackground(0.9, 0.8, 0.3);
  vtkActor* floor = stage.AddFloor();
  stage.AddBox({ -0.8, 0.3, 0.6 }, { 1.0, 1.0, 1.2 });
  stage.AddSphere({ 0.9, -0.5, 1.3 }, 0.6);
  stage.LookAt({ 3.5, -6.5, 4.5 }, { 0.2, 0.2, 0.3 });
  vtkShadowPass::SetShadowCatcher(floor, true);
  return floor;
}

/** The picture of the same without the floor, which is what a catcher in full light leaves. */
Picture GetWithout(ShadowStage& stage, vtkActor* floor)
{
  floor->VisibilityOff();
  stage.Render();
  ShadowTest::TakeMessages(); // planar techniques say that nothing receives
  const Picture picture = stage.GetPicture();
  floor->VisibilityOn();
  return picture;
}
}

//------------------------------------------------------------------------------
// With one light, the background shows through by V; other props are what they are without a catcher.
// Blended and peeled; of a catcher that is coloured, shiny or physically based too.
SHADOW_TEST(Catcher, ShowsShadowAlone, Each)
{
  const char* const kinds[] = { "plain", "shiny", "physically based", "peeled" };
  for (const std::string kind : kinds)
  {
    ShadowStage stage;
    vtkActor* floor = Build(stage);
    vtkLight* light = stage.AddLight(LightKind::Point);
    stage.Renderer->SetUseDepthPeeling(kind == "peeled");
    floor->GetProperty()->SetColor(0.1, 0.5, 0.2);
    if (kind == "shiny")
    {
      floor->GetProperty()->SetAmbient(0.4);
      floor->GetProperty()->SetSpecular(0.6);
    }
    else if (kind == "physically based")
    {
      vtkShadowPass::SetShadowCatcher(floor, false);
      floor->GetProperty()->SetInterpolationToPBR();
      vtkShadowPass::SetShadowCatcher(floor, true);
    }
    stage.SetPass(technique, Fine);
    const Picture without = GetWithout(stage, floor);
    stage.Render();
    const Picture picture = stage.GetPicture();
    const Visibility visibility = stage.GetVisibility(light);
    ShadowTest::CheckNoMessage(kind);

    const ShadowOracle oracle(stage);
    const auto mask = oracle.GetMask(floor);
    const auto inner = oracle.GetInner(1);
    int worst = 0;
    int others = 0;
    std::size_t dark = 0;
    std::size_t lit = 0;
    std::size_t receivers = 0;
    std::size_t catching = 0;
    for (std::size_t i = 0; i < mask.size(); ++i)
    {
      if (!inner[i])
      {
        continue;
      }
      if (!mask[i])
      {
        others = std::max(others, picture.Difference(without, i));
        continue;
      }
      ++catching;
      receivers += visibility.Mask[i];
      dark += visibility.V[i] == 0.0f;
      lit += visibility.V[i] == 1.0f;
      for (int c = 0; c < 3; ++c)
      {
        const double expected = visibility.V[i] * without.RGB[3 * i + c];
        worst = std::max(
          worst, static_cast<int>(std::abs(std::round(expected) - picture.RGB[3 * i + c])));
      }
    }
    ShadowTest::CheckAtLeast(static_cast<double>(receivers), 0.99 * static_cast<double>(dark + lit),
      kind + ", receivers in the visibility");
    ShadowTest::CheckAtLeast(static_cast<double>(dark), 500.0, kind + ", dark pixels");
    ShadowTest::CheckAtLeast(static_cast<double>(lit), 3000.0, kind + ", lit pixels");
    ShadowTest::CheckAtMost(worst, 1.0, kind + ": difference from V times background, of 255");
    ShadowTest::CheckAtMost(others, 1.0, kind + ": difference of other props, of 255");
  }
}

//------------------------------------------------------------------------------
// Of several lights, each counts by its brightness and slope: half of the light missing is half black.
// One that casts no shadow counts as light. With none that casts, there is nothing to see.
SHADOW_TEST(Catcher, SeveralLights, Each)
{
  ShadowStage stage;
  vtkActor* floor = Build(stage);
  const auto addSun = [&stage](double x, double y)
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPosition(x, y, 2.0);
    light->SetFocalPoint(0.0, 0.0, 0.0);
    stage.Renderer->AddLight(light);
    return light.Get();
  };
  vtkLight* first = addSun(1.0, 0.5);
  vtkLight* second = addSun(-1.0, 0.5); // of the same slope to the floor
  vtkLight* third = addSun(0.5, -1.0);
  second->SetIntensity(0.5);
  third->SetIntensity(0.5);
  vtkShadowPass::SetLightCasting(third, false);
  second->SetShadowAttenuation(0.5);
  stage.SetPass(technique, Fine);
  const Picture without = GetWithout(stage, floor);
  stage.Render();
  const Picture picture = stage.GetPicture();
  const Visibility a = stage.GetVisibility(first);
  const Visibility b = stage.GetVisibility(second);
  const ShadowOracle oracle(stage);
  const auto mask = oracle.GetMask(floor);
  const auto inner = oracle.GetInner(1);
  double worst = 0.0;
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    if (inner[i] && mask[i])
    {
      const double share = (a.V[i] + 0.5 * (0.5 + 0.5 * b.V[i]) + 0.5) / 2.0;
      worst = std::max(worst, std::abs(share * without.RGB[3 * i] - picture.RGB[3 * i]));
    }
  }
  // The background and the product are rounded to 8 bits.
  ShadowTest::CheckAtMost(worst, 2.0, "difference from the share of light, of 255");

  vtkShadowPass::SetLightCasting(first, false);
  vtkShadowPass::SetLightCasting(second, false);
  const Picture unshadowed = GetWithout(stage, floor);
  stage.Render();
  ShadowTest::Check(Same(stage.GetPicture(), unshadowed), "a catcher shows where no light casts");
  vtkShadowPass::SetShadowCatcher(floor, false);
  stage.Render();
  const Picture ordinary = stage.GetPicture();
  stage.Renderer->SetPass(nullptr);
  stage.Render();
  ShadowTest::Check(Same(stage.GetPicture(), ordinary), "once a catcher, no ordinary prop again");
  ShadowTest::CheckNoMessage("several lights");
}

//------------------------------------------------------------------------------
// On a transparent background the picture's alpha is the shadow, to be laid over another picture. Under
// depth peeling: VTK 9.1 writes a (1 - a) where it blends by order-independent transparency.
SHADOW_TEST(Catcher, PictureHasAlpha, Each)
{
  ShadowStage stage;
  vtkActor* floor = Build(stage);
  stage.Window->SetAlphaBitPlanes(1);
  stage.Renderer->SetBackgroundAlpha(0.0);
  stage.Renderer->UseDepthPeelingOn();
  vtkLight* light = stage.AddLight(LightKind::Point);
  stage.SetPass(technique, Fine);
  stage.Render();
  const Visibility visibility = stage.GetVisibility(light);
  stage.Render();
  vtkNew<vtkUnsignedCharArray> rgba;
  stage.Window->GetRGBACharPixelData(0, 0, 159, 159, 0, rgba);
  const ShadowOracle oracle(stage);
  const auto mask = oracle.GetMask(floor);
  const auto inner = oracle.GetInner(1);
  double worst = 0.0;
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    if (inner[i])
    {
      const double alpha = rgba->GetValue(4 * static_cast<vtkIdType>(i) + 3) / 255.0;
      const bool background = !oracle.GetPixels()[i].Actor;
      const double expected = mask[i] ? 1.0 - visibility.V[i] : (background ? 0.0 : 1.0);
      worst = std::max(worst, std::abs(alpha - expected));
    }
  }
  ShadowTest::CheckAtMost(worst, 1.5 / 255.0, "difference of alpha");
}
