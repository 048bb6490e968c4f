// SPDX-License-Identifier: BSD-3-Clause
// What penumbra wedges promise: the union of casters by counts, no streak wherever the eye is and
// whatever the mesh, and the same picture however wedges are bounded.

#include "ShadowOracle.h"
#include "ShadowTest.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkImageData.h"
#include "vtkLightCollection.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTexture.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{
vtkAreaLight* AddLight(ShadowStage& stage, LightKind kind, const glm::dvec3& place, double size)
{
  vtkAreaLight* light = stage.AddLight(kind, place, { 0.0, 0.0, 0.0 });
  light->SetRadius(size);
  light->SetWidth(2.0 * size);
  light->SetHeight(2.0 * size);
  return light;
}

/** Polygons over points, whatever they are. */
void AddMesh(ShadowStage& stage, const std::vector<glm::dvec3>& points,
  const std::vector<std::vector<vtkIdType>>& polygons)
{
  vtkNew<vtkPoints> places;
  for (const auto& p : points)
  {
    places->InsertNextPoint(p.x, p.y, p.z);
  }
  vtkNew<vtkCellArray> cells;
  for (const auto& polygon : polygons)
  {
    cells->InsertNextCell(static_cast<vtkIdType>(polygon.size()), polygon.data());
  }
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(places);
  mesh->SetPolys(cells);
  stage.Add(mesh);
}

/** Open, wound both ways, doubled, three at an edge, passing through each other, of no area. */
void AddBadMeshes(ShadowStage& stage)
{
  AddMesh(stage,
    { { -1.4, -1.0, 1.0 }, { 0.2, -1.0, 1.0 }, { 0.2, 0.4, 1.2 }, { -1.4, 0.4, 1.2 },
      { -0.6, -0.3, 2.0 }, { -0.6, -1.0, 1.6 } },
    { { 0, 1, 2 }, { 0, 3, 2 }, { 0, 1, 2 }, { 0, 2, 4 }, { 1, 1, 2 }, { 0, 5, 1 }, { 3, 3, 3 } });
  AddMesh(stage,
    { { 0.4, -0.8, 0.4 }, { 1.6, -0.8, 1.0 }, { 1.0, 0.6, 0.7 }, { 0.8, -0.2, 0.1 },
      { 1.3, -0.1, 1.5 }, { 1.0, 0.9, 0.9 } },
    { { 0, 1, 2 }, { 3, 4, 5 }, { 0, 4, 2 }, { 5, 4, 3 } });
}

/** Whose hole has a concave silhouette. */
void AddTorus(ShadowStage& stage, const glm::dvec3& centre, int resolution)
{
  std::vector<glm::dvec3> points;
  std::vector<std::vector<vtkIdType>> polygons;
  const auto at = [&](int i, int j)
  { return static_cast<vtkIdType>((i % resolution) * resolution + j % resolution); };
  for (int i = 0; i < resolution; ++i)
  {
    for (int j = 0; j < resolution; ++j)
    {
      const double around = glm::radians(360.0 * i / resolution);
      const double across = glm::radians(360.0 * j / resolution);
      const double reach = 0.4 + 0.15 * std::cos(across);
      points.push_back(centre + glm::dvec3(reach * std::cos(around), reach * std::sin(around),
                                  0.15 * std::sin(across)));
      polygons.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) });
    }
  }
  AddMesh(stage, points, polygons);
}

Visibility See(ShadowStage& stage, const std::string& technique, const Parameters& parameters)
{
  stage.SetPass(technique, parameters);
  stage.Render();
  return stage.GetVisibility();
}
}

//------------------------------------------------------------------------------
// Two squares under a square light, all parallel: what they hide together is a union of rectangles
// of the light. Of 256 stratified samples 0.5 x 256^-0.75 = 0.0078 are wrong in the penumbra, a
// tenth of the picture.
SHADOW_TEST(Wedges, StackedSquares, Once)
{
  ShadowStage stage(200, 200);
  vtkActor* floor = stage.AddFloor(5.0);
  const glm::dvec2 low[] = { { -1.0, -0.9 }, { -0.4, -0.5 } };
  const glm::dvec2 high[] = { { 0.6, 0.7 }, { 1.2, 1.0 } };
  const double heights[] = { 1.5, 3.0 };
  for (int i = 0; i < 2; ++i)
  {
    const glm::dvec2 size = high[i] - low[i];
    stage.AddQuad({ low[i], heights[i] }, { size.x, 0.0, 0.0 }, { 0.0, size.y, 0.0 });
  }
  AddLight(stage, LightKind::Rectangle, { 0.0, 0.0, 6.0 }, 1.0);
  stage.LookAt({ 3.0, -8.0, 5.0 }, { 0.0, 0.0, 0.3 });
  const ShadowOracle oracle(stage);
  const auto mask = oracle.GetMask(floor);
  auto use = oracle.GetInner(1);
  Visibility truth;
  truth.Width = truth.Height = 200;
  truth.Mask.assign(use.size(), 1);
  for (std::size_t k = 0; k < use.size(); ++k)
  {
    use[k] = use[k] && mask[k];
    const glm::dvec3& p = oracle.GetPixels()[k].Position;
    glm::dvec2 from[3];
    glm::dvec2 to[3];
    for (int i = 0; i < 2; ++i)
    {
      const double scale = (6.0 - p.z) / (heights[i] - p.z);
      from[i] = glm::clamp(glm::dvec2(p) + scale * (low[i] - glm::dvec2(p)), -1.0, 1.0);
      to[i] = glm::clamp(glm::dvec2(p) + scale * (high[i] - glm::dvec2(p)), -1.0, 1.0);
    }
    from[2] = glm::max(from[0], from[1]);
    to[2] = glm::max(from[2], glm::min(to[0], to[1]));
    double areas[3];
    for (int i = 0; i < 3; ++i)
    {
      const glm::dvec2 size = to[i] - from[i];
      areas[i] = 0.25 * size.x * size.y;
    }
    truth.V.push_back(static_cast<float>(1.0 - areas[0] - areas[1] + areas[2]));
  }
  const auto count = See(stage, "wedges", { { "overlap", "count" }, { "samples", "256" } });
  ShadowTest::CheckAtMost(Compare(count, truth, 0.1, use).RMSE, 0.005, "count: RMSE");
  ShadowTest::CheckAtMost(std::abs(Compare(count, truth, 0.1, use).Bias), 0.0005, "count: bias");
  // Where both hide the same part of the light it counts twice: the sum is darker, never lighter.
  const auto sum = See(stage, "wedges", { { "overlap", "sum" } });
  ShadowTest::CheckAtMost(Compare(sum, truth, 0.1, use).Bias, -0.001, "sum: bias");
  // A guess between both bounds.
  const auto loops = See(stage, "wedges", { { "overlap", "loops" } });
  ShadowTest::CheckEqual(stage.Count("loops"), 2.0, "loops of silhouettes");
  ShadowTest::CheckAtMost(Compare(loops, truth, 0.1, use).RMSE,
    0.8 * Compare(sum, truth, 0.1, use).RMSE, "loops: RMSE, against that of the sum");
  for (std::size_t k = 0; k < use.size(); ++k)
  {
    if (use[k] && sum.V[k] > truth.V[k] + 0.005f)
    {
      ShadowTest::Check(false, "sum: lighter than the truth at pixel " + std::to_string(k));
      break;
    }
  }
}

//------------------------------------------------------------------------------
// Terms are multiples of 2^-20, whose sums floats hold without rounding: what inner halves let
// through less what outer ones hide is the whole, and casters may come in any order, to the bit. The
// views' sums over all pixels are exact in doubles too.
SHADOW_TEST(Wedges, SumsAreExact, Once)
{
  for (const LightKind kind :
    { LightKind::Sphere, LightKind::Disk, LightKind::Rectangle, LightKind::Directional })
  {
    const std::string name = GetName(kind);
    Visibility seen[2];
    for (const bool reverse : { false, true })
    {
      ShadowStage stage(120, 120);
      stage.AddFloor();
      for (int i = 0; i < 5; ++i)
      {
        const int k = reverse ? 4 - i : i;
        stage.AddSphere({ 0.3 * k - 0.6, 0.2 * k - 0.3, 0.7 + 0.2 * (k % 2) }, 0.31, 10 + 3 * k);
      }
      stage.AddLight(kind);
      stage.LookAt({ 3.0, -6.5, 4.0 }, { 0.0, 0.0, 0.4 });
      seen[reverse ? 1 : 0] = See(stage, "wedges", {});
      double sums[3];
      const char* views[] = { "inner", "outer", "edges" };
      for (int i = 0; i < 3; ++i)
      {
        stage.Pass->SetDebugView(views[i]);
        stage.Render();
        sums[i] = stage.Count(std::string(views[i]) + "Pixels");
        ShadowTest::CheckAtLeast(std::abs(sums[i]), 1.0, name + ", view " + views[i]);
        ShadowTest::CheckEqual(
          std::remainder(sums[i], std::exp2(-20.0)), 0.0, name + ": what is no multiple of 2^-20");
      }
      ShadowTest::CheckEqual(sums[0] - sums[1], sums[2], name + ": inner halves less outer ones");
    }
    ShadowTest::Check(Same(seen[0], seen[1]), name + ": V depends on the order of casters");
  }
}

//------------------------------------------------------------------------------
// A half plane under a textured light, at any angle: red is half of it, green a ramp along the other
// axis, and blue, without emission, geometry. The truth is exact along rows of the light. Where the
// emission jumps, tables have kinks, between whose texels, 1/23 of a half side, a line is off by a
// quarter of a texel times the kink of 1/2, of a light of 2: 0.003. With loops and split too.
SHADOW_TEST(Wedges, TexturedLight, Once)
{
  constexpr double h = 2.0;
  constexpr double H = 6.0;
  constexpr int size = 64;
  vtkNew<vtkImageData> emission;
  emission->SetDimensions(size, size, 1);
  emission->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int i = 0; i < size * size; ++i)
  {
    auto* texel = static_cast<unsigned char*>(emission->GetScalarPointer(i % size, i / size, 0));
    texel[0] = i % size >= size / 2 ? 0 : 255;
    texel[1] = static_cast<unsigned char>(4 * (i / size));
    texel[2] = 0;
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(emission);
  // What a column emits, with the texel in which the halves meet; and what lies below.
  const auto red = [](double u) { return std::clamp(0.5 - 0.5 * u * size, 0.0, 1.0); };
  const auto green = [](double v) { return std::clamp(0.5 * (v + 1.0) * size - 0.5, 0.0, 63.0); };
  constexpr int steps = 1024;
  std::vector<double> below(1, 0.0);
  for (int i = 0; i < steps; ++i)
  {
    below.push_back(below.back() + red((2.0 * i + 1.0) / steps - 1.0));
  }
  for (const double degrees : { 0.0, 30.0, 77.0, 200.0 })
  {
    const glm::dvec2 normal(std::cos(glm::radians(degrees)), std::sin(glm::radians(degrees)));
    const glm::dvec2 along(-normal.y, normal.x);
    ShadowStage stage(120, 120);
    vtkActor* floor = stage.AddFloor(6.0);
    stage.AddQuad({ -16.0 * (normal + along), h }, { 16.0 * normal, 0.0 }, { 32.0 * along, 0.0 });
    vtkAreaLight* light = AddLight(stage, LightKind::Rectangle, { 0.0, 0.0, H }, 1.0);
    light->SetTexture(texture);
    stage.LookAt({ 1.0, -1.0, 1.8 }, { 0.0, 0.0, 0.0 }, 90.0);
    const ShadowOracle oracle(stage);
    const auto mask = oracle.GetMask(floor);
    const auto inner = oracle.GetInner(1);
    for (const Parameters& parameters : { Parameters{ { "overlap", "sum" } },
           Parameters{ { "overlap", "loops" } }, Parameters{ { "split", "2" } } })
    {
      const auto seen = See(stage, "wedges", parameters);
      if (!ShadowTest::CheckEqual(seen.Components, 3, "components"))
      {
        return;
      }
      double squares[3] = { 0.0, 0.0, 0.0 };
      double worst = 0.0;
      int pixels = 0;
      for (std::size_t i = 0; i < mask.size(); ++i)
      {
        if (!mask[i] || !inner[i])
        {
          continue;
        }
        // A point (u, v) of the light is hidden where normal . (p + (L - p) h / H) < 0.
        const glm::dvec2 p(oracle.GetPixels()[i].Position);
        const double offset = glm::dot(normal, p) * (H / h - 1.0);
        double hidden[3] = { 0.0, 0.0, 0.0 };
        double whole[3] = { 0.0, 0.0, 0.0 };
        constexpr int rows = 64;
        for (int j = 0; j < rows; ++j)
        {
          const double v = (2.0 * j + 1.0) / rows - 1.0;
          const double u = std::clamp(-(offset + normal.y * v) / normal.x, -1.0, 1.0);
          const double place = 0.5 * (u + 1.0) * steps;
          const int k = std::min(static_cast<int>(place), steps - 1);
          double shares[3] = { below[k] + (place - k) * (below[k + 1] - below[k]), place, place };
          double all[3] = { below[steps], steps, steps };
          for (int c = 0; c < 3; ++c)
          {
            const double weight = c == 1 ? green(v) : 1.0;
            hidden[c] += weight * (normal.x > 0.0 ? shares[c] : all[c] - shares[c]);
            whole[c] += weight * all[c];
          }
        }
        for (int c = 0; c < 3; ++c)
        {
          const double difference = seen.V[3 * i + c] - (1.0 - hidden[c] / whole[c]);
          squares[c] += difference * difference;
          worst = std::max(worst, std::abs(difference));
        }
        ++pixels;
      }
      ShadowTest::CheckAtLeast(pixels, 5000.0, "pixels");
      const std::string what = parameters.begin()->second + " at " + std::to_string(degrees);
      for (int c = 0; c < 3; ++c)
      {
        ShadowTest::CheckAtMost(
          std::sqrt(squares[c] / pixels), 0.001, what + ", channel " + std::to_string(c));
      }
      ShadowTest::CheckAtMost(worst, 0.004, what + ", worst pixel");
    }
  }
}

//------------------------------------------------------------------------------
// On bodies, whose own horizons cut the light too, the tables are as good as the formula of an even
// light: against 256 rays the error is no more than half as large again.
SHADOW_TEST(Wedges, TexturedLightOnBodies, Once)
{
  double errors[2];
  for (const bool textured : { false, true })
  {
    ShadowStage stage;
    stage.AddThings();
    vtkAreaLight* light = stage.AddLight(LightKind::Rectangle);
    if (textured)
    {
      vtkNew<vtkImageData> emission;
      emission->SetDimensions(8, 8, 1);
      emission->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
      for (int i = 0; i < 3 * 64; ++i)
      {
        static_cast<unsigned char*>(emission->GetScalarPointer())[i] =
          static_cast<unsigned char>(40 + 71 * i % 210);
      }
      vtkNew<vtkTexture> texture;
      texture->SetInputData(emission);
      light->SetTexture(texture);
    }
    const auto sum = See(stage, "wedges", {});
    const auto rays =
      See(stage, "ray-traced", { { "samples", "256" }, { "terminator", "facets" } });
    errors[textured ? 1 : 0] = Compare(sum, rays).RMSE;
  }
  ShadowTest::CheckAtMost(errors[1], 1.5 * errors[0], "RMSE, against that of an even light");
}

//------------------------------------------------------------------------------
// However a wedge is bounded, what its edge hides is the same, to the bit.
SHADOW_TEST(Wedges, BoundsChangeNothing, Once)
{
  for (const LightKind kind :
    { LightKind::Sphere, LightKind::Disk, LightKind::Rectangle, LightKind::Directional })
  {
    for (const char* overlap : { "sum", "loops", "count" })
    {
      ShadowStage stage;
      stage.AddThings();
      stage.AddLight(kind);
      const auto tight = See(stage, "wedges", { { "overlap", overlap } });
      const auto sphere = See(stage, "wedges", { { "overlap", overlap }, { "bounds", "sphere" } });
      ShadowTest::Check(
        Same(tight, sphere), std::string(GetName(kind)) + ", " + overlap + ": V by another bound");
      ShadowTest::CheckAtLeast(stage.Count("wedgesDrawn"), 10.0, "wedges");
    }
  }
}

//------------------------------------------------------------------------------
// Runs of short edges that are one edge move a shadow by less than a pixel: each pixel is as bright as
// some place between it and its neighbours was, so that it lies between the least and the greatest of
// these, and there is no hole: but for single pixels on bodies themselves beside a silhouette, where the
// light is seen along the surface. More edges are left where the camera is nearer.
SHADOW_TEST(Wedges, RunsAreOneEdge, Once)
{
  for (const LightKind kind : { LightKind::Sphere, LightKind::Rectangle, LightKind::Directional })
  {
    for (const double softness : { 0.1, 1.0 })
    {
      for (const Parameters& parameters : { Parameters{ { "merge", "0.25" } },
             Parameters{ { "merge", "0.25" }, { "overlap", "loops" }, { "split", "2" } } })
      {
        ShadowStage stage(160, 120);
        stage.AddFloor();
        stage.AddSphere({ 0.0, 0.0, 1.0 }, 0.6, 160);
        stage.AddSphere({ 0.9, -0.8, 0.4 }, 0.3, 100);
        AddTorus(stage, { -1.1, 0.4, 0.7 }, 96);
        ShadowStage::Shrink(stage.AddLight(kind), softness);
        stage.LookAt({ 3.0, -6.5, 4.0 }, { 0.0, 0.0, 0.4 });
        Parameters every = parameters;
        every.erase("merge");
        const auto before = See(stage, "wedges", every);
        const double edges = stage.Count("wedges");
        ShadowTest::CheckEqual(stage.Count("linesMerged"), 0.0, "merged, by default");
        const auto after = See(stage, "wedges", parameters);
        const double fewer = stage.Count("wedges");
        const std::string what = std::string(GetName(kind)) + " x " + std::to_string(softness) +
                                 (parameters.count("overlap") ? ", loops" : "");
        ShadowTest::CheckAtMost(fewer, 0.7 * edges, what + ": wedges, of " + std::to_string(edges));
        int wrong = 0;
        for (int k = 0; k < after.Width * after.Height; ++k)
        {
          float low = 1.0f;
          float high = 0.0f;
          for (int j = 0; j < 9; ++j)
          {
            const int x = std::clamp(k % after.Width + j % 3 - 1, 0, after.Width - 1);
            const int y = std::clamp(k / after.Width + j / 3 - 1, 0, after.Height - 1);
            const std::size_t i = static_cast<std::size_t>(y) * after.Width + x;
            low = std::min(low, before.V[i]);
            high = std::max(high, before.V[i]);
          }
          wrong += after.Mask[k] && !(after.V[k] >= low - 0.02f && after.V[k] <= high + 0.02f);
        }
        ShadowTest::CheckAtMost(wrong, 0.0005 * after.Width * after.Height,
          what + ": pixels out of their neighbours' range");
        stage.LookAt({ 0.6, -1.3, 1.8 }, { 0.0, 0.0, 0.4 });
        stage.Render();
        ShadowTest::CheckAtLeast(stage.Count("wedges"), 1.1 * fewer, what + ": wedges from nearby");
      }
    }
  }
}

//------------------------------------------------------------------------------
// How far a ground reaches changes little of what is seen of it. What VTK computes with such a one
// bounds the rounding of its points by a tenth of the scene, of which hundredths of a penumbra may be on
// the wrong side of an edge; what rounding there is moves shadows by far less.
SHADOW_TEST(Wedges, FarGround, Once)
{
  for (const LightKind kind :
    { LightKind::Sphere, LightKind::Disk, LightKind::Rectangle, LightKind::Directional })
  {
    for (const char* overlap : { "sum", "count" })
    {
      Visibility seen[2];
      for (const bool far : { false, true })
      {
        ShadowStage stage(200, 200);
        stage.AddFloor(far ? 4e4 : 40.0);
        stage.AddQuad({ -1.0, -1.0, 1.0 }, { 1.5, 0.0, 0.0 }, { 0.0, 1.5, 0.0 });
        stage.AddBox({ 1.2, 0.4, 1.1 }, { 0.6, 0.8, 1.0 });
        stage.AddLight(kind);
        stage.LookAt({ 3.0, -6.5, 4.5 }, { 0.6, 0.4, 0.0 });
        seen[far ? 1 : 0] = See(stage, "wedges", { { "overlap", overlap } });
      }
      const std::string what = std::string(GetName(kind)) + ", " + overlap;
      ShadowTest::CheckAtMost(GetRange(seen[0]).first, 0.1, what + ": lowest V");
      ShadowTest::CheckAtMost(Compare(seen[1], seen[0]).RMSE, 0.01, what + ": RMSE");
    }
  }
}

//------------------------------------------------------------------------------
// A light of no size is counted as volume-hard counts it.
SHADOW_TEST(Wedges, ZeroSizeIsVolumeHard, Once)
{
  for (const LightKind kind : { LightKind::Sphere, LightKind::Rectangle, LightKind::Directional })
  {
    for (const char* overlap : { "sum", "loops", "count" })
    {
      ShadowStage stage;
      stage.AddThings();
      ShadowStage::Shrink(stage.AddLight(kind));
      ShadowTest::Check(
        Same(See(stage, "wedges", { { "overlap", overlap } }), See(stage, "volume-hard", {})),
        std::string(GetName(kind)) + ", " + overlap + ": not volume-hard");
    }
  }
}

//------------------------------------------------------------------------------
// The eye in the penumbra, in the inner half of a wedge, in the plane of a volume's side, before a
// caster that the near plane cuts, and in a parallel view; of bodies and of meshes that are none.
// What differs from rays by a quarter of the light and more are single pixels at edges: one in 300.
SHADOW_TEST(Wedges, NoStreaks, Once)
{
  // A sheet of side 3 at height 3 under a light at height 6 of radius 0.5: the side of its volume
  // towards -y holds the points y = -1.5 - (3 - z) / 2, and the penumbra reaches half as far again.
  const struct
  {
    const char* What;
    glm::dvec3 Eye, Focus;
    double Near;
  } views[] = {
    { "from outside", { 3.0, -8.0, 5.0 }, { 0.0, 0.0, 0.5 }, 0.1 },
    { "in the penumbra", { 0.3, -1.8, 2.0 }, { 1.0, 2.0, 0.0 }, 0.01 },
    { "in a side's plane", { 0.3, -2.0, 2.0 }, { 3.0, -3.0, 0.0 }, 0.01 },
    { "in the inner half", { 0.3, -1.7, 1.8 }, { 0.2, 3.0, 0.2 }, 0.01 },
    { "in the umbra", { 0.3, -0.2, 0.9 }, { 3.0, 1.0, 0.0 }, 0.01 },
    { "before the near plane", { 2.5, -4.0, 1.8 }, { 0.0, 0.0, 0.8 }, 3.6 },
  };
  for (const bool bad : { false, true })
  {
    for (const bool parallel : { false, true })
    {
      for (const auto& view : views)
      {
        ShadowStage stage(160, 120);
        stage.AddFloor(8.0);
        stage.AddQuad({ -1.5, -1.5, 3.0 }, { 3.0, 0.0, 0.0 }, { 0.0, 3.0, 0.0 });
        bad ? AddBadMeshes(stage)
            : static_cast<void>(stage.AddBox({ 1.2, 0.4, 0.6 }, { 1.0, 0.8, 1.0 }));
        AddLight(stage, LightKind::Sphere, { 0.1, 0.0, 6.0 }, 0.5);
        stage.LookAt(view.Eye, view.Focus, 60.0);
        vtkCamera* camera = stage.Renderer->GetActiveCamera();
        camera->SetClippingRange(view.Near, 40.0);
        camera->SetParallelProjection(parallel);
        camera->SetParallelScale(2.5);
        const auto use = ShadowOracle(stage).GetInner(1);
        const auto truth = See(stage, "ray-traced", { { "samples", "64" } });
        const std::string what = std::string(view.What) + (bad ? ", bad meshes" : ", bodies") +
                                 (parallel ? ", parallel view" : "");
        // What is looked at is there.
        const auto range = GetRange(truth);
        ShadowTest::CheckAtMost(range.first, 0.1, what + ": lowest V");
        ShadowTest::CheckAtLeast(range.second, 0.5, what + ": highest V");
        const auto count = See(stage, "wedges", { { "overlap", "count" }, { "samples", "64" } });
        ShadowTest::CheckAtMost(
          Compare(count, truth, 0.25, use).Share, 0.0033, what + ", count: pixels other than rays");
        if (!bad) // or its limits are more
        {
          const auto sum = See(stage, "wedges", { { "overlap", "sum" } });
          ShadowTest::CheckAtMost(
            Compare(sum, truth, 0.5, use).Share, 0.0033, what + ", sum: pixels other than rays");
          const auto loops = See(stage, "wedges", { { "overlap", "loops" }, { "split", "2" } });
          ShadowTest::CheckAtMost(Compare(loops, truth, 0.5, use).Share, 0.0033,
            what + ", loops: pixels other than rays");
        }
      }
    }
  }
}
