// SPDX-License-Identifier: BSD-3-Clause
// What a map holds must not show in the picture: things that move far away, many flat things, things
// that cast nothing, a sky around everything.

#include "ShadowStage.h"
#include "ShadowTest.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkShadowTechniques.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace
{
bool IsMap(const std::string& technique)
{
  return technique.compare(0, 4, "map-") == 0;
}

/** At its defaults. */
void SetPass(ShadowStage& stage, const std::string& technique)
{
  stage.Pass.TakeReference(vtkShadowTechniques::Create(technique));
  stage.Renderer->SetPass(stage.Pass);
}

/** Pixels at which two differ by more. */
int CountOff(const Visibility& a, const Visibility& b, float bound)
{
  int count = 0;
  for (std::size_t i = 0; i < a.V.size(); ++i)
  {
    count += a.Mask[i] && b.Mask[i] && std::abs(a.V[i] - b.V[i]) > bound ? 1 : 0;
  }
  return count;
}
}

//------------------------------------------------------------------------------
// A ball moves outside of the picture; not a pixel's visibility of what stands still changes by more
// than a quarter.
SHADOW_TEST(Frusta, WhatStandsStillDoesNotShimmer, Each)
{
  if (technique == "occlusion-textures")
  {
    return; // one window for all casters: a declared limit
  }
  for (const bool positional : { false, true })
  {
    const LightKind kind = positional ? LightKind::Point : LightKind::Directional;
    if (!ShadowStage::Supports(technique, kind))
    {
      continue;
    }
    ShadowStage stage(320, 240);
    stage.AddFloor(40.0);
    stage.AddBox({ 0.0, 0.0, 2.0 }, { 2.0, 2.0, 4.0 });
    vtkActor* ball = stage.AddSphere({ 0.0, 0.0, 0.0 }, 0.8);
    stage.AddLight(kind, { 5.0, -6.0, 30.0 }, { 0.0, 0.0, 0.0 });
    stage.LookAt({ -9.0, -12.0, 9.0 }, { -2.0, 1.0, 0.6 }, 30.0);
    SetPass(stage, technique);
    Visibility first;
    int off = 0;
    for (int i = 0; i < 8; ++i)
    {
      const double angle = 2.0 * 3.14159265 / 8.0 * i;
      ball->SetPosition(
        14.0 + 3.0 * std::cos(angle), -10.0 + 4.0 * std::sin(angle), 3.0 + std::sin(3.0 * angle));
      stage.Render();
      const Visibility visibility = stage.GetVisibility();
      first = i == 0 ? visibility : first;
      off = std::max(off, CountOff(visibility, first, 0.25f));
    }
    ShadowTest::CheckAtMost(off, 2.0, "pixels that change");
    ShadowTest::CheckAtMost(
      *std::min_element(first.V.begin(), first.V.end()), 0.0, "there is a shadow");
  }
}

//------------------------------------------------------------------------------
// Two boxes far apart: each has the shadow that it has alone, to the bit where it falls onto planes.
SHADOW_TEST(Frusta, GroupsAreEachAsAlone, Each)
{
  if (!ShadowStage::Describe(technique).Traits.PlanarReceivers)
  {
    return;
  }
  const auto draw = [&](bool left, bool right)
  {
    ShadowStage stage(320, 240);
    stage.AddFloor(40.0);
    vtkActor* boxes[] = { stage.AddBox({ -9.0, 0.0, 1.0 }, { 2.0, 2.0, 2.0 }),
      stage.AddBox({ 9.0, 3.0, 1.5 }, { 1.0, 1.0, 3.0 }) };
    boxes[0]->SetVisibility(left);
    boxes[1]->SetVisibility(right);
    stage.AddLight(LightKind::Directional, { 5.0, -6.0, 12.0 }, { 0.0, 0.0, 0.0 });
    stage.LookAt({ 0.0, -1.0, 60.0 }, { 0.0, 0.0, 0.0 }, 25.0);
    SetPass(stage, technique);
    stage.Render();
    return stage.GetVisibility();
  };
  const Visibility left = draw(true, false);
  const Visibility right = draw(false, true);
  const Visibility both = draw(true, true);
  std::size_t off = 0;
  for (std::size_t i = 0; i < both.V.size(); ++i)
  {
    off +=
      both.Mask[i] && left.Mask[i] && right.Mask[i] && both.V[i] != std::min(left.V[i], right.V[i])
        ? 1
        : 0;
  }
  ShadowTest::CheckEqual(static_cast<double>(off), 0.0, "pixels that differ");
  for (const Visibility* one : { &left, &right })
  {
    ShadowTest::CheckAtMost(
      *std::min_element(one->V.begin(), one->V.end()), 0.0, "there is a shadow");
  }
}

//------------------------------------------------------------------------------
// A ground a hundred times the scene, and ever more small walls: shadows do not coarsen at once.
SHADOW_TEST(Frusta, ManyFlatCasters, Each)
{
  Visibility few;
  for (const int count : { 62, 65, 200 })
  {
    ShadowStage stage(240, 180);
    stage.AddFloor(300.0);
    stage.AddBox({ 0.0, 0.0, 0.75 }, { 1.0, 1.0, 1.5 });
    for (int i = 0; i < count; ++i)
    {
      stage.AddQuad({ -3.0 + 0.03 * i, 3.0, 0.2 }, { 0.02, 0.0, 0.0 }, { 0.0, 0.02, 0.0 });
    }
    stage.AddLight(LightKind::Directional, { 3.0, -4.0, 8.0 }, { 0.0, 0.0, 0.0 });
    stage.LookAt({ 0.0, -9.0, 6.0 }, { 0.0, 0.0, 0.0 }, 30.0);
    SetPass(stage, technique);
    stage.Render();
    const Visibility visibility = stage.GetVisibility();
    few = count == 62 ? visibility : few;
    ShadowTest::CheckAtMost(
      CountOff(visibility, few, 0.5f), 40.0, "pixels that change with " + std::to_string(count));
  }
}

//------------------------------------------------------------------------------
// A triangle of no area, far away: no pixel changes.
SHADOW_TEST(Frusta, WhatCastsNothingCountsNowhere, Each)
{
  const auto show = [&technique](bool more)
  {
    Placement place;
    place.Offset = glm::dvec3(1e6, -1e6, 1e5);
    return RenderVisibility(
      technique, {},
      [more](ShadowStage& stage)
      {
        stage.AddThings();
        stage.AddLight(LightKind::Point);
        if (more)
        {
          vtkNew<vtkPoints> points;
          vtkNew<vtkCellArray> cells;
          cells->InsertNextCell(3);
          for (int i = 0; i < 3; ++i)
          {
            cells->InsertCellPoint(points->InsertNextPoint(0.0, 0.0, 0.0));
          }
          vtkNew<vtkPolyData> nothing;
          nothing->SetPoints(points);
          nothing->SetPolys(cells);
          stage.Add(nothing)->SetPosition(-1e6, 1e6, -1e5);
        }
      },
      place);
  };
  ShadowTest::Check(Same(show(true), show(false)), "it makes a difference");
}

//------------------------------------------------------------------------------
// A sky ten thousand times as far as everything else, with the light in it, whole or open below: but for
// edges maps are what they are without it. The floor then casts, and an open sky too: they take
// resolution.
SHADOW_TEST(Frusta, SkyAround, Each)
{
  if (!IsMap(technique))
  {
    return;
  }
  const auto show = [&technique](double endPhi)
  {
    return RenderVisibility(technique, { { "resolution", "1024" } },
      [endPhi](ShadowStage& stage)
      {
        stage.AddThings();
        stage.AddLight(LightKind::Point, { 1.0, -1.0, 4.0 }, { 0.0, 0.0, 0.0 });
        if (endPhi > 0.0)
        {
          vtkNew<vtkSphereSource> sky;
          sky->SetRadius(1e4);
          sky->SetEndPhi(endPhi);
          sky->Update();
          stage.Add(sky->GetOutput());
        }
      });
  };
  const Visibility without = show(0.0);
  ShadowTest::CheckAtMost(CountOff(show(180.0), without, 0.5f), 40.0, "pixels off with a sky");
  ShadowTest::CheckAtMost(CountOff(show(120.0), without, 0.5f), 250.0, "pixels off with a dome");
  ShadowTest::CheckAtMost(
    *std::min_element(without.V.begin(), without.V.end()), 0.0, "there is a shadow");
}

//------------------------------------------------------------------------------
// A lamp amid a large mesh: each face of its cube shows a part, and leaves chunks of the mesh out. Cut into
// small meshes, which are no chunks, it casts the same.
SHADOW_TEST(Frusta, ChunksThatAreSeenAreDrawn, Once)
{
  const std::string hard = "map-hard";
  if (!vtkShadowTechniqueRegistration::Find(hard))
  {
    return;
  }
  constexpr int side = 192; // quads; 73,728 triangles
  const auto makePart = [](int firstX, int firstY, int count)
  {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> quads;
    for (int y = 0; y <= count; ++y)
    {
      for (int x = 0; x <= count; ++x)
      {
        const double u = 8.0 * (firstX + x) / side - 4.0;
        const double v = 8.0 * (firstY + y) / side - 4.0;
        points->InsertNextPoint(u, v, 0.5 * std::sin(2.0 * u) * std::cos(2.5 * v));
        if (x < count && y < count)
        {
          const vtkIdType corner = static_cast<vtkIdType>(y) * (count + 1) + x;
          quads->InsertNextCell({ corner, corner + 1, corner + count + 2, corner + count + 1 });
        }
      }
    }
    vtkNew<vtkPolyData> part;
    part->SetPoints(points);
    part->SetPolys(quads);
    return vtkSmartPointer<vtkPolyData>(part);
  };
  Visibility visibility[2];
  for (const int parts : { 1, 4 })
  {
    ShadowStage stage;
    for (int i = 0; i < parts * parts; ++i)
    {
      const int count = side / parts;
      stage.Add(makePart(i % parts * count, i / parts * count, count));
    }
    stage.AddLight(LightKind::Point, { 0.3, 0.2, 0.45 }, { 0.0, 0.0, 0.0 });
    stage.LookAt({ 5.0, -6.0, 7.0 }, { 0.0, 0.0, 0.0 });
    stage.SetPass(hard, { { "resolution", "1024" } });
    stage.Render();
    visibility[parts == 1 ? 0 : 1] = stage.GetVisibility();
    ShadowTest::CheckAtLeast(stage.Count("trianglesDrawn"), 2.0 * side * side, "triangles drawn");
    if (parts == 1)
    {
      ShadowTest::CheckAtLeast(stage.Count("trianglesCulled"), 16384.0, "triangles culled");
    }
  }
  // Frusta hug what casts, so that texels lie elsewhere: shadows' edges differ.
  ShadowTest::CheckAtMost(
    Compare(visibility[0], visibility[1], 0.5).Share, 0.01, "pixels that differ");
}
