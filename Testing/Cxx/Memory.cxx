// SPDX-License-Identifier: BSD-3-Clause
// What is held on the GPU: no more than is told, and nothing once shadows are off.

#include "ShadowStage.h"
#include "ShadowTest.h"

#include "vtkLightCollection.h"

namespace
{
void Build(ShadowStage& stage, const std::string& technique)
{
  stage.AddThings();
  stage.AddSphere({ -2.0, -1.5, 0.8 }, 0.5, 64);
  stage.AddLight(
    ShadowStage::Supports(technique, LightKind::Sphere) ? LightKind::Sphere : LightKind::Point);
}
}

//------------------------------------------------------------------------------
// Casters: 16 bytes a vertex and 12 a triangle, with room for 8 more a vertex. Matrices are few.
SHADOW_TEST(Memory, CastersAreSmall, Each)
{
  ShadowStage stage;
  Build(stage, technique);
  stage.SetPass(technique);
  stage.Render();
  const auto statistics = stage.GetStatistics();
  const double vertices = statistics["counts"]["vertices"];
  const double triangles = statistics["counts"]["triangles"];
  ShadowTest::CheckAtLeast(triangles, 8000.0, "triangles"); // two spheres, two boxes, the floor
  ShadowTest::CheckAtMost(triangles, 9200.0, "triangles");
  ShadowTest::CheckAtMost(
    statistics["bytes"]["casters"], 24.0 * vertices + 12.0 * triangles, "bytes of casters");
  double sum = 0.0;
  for (const auto& entry : statistics["bytes"].items())
  {
    sum += entry.key() == "total" ? 0.0 : entry.value().get<double>();
  }
  ShadowTest::CheckEqual(statistics["bytes"]["total"], sum, "the sum of all bytes");
  ShadowTest::CheckAtLeast(sum, 1.0, "the sum of all bytes");
}

//------------------------------------------------------------------------------
// A pass that is taken off the renderer frees all at once, without a further frame, though the
// caller keeps it; and so does one that nobody keeps. What is left in the context is what was there.
SHADOW_TEST(Memory, TakingThePassOffFreesAll, Each)
{
  ShadowStage stage;
  Build(stage, technique);
  stage.Render();
  const int plain = stage.CountGLObjects();
  stage.SetPass(technique);
  stage.Render();
  stage.GetVisibility();
  const int shadowed = stage.CountGLObjects();
  ShadowTest::CheckAtLeast(static_cast<double>(stage.GetBytes()), 1.0, "bytes held");
  ShadowTest::CheckAtLeast(shadowed, plain + 1.0, "objects held");
  stage.Renderer->SetPass(nullptr);
  ShadowTest::CheckEqual(static_cast<double>(stage.GetBytes()), 0.0, "bytes, kept by the caller");
  ShadowTest::CheckEqual(stage.CountGLObjects(), plain, "objects, kept by the caller");

  stage.SetPass(technique);
  stage.Render();
  stage.GetVisibility();
  stage.Pass = nullptr;
  stage.Renderer->SetPass(nullptr);
  ShadowTest::CheckEqual(stage.CountGLObjects(), plain, "objects, not kept");
  stage.Render();
}

//------------------------------------------------------------------------------
SHADOW_TEST(Memory, AnotherPassTakesItsPlace, Each)
{
  ShadowStage stage;
  Build(stage, technique);
  vtkSmartPointer<vtkShadowPass> first = stage.SetPass(technique);
  stage.Render();
  stage.SetPass(technique);
  stage.Render();
  const auto bytes = nlohmann::json::parse(first->GetStatistics())["bytes"]["total"];
  ShadowTest::CheckEqual(bytes, 0.0, "bytes of the first pass");
  ShadowTest::CheckAtLeast(static_cast<double>(stage.GetBytes()), 1.0, "bytes of the second");
}

//------------------------------------------------------------------------------
SHADOW_TEST(Memory, FinalizeFreesAll, Each)
{
  ShadowStage stage;
  Build(stage, technique);
  stage.SetPass(technique);
  stage.Render();
  ShadowTest::CheckAtLeast(static_cast<double>(stage.GetBytes()), 1.0, "bytes held");
  stage.Window->Finalize();
  ShadowTest::CheckEqual(static_cast<double>(stage.GetBytes()), 0.0, "bytes after Finalize");
  ShadowTest::CheckNoMessage("Finalize");

  // And the window comes back to life with the next frame.
  stage.Render();
  ShadowTest::CheckEqual(GetRange(stage.GetVisibility()).first, 0.0, "shadow after Finalize");
}

//------------------------------------------------------------------------------
SHADOW_TEST(Memory, OnAndOffLeavesTheSame, Each)
{
  ShadowStage stage;
  Build(stage, technique);
  stage.SetPass(technique);
  stage.Render();
  stage.GetVisibility();
  const auto bytes = static_cast<double>(stage.GetBytes());
  int objects = 0;
  // VTK's mappers make timers of their own at their hundredth draw: 100 times after that.
  const int first = 50;
  for (int i = 0; i <= first + 100; ++i)
  {
    stage.Renderer->SetPass(nullptr);
    stage.Render();
    stage.Renderer->SetPass(stage.Pass);
    stage.Render();
    stage.GetVisibility();
    objects = i == first ? stage.CountGLObjects() : objects;
  }
  ShadowTest::CheckEqual(static_cast<double>(stage.GetBytes()), bytes, "bytes");
  ShadowTest::CheckEqual(stage.CountGLObjects(), objects, "objects");
}

//------------------------------------------------------------------------------
// Frames of a scene that keeps changing hold no more than the first.
SHADOW_TEST(Memory, ChangingFramesDoNotGrow, Each)
{
  ShadowStage stage;
  Build(stage, technique);
  auto* light = vtkLight::SafeDownCast(stage.Renderer->GetLights()->GetItemAsObject(0));
  vtkActor* box = stage.AddBox({ 2.0, -1.0, 0.5 }, { 0.5, 0.5, 1.0 });
  stage.SetPass(technique);
  double bytes = 0.0;
  int objects = 0;
  for (int i = 0; i < 12; ++i)
  {
    light->SetPosition(
      -2.5 + 0.1 * (i % 9), -2.0, 5.5); // back to where it was: lights cost as they stand
    box->SetPosition(0.1 * (i % 3), 0.0, 0.0);
    stage.Window->SetSize(160 - 8 * (i % 3), 160);
    stage.Render();
    stage.GetVisibility();
    if (i == 2)
    {
      bytes = static_cast<double>(stage.GetBytes());
      objects = stage.CountGLObjects();
    }
  }
  ShadowTest::CheckEqual(static_cast<double>(stage.GetBytes()), bytes, "bytes");
  ShadowTest::CheckEqual(stage.CountGLObjects(), objects, "objects");
}

//------------------------------------------------------------------------------
// What GetVisibility needs beyond the frame's own goes again with the next frame but one.
SHADOW_TEST(Memory, VisibilityIsGivenBack, Each)
{
  ShadowStage stage;
  Build(stage, technique);
  stage.SetPass(technique);
  stage.Render();
  const auto bytes = static_cast<double>(stage.GetBytes());
  stage.GetVisibility();
  stage.Render();
  stage.Render();
  ShadowTest::CheckEqual(static_cast<double>(stage.GetBytes()), bytes, "bytes");
}
