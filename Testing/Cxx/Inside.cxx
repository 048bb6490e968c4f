// SPDX-License-Identifier: BSD-3-Clause
// Bodies that are seen from within: rooms, glass, culled walls, what clipping planes or the near plane
// cut open. Their volumes are to hold the inside too, as rays tell.

#include "ShadowOracle.h"
#include "ShadowTest.h"

#include "vtkAppendPolyData.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCubeSource.h"
#include "vtkLightCollection.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlane.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkShadowVTKVersion.h"
#include "vtkSphereSource.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>
#include <initializer_list>

namespace
{
vtkSmartPointer<vtkPolyData> Box(const glm::dvec3& low, const glm::dvec3& high)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(low.x, high.x, low.y, high.y, low.z, high.z);
  cube->Update();
  return cube->GetOutput();
}

/** Without some of its faces: left, right, front, back, bottom, top. */
vtkSmartPointer<vtkPolyData> Without(vtkPolyData* box, std::initializer_list<vtkIdType> faces)
{
  auto rest = vtkSmartPointer<vtkPolyData>::New();
  rest->DeepCopy(box);
  rest->BuildCells();
  for (const vtkIdType face : faces)
  {
    rest->DeleteCell(face);
  }
  rest->RemoveDeletedCells();
  return rest;
}

/** A ball whose radius swings, by so many waves around. */
vtkSmartPointer<vtkPolyData> Blob(
  const glm::dvec3& centre, double radius, double swing = 0.0, int resolution = 64)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(resolution);
  sphere->SetPhiResolution(resolution);
  sphere->Update();
  vtkSmartPointer<vtkPolyData> blob = sphere->GetOutput();
  for (vtkIdType i = 0; i < blob->GetNumberOfPoints(); ++i)
  {
    double p[3];
    blob->GetPoint(i, p);
    const double turn = std::atan2(p[1], p[0]);
    const double scale = 1.0 + swing * std::sin(5.0 * turn) * std::cos(4.0 * p[2] / radius);
    blob->GetPoints()->SetPoint(
      i, centre.x + scale * p[0], centre.y + scale * p[1], centre.z + scale * p[2]);
  }
  return blob;
}

vtkSmartPointer<vtkPolyData> Together(std::initializer_list<vtkSmartPointer<vtkPolyData>> meshes)
{
  vtkNew<vtkAppendPolyData> append;
  for (const auto& mesh : meshes)
  {
    append->AddInputData(mesh);
  }
  append->Update();
  return append->GetOutput();
}

/** A U seen from above, around what lies at y > -1, |x| < 1. */
vtkSmartPointer<vtkPolyData> Horseshoe()
{
  const glm::dvec2 outline[] = { { -2, -2 }, { 2, -2 }, { 2, 2 }, { 1, 2 }, { 1, -1 }, { -1, -1 },
    { -1, 2 }, { -2, 2 } };
  constexpr vtkIdType count = 8;
  vtkNew<vtkPoints> points;
  for (const double z : { 0.2, 2.0 })
  {
    for (const auto& p : outline)
    {
      points->InsertNextPoint(p.x, p.y, z);
    }
  }
  vtkNew<vtkCellArray> faces;
  // Convex pieces of the top, with all corners of the outline.
  const std::vector<std::vector<vtkIdType>> tops = { { 0, 1, 4, 5 }, { 1, 2, 3, 4 },
    { 0, 5, 6, 7 } };
  for (auto face : tops)
  {
    faces->InsertNextCell({ face[0] + count, face[1] + count, face[2] + count, face[3] + count });
    faces->InsertNextCell({ face[3], face[2], face[1], face[0] });
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    const vtkIdType j = (i + 1) % count;
    faces->InsertNextCell({ i, j, j + count, i + count });
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(faces);
  return mesh;
}

/** A room with thick walls and a window, one closed surface: 9 x 9 x 4 cells, of which some are wall. */
vtkSmartPointer<vtkPolyData> ThickRoom()
{
  constexpr int n = 9;
  const auto wall = [](int x, int y, int z)
  {
    const auto within = [](int i, int low, int high) { return i >= low && i <= high; };
    const bool all = within(x, 0, n - 1) && within(y, 0, n - 1) && within(z, 0, n - 1);
    const bool room = within(x, 1, n - 2) && within(y, 1, n - 2) && within(z, 1, n - 2);
    const bool window = x == n - 1 && within(y, 3, 6) && within(z, 4, 6);
    return all && !room && !window;
  };
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> faces;
  const auto point = [](int x, int y, int z) { return (x * (n + 1) + y) * (n + 1) + z; };
  for (int x = 0; x <= n; ++x)
  {
    for (int y = 0; y <= n; ++y)
    {
      for (int z = 0; z <= n; ++z)
      {
        points->InsertNextPoint((x - 0.5 * n) * 0.7, (y - 0.5 * n) * 0.7, z * 0.4);
        for (int axis = 0; axis < 3 && x < n && y < n && z < n; ++axis)
        {
          for (const int side : { 0, 1 })
          {
            const glm::ivec3 step(axis == 0, axis == 1, axis == 2);
            const glm::ivec3 at(x, y, z);
            const glm::ivec3 next = at + (side ? step : -step);
            if (!wall(x, y, z) || wall(next.x, next.y, next.z))
            {
              continue;
            }
            const glm::ivec3 u(axis == 1, axis == 2, axis == 0);
            const glm::ivec3 v(axis == 2, axis == 0, axis == 1);
            const glm::ivec3 a = at + side * step;
            vtkIdType face[4];
            for (int i = 0; i < 4; ++i)
            {
              const glm::ivec3 c =
                a + (i == 1 || i == 2 ? 1 : 0) * (side ? v : u) + (i >= 2 ? 1 : 0) * (side ? u : v);
              face[side ? i : 3 - i] = point(c.x, c.y, c.z);
            }
            faces->InsertNextCell(4, face);
          }
        }
      }
    }
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(faces);
  return mesh;
}

struct View
{
  glm::dvec3 Eye, Focus;
  double Angle = 70.0;
};

void Look(ShadowStage& stage, const View& view, bool parallel)
{
  stage.LookAt(view.Eye, view.Focus, view.Angle);
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetClippingRange(0.01 * camera->GetDistance(), 6.0 * camera->GetDistance());
  camera->SetParallelProjection(parallel);
  camera->SetParallelScale(camera->GetDistance() * std::tan(glm::radians(0.5 * view.Angle)));
}

struct Lamp
{
  const char* Name;
  LightKind Kind;
  glm::dvec3 Place;
};

const Lamp Sun = { "a sun", LightKind::Directional, { 4.0, 3.0, 5.0 } };
const Lamp Outside = { "a lamp outside", LightKind::Point,
  { 4.0, 3.2, 6.0 } }; // in no wall's plane

/** Pixels that are receivers of the same V as all around: away from the edges of shadows and things. */
std::vector<unsigned char> GetEven(const Visibility& visibility)
{
  std::vector<unsigned char> even(visibility.V.size(), 0);
  for (int y = 1; y < visibility.Height - 1; ++y)
  {
    for (int x = 1; x < visibility.Width - 1; ++x)
    {
      bool same = true;
      for (int i = 0; i < 9; ++i)
      {
        const int pixel = (y + i / 3 - 1) * visibility.Width + x + i % 3 - 1;
        same = same && visibility.Mask[pixel] && visibility.V[pixel] == visibility(x, y);
      }
      even[y * visibility.Width + x] = same;
    }
  }
  return even;
}

/**
 * Where the picture is even, all is as rays tell, but for a pixel in ten thousand: where the grid of
 * pixels meets an edge that both light and eye see. At least so many pixels have these values.
 */
void CheckAgainstRays(ShadowStage& stage, const std::string& what, const std::vector<float>& values,
  std::size_t least = 200)
{
  const auto see = [&](const char* name, const char* counting)
  {
    stage.SetPass(name,
      { { "samples", "1" }, { "counting", counting }, { "translucent-casters", "weighted" } });
    stage.Render();
    return stage.GetVisibility();
  };
  const Visibility truth = see("ray-traced", "");
  const auto even = GetEven(truth);
  for (const float value : values)
  {
    std::size_t count = 0;
    for (std::size_t i = 0; i < even.size(); ++i)
    {
      count += even[i] && std::abs(truth.V[i] - value) < 0.01f;
    }
    ShadowTest::CheckAtLeast(static_cast<double>(count), static_cast<double>(least),
      what + ": pixels of V " + std::to_string(value));
  }
  for (const char* counting : { "auto", "z-fail" })
  {
    ShadowTest::CheckAtMost(Compare(see("volume-hard", counting), truth, 0.01, even).Share, 1e-4,
      what + ", " + counting + ": share of pixels other than rays");
  }
}

/** With each light, in perspective and parallel. */
void CheckViews(const std::string& what, const View& view, const std::vector<Lamp>& lamps,
  const std::vector<float>& values, const std::function<void(ShadowStage&)>& build,
  const Placement& place = {})
{
  for (const auto& lamp : lamps)
  {
    for (const bool parallel : { false, true })
    {
      ShadowStage stage(200, 160, place);
      build(stage);
      ShadowStage::Shrink(stage.AddLight(lamp.Kind, lamp.Place, { 0.0, 0.0, 0.0 }));
      Look(stage, view, parallel);
      CheckAgainstRays(
        stage, what + ", " + lamp.Name + (parallel ? ", parallel view" : ""), values);
    }
  }
}
}

//------------------------------------------------------------------------------
// The eye in a closed room: no light comes in; and a lamp within lights what nothing hides.
SHADOW_TEST(Inside, ClosedRoom, Once)
{
  const View view = { { 2.5, 2.5, 2.2 }, { 0.0, 0.0, 0.5 } };
  const Lamp within = { "a lamp within", LightKind::Point, { -1.0, 1.2, 2.5 } };
  const auto build = [](ShadowStage& stage)
  {
    stage.Add(Box({ -3.0, -3.0, 0.0 }, { 3.0, 3.0, 3.0 }));
    stage.AddBox({ 0.3, 0.2, 0.4 }, { 0.8, 0.6, 0.8 });
    stage.AddSphere({ -1.2, -0.4, 0.8 }, 0.5, 32);
  };
  CheckViews("a room", view, { Sun, Outside }, { 0.0f }, build);
  CheckViews("a room", view, { within }, { 0.0f, 1.0f }, build);
  // As one mesh, of closed bodies alone, and with sheets.
  const auto box = Box({ -0.1, -0.1, 0.0 }, { 0.7, 0.5, 0.8 });
  const auto room = Box({ -3.0, -3.0, 0.0 }, { 3.0, 3.0, 3.0 });
  const auto sheet = Without(Box({ -1.8, -0.9, 0.9 }, { -0.6, 0.3, 1.6 }), { 0, 1, 2, 5 });
  const auto one = [&](ShadowStage& stage) { stage.Add(Together({ room, box })); };
  const auto mixed = [&](ShadowStage& stage) { stage.Add(Together({ room, box, sheet })); };
  CheckViews("a room in one mesh", view, { Sun, Outside }, { 0.0f }, one);
  CheckViews("a room in one mesh", view, { within }, { 0.0f, 1.0f }, one);
  CheckViews("a room in one mesh with sheets", view, { Sun, Outside }, { 0.0f }, mixed);
  CheckViews("a room in one mesh with sheets", view, { within }, { 0.0f, 1.0f }, mixed);
  for (const double scale : { 1e-3, 1e3 })
  {
    Placement place;
    place.Scale = scale;
    place.Offset = scale * glm::dvec3(3.0, -20.0, 7.0);
    CheckViews("a room of another size", view, { within }, { 0.0f, 1.0f }, build, place);
  }
}

//------------------------------------------------------------------------------
// Light comes in through a window: into thin walls, which are open, and into thick ones, which are not.
SHADOW_TEST(Inside, RoomWithWindow, Once)
{
  const View view = { { -2.0, 2.0, 2.2 }, { 1.5, -0.5, 0.5 }, 80.0 };
  const Lamp low = { "a low sun", LightKind::Directional, { 6.0, -1.3, 3.1 } };
  const Lamp within = { "a lamp within", LightKind::Point, { -0.6, -1.0, 2.6 } };
  CheckViews("thin walls", view, { low, within }, { 0.0f, 1.0f },
    [](ShadowStage& stage)
    {
      stage.Add(Without(Box({ -3.0, -3.0, 0.0 }, { 3.0, 3.0, 3.0 }), { 1 }));
      stage.AddBox({ 3.0, -2.0, 1.5 }, { 0.2, 1.8, 2.9 });
      stage.AddBox({ 0.6, -0.5, 0.4 }, { 0.6, 0.6, 0.8 });
    });
  CheckViews("thick walls", view, { low, within }, { 0.0f, 1.0f },
    [](ShadowStage& stage)
    {
      stage.Add(ThickRoom());
      stage.AddBox({ 0.6, -0.5, 0.8 }, { 0.6, 0.6, 0.8 });
    });
}

//------------------------------------------------------------------------------
// In the box of a body, but outside of it; light and eye there, and the light alone.
SHADOW_TEST(Inside, Concave, Once)
{
  const Lamp between = { "a lamp in its box", LightKind::Point, { -0.3, 0.4, 1.7 } };
  for (const glm::dvec3& eye : { glm::dvec3(0.3, 1.8, 1.2), glm::dvec3(3.0, 6.5, 5.0) })
  {
    CheckViews(eye.y < 2.0 ? "between its legs" : "before it", { eye, { 0.0, -0.6, 0.6 } },
      { Outside, between }, { 0.0f, 1.0f },
      [](ShadowStage& stage)
      {
        stage.AddFloor(5.0);
        stage.Add(Horseshoe());
        stage.AddBox({ 0.2, -0.3, 0.6 }, { 0.4, 0.4, 0.5 });
      });
  }
}

//------------------------------------------------------------------------------
// Shells within each other, as one mesh and as several, the eye between them or in the middle, the
// light outside, between, and in the middle.
SHADOW_TEST(Inside, NestedShells, Once)
{
  const std::vector<Lamp> lamps = { Outside,
    { "a lamp between", LightKind::Point, { -1.9, 1.0, 2.2 } },
    { "a lamp in the middle", LightKind::Point, { 0.2, -0.1, 1.3 } } };
  for (const bool one : { false, true })
  {
    for (const bool between : { false, true })
    {
      const View view = between ? View{ { 2.2, 2.0, 2.4 }, { -0.5, 0.0, 0.8 } }
                                : View{ { 0.45, 0.45, 1.5 }, { -0.5, -0.3, 0.9 } };
      CheckViews(std::string(between ? "between shells" : "in the inner shell") +
                   (one ? " of one mesh" : ""),
        view, lamps, {},
        [one](ShadowStage& stage)
        {
          const auto outer = Blob({ 0.0, 0.0, 1.2 }, 3.5, 0.03);
          const auto inner = Box({ -0.8, -0.7, 0.6 }, { 0.7, 0.8, 1.8 });
          const auto least = Blob({ -0.4, -0.3, 0.9 }, 0.2, 0.0, 24);
          if (one)
          {
            stage.Add(Together({ outer, inner, least }));
            return;
          }
          for (const auto& mesh : { outer, inner, least })
          {
            stage.Add(mesh);
          }
        });
    }
  }
}

//------------------------------------------------------------------------------
// What lies in glass, touches it or stands through it; the glass opaque or not by its property or by
// its block, and the light in the glass too.
SHADOW_TEST(Inside, Glass, Once)
{
  const View view = { { -2.0, -8.0, 5.0 }, { 0.0, 0.0, 1.2 }, 35.0 };
  const std::vector<Lamp> lamps = { Outside, Sun,
    { "a lamp in the glass", LightKind::Point, { 0.6, -0.9, 2.5 } } };
  for (const bool byBlock : { false, true })
  {
    for (const auto& lamp : lamps)
    {
      ShadowStage stage(240, 180);
      stage.AddFloor(4.0);
      const auto glass = Blob({ 0.0, 0.0, 1.9 }, 1.8);
      const auto part = Blob({ 0.0, 0.3, 1.6 }, 0.7);
      vtkNew<vtkMultiBlockDataSet> blocks; // must outlive its mapper's attributes
      if (byBlock)
      {
        blocks->SetBlock(0, glass);
        blocks->SetBlock(1, part);
        vtkNew<vtkCompositeDataDisplayAttributes> attributes;
        vtkNew<vtkShadowCompositeMapper> mapper;
        mapper->SetInputDataObject(blocks);
        mapper->SetCompositeDataDisplayAttributes(attributes);
        attributes->SetBlockOpacity(glass, 0.4);
        vtkNew<vtkActor> actor;
        actor->SetMapper(mapper);
        stage.Renderer->AddActor(actor);
      }
      else
      {
        stage.Add(glass)->GetProperty()->SetOpacity(0.4);
        stage.Add(part);
      }
      stage.AddBox({ -1.0, 0.3, 1.2 }, { 0.2, 0.2, 2.4 }); // stands through the glass
      stage.Add(Blob({ 1.0, -0.2, 1.9 }, 0.8));            // and this touches it
      stage.Renderer->UseDepthPeelingOn();
      ShadowStage::Shrink(stage.AddLight(lamp.Kind, lamp.Place, { 0.0, 0.0, 0.0 }));
      stage.LookAt(view.Eye, view.Focus, view.Angle);
      CheckAgainstRays(stage,
        std::string("glass by its ") + (byBlock ? "block, " : "property, ") + lamp.Name,
        { 0.0f, 0.6f, 1.0f });
    }
  }
}

//------------------------------------------------------------------------------
// Looking into a room from outside: its near walls are not drawn, or cut away by a plane, or by the
// near plane.
SHADOW_TEST(Inside, CutOpen, Once)
{
  const std::vector<Lamp> lamps = { Outside,
    { "a lamp within", LightKind::Point, { -1.0, 1.2, 2.5 } } };
  const View view = { { 3.0, -9.0, 6.0 }, { 0.0, 0.0, 1.2 }, 40.0 };
  for (const auto& lamp : lamps)
  {
    for (const char* cut : { "culled", "clipped", "before the near plane" })
    {
      ShadowStage stage(200, 160);
      vtkActor* room = stage.Add(Box({ -3.0, -3.0, 0.0 }, { 3.0, 3.0, 3.0 }));
      stage.AddBox({ 0.3, 0.2, 0.4 }, { 0.8, 0.6, 0.8 });
      stage.AddSphere({ -1.2, -0.4, 0.8 }, 0.5, 32);
      ShadowStage::Shrink(stage.AddLight(lamp.Kind, lamp.Place, { 0.0, 0.0, 0.0 }));
      stage.LookAt(view.Eye, view.Focus, view.Angle);
      vtkCamera* camera = stage.Renderer->GetActiveCamera();
      if (cut[1] == 'u')
      {
        room->GetProperty()->FrontfaceCullingOn();
      }
      else if (cut[0] == 'c')
      {
        vtkNew<vtkPlane> plane;
        plane->SetOrigin(0.0, -1.5, 0.0);
        plane->SetNormal(0.1, 1.0, -0.3);
        room->GetMapper()->AddClippingPlane(plane);
      }
      else
      {
        camera->SetClippingRange(0.85 * camera->GetDistance(), 3.0 * camera->GetDistance());
      }
      CheckAgainstRays(stage, std::string("a room ") + cut + ", " + lamp.Name,
        lamp.Kind == Outside.Kind && lamp.Place == Outside.Place
          ? std::vector<float>{ 0.0f }
          : std::vector<float>{ 0.0f, 1.0f });
    }
  }
}

//------------------------------------------------------------------------------
// A picture from within a rough closed surface, as of a scan: every bump's shadow.
SHADOW_TEST(Inside, ScannedSurface, Once)
{
  CheckViews("a rough surface", { { 0.6, -1.2, 1.4 }, { -1.0, 1.5, 0.8 }, 80.0 },
    { { "a lamp within", LightKind::Point, { 0.8, 0.4, 1.9 } } }, { 0.0f, 1.0f },
    [](ShadowStage& stage)
    {
      stage.Add(Blob({ 0.0, 0.0, 1.0 }, 2.5, 0.25, 200));
      stage.Add(Blob({ -0.6, 0.4, 0.9 }, 0.4, 0.2, 48));
    });
}

//------------------------------------------------------------------------------
// The cap of what is looked into lies in lit surfaces. From outside it changes nothing, near or far, up
// to the terminator and at grazing light: bodies whose back faces are culled, which nobody misses.
SHADOW_TEST(Inside, CapsShadowNothingOfTheirOwn, Once)
{
  const Lamp grazing = { "a grazing sun", LightKind::Directional, { -4.0, 1.0, 0.3 } };
  for (const double distance : { 4.0, 40.0, 4000.0 })
  {
    for (const Lamp& lamp : { Outside, Sun, grazing })
    {
      for (const bool parallel : { false, true })
      {
        ShadowStage stage(200, 160);
        stage.AddFloor(8.0, -1.6);
        vtkActor* bodies[] = { stage.Add(Blob({ -1.2, 0.0, 0.0 }, 1.0, 0.0, 100)),
          stage.Add(Blob({ 1.4, 0.0, 0.0 }, 1.2, 0.15, 150)),
          stage.AddBox({ 0.1, -2.0, -1.0 }, { 1.5, 0.6, 0.8 }) };
        ShadowStage::Shrink(stage.AddLight(lamp.Kind, lamp.Place, { 0.0, 0.0, 0.0 }));
        const glm::dvec3 eye = distance * glm::dvec3(0.3, -0.8, 0.5);
        Look(stage, { eye, glm::dvec3(0.0), 140.0 / distance }, parallel);
        stage.SetPass("volume-hard", { { "counting", "z-fail" } });
        stage.Render();
        const Visibility whole = stage.GetVisibility();
        for (vtkActor* body : bodies)
        {
          body->GetProperty()->BackfaceCullingOn();
        }
        stage.Render();
        // But for pixels of outlines, where the floor shows between faces that are drawn.
        ShadowTest::CheckAtMost(Compare(stage.GetVisibility(), whole, 0.01).Share, 3e-4,
          "from " + std::to_string(static_cast<int>(distance)) + " away, " + lamp.Name +
            (parallel ? ", parallel view" : "") + ": share of pixels that culling changes");
      }
    }
  }
}

//------------------------------------------------------------------------------
// Closed surfaces within each other, more than 8 bits can count twice: none comes back to light.
SHADOW_TEST(Inside, ManyNested, Once)
{
  ShadowStage stage(100, 100);
  vtkNew<vtkAppendPolyData> append;
  for (int i = 0; i < 128; ++i)
  {
    const double side = 1.0 + 0.01 * i;
    append->AddInputData(Box({ -side, -side, -side }, { side, side, side }));
  }
  append->Update();
  stage.Add(append->GetOutput());
  stage.AddBox({ 0.0, 0.0, -0.5 }, { 0.4, 0.4, 0.2 });
  ShadowStage::Shrink(stage.AddLight(LightKind::Point, { 0.2, 0.1, 2.269 }, { 0.0, 0.0, 0.0 }));
  stage.LookAt({ 0.8, 0.8, 0.6 }, { -0.2, 0.0, -0.5 }, 80.0);
  CheckAgainstRays(stage, "128 shells, a lamp in the last", { 0.0f });
  ShadowTest::CheckEqual(stage.Count("wideCounts"), 1.0, "counts wider than 8 bits");
}

//------------------------------------------------------------------------------
// All samples of a light.
SHADOW_TEST(Inside, SoftLight, Once)
{
  ShadowStage stage(160, 120);
  stage.Add(Box({ -3.0, -3.0, 0.0 }, { 3.0, 3.0, 3.0 }));
  stage.AddBox({ 0.3, 0.2, 0.4 }, { 0.8, 0.6, 0.8 });
  stage.LookAt({ 2.5, 2.5, 2.2 }, { 0.0, 0.0, 0.5 }, 70.0);
  vtkAreaLight* light = stage.AddLight(LightKind::Sphere, { 4.0, 3.0, 6.0 }, { 0.0, 0.0, 0.0 });
  light->SetRadius(0.6);
  stage.SetPass("volume-soft", { { "samples", "100" } }); // more than a word's
  stage.Render();
  ShadowTest::CheckAtMost(
    GetRange(stage.GetVisibility()).second, 1e-4, "V where no light comes in");
}
