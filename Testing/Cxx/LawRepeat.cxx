// SPDX-License-Identifier: BSD-3-Clause
// Laws: the same scene gives the same picture, however it was come to and evaluated.

#include "ShadowStage.h"
#include "ShadowTest.h"

#include "vtkCamera.h"
#include "vtkProperty.h"

#include <cmath>

namespace
{
LightKind GetKind(const std::string& technique)
{
  return ShadowStage::Supports(technique, LightKind::Rectangle) ? LightKind::Rectangle
                                                                : LightKind::Point;
}
}

//------------------------------------------------------------------------------
SHADOW_TEST(Law, TwoRunsAreTheSame, Each)
{
  Visibility visibility[2];
  Picture picture[2];
  for (int run = 0; run < 2; ++run)
  {
    ShadowStage stage;
    stage.AddThings();
    stage.AddLight(GetKind(technique));
    stage.SetPass(technique);
    stage.Render();
    picture[run] = stage.GetPicture();
    visibility[run] = stage.GetVisibility();
    // The next frame is the same too, and asking for the visibility left no trace in it.
    stage.Render();
    ShadowTest::Check(Same(stage.GetPicture(), picture[run]), "the second frame differs");
    ShadowTest::Check(Same(stage.GetVisibility(), visibility[run]), "the second frame's V differs");
  }
  ShadowTest::Check(Same(picture[0], picture[1]), "the second run's picture differs");
  ShadowTest::Check(Same(visibility[0], visibility[1]), "the second run's V differs");
  ShadowTest::CheckEqual(GetRange(visibility[0]).first, 0.0, "there is a shadow");
}

//------------------------------------------------------------------------------
// Light data that was kept or rebuilt in place gives the frame that a new pass gives, bit by bit:
// whatever came before.
SHADOW_TEST(Law, ReusedFrameIsTheSame, Each)
{
  ShadowStage stage;
  vtkActor* box = stage.AddThings();
  vtkAreaLight* light = stage.AddLight(GetKind(technique));
  stage.SetPass(technique);
  stage.Render();
  const Visibility expected = stage.GetVisibility();
  const Picture picture = stage.GetPicture();
  const auto check = [&](const std::string& what)
  {
    stage.Render();
    ShadowTest::Check(Same(stage.GetPicture(), picture), what + ": picture differs");
    const Visibility visibility = stage.GetVisibility();
    ShadowTest::Check(Same(visibility, expected),
      what + ": V differs, by at most " + std::to_string(Compare(visibility, expected).Maximum));
  };

  // Away so far that no prop is in the picture.
  stage.LookAt({ 30.0, 0.0, 4.0 }, { 60.0, 0.0, 4.0 });
  stage.Render();
  ShadowTest::CheckEqual(static_cast<double>(stage.GetVisibility().GetNumberOfReceivers()), 0.0,
    "receivers out of view");
  stage.LookAt({ 3.5, -6.5, 4.5 }, { 0.2, 0.2, 0.3 });
  check("camera away and back");

  stage.Window->SetSize(100, 70);
  stage.Render();
  stage.Window->SetSize(160, 160);
  check("window smaller and back");

  double position[3];
  light->GetPosition(position);
  light->SetPosition(2.0, 1.0, 3.0);
  stage.Render();
  light->SetPosition(position);
  check("light away and back");

  box->SetPosition(0.5, -1.0, 0.2);
  stage.Render();
  box->SetPosition(0.0, 0.0, 0.0);
  check("box away and back");

  box->VisibilityOff();
  stage.Render();
  box->VisibilityOn();
  check("box hidden and shown");

  light->SwitchOff();
  stage.Render();
  light->SwitchOn();
  check("light off and on");

  stage.Renderer->SetPass(nullptr);
  stage.Render();
  stage.Renderer->SetPass(stage.Pass);
  check("pass off and on");

  stage.SetPass(technique);
  check("a new pass on the same props");

  // A scene that was out of the picture in the first frame of the pass.
  stage.LookAt({ 30.0, 0.0, 4.0 }, { 60.0, 0.0, 4.0 });
  stage.SetPass(technique);
  stage.Render();
  stage.LookAt({ 3.5, -6.5, 4.5 }, { 0.2, 0.2, 0.3 });
  check("panned in");
}

//------------------------------------------------------------------------------
// The picture is VTK's with each light's colour times 1 - A (1 - V), by either road of evaluation.
// Ambient and specular light are off, so the picture is just that product. Both pictures are rounded
// to 8 bits: a difference of 1. Evaluated forward, edges move by what the 12-bit normal of the
// screen-space buffer moves the bias: hundredths of a texel, of 500 pixels at edges one or two.
SHADOW_TEST(Law, PictureIsVTKsTimesVisibility, Each)
{
  for (const std::string evaluation : { "auto", "forward", "screen" })
  {
    ShadowStage stage;
    stage.AddThings();
    vtkAreaLight* light = stage.AddLight(GetKind(technique));
    light->SetShadowAttenuation(0.7);
    stage.Renderer->SetBackground(0.0, 0.0, 0.0);
    vtkPropCollection* props = stage.Renderer->GetViewProps();
    for (int i = 0; i < props->GetNumberOfItems(); ++i)
    {
      vtkProperty* property = vtkActor::SafeDownCast(props->GetItemAsObject(i))->GetProperty();
      property->SetAmbient(0.0);
      property->SetDiffuse(1.0);
    }
    stage.Render();
    const Picture without = stage.GetPicture();
    stage.SetPass(technique, { { "evaluation", evaluation } });
    stage.Render();
    const std::string used = stage.GetStatistics()["evaluation"];
    if (evaluation == "forward" && used == "screen")
    {
      ShadowTest::CheckOneMessage(
        ShadowTest::Message::Warning, { technique, "forward" }, "a technique without that road");
    }
    else
    {
      ShadowTest::Check(evaluation == "auto" || used == evaluation, "evaluated otherwise: " + used);
    }
    const Picture with = stage.GetPicture();
    const Visibility visibility = stage.GetVisibility();
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < visibility.V.size(); ++i)
    {
      const double factor = 1.0 - 0.7 * (1.0 - visibility.V[i]);
      for (int c = 0; c < 3; ++c)
      {
        if (std::abs(with.RGB[3 * i + c] - factor * without.RGB[3 * i + c]) > 1.5)
        {
          ++wrong;
          break;
        }
      }
    }
    const std::string what = "evaluation=" + evaluation + " (" + used + ")";
    ShadowTest::CheckAtMost(static_cast<double>(wrong), used == "screen" ? 0.0 : 5.0,
      what + ": pixels other than V tells");
    ShadowTest::Check(!Same(with, without), what + ": no shadow in the picture");
  }
}
