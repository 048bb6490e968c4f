// SPDX-License-Identifier: BSD-3-Clause
// The technique auto is the one that it has chosen, bit by bit: so it has all of that one's laws, and those that
// run over every technique need not try all candidates again. Here is what is its own: that it chooses right,
// keeps its choice, and comes to rest.

#include "ShadowStage.h"
#include "ShadowTest.h"

#include "vtkCamera.h"
#include "vtkShadowTechniques.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace
{
vtkShadowPass* Choose(ShadowStage& stage, const Parameters& parameters)
{
  stage.Pass = vtkSmartPointer<vtkShadowPass>::Take(vtkShadowTechniques::Create("auto"));
  stage.Pass->SetParameter("terminator", "facets");
  for (const auto& parameter : parameters)
  {
    stage.Pass->SetParameter(parameter.first, parameter.second);
  }
  stage.Renderer->SetPass(stage.Pass);
  stage.Render();
  return stage.Pass;
}

/** RMSE in penumbrae. */
double FindError(ShadowStage& stage, const Visibility& truth)
{
  std::vector<unsigned char> penumbra(truth.V.size());
  for (std::size_t i = 0; i < truth.V.size(); ++i)
  {
    penumbra[i] = truth.Mask[i] != 0 && truth.V[i] > 0.02f && truth.V[i] < 0.98f ? 1 : 0;
  }
  return Compare(stage.GetVisibility(), truth, 0.1, penumbra).RMSE;
}

Visibility FindTruth(ShadowStage& stage)
{
  stage.SetPass(
    "ray-traced", { { "samples", "1024" }, { "seed", "7" }, { "terminator", "facets" } });
  stage.Render();
  return stage.GetVisibility();
}

bool HasTried(ShadowStage& stage)
{
  return stage.Count("candidatesTried") > 0.0;
}
}

//------------------------------------------------------------------------------
SHADOW_TEST(Automatic, IsWhatItChose, Once)
{
  for (const char* error : { "0.3", "0.02" })
  {
    ShadowStage stage(160, 160);
    stage.AddThings();
    stage.AddLight(LightKind::Rectangle);
    Choose(stage, { { "error", error } });
    const Visibility seen = stage.GetVisibility();
    const Picture picture = stage.GetPicture();
    const auto chosen = stage.GetStatistics()["choice"]["chosen"];
    const std::string name = chosen["technique"];
    ShadowTest::Check(name != "auto" && !stage.GetStatistics()["choice"]["why"].empty(),
      "it names what it chose, and why: " + chosen.dump());
    ShadowTest::CheckAtLeast(
      static_cast<double>(stage.GetStatistics()["choice"]["tried"].size()), 3.0, "candidates");
    stage.Pass = vtkSmartPointer<vtkShadowPass>::Take(vtkShadowTechniques::Create(name));
    stage.Pass->SetParameter("terminator", "facets");
    for (const auto& parameter : chosen["parameters"].items())
    {
      stage.Pass->SetParameter(parameter.key(), parameter.value().get<std::string>());
    }
    stage.Renderer->SetPass(stage.Pass);
    stage.Render();
    ShadowTest::CheckEqual(
      Compare(seen, stage.GetVisibility()).Maximum, 0.0, "V of " + name + ", off from auto's");
    ShadowTest::Check(Same(picture, stage.GetPicture()), "so is the picture");
  }
  ShadowTest::CheckNoMessage("a choice");
}

//------------------------------------------------------------------------------
// The upper end of a 95 % interval of some thousand pixels is within the error: so is the truth, but for a
// twentieth of it.
SHADOW_TEST(Automatic, HoldsTheError, Once)
{
  for (const LightKind kind : { LightKind::Rectangle, LightKind::Sphere })
  {
    ShadowStage stage(240, 240);
    stage.AddThings();
    stage.AddLight(kind);
    const Visibility truth = FindTruth(stage);
    for (const double error : { 0.1, 0.05, 0.02 })
    {
      auto* pass = Choose(stage, { { "error", std::to_string(error) } });
      for (int frame = 0; frame < 100 && !pass->IsFinished(); ++frame)
      {
        stage.Render();
      }
      ShadowTest::CheckAtMost(FindError(stage, truth), 1.05 * error,
        std::string(GetName(kind)) + ": error of " +
          stage.GetStatistics()["choice"]["chosen"]["technique"].get<std::string>());
    }
  }
  ShadowTest::CheckNoMessage("choices");
}

//------------------------------------------------------------------------------
SHADOW_TEST(Automatic, KeepsItsChoice, Once)
{
  ShadowStage stage(120, 120);
  vtkActor* box = stage.AddThings();
  vtkAreaLight* light = stage.AddLight(LightKind::Rectangle);
  stage.Render();
  const int before = stage.CountGLObjects();
  auto* pass = Choose(stage, { { "error", "0.1" } });
  ShadowTest::Check(HasTried(stage), "the first frame tries candidates");
  const auto keeps = [&](const std::string& what)
  {
    stage.Render();
    ShadowTest::Check(!HasTried(stage), "nothing is tried for " + what);
  };
  keeps("the same again");
  stage.Renderer->GetActiveCamera()->Azimuth(5.0);
  keeps("another view");
  box->AddPosition(0.1, 0.0, 0.0);
  keeps("a box that moves");
  light->SetPosition(-2.0, -1.5, 4.5);
  keeps("a light that moves");
  stage.Window->SetSize(130, 110);
  keeps("a size that is about the same");
  pass->SetParameter("error", 0.2);
  stage.Render();
  ShadowTest::Check(HasTried(stage), "another error is another choice");
  const auto changes = [&](const std::string& what)
  {
    stage.Render(); // sees it
    stage.Render();
    ShadowTest::Check(HasTried(stage), "candidates are tried for " + what);
    keeps("the frame after " + what);
  };
  stage.Window->SetSize(300, 300);
  changes("six times the pixels");
  stage.AddSphere({ 1.0, 1.0, 1.5 }, 0.4, 60);
  changes("many more triangles");
  stage.AddLight(LightKind::Sphere, { 3.0, -2.0, 5.0 }, { 0.0, 0.0, 0.0 });
  changes("a light more");
  stage.Renderer->SetPass(nullptr);
  stage.Render();
  ShadowTest::CheckAtMost(stage.CountGLObjects() - before, 8.0,
    "GL objects once the pass is gone, but for what was added");
  ShadowTest::CheckNoMessage("choices");
}

//------------------------------------------------------------------------------
// A time that nothing has is the fastest's, and once nothing moves frames add up to the error.
SHADOW_TEST(Automatic, ComesToRest, Once)
{
  ShadowStage stage(160, 160);
  vtkActor* box = stage.AddThings();
  stage.AddLight(LightKind::Rectangle);
  const double error = 0.02;
  auto* pass = Choose(stage, { { "error", std::to_string(error) }, { "time", "0.001" } });
  const auto choice = stage.GetStatistics()["choice"];
  ShadowTest::Check(choice.contains("atRest"), "there is one for rest: " + choice["why"].dump());
  const auto rest = [&]
  {
    int frames = 0;
    while (!pass->IsFinished() && frames < 2000)
    {
      stage.Render();
      ++frames;
    }
    ShadowTest::Check(pass->IsFinished(), "it comes to rest");
    ShadowTest::CheckAtLeast(stage.Count("accumulatedSamples"),
      choice["atRest"]["samples"].get<double>(), "samples at rest");
  };
  ShadowTest::Check(!pass->IsFinished(), "the first frame is not all");
  rest();
  box->AddPosition(0.05, 0.0, 0.0);
  stage.Render();
  ShadowTest::Check(!pass->IsFinished(), "nor is one that has moved");
  ShadowTest::CheckEqual(stage.Count("accumulatedSamples"), -1, "samples while it moves");
  rest();
  const Visibility seen = stage.GetVisibility();
  vtkSmartPointer<vtkShadowPass> kept = stage.Pass;
  const Visibility truth = FindTruth(stage);
  stage.Pass = kept;
  stage.Renderer->SetPass(kept);
  stage.Render();
  stage.Render();
  rest();
  ShadowTest::CheckAtMost(FindError(stage, truth), 1.1 * error, "error at rest");
  ShadowTest::CheckEqual(
    Compare(seen, stage.GetVisibility()).Maximum, 0.0, "rest is the same again");
  ShadowTest::CheckNoMessage("a choice");
}
