// SPDX-License-Identifier: BSD-3-Clause
// The pass with a delegate, in several windows, and with what is no surface. See also Composition.cxx.

#include "ShadowStage.h"
#include "ShadowTest.h"

#include "vtkCallbackCommand.h"
#include "vtkMapper.h"
#include "vtkRenderStepsPass.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

namespace
{
void Build(ShadowStage& stage, const std::string& technique)
{
  stage.AddThings();
  stage.AddLight(
    ShadowStage::Supports(technique, LightKind::Sphere) ? LightKind::Sphere : LightKind::Point);
}

std::size_t CountDifferences(const Picture& a, const Picture& b)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.RGB.size() / 3; ++i)
  {
    count += a.Difference(b, i) > 1;
  }
  return count;
}
}

//------------------------------------------------------------------------------
// VTK's own steps as the delegate: the picture is that of the default one.
SHADOW_TEST(Control, DelegatePass, Each)
{
  ShadowStage stage;
  Build(stage, technique);
  stage.SetPass(technique);
  stage.Render();
  const Picture expected = stage.GetPicture();
  const Visibility visibility = stage.GetVisibility();
  vtkNew<vtkRenderStepsPass> steps;
  stage.Pass->SetDelegatePass(steps);
  stage.Render();
  ShadowTest::CheckEqual(static_cast<double>(CountDifferences(stage.GetPicture(), expected)), 0.0,
    "pixels that differ from the default delegate's");
  ShadowTest::Check(Same(stage.GetVisibility(), visibility), "V differs");
  stage.Pass->SetDelegatePass(nullptr);
  stage.Render();
  ShadowTest::Check(Same(stage.GetPicture(), expected), "the default delegate's picture differs");
}

//------------------------------------------------------------------------------
// Two windows at once, in turns: contexts do not mix.
SHADOW_TEST(Control, TwoWindows, Each)
{
  ShadowStage first;
  Build(first, technique);
  first.SetPass(technique);
  first.Render();
  const Picture expected = first.GetPicture();
  const Visibility visibility = first.GetVisibility();
  {
    ShadowStage second(120, 90);
    Build(second, technique);
    second.AddBox({ 1.8, 1.0, 0.5 }, { 0.4, 0.4, 1.0 });
    second.SetPass(technique);
    for (int i = 0; i < 2; ++i)
    {
      second.Render();
      ShadowTest::CheckEqual(GetRange(second.GetVisibility()).first, 0.0, "shadow of the second");
      ShadowTest::Check(Same(first.GetVisibility(), visibility), "V of the first without a frame");
      first.Render();
      ShadowTest::Check(Same(first.GetPicture(), expected), "picture of the first");
      ShadowTest::Check(Same(first.GetVisibility(), visibility), "V of the first");
    }
  }
  first.Render();
  ShadowTest::Check(Same(first.GetPicture(), expected), "picture after the second window is gone");
}

//------------------------------------------------------------------------------
// Text lies over the shadows as over a plain picture.
SHADOW_TEST(Control, Overlay, Each)
{
  ShadowStage stage;
  Build(stage, technique);
  stage.SetPass(technique);
  stage.Render();
  const Picture without = stage.GetPicture();
  vtkNew<vtkTextActor> text;
  text->SetInput("Shadow");
  text->SetPosition(20, 30);
  text->GetTextProperty()->SetFontSize(30);
  text->GetTextProperty()->SetColor(1.0, 1.0, 0.0);
  stage.Renderer->AddViewProp(text);
  stage.Render();
  const Picture picture = stage.GetPicture();
  std::size_t yellow = 0;
  std::size_t other = 0;
  for (std::size_t i = 0; i < picture.RGB.size() / 3; ++i)
  {
    const bool changed = picture.Difference(without, i) > 0;
    yellow += changed && picture.RGB[3 * i] > 250 && picture.RGB[3 * i + 2] < 5;
    const auto x = i % 160;
    const auto y = i / 160;
    other += changed && (x < 18 || x > 150 || y < 18 || y > 70);
  }
  ShadowTest::CheckAtLeast(static_cast<double>(yellow), 200.0, "pixels of the text");
  ShadowTest::CheckEqual(static_cast<double>(other), 0.0, "other pixels that changed");
}

//------------------------------------------------------------------------------
// GetVisibility after the lights or, with forward evaluation, the props have changed: of the light that
// was meant, and of what is there now.
SHADOW_TEST(Control, VisibilityOfNow, Each)
{
  ShadowStage stage;
  stage.AddThings();
  vtkActor* box = stage.AddBox({ 1.8, -1.0, 0.5 }, { 0.5, 0.5, 1.0 });
  vtkLight* first = stage.AddLight(LightKind::Point);
  vtkLight* second = stage.AddLight(LightKind::Point, { 3.0, -2.0, 5.0 }, { 0.0, 0.0, 0.0 });
  stage.SetPass(technique);
  stage.Render();
  const Visibility before = stage.GetVisibility(second);
  ShadowTest::Check(Same(stage.GetVisibility(1), before), "number 1 is not the second light");
  first->SwitchOff();
  ShadowTest::Check(Same(stage.GetVisibility(second), before), "V of the second light changed");
  stage.Render();
  ShadowTest::Check(Same(stage.GetVisibility(0), before), "the second light is not number 0");
  stage.Render();
  const double rebuilt = stage.Count("castersRebuilt");
  stage.Renderer->RemoveActor(box);
  if (stage.GetStatistics()["evaluation"] == "forward")
  {
    const Visibility now = stage.GetVisibility(second);
    ShadowTest::CheckEqual(stage.Count("castersRebuilt"), rebuilt, "statistics of the frame");
    stage.Render();
    ShadowTest::Check(Same(stage.GetVisibility(second), now), "V is not of what is there now");
    ShadowTest::Check(!Same(now, before), "a box taken away changes nothing");
  }
}

//------------------------------------------------------------------------------
// What is drawn may take the pass off its renderer: this frame is still drawn, the next has none.
SHADOW_TEST(Control, TakenOffWhileRendering, Each)
{
  ShadowStage stage;
  vtkActor* box = stage.AddThings();
  stage.AddLight(LightKind::Point);
  stage.Render();
  const Picture plain = stage.GetPicture();
  stage.SetPass(technique);
  stage.Render();
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(stage.Renderer.Get());
  command->SetCallback([](vtkObject*, unsigned long, void* renderer, void*)
    { static_cast<vtkRenderer*>(renderer)->SetPass(nullptr); });
  const unsigned long observer =
    box->GetMapper()->AddObserver(vtkCommand::UpdateShaderEvent, command);
  stage.Render();
  box->GetMapper()->RemoveObserver(observer);
  ShadowTest::CheckEqual(static_cast<double>(stage.GetBytes()), 0.0, "bytes");
  stage.Render();
  ShadowTest::Check(Same(stage.GetPicture(), plain), "not the picture of no pass");
  ShadowTest::CheckNoMessage("taken off");
}
