// SPDX-License-Identifier: BSD-3-Clause
// What stencil shadow volumes promise: every way of counting gives the truth wherever the eye is, any
// mesh will do, counts never wrap to light, and what is not needed is not made.

#include "ShadowOracle.h"
#include "ShadowTest.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkLightCollection.h"
#include "vtkMatrix4x4.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShadowScenes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
using Faces = std::vector<std::vector<vtkIdType>>;

vtkSmartPointer<vtkPolyData> MakeMesh(const std::vector<glm::dvec3>& points, const Faces& faces)
{
  vtkNew<vtkPoints> places;
  for (const auto& p : points)
  {
    places->InsertNextPoint(p.x, p.y, p.z);
  }
  vtkNew<vtkCellArray> polygons;
  for (const auto& face : faces)
  {
    polygons->InsertNextCell(static_cast<vtkIdType>(face.size()), face.data());
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(places);
  mesh->SetPolys(polygons);
  return mesh;
}

std::vector<glm::dvec3> BoxPoints(const glm::dvec3& low, const glm::dvec3& high)
{
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 8; ++i)
  {
    points.emplace_back(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
  }
  return points;
}

/** Wound outwards: bottom, top, front, back, left, right. */
const Faces BoxFaces = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 },
  { 0, 4, 6, 2 }, { 1, 3, 7, 5 } };

void AddPointLight(ShadowStage& stage, const glm::dvec3& position = { -2.5, -2.0, 5.5 })
{
  ShadowStage::Shrink(stage.AddLight(LightKind::Point, position, { 0.0, 0.0, 0.0 }));
}

/**
 * Pixels away from the picture's silhouettes that differ from the truth. What lies on an edge of a
 * shadow may: bounds allow a pixel in 300, far less than any face would make wrong.
 */
void CheckTruth(ShadowStage& stage, const std::string& what)
{
  const ShadowOracle oracle(stage);
  auto* light = vtkLight::SafeDownCast(stage.Renderer->GetLights()->GetItemAsObject(0));
  const Visibility truth = oracle.GetHard(light);
  const Visibility seen = stage.GetVisibility();
  const auto use = oracle.GetInner(1);
  ShadowTest::CheckAtMost(
    Compare(seen, truth, 0.5, use).Share, 0.0033, what + ": pixels other than the truth");
}

/** By both ways of counting, and by the one that is chosen; they agree to the bit. */
void CheckAllCounts(ShadowStage& stage, const std::string& what, bool zPassHolds = true)
{
  stage.SetPass("volume-hard", { { "counting", "z-fail" } });
  stage.Render();
  CheckTruth(stage, what + ", z-fail");
  const Visibility fail = stage.GetVisibility();
  stage.SetPass("volume-hard");
  stage.Render();
  CheckTruth(stage, what + ", auto");
  ShadowTest::Check(Same(fail, stage.GetVisibility()), what + ": auto is z-fail, bit by bit");
  if (zPassHolds)
  {
    stage.SetPass("volume-hard", { { "counting", "z-pass" } });
    stage.Render();
    ShadowTest::Check(Same(fail, stage.GetVisibility()), what + ": z-pass is z-fail, bit by bit");
  }
}
}

//------------------------------------------------------------------------------
// Where the eye is outside of all volumes, both ways of counting give the same picture.
SHADOW_TEST(Volumes, CountsAgree, Once)
{
  for (const bool parallel : { false, true })
  {
    for (const LightKind kind : { LightKind::Point, LightKind::Directional })
    {
      ShadowStage stage(200, 160);
      stage.AddThings();
      ShadowStage::Shrink(stage.AddLight(kind));
      if (parallel)
      {
        stage.Renderer->GetActiveCamera()->ParallelProjectionOn();
        stage.Renderer->GetActiveCamera()->SetParallelScale(2.5);
      }
      CheckAllCounts(stage, std::string(GetName(kind)) + (parallel ? ", parallel" : ""));
      ShadowTest::CheckEqual(stage.Count("volumesZFail"), 0.0, "volumes that needed z-fail");
    }
  }
}

//------------------------------------------------------------------------------
// The eye within a volume, looking into and out of it, and in the plane of one of its sides.
SHADOW_TEST(Volumes, EyeInVolume, Once)
{
  // A sheet of side 3 at height 3 under a light at height 6: the side of its volume towards -y holds
  // the points y = -1.5 - (3 - z) / 2, or, of the directional light, y = -1.5 + (3 - z) / 20. That one
  // is slanted, for no face is to be parallel to it: what such a face sees is anyone's guess.
  for (const bool directional : { false, true })
  {
    const auto build = [&](ShadowStage& stage)
    {
      stage.AddFloor(8.0);
      stage.AddQuad({ -1.5, -1.5, 3.0 }, { 3.0, 0.0, 0.0 }, { 0.0, 3.0, 0.0 });
      stage.AddBox({ 2.2, 1.0, 0.5 }, { 1.0, 1.0, 1.0 });
      ShadowStage::Shrink(directional
                            ? stage.AddLight(LightKind::Directional, { 0.4, -0.3, 6 }, { 0, 0, 0 })
                            : stage.AddLight(LightKind::Point, { 0, 0, 6 }, { 0, 0, 0 }));
    };
    const std::string kind = directional ? "directional, " : "point, ";
    const struct
    {
      const char* What;
      glm::dvec3 Eye, Focus;
    } views[] = {
      { "looking out", { 0.3, -0.4, 1.5 }, { 3.0, 1.0, 0.0 } },
      { "looking down", { 0.3, -0.4, 2.0 }, { 0.4, 0.5, 0.0 } },
      { "looking in", { 0.5, -7.0, 1.5 }, { 0.3, 0.0, 0.5 } },
      { "in a side's plane", { 0.3, directional ? -1.45 : -2.0, 2.0 },
        { 3.0, directional ? -1.35 : -3.0, 0.0 } },
      { "above the sheet", { 0.5, -1.0, 4.5 }, { 1.5, 1.0, 0.0 } },
    };
    for (const auto& view : views)
    {
      ShadowStage stage(200, 160);
      build(stage);
      stage.LookAt(view.Eye, view.Focus, 70.0);
      stage.Renderer->GetActiveCamera()->SetClippingRange(0.01, 40.0);
      CheckAllCounts(stage, kind + view.What, false);
    }
  }
}

//------------------------------------------------------------------------------
// A parallel view has no infinity that a far cap could cover: along the light, across, and opposite.
SHADOW_TEST(Volumes, ParallelAlongTheLight, Once)
{
  for (const glm::dvec3& eye :
    { glm::dvec3(0.0, -0.6, 8.0), glm::dvec3(-4.0, -3.0, 8.0), glm::dvec3(3.0, -6.0, 4.0) })
  {
    for (const bool directional : { false, true })
    {
      ShadowStage stage(160, 160);
      stage.AddFloor(4.0);
      stage.AddQuad({ -1.0, -1.0, 2.0 }, { 1.6, 0.0, 0.0 }, { 0.0, 1.4, 0.0 });
      stage.AddBox({ 1.2, 1.0, 0.5 }, { 0.8, 0.8, 1.0 });
      ShadowStage::Shrink(stage.AddLight(
        directional ? LightKind::Directional : LightKind::Point, { -2.0, -1.5, 5.0 }, { 0, 0, 0 }));
      stage.LookAt(eye, { 0.0, 0.0, 0.0 });
      stage.Renderer->GetActiveCamera()->ParallelProjectionOn();
      stage.Renderer->GetActiveCamera()->SetParallelScale(3.5);
      CheckAllCounts(stage, std::string(directional ? "directional" : "point") + " light, eye at " +
                              std::to_string(eye.x));
    }
  }
}

//------------------------------------------------------------------------------
// The near plane cuts a caster: what is cut away still casts, and what shows through is right.
SHADOW_TEST(Volumes, NearPlaneCutsCaster, Once)
{
  const auto build = [](ShadowStage& stage, bool cut)
  {
    stage.AddFloor(6.0);
    stage.AddBox({ 1.0, 1.5, 0.5 }, { 1.0, 1.0, 1.0 });
    vtkActor* sheet = stage.AddQuad({ -1.5, -4.0, 0.3 }, { 3.0, 0.0, 0.0 }, { 0.0, 3.0, 1.2 });
    AddPointLight(stage, { -1.0, -3.0, 6.0 });
    stage.LookAt({ 0.2, -7.0, 2.2 }, { 0.2, 0.0, 0.2 }, 45.0);
    sheet->SetVisibility(cut);
    // Half of the sheet lies before this.
    stage.Renderer->GetActiveCamera()->SetClippingRange(4.6, 40.0);
    return sheet;
  };
  ShadowStage without(200, 160);
  build(without, false);
  const ShadowOracle behind(without);
  ShadowStage stage(200, 160);
  vtkActor* sheet = build(stage, true);
  const ShadowOracle oracle(stage);
  const auto inner = oracle.GetInner(2);
  const auto innerBehind = behind.GetInner(2);
  const glm::dvec3 eye(0.2, -7.0, 2.2);
  const glm::dvec3 ahead = glm::normalize(glm::dvec3(0.2, 0.0, 0.2) - eye);
  const glm::dvec3 light(-1.0, -3.0, 6.0);
  stage.SetPass("volume-hard");
  stage.Render();
  ShadowTest::CheckAtLeast(stage.Count("volumesZFail"), 1.0, "volumes that needed z-fail");
  const Visibility seen = stage.GetVisibility();
  std::size_t cut = 0;
  std::size_t wrong = 0;
  std::size_t dark = 0;
  for (std::size_t i = 0; i < inner.size(); ++i)
  {
    const SurfacePoint& first = oracle.GetPixels()[i];
    const bool away = first.Actor == sheet && glm::dot(first.Position - eye, ahead) < 4.6;
    const SurfacePoint& shown = away ? behind.GetPixels()[i] : first;
    if (!shown.Actor || !inner[i] || !innerBehind[i] || !seen.Mask[i])
    {
      continue;
    }
    const bool blocked = oracle.IsBlocked(shown, light);
    cut += away;
    dark += blocked;
    wrong += blocked != (seen.V[i] < 0.5f);
  }
  ShadowTest::CheckAtLeast(static_cast<double>(cut), 1000.0, "pixels seen through the cut");
  ShadowTest::CheckAtLeast(static_cast<double>(dark), 1000.0, "pixels in shadow");
  ShadowTest::CheckAtMost(
    static_cast<double>(wrong), 0.0033 * inner.size(), "pixels other than the truth");
}

//------------------------------------------------------------------------------
// A projection matrix of the user's own, whose near plane is not the camera's clipping range.
SHADOW_TEST(Volumes, ExplicitProjection, Once)
{
  ShadowStage stage(160, 160);
  stage.AddThings();
  AddPointLight(stage);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  const double distance = camera->GetDistance();
  camera->SetClippingRange(0.02 * distance, 5.0 * distance);
  vtkNew<vtkMatrix4x4> projection;
  projection->DeepCopy(camera->GetProjectionTransformMatrix(1.0, -1.0, 1.0));
  camera->SetExplicitProjectionTransformMatrix(projection);
  camera->UseExplicitProjectionTransformMatrixOn();
  camera->SetClippingRange(0.9 * distance, 5.0 * distance);
  CheckAllCounts(stage, "near plane before the clipping range");
}

//------------------------------------------------------------------------------
// An 8-bit count comes back to 0 after 256 volumes: nested ones beyond that stay dark.
SHADOW_TEST(Volumes, ManyNested, Once)
{
  for (const int count : { 100, 256, 257, 512 })
  {
    for (const bool one : { true, false })
    {
      ShadowStage stage(100, 100);
      stage.AddFloor(4.0);
      std::vector<glm::dvec3> points;
      Faces faces;
      for (int i = 0; i < count; ++i)
      {
        const double z = 1.0 + 2.0 * i / count;
        if (!one)
        {
          stage.AddQuad({ -1.0, -1.0, z }, { 2.0, 0.0, 0.0 }, { 0.0, 2.0, 0.0 });
          continue;
        }
        const auto first = static_cast<vtkIdType>(points.size());
        points.insert(
          points.end(), { { -1.0, -1.0, z }, { 1.0, -1.0, z }, { 1.0, 1.0, z }, { -1.0, 1.0, z } });
        faces.push_back({ first, first + 1, first + 2, first + 3 });
      }
      if (one)
      {
        stage.Add(MakeMesh(points, faces));
      }
      AddPointLight(stage, { 0.5, 0.5, 8.0 });
      stage.LookAt({ 1.0, -7.0, 0.6 }, { 0.0, 0.0, 0.6 });
      const std::string what =
        std::to_string(count) + " sheets in " + (one ? "one mesh" : "a mesh each");
      for (const char* counting : { "auto", "z-fail" })
      {
        stage.SetPass("volume-hard", { { "counting", counting } });
        stage.Render();
        CheckTruth(stage, what + ", " + counting);
      }
      ShadowTest::CheckEqual(
        stage.Count("wideCounts"), count > 255 ? 1.0 : 0.0, what + ": counts wider than 8 bits");
    }
  }
}

//------------------------------------------------------------------------------
// Meshes that have no two faces at every edge, or not wound alike; by all matrices.
SHADOW_TEST(Volumes, AnyMesh, Once)
{
  const auto box = BoxPoints({ -0.8, -0.6, 0.8 }, { 0.8, 0.6, 2.0 });
  Faces openTop = BoxFaces;
  openTop.erase(openTop.begin() + 1);
  Faces openFront = BoxFaces;
  openFront.erase(openFront.begin() + 2);
  Faces mixed = BoxFaces;
  std::reverse(mixed[1].begin(), mixed[1].end());
  std::reverse(mixed[4].begin(), mixed[4].end());
  Faces inside = BoxFaces;
  for (auto& face : inside)
  {
    std::reverse(face.begin(), face.end());
  }
  Faces twice = BoxFaces;
  twice.insert(twice.end(), inside.begin(), inside.end());
  twice.push_back(BoxFaces[1]);
  Faces fins = BoxFaces; // a third face at the edge from 4 to 5, and another one in the middle
  fins.push_back({ 4, 5, 8 });
  auto finned = box;
  finned.emplace_back(0.0, -1.6, 2.6);
  // Three fans around one axis, and two tetrahedra that share a point.
  const std::vector<glm::dvec3> fan = { { 0, 0, 0.6 }, { 0, 0, 2.2 }, { 1.2, 0.2, 1.4 },
    { -0.9, 0.8, 1.4 }, { -0.5, -1.0, 1.3 } };
  const std::vector<glm::dvec3> bow = { { 0, 0, 1.4 }, { 1, 0.2, 0.8 }, { 0.9, 0.9, 1.6 },
    { 0.7, -0.6, 2.0 }, { -1, 0.1, 0.8 }, { -0.9, 0.8, 1.9 }, { -0.8, -0.7, 1.5 } };
  const struct
  {
    const char* What;
    vtkSmartPointer<vtkPolyData> Mesh;
    double Open, NonManifold, Duplicate; // as the statistics tell; -1: not told here
  } meshes[] = {
    { "a box", MakeMesh(box, BoxFaces), 0, 0, 0 },
    { "a box without a lid", MakeMesh(box, openTop), 4, 0, 0 },
    { "a box without a front", MakeMesh(box, openFront), 4, 0, 0 },
    { "a box of mixed winding", MakeMesh(box, mixed), 0, 0, 0 },
    { "a box wound inwards", MakeMesh(box, inside), 0, 0, 0 },
    { "a box with doubled faces", MakeMesh(box, twice), 0, 0, -1 },
    { "a box with a fin", MakeMesh(finned, fins), -1, -1, 0 },
    { "three sheets on an edge", MakeMesh(fan, { { 0, 1, 2 }, { 0, 1, 3 }, { 1, 0, 4 } }), 6, 1,
      0 },
    { "two tetrahedra on a point",
      MakeMesh(bow, { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 1, 3, 2 }, { 0, 5, 4 }, { 0, 6, 5 },
                      { 0, 4, 6 }, { 4, 5, 6 } }),
      0, 0, 0 },
  };
  for (const auto& mesh : meshes)
  {
    for (const glm::dvec3& scale :
      { glm::dvec3(1.0), glm::dvec3(-1.0, 1.0, 1.0), glm::dvec3(1.0, 1.0, 0.0) })
    {
      ShadowStage stage(160, 160);
      stage.AddFloor(5.0);
      vtkActor* actor = stage.Add(mesh.Mesh);
      actor->SetScale(scale.x, scale.y, scale.z);
      if (scale.z == 0.0)
      {
        actor->SetPosition(0.0, 0.0, 1.2); // flat; it would lie in the floor
      }
      AddPointLight(stage);
      stage.LookAt({ 4.0, -8.0, 5.5 }, { 0.3, 0.3, 0.6 });
      const std::string what = std::string(mesh.What) + (scale.x < 0.0 ? ", mirrored" : "") +
                               (scale.z == 0.0 ? ", flattened" : "");
      CheckAllCounts(stage, what);
      if (mesh.Open >= 0.0)
      {
        ShadowTest::CheckEqual(stage.Count("edgesOpen"), mesh.Open, what + ": open edges");
      }
      if (mesh.NonManifold >= 0.0)
      {
        ShadowTest::CheckEqual(
          stage.Count("edgesNonManifold"), mesh.NonManifold, what + ": edges of more faces");
      }
      if (mesh.Duplicate >= 0.0)
      {
        ShadowTest::CheckEqual(
          stage.Count("trianglesDuplicate"), mesh.Duplicate, what + ": duplicates");
      }
    }
  }
}

//------------------------------------------------------------------------------
// A caster whose near faces are not drawn is looked into: its volume is entered where nothing is seen.
SHADOW_TEST(Volumes, CulledFaces, Once)
{
  for (const bool back : { false, true })
  {
    ShadowStage stage(160, 160);
    vtkActor* floor = stage.AddFloor(5.0);
    vtkActor* box = stage.AddBox({ 0.0, 0.0, 1.2 }, { 1.6, 1.2, 1.2 });
    back ? box->GetProperty()->BackfaceCullingOn() : box->GetProperty()->FrontfaceCullingOn();
    AddPointLight(stage);
    stage.LookAt({ 4.0, -8.0, 5.5 }, { 0.3, 0.3, 0.6 });
    stage.SetPass("volume-hard");
    stage.Render();
    ShadowTest::CheckEqual(stage.Count("volumesZFail"), 1.0, "volumes that needed z-fail");
    const ShadowOracle oracle(stage);
    auto* light = vtkLight::SafeDownCast(stage.Renderer->GetLights()->GetItemAsObject(0));
    const auto inner = oracle.GetInner(1);
    auto use = oracle.GetMask(floor);
    for (std::size_t i = 0; i < use.size(); ++i)
    {
      use[i] = use[i] && inner[i];
    }
    ShadowTest::CheckAtMost(Compare(stage.GetVisibility(), oracle.GetHard(light), 0.5, use).Share,
      0.0033, "the floor's pixels other than the truth");
  }
}

//------------------------------------------------------------------------------
// Parity takes two volumes for none: the limit that its parameter states.
SHADOW_TEST(Volumes, ParityCancels, Once)
{
  ShadowStage stage(160, 160);
  stage.AddFloor(4.0);
  stage.AddQuad({ -1.0, -1.0, 1.0 }, { 2.0, 0.0, 0.0 }, { 0.0, 2.0, 0.0 });
  AddPointLight(stage, { 0.0, 0.0, 6.0 });
  stage.LookAt({ 2.0, -8.0, 5.5 }, { 0.0, 0.0, 0.0 });
  stage.SetPass("volume-hard", { { "counting", "xor" } });
  stage.Render();
  CheckTruth(stage, "one sheet, xor");
  stage.AddQuad({ -1.0, -1.0, 2.0 }, { 2.0, 0.0, 0.0 }, { 0.0, 2.0, 0.0 });
  stage.Render();
  const Visibility parity = stage.GetVisibility();
  stage.SetPass("volume-hard");
  stage.Render();
  CheckTruth(stage, "two sheets, auto");
  const Visibility counted = stage.GetVisibility();
  const auto dark = [](const Visibility& visibility)
  { return std::count(visibility.V.begin(), visibility.V.end(), 0.0f); };
  // The upper sheet's shadow holds the lower one's, (6/4)^2 to (6/5)^2: what is left is a ring.
  ShadowTest::CheckAtMost(
    static_cast<double>(dark(parity)), 0.6 * dark(counted), "dark pixels by parity");
}

//------------------------------------------------------------------------------
// Adjacency is made once for a mesh, in no other technique, and goes with its caster; silhouettes are
// found when light or casters move, for all samples; what is out of view is not drawn.
SHADOW_TEST(Volumes, WhatIsNotNeededIsNotMade, Once)
{
  ShadowStage stage;
  vtkActor* box = stage.AddThings();
  vtkAreaLight* light = stage.AddLight(LightKind::Rectangle);
  stage.SetPass("map-pcf");
  stage.Render();
  ShadowTest::CheckEqual(stage.Count("adjacencyBytes"), -1.0, "adjacency of another technique");

  stage.SetPass("volume-soft", { { "samples", "16" } });
  stage.Render();
  const double casters = stage.Count("adjacenciesBuilt");
  const double bytes = stage.Count("adjacencyBytes");
  ShadowTest::CheckAtLeast(casters, 2.0, "adjacencies");
  ShadowTest::CheckEqual(stage.Count("silhouettesFound"), 16.0, "silhouettes");
  // 1.5 edges a triangle of a closed mesh: 24 bytes, and 17 for its plane.
  ShadowTest::CheckAtMost(bytes / stage.Count("adjacencyTriangles"), 42.0, "bytes a triangle");

  stage.LookAt({ 3.0, -7.0, 4.0 }, { 0.0, 0.0, 0.5 });
  stage.Render();
  ShadowTest::CheckEqual(stage.Count("silhouettesFound"), 0.0, "silhouettes, camera moved");
  ShadowTest::CheckEqual(stage.Count("silhouettesReused"), 16.0, "silhouettes reused");
  light->SetPosition(-2.0, -2.0, 5.0);
  stage.Render();
  ShadowTest::CheckEqual(stage.Count("silhouettesFound"), 16.0, "silhouettes, light moved");
  ShadowTest::CheckEqual(stage.Count("adjacenciesBuilt"), 0.0, "adjacencies, light moved");
  box->SetPosition(0.1, 0.0, 0.0);
  stage.Render();
  ShadowTest::CheckEqual(stage.Count("adjacenciesBuilt"), 0.0, "adjacencies, caster moved");
  stage.Renderer->RemoveActor(box);
  stage.Render();
  ShadowTest::CheckAtMost(
    stage.Count("adjacencyBytes"), bytes - 12 * 41.0, "bytes without the box");

  // Far to the side, with the light before it: its shadow falls away from the picture.
  stage.AddBox({ 60.0, 60.0, 0.5 }, { 1.0, 1.0, 1.0 });
  stage.Render();
  ShadowTest::CheckEqual(stage.Count("volumesOutOfView"), 16.0, "volumes out of view");
}

//------------------------------------------------------------------------------
// Silhouettes that do not fit into memory are found anew in each frame, with the same picture.
SHADOW_TEST(Volumes, BatchesChangeNothing, Once)
{
  ShadowStage stage;
  stage.AddThings();
  for (int i = 0; i < 12; ++i)
  {
    stage.AddSphere({ -2.0 + 0.35 * i, 1.5, 0.4 + 0.1 * (i % 3) }, 0.3, 64);
  }
  stage.AddLight(LightKind::Disk);
  stage.SetPass("volume-soft", { { "samples", "200" }, { "memory", "512" } });
  stage.Render();
  stage.Render();
  const Visibility all = stage.GetVisibility();
  ShadowTest::CheckEqual(stage.Count("silhouettesFound"), 0.0, "silhouettes kept");
  stage.SetPass("volume-soft", { { "samples", "200" }, { "memory", "1" } });
  stage.Render();
  stage.Render();
  ShadowTest::Check(Same(all, stage.GetVisibility()), "in batches the same, bit by bit");
  ShadowTest::CheckAtLeast(stage.Count("silhouettesFound"), 8.0, "silhouettes found again");
}
