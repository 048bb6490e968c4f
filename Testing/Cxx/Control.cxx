// SPDX-License-Identifier: BSD-3-Clause
// Who casts, who receives, and where the pass stands among VTK's other machinery.

#include "ShadowOracle.h"
#include "ShadowTest.h"

#include "vtkCamera.h"
#include "vtkHardwareSelector.h"
#include "vtkInformation.h"
#include "vtkLightCollection.h"
#include "vtkProperty.h"
#include "vtkSelection.h"
#include "vtkSelectionNode.h"

namespace
{
constexpr double EdgeShare = 0.015; // as in LightKinds.cxx
const Parameters Fine = { { "resolution", "1024" }, { "samples", "4" } };

vtkActor* Stand(ShadowStage& stage)
{
  vtkActor* box = stage.AddThings();
  stage.AddLight(LightKind::Point);
  return box;
}

/** V against the oracle's, for which these actors do not cast, at the pixels to be used. */
void CheckAgainstOracle(const std::string& technique, ShadowStage& stage,
  const std::set<vtkActor*>& ignored, const std::string& what,
  const std::vector<unsigned char>& use = {})
{
  auto* light = vtkLight::SafeDownCast(stage.Renderer->GetLights()->GetItemAsObject(0));
  const Visibility truth = ShadowOracle(stage, ignored).GetHard(light, technique);
  ShadowTest::CheckAtMost(Compare(stage.GetVisibility(light), truth, 0.5, use).Share, EdgeShare,
    what + ": pixels that differ");
}
}

//------------------------------------------------------------------------------
SHADOW_TEST(Control, CastingOfAProp, Each)
{
  ShadowStage stage;
  vtkActor* box = Stand(stage);
  ShadowTest::Check(vtkShadowPass::GetCasting(box), "casting is not the default");
  stage.SetPass(technique, Fine);
  stage.Render();
  const Visibility with = stage.GetVisibility();
  CheckAgainstOracle(technique, stage, {}, "casting");
  vtkShadowPass::SetCasting(box, false);
  ShadowTest::Check(!vtkShadowPass::GetCasting(box), "casting is not off");
  stage.Render();
  CheckAgainstOracle(technique, stage, { box }, "not casting");
  ShadowTest::CheckAtLeast(
    Compare(stage.GetVisibility(), with, 0.5).Share, 0.02, "pixels that the box had shadowed");
  vtkShadowPass::SetCasting(box, true);
  stage.Render();
  ShadowTest::Check(Same(stage.GetVisibility(), with), "casting again is not as before");
}

//------------------------------------------------------------------------------
// A prop that does not receive is drawn as VTK draws it, and is no receiver; it still casts.
SHADOW_TEST(Control, ReceivingOfAProp, Each)
{
  ShadowStage stage;
  Stand(stage);
  auto* floor = vtkActor::SafeDownCast(stage.Renderer->GetViewProps()->GetItemAsObject(0));
  stage.Render();
  const Picture plain = stage.GetPicture();
  stage.SetPass(technique, Fine);
  stage.Render();
  const Visibility with = stage.GetVisibility();
  vtkShadowPass::SetReceiving(floor, false);
  stage.Render();
  const Picture picture = stage.GetPicture();
  const Visibility visibility = stage.GetVisibility();
  const ShadowOracle oracle(stage);
  const auto mask = oracle.GetMask(floor);
  const auto inner = oracle.GetInner(1);
  int worst = 0;
  std::size_t receivers = 0;
  double others = 0.0;
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    if (inner[i] && mask[i])
    {
      worst = std::max(worst, picture.Difference(plain, i));
      receivers += visibility.Mask[i];
    }
    else if (inner[i])
    {
      others = std::max<double>(others, std::abs(visibility.V[i] - with.V[i]));
    }
  }
  ShadowTest::CheckAtMost(worst, 0.0, "the floor's difference from the picture of no pass");
  ShadowTest::CheckEqual(static_cast<double>(receivers), 0.0, "the floor's receivers");
  ShadowTest::CheckEqual(others, 0.0, "difference of the others' V");
}

//------------------------------------------------------------------------------
SHADOW_TEST(Control, CastingOfALight, Each)
{
  ShadowStage stage;
  stage.AddThings();
  vtkLight* light = stage.AddLight(LightKind::Point);
  stage.Render();
  const Picture plain = stage.GetPicture();
  stage.SetPass(technique);
  vtkShadowPass::SetLightCasting(light, false);
  stage.Render();
  ShadowTest::Check(Same(stage.GetPicture(), plain), "not the picture of no pass");
  ShadowTest::CheckEqual(GetRange(stage.GetVisibility(light)).first, 1.0, "V");
  vtkShadowPass::SetLightCasting(light, true);
  stage.Render();
  ShadowTest::Check(!Same(stage.GetPicture(), plain), "no shadow after casting is on again");
}

//------------------------------------------------------------------------------
// What is not seen casts nothing, and spoils no map by its size.
SHADOW_TEST(Control, InvisibleCaster, Each)
{
  ShadowStage stage;
  Stand(stage);
  stage.SetPass(technique, Fine);
  stage.Render();
  const Visibility expected = stage.GetVisibility();
  vtkActor* huge = stage.AddBox({ 0.0, 0.0, 5000.0 }, { 9000.0, 9000.0, 9000.0 });
  huge->VisibilityOff();
  stage.Render();
  ShadowTest::Check(Same(stage.GetVisibility(), expected), "an invisible box changes V");
  CheckAgainstOracle(technique, stage, {}, "invisible box");
}

//------------------------------------------------------------------------------
// A ground that is far larger than what stands on it costs no resolution.
SHADOW_TEST(Control, HugeGround, Each)
{
  ShadowStage stage;
  stage.AddFloor(1000.0);
  stage.AddBox({ -0.8, 0.3, 0.6 }, { 1.0, 1.0, 1.2 });
  stage.AddSphere({ 0.9, -0.5, 1.3 }, 0.6);
  stage.AddLight(LightKind::Point);
  stage.LookAt({ 3.5, -6.5, 4.5 }, { 0.2, 0.2, 0.3 });
  stage.SetPass(technique, Fine);
  stage.Render();
  CheckAgainstOracle(technique, stage, {}, "ground of 2000");
}

//------------------------------------------------------------------------------
// A translucent prop does not cast, and does not vanish.
SHADOW_TEST(Control, TranslucentCaster, Each)
{
  ShadowStage stage;
  vtkActor* box = Stand(stage);
  box->GetProperty()->SetOpacity(0.5);
  stage.SetPass(technique, Fine);
  stage.Render();
  const Picture with = stage.GetPicture();
  const ShadowOracle oracle(stage, { box });
  auto use = oracle.GetMask(box);
  std::size_t shown = 0;
  vtkShadowPass::SetReceiving(box, false); // its own V is not asked
  stage.Render();
  for (auto& pixel : use)
  {
    pixel = !pixel;
  }
  CheckAgainstOracle(technique, stage, { box }, "translucent box", use);
  box->VisibilityOff();
  stage.Render();
  const Picture without = stage.GetPicture();
  for (std::size_t i = 0; i < use.size(); ++i)
  {
    shown += !use[i] && with.Difference(without, i) > 2;
  }
  ShadowTest::CheckAtLeast(static_cast<double>(shown), 1000.0, "pixels where the box shows");
}

//------------------------------------------------------------------------------
// Wide, tall and tiny windows: the picture's shape moves no shadow.
SHADOW_TEST(Control, WindowShapes, Each)
{
  const int sizes[][2] = { { 230, 90 }, { 90, 230 }, { 61, 37 } };
  for (const auto& size : sizes)
  {
    ShadowStage stage(size[0], size[1]);
    Stand(stage);
    stage.SetPass(technique, Fine);
    stage.Render();
    const std::string what = std::to_string(size[0]) + " x " + std::to_string(size[1]);
    ShadowTest::CheckEqual(stage.GetVisibility().Width, size[0], what + ", width");
    ShadowTest::CheckEqual(stage.GetVisibility().Height, size[1], what + ", height");
    // Edges take the larger a share, the fewer pixels there are.
    auto* light = vtkLight::SafeDownCast(stage.Renderer->GetLights()->GetItemAsObject(0));
    ShadowTest::CheckAtMost(
      Compare(stage.GetVisibility(), ShadowOracle(stage).GetHard(light, technique), 0.5).Share,
      EdgeShare * 160.0 / size[1], what + ": pixels that differ");
  }
}

//------------------------------------------------------------------------------
// Two viewports of a window that is not square, each with a pass: each as if it were alone.
SHADOW_TEST(Control, TwoViewports, Each)
{
  ShadowStage stage(220, 130);
  Stand(stage);
  vtkNew<vtkRenderer> left;
  left->SetViewport(0.0, 0.0, 0.4, 1.0);
  left->SetBackground(0.5, 0.1, 0.1);
  left->AutomaticLightCreationOff();
  stage.Window->AddRenderer(left);
  stage.Renderer->SetViewport(0.4, 0.0, 1.0, 1.0);
  // The left one shows the same props from elsewhere.
  vtkPropCollection* props = stage.Renderer->GetViewProps();
  for (int i = 0; i < props->GetNumberOfItems(); ++i)
  {
    left->AddViewProp(vtkProp::SafeDownCast(props->GetItemAsObject(i)));
  }
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->PositionalOn();
  light->SetConeAngle(180.0);
  light->SetPosition(3.0, -1.0, 4.0);
  left->AddLight(light);
  left->GetActiveCamera()->SetPosition(-3.0, -6.0, 5.0);
  left->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 0.3);
  left->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
  left->ResetCameraClippingRange();
  stage.SetPass(technique, Fine);
  vtkSmartPointer<vtkShadowPass> rightPass = stage.Pass;
  vtkShadowPass* made = stage.SetPass(technique, Fine);
  left->SetPass(made);
  stage.Renderer->SetPass(rightPass);
  stage.Pass = rightPass;
  for (int frame = 0; frame < 2; ++frame)
  {
    stage.Render();
    CheckAgainstOracle(technique, stage, {}, "right, frame " + std::to_string(frame));
  }
  const Visibility visibility = stage.GetVisibility();
  ShadowTest::CheckEqual(visibility.Width, 132.0, "width of the right");
  ShadowTest::CheckEqual(visibility.Height, 130.0, "height of the right");
  const Picture both = stage.GetPicture();

  ShadowStage alone(132, 130);
  Stand(alone);
  alone.SetPass(technique, Fine);
  alone.Render();
  ShadowTest::Check(
    Same(alone.GetVisibility(), visibility), "V of the right is not that of it alone");
  const Picture single = alone.GetPicture();
  std::size_t wrong = 0;
  for (int y = 0; y < 130; ++y)
  {
    for (int x = 0; x < 132; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        wrong += std::abs(int(single.RGB[3 * (y * 132 + x) + c]) -
                          int(both.RGB[3 * (y * 220 + x + 88) + c])) > 1;
      }
    }
  }
  ShadowTest::CheckEqual(static_cast<double>(wrong), 0.0, "values of the right that differ");
  left->SetPass(nullptr);
}

//------------------------------------------------------------------------------
// Cells and props are found under a pass as without one.
SHADOW_TEST(Control, Picking, Each)
{
  ShadowStage stage;
  vtkActor* box = Stand(stage);
  stage.SetPass(technique);
  stage.Render();
  const Visibility before = stage.GetVisibility();
  const auto mask = ShadowOracle(stage).GetMask(box);
  std::size_t pixel = 0;
  std::size_t seen = 0;
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    // Half way through the box's pixels.
    seen += mask[i];
    pixel = mask[i] && seen == 1000 ? i : pixel;
  }
  const auto x = static_cast<unsigned int>(pixel % 160);
  const auto y = static_cast<unsigned int>(pixel / 160);
  vtkNew<vtkHardwareSelector> selector;
  selector->SetRenderer(stage.Renderer);
  selector->SetArea(x, y, x, y);
  auto selection = vtkSmartPointer<vtkSelection>::Take(selector->Select());
  bool found = false;
  for (unsigned int i = 0; i < selection->GetNumberOfNodes(); ++i)
  {
    found = found || selection->GetNode(i)->GetProperties()->Get(vtkSelectionNode::PROP()) == box;
  }
  ShadowTest::Check(found, "the box was not picked");
  stage.Render();
  ShadowTest::CheckAtMost(stage.Count("mapsDrawn"), 0.0, "maps drawn anew after the pick");
  ShadowTest::Check(Same(stage.GetVisibility(), before), "V after picking differs");
}

//------------------------------------------------------------------------------
// Peeling, FXAA and several samples a pixel go on below the pass.
SHADOW_TEST(Control, RendererFeatures, Each)
{
  const std::pair<const char*, std::function<void(ShadowStage&)>> features[] = {
    { "depth peeling",
      [](ShadowStage& stage)
      {
        stage.Renderer->UseDepthPeelingOn();
        stage.AddBox({ 1.5, 1.5, 0.5 }, { 0.5, 0.5, 1.0 })->GetProperty()->SetOpacity(0.4);
      } },
    { "FXAA", [](ShadowStage& stage) { stage.Renderer->UseFXAAOn(); } },
    { "samples", [](ShadowStage& stage) { stage.Window->SetMultiSamples(4); } },
    { "parallel camera",
      [](ShadowStage& stage)
      {
        stage.Renderer->GetActiveCamera()->ParallelProjectionOn();
        stage.Renderer->GetActiveCamera()->SetParallelScale(2.5);
      } },
  };
  for (const auto& feature : features)
  {
    ShadowStage stage;
    Stand(stage);
    feature.second(stage);
    stage.Render();
    const Picture plain = stage.GetPicture();
    stage.SetPass(technique, Fine);
    stage.Render();
    const Picture picture = stage.GetPicture();
    const Visibility visibility = stage.GetVisibility();
    ShadowTest::CheckNoMessage(feature.first);
    // Lit pixels that have only lit ones of the same surface around them are as VTK draws them; dark
    // ones are darker. (A pixel of several samples may show a shadow that begins behind an edge.)
    const auto inner = ShadowOracle(stage).GetInner(3);
    std::size_t lit = 0;
    std::size_t dark = 0;
    std::size_t wrong = 0;
    for (int y = 3; y < 157; ++y)
    {
      for (int x = 3; x < 157; ++x)
      {
        double low = 1.0;
        double high = 0.0;
        for (int k = 0; k < 49; ++k)
        {
          const double v = visibility(x + k % 7 - 3, y + k / 7 - 3);
          low = std::min(low, v);
          high = std::max(high, v);
        }
        const std::size_t i = y * 160 + x;
        if (!inner[i])
        {
          continue;
        }
        const bool darker = picture.RGB[3 * i] < plain.RGB[3 * i];
        if (visibility.Mask[i] && low == 1.0)
        {
          ++lit;
          wrong += picture.Difference(plain, i) > 1;
        }
        else if (visibility.Mask[i] && high == 0.0)
        {
          ++dark;
          wrong += !darker && plain.RGB[3 * i] > 60; // faces away from the light: dark anyway
        }
      }
    }
    ShadowTest::CheckAtLeast(
      static_cast<double>(lit), 3000.0, std::string(feature.first) + ", lit");
    ShadowTest::CheckAtLeast(
      static_cast<double>(dark), 300.0, std::string(feature.first) + ", dark");
    // The translucent box covers some 700 pixels of both.
    const bool translucent = stage.Renderer->GetUseDepthPeeling();
    ShadowTest::CheckAtMost(static_cast<double>(wrong), translucent ? 700.0 : 0.0,
      std::string(feature.first) + ", wrong");
    if (!translucent)
    {
      CheckAgainstOracle(technique, stage, {}, feature.first);
    }
  }
}
