// The pass among other passes, other windows, and what is no surface.

#include "ShadowOracle.h"
#include "ShadowTest.h"

#include "vtkGaussianBlurPass.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAAPass.h"
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
// A pass within another one that draws more pixels than the window has, on the borders (blur) or
// within each (SSAA): there are shadows, in their places, and what is lit is as without the pass.
// When the outer pass is taken off, the next frame tells.
SHADOW_TEST(Control, WithinAnotherPass, Each)
{
  for (const bool blurs : { true, false })
  {
    const std::string what = blurs ? "blur" : "SSAA";
    const auto makeOuter = [blurs](vtkRenderPass* delegate)
    {
      vtkSmartPointer<vtkRenderPass> outer;
      if (blurs)
      {
        vtkNew<vtkGaussianBlurPass> blur;
        blur->SetDelegatePass(delegate);
        outer = blur;
      }
      else
      {
        vtkNew<vtkSSAAPass> manySamples;
        manySamples->SetDelegatePass(delegate);
        outer = manySamples;
      }
      return outer;
    };
    ShadowStage stage;
    Build(stage, technique);
    vtkNew<vtkRenderStepsPass> steps;
    auto outer = makeOuter(steps);
    stage.Renderer->SetPass(outer);
    stage.Render();
    const Picture plain = stage.GetPicture();
    outer->ReleaseGraphicsResources(stage.Window);
    ShadowTest::CheckNoMessage(what + " without shadows");

    stage.SetPass(technique);
    stage.Render();
    const Visibility visibility = stage.GetVisibility();
    outer = makeOuter(stage.Pass);
    stage.Renderer->SetPass(outer);
    stage.Render();
    stage.Render();
    const Picture picture = stage.GetPicture();
    stage.GetVisibility();
    ShadowTest::CheckNoMessage(what + " of shadows");
    // Away from edges, behind which a shadow may begin that some samples of a pixel show.
    const auto inner = ShadowOracle(stage).GetInner(3);
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
        if (inner[i] && low == 1.0)
        {
          ++lit;
          wrong += picture.Difference(plain, i) > 1;
        }
        else if (inner[i] && high == 0.0 &&
                 plain.RGB[3 * i] > 60) // less is in shadow by its own slope
        {
          ++dark;
          wrong += picture.RGB[3 * i] >= plain.RGB[3 * i];
        }
      }
    }
    ShadowTest::CheckAtLeast(static_cast<double>(lit), 3000.0, what + ", lit pixels");
    ShadowTest::CheckAtLeast(static_cast<double>(dark), 100.0, what + ", dark pixels");
    ShadowTest::CheckEqual(static_cast<double>(wrong), 0.0, what + ", wrong pixels");

    stage.Renderer->SetPass(nullptr);
    stage.Render();
    ShadowTest::CheckEqual(
      static_cast<double>(stage.GetBytes()), 0.0, what + ", bytes after the next frame");
    outer->ReleaseGraphicsResources(stage.Window);
  }
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
