// SPDX-License-Identifier: BSD-3-Clause
// Frames of a scene that stands still add up to what all of their samples give (parameter accumulate).

#include "ShadowStage.h"
#include "ShadowTest.h"

#include "vtkCamera.h"
#include "vtkMapper.h"
#include "vtkPlane.h"
#include "vtkProperty.h"

#include <functional>
#include <string>
#include <utility>

namespace
{
/** Where the technique samples the lights: wedges by a count for each sample. */
Parameters Sampling(const std::string& samples, const std::string& wanted = "")
{
  Parameters parameters = { { "samples", samples }, { "overlap", "count" }, { "error", "0" },
    { "terminator", "facets" } };
  if (!wanted.empty())
  {
    parameters["accumulate"] = "on";
    parameters["accumulate-samples"] = wanted;
  }
  return parameters;
}

bool SamplesLights(const std::string& technique)
{
  return ShadowStage::Describe(technique).Traits.SamplesLights;
}

void Build(ShadowStage& stage, LightKind kind = LightKind::Rectangle)
{
  stage.AddThings();
  stage.AddLight(kind);
}
}

//------------------------------------------------------------------------------
// Four frames of 16 samples are as far from the technique's own answer by many samples as one of 64, within a
// tenth; of a single sample a frame too.
SHADOW_TEST(Accumulation, AddsUp, Each)
{
  if (!SamplesLights(technique))
  {
    return;
  }
  for (const LightKind kind : { LightKind::Rectangle, LightKind::Disk })
  {
    ShadowStage stage(200, 200);
    Build(stage, kind);
    const auto see = [&](const Parameters& parameters)
    {
      stage.SetPass(technique, parameters);
      int frames = 0;
      do
      {
        stage.Render();
        ++frames;
      } while (!stage.Pass->IsFinished() && frames < 100);
      return std::make_pair(stage.GetVisibility(), frames);
    };
    const auto truth = see(Sampling(technique == "wedges" ? "256" : "1024")).first;
    const double alone = Compare(see(Sampling("64")).first, truth).RMSE;
    const auto few = see(Sampling("16", "64"));
    const auto single = see(Sampling("1", "64"));
    ShadowTest::CheckEqual(few.second, 4, "frames of 16 samples");
    ShadowTest::CheckEqual(single.second, 64, "frames of one sample");
    const std::string name = GetName(kind);
    const double error = Compare(few.first, truth).RMSE;
    const double errorOfSingle = Compare(single.first, truth).RMSE;
    ShadowTest::CheckAtMost(error, 1.1 * alone, name + ": error of 4 x 16 samples");
    // A window on a plane hugs a frame's shadows, and has texels of its own.
    const bool windows = ShadowStage::Describe(technique).Traits.PlanarReceivers;
    ShadowTest::CheckAtMost(
      errorOfSingle, (windows ? 1.2 : 1.1) * alone, name + ": error of 64 x 1 samples");
    ShadowTest::CheckAtMost(alone, 0.5 * Compare(see(Sampling("16")).first, truth).RMSE,
      name + ": error of 64 samples, against 16");
  }
  ShadowTest::CheckNoMessage("frames that add up");
}

//------------------------------------------------------------------------------
// All samples taken, frames cost nothing and stay as they are; techniques that sample nothing are finished at once.
SHADOW_TEST(Accumulation, EndsAndCostsNothing, Each)
{
  ShadowStage stage(160, 160);
  Build(stage);
  stage.Render();
  const int before = stage.CountGLObjects();
  auto* pass = stage.SetPass(technique, Sampling("4", "10"));
  ShadowTest::Check(!pass->IsFinished(), "there is no frame yet");
  stage.Render();
  if (!SamplesLights(technique))
  {
    ShadowTest::Check(pass->IsFinished(), "nothing adds up");
    ShadowTest::CheckEqual(stage.Count("accumulatedFrames"), -1, "frames that add up");
    return;
  }
  ShadowTest::CheckEqual(stage.Count("accumulatedSamples"), 4, "samples of the first frame");
  stage.Render();
  ShadowTest::Check(!pass->IsFinished(), "two of three frames are not all");
  stage.Render();
  ShadowTest::Check(pass->IsFinished(), "three frames of 4 samples have the ten");
  ShadowTest::CheckEqual(stage.Count("accumulatedSamples"), 12, "samples of all frames");
  const Visibility mean = stage.GetVisibility();
  const Picture picture = stage.GetPicture();
  stage.Render();
  ShadowTest::Check(pass->IsFinished(), "it stays finished");
  const auto statistics = stage.GetStatistics();
  for (const char* name : { "light data", "receivers", "visibility" })
  {
    ShadowTest::Check(!statistics["milliseconds"].contains(name), std::string("no stage ") + name);
  }
  ShadowTest::CheckEqual(stage.Count("accumulatedSamples"), 12, "samples afterwards");
  ShadowTest::CheckEqual(Compare(stage.GetVisibility(), mean).Maximum, 0.0, "V stays");
  ShadowTest::Check(stage.GetPicture().RGB == picture.RGB, "so does the picture");
  pass->SetParameter("accumulate", "off");
  stage.Render();
  const Visibility plain = stage.GetVisibility();
  stage.SetPass(technique, Sampling("4"));
  stage.Render();
  ShadowTest::CheckEqual(
    Compare(plain, stage.GetVisibility()).Maximum, 0.0, "V once nothing adds up any more");
  stage.Renderer->SetPass(nullptr);
  stage.Render();
  ShadowTest::CheckEqual(stage.CountGLObjects(), before, "GL objects once the pass is gone");
  ShadowTest::CheckNoMessage("frames that add up");
}

//------------------------------------------------------------------------------
// Whatever visibility depends on starts anew, and is right at once; what it does not depend on does not.
SHADOW_TEST(Accumulation, ChangesStartAnew, Each)
{
  if (!SamplesLights(technique))
  {
    return;
  }
  ShadowStage stage(120, 120);
  vtkActor* box = stage.AddThings();
  vtkActor* glass = stage.AddQuad({ -4.0, -2.5, 0.5 }, { 8.0, 0.0, 0.0 }, { 0.0, 0.0, 4.0 });
  glass->GetProperty()->SetOpacity(0.3);
  vtkAreaLight* light = stage.AddLight(LightKind::Rectangle);
  auto* pass = stage.SetPass(technique, Sampling("4", "1024"));
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(0.0, 0.0, 100.0);
  plane->SetNormal(0.0, 0.0, -1.0);
  box->GetMapper()->AddClippingPlane(plane);
  const auto starts = [&](const std::string& what, const std::function<void()>& change)
  {
    stage.Render();
    stage.Render();
    const double frames = stage.Count("accumulatedFrames");
    change();
    stage.Render();
    ShadowTest::CheckEqual(stage.Count("accumulatedFrames"), 1, "frames after " + what);
    ShadowTest::CheckAtLeast(frames, 2, "frames before " + what);
    const Visibility seen = stage.GetVisibility();
    stage.Renderer->SetPass(nullptr);
    stage.Render();
    stage.Renderer->SetPass(pass);
    stage.Render();
    ShadowTest::CheckEqual(Compare(seen, stage.GetVisibility()).Maximum, 0.0,
      "V after " + what + ", off from that of a pass that begins");
  };
  ShadowTest::TakeMessages();
  starts("a moved box", [&] { box->AddPosition(0.1, 0.0, 0.0); });
  starts("a moved plane that cuts", [&] { plane->SetOrigin(0.0, 0.0, 0.7); });
  starts("a moved camera", [&] { stage.Renderer->GetActiveCamera()->Azimuth(3.0); });
  starts("a moved light", [&] { light->SetPosition(-2.2, -1.4, 4.0); });
  starts("a larger light", [&] { light->SetWidth(1.5 * light->GetWidth()); });
  starts("a moved glass", [&] { glass->AddPosition(0.0, 0.3, 0.0); });
  starts("a box that is gone", [&] { box->VisibilityOff(); });
  starts("a parameter", [&] { pass->SetParameter("terminator", "smooth"); });
  starts("another size", [&] { stage.Window->SetSize(140, 120); });
  stage.Render();
  const double frames = stage.Count("accumulatedFrames");
  stage.Renderer->GetActiveCamera()->Modified();
  stage.Renderer->SetBackground(0.3, 0.2, 0.1);
  stage.Render();
  ShadowTest::CheckEqual(stage.Count("accumulatedFrames"), frames + 1, "frames after no change");
  ShadowTest::TakeMessages();
}
