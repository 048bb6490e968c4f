// The pass among other passes, other windows, and what is no surface.

#include "ShadowStage.h"
#include "ShadowTest.h"

#include "vtkGaussianBlurPass.h"
#include "vtkRenderStepsPass.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include <algorithm>

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
// A pass within another: there are shadows, and they go with it. When the outer pass is taken off,
// the next frame tells.
SHADOW_TEST(Control, WithinAnotherPass, Each)
{
  ShadowStage stage;
  Build(stage, technique);
  vtkNew<vtkGaussianBlurPass> plainBlur;
  vtkNew<vtkRenderStepsPass> steps;
  plainBlur->SetDelegatePass(steps);
  stage.Renderer->SetPass(plainBlur);
  stage.Render();
  const Picture plain = stage.GetPicture();
  ShadowTest::CheckNoMessage("blur without shadows");

  stage.SetPass(technique);
  stage.Render();
  const Visibility expected = stage.GetVisibility();
  vtkNew<vtkGaussianBlurPass> blur;
  blur->SetDelegatePass(stage.Pass);
  stage.Renderer->SetPass(blur);
  stage.Render();
  stage.Render();
  const Picture picture = stage.GetPicture();
  ShadowTest::CheckNoMessage("blur of shadows");
  const Visibility visibility = stage.GetVisibility();
  ShadowTest::Check(Same(visibility, expected), "V within the blur differs");
  std::size_t wrong = 0;
  std::size_t lit = 0;
  std::size_t dark = 0;
  for (int y = 4; y < 156; ++y)
  {
    for (int x = 4; x < 156; ++x)
    {
      // The blur reaches 2 pixels.
      double low = 1.0;
      double high = 0.0;
      for (int k = 0; k < 49; ++k)
      {
        low = std::min<double>(low, visibility(x + k % 7 - 3, y + k / 7 - 3));
        high = std::max<double>(high, visibility(x + k % 7 - 3, y + k / 7 - 3));
      }
      const std::size_t i = y * 160 + x;
      if (low == 1.0)
      {
        ++lit;
        wrong += picture.Difference(plain, i) > 1;
      }
      else if (high == 0.0 && plain.RGB[3 * i] > 60) // less is in shadow by its own slope
      {
        ++dark;
        wrong += picture.RGB[3 * i] >= plain.RGB[3 * i];
      }
    }
  }
  ShadowTest::CheckAtLeast(static_cast<double>(lit), 3000.0, "lit pixels");
  ShadowTest::CheckAtLeast(static_cast<double>(dark), 100.0, "dark pixels");
  ShadowTest::CheckEqual(static_cast<double>(wrong), 0.0, "wrong pixels");

  stage.Renderer->SetPass(nullptr);
  stage.Render();
  ShadowTest::CheckEqual(static_cast<double>(stage.GetBytes()), 0.0, "bytes after the next frame");
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
