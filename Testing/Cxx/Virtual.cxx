// SPDX-License-Identifier: BSD-3-Clause
// What virtual-maps promises: closed forms by each metric, tiles that are kept bit by bit, memory
// within its budget, and fewer texels for softer shadows.

#include "ShadowOracle.h"
#include "ShadowTest.h"

#include "vtkCellArray.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkShadowScenes.h"
#include "vtkVirtualConservative.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace
{
using ShadowTest::Message;

constexpr const char* Name = "virtual-maps";

struct Errors
{
  double All = 0.0;
  double Penumbra = 0.0;
};

/** Against the closed form of the scene `blocker`. */
Errors MeasureBlocker(const Parameters& parameters)
{
  ShadowStage stage(400, 400);
  vtkShadowScenes::Build("blocker", stage.Renderer);
  auto* floor = vtkActor::SafeDownCast(stage.Renderer->GetViewProps()->GetItemAsObject(0));
  stage.SetPass(Name, parameters);
  stage.Render();
  const Visibility visibility = stage.GetVisibility();
  const ShadowOracle oracle(stage);
  const auto inner = oracle.GetInner(1);
  auto use = oracle.GetMask(floor);
  Visibility truth = visibility;
  auto penumbra = use;
  for (std::size_t i = 0; i < use.size(); ++i)
  {
    const glm::dvec3& p = oracle.GetPixels()[i].Position;
    use[i] = use[i] && inner[i];
    truth.V[i] = static_cast<float>(vtkShadowScenes::BlockerVisibility(p.x, p.y));
    penumbra[i] = use[i] && truth.V[i] > 0.02f && truth.V[i] < 0.98f;
  }
  return { Compare(visibility, truth, 0.1, use).RMSE,
    Compare(visibility, truth, 0.1, penumbra).RMSE };
}

void Build(ShadowStage& stage)
{
  stage.AddThings();
  stage.AddLight(LightKind::Rectangle);
}
}

// ------------------------------------------------------------------------------ With one map of
// the whole light the filter is exact but for texels: 2048 of them across a penumbra of half the
// map. By the metrics a penumbra has up to 21 texels: its edges are off by half of one at most, of
// either sign.
SHADOW_TEST(Virtual, ClosedForm, Once)
{
  for (const std::string cache : { "on", "off" })
  {
    const Errors fixed =
      MeasureBlocker({ { "metric", "none" }, { "resolution", "2048" }, { "cache", cache } });
    ShadowTest::CheckAtMost(fixed.All, 0.005, "one map, cache " + cache + ": RMSE");
    ShadowTest::CheckAtMost(fixed.Penumbra, 0.012, "one map, cache " + cache + ": in the penumbra");
    for (const std::string metric : { "dynamic", "static" })
    {
      const Errors errors = MeasureBlocker({ { "metric", metric }, { "cache", cache } });
      ShadowTest::CheckAtMost(errors.All, 0.015, metric + ", cache " + cache + ": RMSE");
      ShadowTest::CheckAtMost(
        errors.Penumbra, 0.035, metric + ", cache " + cache + ": in the penumbra");
    }
  }
}

// ------------------------------------------------------------------------------ A camera that
// comes back finds its pages, and sees the same to the bit; so does one that never left.
SHADOW_TEST(Virtual, PagesAreKept, Once)
{
  ShadowStage stage;
  Build(stage);
  stage.SetPass(Name);
  stage.Render();
  const Visibility first = stage.GetVisibility();
  ShadowTest::CheckAtLeast(stage.Count("tilesDrawn"), 1.0, "pages drawn at first");
  stage.Render();
  ShadowTest::CheckEqual(stage.Count("tilesDrawn"), 0.0, "pages drawn for the same picture");
  ShadowTest::CheckEqual(stage.Count("tilesKept"), stage.Count("tiles"), "pages kept");
  stage.LookAt({ 4.0, -5.0, 6.0 }, { 0.0, 0.2, 0.3 });
  stage.Render();
  stage.LookAt({ 3.5, -6.5, 4.5 }, { 0.2, 0.2, 0.3 });
  stage.Render();
  ShadowTest::CheckEqual(stage.Count("tilesDrawn"), 0.0, "pages drawn for a camera that is back");
  ShadowTest::Check(Same(stage.GetVisibility(), first), "kept pages show another V");
  // In a new pass all are drawn anew.
  stage.SetPass(Name);
  stage.Render();
  ShadowTest::CheckEqual(stage.Count("tilesKept"), 0.0, "pages kept by a new pass");
  ShadowTest::Check(Same(stage.GetVisibility(), first), "pages drawn anew show another V");
}

//------------------------------------------------------------------------------
// A lamp close above a box, which hides all of the floor from it as far as that goes: what a kernel,
// wider than the map by far, has beyond the light's plane, leaves nothing of the light free. What is
// left is light along the horizon: a strip 1/50 high as a tangent, and half a texel, of kernels that
// reach down by one at least.
SHADOW_TEST(Virtual, LampCloseAboveABox, Once)
{
  for (const double distance : { 0.01, 0.001 })
  {
    ShadowStage stage(100, 100);
    vtkActor* floor = stage.AddFloor();
    stage.AddBox({ 0.0, 0.0, 0.6 }, { 1.0, 1.0, 1.2 });
    vtkAreaLight* light =
      stage.AddLight(LightKind::Rectangle, { 0.0, 0.0, 1.2 + distance }, { 0.0, 0.0, 0.0 });
    light->SetWidth(0.1);
    light->SetHeight(0.1);
    stage.LookAt({ 3.5, -6.5, 4.5 }, { 0.2, 0.2, 0.3 });
    stage.SetPass(Name);
    stage.Render();
    const Visibility visibility = stage.GetVisibility();
    Visibility dark = visibility;
    std::fill(dark.V.begin(), dark.V.end(), 0.0f);
    const auto use = ShadowOracle(stage).GetMask(floor);
    ShadowTest::CheckAtMost(Compare(visibility, dark, 0.5, use).Bias, 0.03,
      "mean visibility on the floor, lamp at " + std::to_string(distance));
  }
}

//------------------------------------------------------------------------------
// What moves drops the pages that it is in, before and after, and no others; and none is stale.
SHADOW_TEST(Virtual, PagesUnderWhatMovesAreDropped, Once)
{
  const auto build = [](ShadowStage& stage)
  {
    stage.AddFloor(8.0);
    stage.AddBox({ -5.0, 0.0, 1.0 }, { 2.0, 3.0, 2.0 });
    vtkActor* mover = stage.AddBox({ 4.0, 0.0, 0.6 }, { 0.4, 0.4, 0.4 });
    stage.AddLight(LightKind::Rectangle, { 0.0, 0.0, 12.0 }, { 0.0, 0.0, 0.0 });
    stage.LookAt({ 0.0, -12.0, 9.0 }, { 0.0, 0.0, 0.0 }, 60.0);
    return mover;
  };
  const Parameters parameters = { { "resolution", "64" } };
  ShadowStage stage(200, 200);
  vtkActor* mover = build(stage);
  stage.SetPass(Name, parameters);
  stage.Render();
  const double tiles = stage.Count("tiles");
  mover->SetPosition(0.05, 0.02, 0.0);
  stage.Render();
  ShadowTest::CheckAtLeast(stage.Count("tilesDrawn"), 1.0, "pages drawn");
  ShadowTest::CheckAtMost(stage.Count("tilesDrawn"), 0.5 * tiles, "pages drawn, of all");
  const Visibility kept = stage.GetVisibility();
  ShadowStage fresh(200, 200);
  build(fresh)->SetPosition(0.05, 0.02, 0.0);
  fresh.SetPass(Name, parameters);
  fresh.Render();
  ShadowTest::Check(Same(kept, fresh.GetVisibility()), "V is stale");
}

//------------------------------------------------------------------------------
// Points of a large mesh move in one corner, within its box: pages that lie under its other chunks, and
// under triangles that stay, are kept bit by bit.
SHADOW_TEST(Virtual, PagesUnderWhatStaysOfAMeshAreKept, Once)
{
  constexpr int side = 150; // quads: 45000 triangles, three chunks
  const auto build = [](ShadowStage& stage)
  {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> quads;
    for (int y = 0; y <= side; ++y)
    {
      for (int x = 0; x <= side; ++x)
      {
        // Hills whose highest and lowest points stay.
        points->InsertNextPoint(8.0 * x / side - 4.0, 8.0 * y / side - 4.0,
          1.0 + 0.3 * std::sin(0.3 * x) * std::sin(0.3 * y));
        const vtkIdType first = x + (side + 1) * y;
        if (x < side && y < side && (x / 15 + y / 15) % 2 == 0)
        {
          const vtkIdType quad[] = { first, first + 1, first + side + 2, first + side + 1 };
          quads->InsertNextCell(4, quad);
        }
      }
    }
    vtkNew<vtkPolyData> mesh;
    mesh->SetPoints(points);
    mesh->SetPolys(quads);
    stage.AddFloor(8.0);
    vtkActor* actor = stage.Add(mesh);
    stage.AddLight(LightKind::Rectangle, { 0.0, 0.0, 12.0 }, { 0.0, 0.0, 0.0 });
    stage.LookAt({ 0.0, -12.0, 9.0 }, { 0.0, 0.0, 0.0 }, 60.0);
    return vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
  };
  const auto move = [](vtkPolyData* mesh)
  {
    vtkPoints* points = mesh->GetPoints();
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      double p[3];
      points->GetPoint(i, p);
      if (p[0] > 2.5 && p[0] < 3.5 && p[1] > 2.5 && p[1] < 3.5)
      {
        points->SetPoint(i, p[0], p[1], 1.0);
      }
    }
    points->Modified();
  };
  const Parameters parameters = { { "resolution", "64" } };
  ShadowStage stage(200, 200);
  vtkPolyData* mesh = build(stage);
  stage.SetPass(Name, parameters);
  stage.Render();
  const Visibility before = stage.GetVisibility();
  const double tiles = stage.Count("tiles");
  move(mesh);
  stage.Render();
  ShadowTest::CheckAtLeast(stage.Count("tilesDrawn"), 1.0, "pages drawn");
  ShadowTest::CheckAtMost(stage.Count("tilesDrawn"), 0.25 * tiles, "pages drawn, of all");
  ShadowTest::CheckAtLeast(stage.Count("chunksPerTile"), 1.0, "chunks drawn for a page");
  const Visibility kept = stage.GetVisibility();
  ShadowTest::Check(!Same(kept, before), "nothing has moved");
  ShadowStage fresh(200, 200);
  move(build(fresh));
  fresh.SetPass(Name, parameters);
  fresh.Render();
  ShadowTest::Check(Same(kept, fresh.GetVisibility()), "V is stale");
}

//------------------------------------------------------------------------------
// The GPU's own conservative rasterization is chosen where there is one.
SHADOW_TEST(Virtual, ConservativeRasterizationIsChosen, Once)
{
  const auto choose = [](const std::set<std::string>& extensions)
  {
    return vtkVirtualConservative::Choose(
      [&extensions](const char* name) { return extensions.count(name) > 0; });
  };
  const std::string nvidia = "GL_NV_conservative_raster";
  const std::string intel = "GL_INTEL_conservative_rasterization";
  ShadowTest::CheckEqual(choose({}), 0u, "without an extension");
  ShadowTest::CheckEqual(choose({ "GL_NV_conservative_raster_dilate" }), 0u, "with another");
  ShadowTest::CheckEqual(choose({ nvidia }), 0x9346u, "NVIDIA's");
  ShadowTest::CheckEqual(choose({ intel }), 0x83FEu, "Intel's");
  ShadowTest::CheckEqual(choose({ intel, nvidia }), 0x9346u, "both");
}

//------------------------------------------------------------------------------
// More pages than the budget: one warning, the budget kept, and a shadow all the same.
SHADOW_TEST(Virtual, BudgetIsKept, Once)
{
  ShadowStage stage(300, 300);
  Build(stage);
  stage.SetPass(Name, { { "budget", "1" }, { "resolution", "256" } });
  stage.Render();
  stage.Render();
  ShadowTest::CheckOneMessage(Message::Warning, { Name, "budget", "1 MB" }, "too small a budget");
  ShadowTest::CheckAtLeast(stage.Count("coarser"), 2.0, "how much coarser");
  ShadowTest::CheckAtMost(stage.Count("tiles"), 4.0, "pages of 256 x 256 in a megabyte");
  const double bytes = stage.GetStatistics()["bytes"]["tiles"];
  ShadowTest::CheckAtMost(bytes, 1048576.0 + 65536.0, "bytes of tiles");
  ShadowTest::CheckEqual(GetRange(stage.GetVisibility()).first, 0.0, "there is a shadow");
  // Without pages that are kept one tile is enough, however many are asked for.
  stage.SetPass(Name, { { "cache", "off" }, { "resolution", "64" } });
  stage.Render();
  ShadowTest::CheckAtLeast(stage.Count("tiles"), 5.0, "tiles of 64 x 64");
  const double one = stage.GetStatistics()["bytes"]["tiles"];
  ShadowTest::CheckAtMost(one, 1.1 * 64 * 64 * 4 + 65536.0, "bytes of one tile and the nodes");
  ShadowTest::CheckNoMessage("one tile");
}

//------------------------------------------------------------------------------
// The wider the penumbrae, the coarser the texels: the paper's figure 10. A blocker far above the
// floor, whose penumbra is as wide as its shadow, takes less of them than a hard edge.
SHADOW_TEST(Virtual, SoftTakesFewerTexelsThanHard, Once)
{
  for (const std::string cache : { "on", "off" })
  {
    double last = 0.0;
    for (const double size : { 1.0, 0.3, 0.0 })
    {
      ShadowStage stage(600, 600);
      stage.AddFloor(6.0);
      stage.AddQuad({ -1.0, -0.8, 3.0 }, { 2.0, 0.0, 0.0 }, { 0.0, 1.6, 0.0 });
      vtkAreaLight* light = stage.AddLight(LightKind::Rectangle, { 0, 0, 6 }, { 0, 0, 0 });
      light->SetWidth(2.0);
      light->SetHeight(2.0);
      ShadowStage::Shrink(light, size);
      stage.LookAt({ 0.0, -4.0, 2.5 }, { 0.0, 0.0, 0.0 }, 45.0);
      stage.SetPass(Name, { { "cache", cache }, { "resolution", "64" } });
      stage.Render();
      const double texels = stage.Count("tileTexels");
      ShadowTest::CheckAtLeast(
        texels, 1.2 * last, "cache " + cache + ", light x " + std::to_string(size) + ": texels");
      last = texels;
    }
  }
}

//------------------------------------------------------------------------------
// The floor moves by a tenth of a texel: no pixel of a wide penumbra changes by more than 0.02.
SHADOW_TEST(Virtual, PenumbraeAreSmooth, Once)
{
  ShadowStage stage(400, 400);
  vtkShadowScenes::Build("blocker", stage.Renderer);
  auto* floor = vtkActor::SafeDownCast(stage.Renderer->GetViewProps()->GetItemAsObject(0));
  stage.SetPass(Name, { { "antialias", "on" } });
  stage.Render();
  Visibility last = stage.GetVisibility();
  double worst = 0.0;
  // A penumbra is a unit wide, 20 pixels and 9 texels: a tenth of a texel is 0.01. Where the floor
  // rises, what a pixel sees of it moves by 2.5 times as much along it.
  for (int i = 1; i <= 8; ++i)
  {
    floor->SetPosition(0.0, 0.0, 0.004 * i);
    stage.Render();
    const Visibility now = stage.GetVisibility();
    worst = std::max(worst, Compare(now, last, 0.1).Maximum);
    last = now;
  }
  ShadowTest::CheckAtMost(worst, 0.02, "change of V, at most");
}
