// SPDX-License-Identifier: BSD-3-Clause
// Rays where they matter only: what is left out changes nothing, however thin the casters are. And rays
// in packets and through structures of every kind are the same rays.

#include "ShadowStage.h"
#include "ShadowTest.h"

#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <cmath>
#include <string>

namespace
{
/** Quads of a width that stand, lean and float over the floor: a field of hairs. */
vtkSmartPointer<vtkPolyData> MakeHairs(int count, double width)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> quads;
  for (int i = 0; i < count; ++i)
  {
    // The golden ratio's multiples fill an interval evenly.
    const auto part = [i](double step) { return std::fmod(step * i, 1.0); };
    const glm::dvec3 root(3.0 * part(0.7548776662) - 1.5, 3.0 * part(0.5698402910) - 1.5,
      i % 3 == 0 ? 0.3 : width); // clear of the floor, which is no caster then
    const double turn = glm::two_pi<double>() * part(0.6180339887);
    const glm::dvec3 along(0.5 * std::cos(turn), 0.5 * std::sin(turn), i % 2 == 0 ? 0.6 : 0.05);
    const glm::dvec3 across = width * glm::normalize(glm::cross(along, glm::dvec3(0.3, -0.2, 1.0)));
    quads->InsertNextCell(4);
    for (const glm::dvec3& p : { root, root + across, root + along + across, root + along })
    {
      quads->InsertCellPoint(points->InsertNextPoint(p.x, p.y, p.z));
    }
  }
  auto hairs = vtkSmartPointer<vtkPolyData>::New();
  hairs->SetPoints(points);
  hairs->SetPolys(quads);
  return hairs;
}

/** How many pixels are off by more than four standard errors of so many rays, and the bias. */
void CheckAsAllRays(
  const Visibility& rays, const Visibility& few, int samples, const std::string& what)
{
  double off = 0.0;
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < rays.V.size(); ++i)
  {
    if (rays.Mask[i] != 0)
    {
      // One ray of each kind more, so that the error of 0 and 1 is not 0.
      const double share = (rays.V[i] * samples + 1.0) / (samples + 2.0);
      const double error = std::sqrt(share * (1.0 - share) / samples);
      const double difference = few.V[i] - rays.V[i];
      off += std::abs(difference) <= 4.0 * error ? 0.0 : 1.0;
      sum += difference;
      ++count;
    }
  }
  ShadowTest::CheckAtLeast(count, 10000.0, what + ": receivers");
  ShadowTest::CheckAtMost(off, 1e-4 * count, what + ": pixels off by more than 4 standard errors");
  ShadowTest::CheckAtMost(std::abs(sum / count), 0.0005, what + ": bias");
}
}

//------------------------------------------------------------------------------
// All rays of a pixel and of those around it, or so few that each pixel gets all: in both the picture is
// that of all rays.
SHADOW_TEST(AdaptiveRays, AreAsAllRays, Once)
{
  for (const LightKind kind : LightKinds)
  {
    ShadowStage stage(300, 300);
    stage.AddThings();
    stage.AddLight(kind);
    const auto see = [&](const char* name, const char* samples, const char* selection = "gpu")
    {
      stage.SetPass(
        name, { { "samples", samples }, { "selection", selection }, { "terminator", "facets" } });
      stage.Render();
      return stage.GetVisibility();
    };
    const std::string what = GetName(kind);
    const Visibility all = see("ray-traced", "64");
    const double rays = stage.Count("rays");
    const Visibility few = see("ray-adaptive", "64");
    CheckAsAllRays(all, few, 64, what);
    ShadowTest::CheckAtMost(stage.Count("rays"), 0.5 * rays, what + ": rays");
    ShadowTest::Check(
      Same(few, see("ray-adaptive", "64", "cpu")), what + ": pixels that are chosen on the CPU");
    const Visibility four = see("ray-traced", "4");
    ShadowTest::Check(Same(four, see("ray-adaptive", "4")),
      what + ": pixels that are not traced see all of the light, those of four rays are the same");
  }
}

//------------------------------------------------------------------------------
// Hairs a tenth of a texel wide, in maps of 64 texels over about four units. Each seed has rays of its
// own, none of which may find a pixel that was taken for lit to be hidden.
SHADOW_TEST(AdaptiveRays, MissNoHair, Once)
{
  for (const LightKind kind : { LightKind::Rectangle, LightKind::Sphere, LightKind::Directional })
  {
    ShadowStage stage(300, 300);
    stage.AddFloor();
    stage.Add(MakeHairs(150, 0.1 * 4.0 / 64.0));
    stage.AddLight(kind);
    const auto see = [&](const char* name, const char* samples, int seed)
    {
      stage.SetPass(name, { { "samples", samples }, { "seed", std::to_string(seed) },
                            { "map-resolution", "64" }, { "terminator", "facets" } });
      stage.Render();
      return stage.GetVisibility();
    };
    const std::string what = std::string("hairs, ") + GetName(kind);
    for (int seed = 0; seed < 12; ++seed)
    {
      const Visibility all = see("ray-traced", "4", seed);
      const Difference difference = Compare(see("ray-adaptive", "4", seed), all, 0.0);
      ShadowTest::CheckEqual(difference.Share, 0.0, what + ": pixels that are another's");
      ShadowTest::CheckAtMost(stage.Count("pixelsTraced"),
        0.9 * static_cast<double>(all.GetNumberOfReceivers()), what + ": pixels that are traced");
    }
    const Visibility all = see("ray-traced", "64", 0);
    CheckAsAllRays(all, see("ray-adaptive", "64", 0), 64, what);
  }
}

//------------------------------------------------------------------------------
// A pixel stops where its error is as small as was asked for: of V as 1024 rays tell it.
SHADOW_TEST(AdaptiveRays, StopAtAnError, Once)
{
  ShadowStage stage(300, 300);
  stage.AddThings();
  stage.AddLight(LightKind::Rectangle);
  const auto see = [&](const char* name, const char* samples, const char* seed, const char* error)
  {
    stage.SetPass(name,
      { { "samples", samples }, { "seed", seed }, { "error", error }, { "terminator", "facets" } });
    stage.Render();
    return stage.GetVisibility();
  };
  const Visibility truth = see("ray-traced", "1024", "7", "");
  std::vector<unsigned char> penumbra(truth.V.size());
  for (std::size_t i = 0; i < truth.V.size(); ++i)
  {
    penumbra[i] = truth.Mask[i] != 0 && truth.V[i] > 0.02f && truth.V[i] < 0.98f ? 1 : 0;
  }
  double before = 0.0;
  for (const char* error : { "0.02", "0.008", "0.006" })
  {
    const Visibility seen = see("ray-adaptive", "1024", "0", error);
    const double rays = stage.Count("rays");
    ShadowTest::CheckAtMost(Compare(seen, truth, 0.1, penumbra).RMSE, std::stod(error),
      std::string("standard error in penumbrae, of ") + error);
    ShadowTest::CheckAtLeast(rays, 1.1 * before, std::string("rays for ") + error);
    before = rays;
  }
}

//------------------------------------------------------------------------------
// Packets and structures change the time, and V by rounding: at edges, of single rays.
SHADOW_TEST(AdaptiveRays, PacketsAreTheSameRays, Once)
{
  ShadowStage stage(300, 300);
  stage.AddThings();
  stage.AddLight(LightKind::Disk);
  const auto see = [&](const char* packet, const char* structure)
  {
    stage.SetPass("ray-traced", { { "samples", "16" }, { "packet", packet },
                                  { "structure", structure }, { "terminator", "facets" } });
    stage.Render();
    ShadowTest::CheckAtLeast(stage.Count("megaraysPerSecond"), 1e-3, "million rays a second");
    return stage.GetVisibility();
  };
  const Visibility single = see("1", "instanced");
  for (const char* structure : { "instanced", "flat" })
  {
    for (const char* packet : { "1", "4", "8", "16" })
    {
      const Difference difference = Compare(see(packet, structure), single, 0.07);
      const std::string what = std::string(structure) + ", packets of " + packet;
      ShadowTest::CheckAtMost(difference.Share, 1e-4, what + ": pixels off by more than a ray");
      ShadowTest::CheckAtMost(difference.RMSE, 0.002, what + ": RMSE");
    }
  }
}
