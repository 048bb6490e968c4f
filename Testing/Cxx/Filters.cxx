// SPDX-License-Identifier: BSD-3-Clause
// What the filters of one map a light promise: leaving out changes nothing, penumbrae follow the
// light, midpoints fall back, the blur has no halo. Techniques are known by their parameters.

#include "ShadowOracle.h"
#include "ShadowTest.h"

#include "vtkLightCollection.h"
#include "vtkShadowScenes.h"
#include "vtkShadowTechniques.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace
{
Visibility ShowThings(
  const std::string& technique, LightKind kind, double size, const Parameters& parameters)
{
  return RenderVisibility(technique, parameters,
    [&](ShadowStage& stage)
    {
      stage.AddThings();
      ShadowStage::Shrink(stage.AddLight(kind), size);
    });
}

/** Of one depth map a light, looked up around a receiver; others leave out look-ups too. */
bool IsFilter(const std::string& technique)
{
  return ShadowStage::HasParameter(technique, "skipping") &&
         ShadowStage::HasParameter(technique, "filter");
}

/** RMSE in the penumbra against the closed form of the scene `blocker`, its light being that large. */
double MeasureBlocker(const std::string& technique, double width, double height)
{
  ShadowStage stage(400, 400);
  vtkShadowScenes::Build("blocker", stage.Renderer);
  auto* floor = vtkActor::SafeDownCast(stage.Renderer->GetViewProps()->GetItemAsObject(0));
  auto* light = vtkAreaLight::SafeDownCast(stage.Renderer->GetLights()->GetItemAsObject(0));
  light->SetWidth(width);
  light->SetHeight(height);
  stage.Pass.TakeReference(vtkShadowTechniques::Create(technique)); // at its defaults
  stage.Renderer->SetPass(stage.Pass);
  stage.Render();
  const Visibility visibility = stage.GetVisibility();
  const ShadowOracle oracle(stage);
  const auto inner = oracle.GetInner(1);
  auto use = oracle.GetMask(floor);
  // Width runs along focal direction x up.
  const double* up = light->GetUpVector();
  const bool alongX = std::abs(up[1]) > std::abs(up[0]);
  Visibility truth = visibility;
  for (std::size_t i = 0; i < use.size(); ++i)
  {
    use[i] = use[i] && inner[i];
    const glm::dvec3& p = oracle.GetPixels()[i].Position;
    truth.V[i] = static_cast<float>(vtkShadowScenes::RectangleVisibility(
      0.5 * (alongX ? width : height), 0.5 * (alongX ? height : width), 6.0, 1.0, 2.0, p.x, p.y));
    use[i] = use[i] && truth.V[i] > 0.02f && truth.V[i] < 0.98f;
  }
  return Compare(visibility, truth, 0.1, use).RMSE;
}
}

//------------------------------------------------------------------------------
// A light that goes away and grows with its distance is the same light to a scene, once it is far: where
// it is a thousand times as far as the scene is large, and a million. Pixels at edges, 500 of 25,600, may
// turn where a texel lies elsewhere.
SHADOW_TEST(Filters, FarLightsAreAlike, Each)
{
  if (!ShadowStage::HasParameter(technique, "midpoint"))
  {
    return;
  }
  const auto show = [&](double distance)
  {
    return RenderVisibility(technique, { { "resolution", "512" } },
      [&](ShadowStage& stage)
      {
        stage.AddThings();
        vtkAreaLight* light = stage.AddLight(
          LightKind::Rectangle, distance * glm::dvec3(-2.5, -2.0, 5.5), { 0.0, 0.0, 0.0 });
        ShadowStage::Shrink(light, distance);
      });
  };
  const Difference difference = Compare(show(1e6), show(1e3), 0.5);
  ShadowTest::CheckAtMost(difference.Share, 20.0 / 25600.0, "pixels that differ");
}

//------------------------------------------------------------------------------
// Surely lit and surely dark receivers are told conservatively: not a bit differs, whatever the light,
// and at a resolution that is no power of two, for which the pyramid's cells do not fit.
SHADOW_TEST(Filters, SkippingChangesNothing, Each)
{
  if (!ShadowStage::HasParameter(technique, "skipping"))
  {
    return;
  }
  for (const LightKind kind : LightKinds)
  {
    for (const double size : { 0.3, 3.0 })
    {
      const auto show = [&](const char* skipping)
      {
        return ShowThings(
          technique, kind, size, { { "skipping", skipping }, { "resolution", "300" } });
      };
      const Visibility on = show("on");
      ShadowTest::CheckEqual(Compare(on, show("off")).Maximum, 0.0,
        std::string(GetName(kind)) + " x " + std::to_string(size) + ": largest difference");
      ShadowTest::CheckEqual(GetRange(on).first, 0.0, "there is a shadow");
    }
  }
}

//------------------------------------------------------------------------------
// A light without size gives the picture of map-hard bit by bit, from one map and one look-up.
SHADOW_TEST(Filters, ZeroSizeIsMapHard, Each)
{
  if (!IsFilter(technique))
  {
    return;
  }
  for (const LightKind kind : { LightKind::Point, LightKind::Sphere, LightKind::Rectangle })
  {
    ShadowTest::Check(
      Same(ShowThings(technique, kind, 0.0, {}), ShowThings("map-hard", kind, 0.0, {})),
      std::string(GetName(kind)) + ": not the picture of map-hard");
  }
  ShadowStage stage;
  stage.AddThings();
  stage.AddLight(LightKind::Point);
  stage.SetPass(technique);
  stage.Render();
  const auto statistics = stage.GetStatistics();
  ShadowTest::CheckEqual(stage.Count("mapsDrawn"), 1.0, "maps");
  ShadowTest::Check(statistics["evaluation"] == "forward", "not evaluated forward");
  ShadowTest::Check(!statistics["bytes"].contains("pyramid"), "a pyramid is held");
  ShadowTest::Check(!statistics["bytes"].contains("layers"), "layers are held");
}

//------------------------------------------------------------------------------
// Where blockers are searched, penumbrae are the light's: with a light of twice or half the size, or
// 4 : 1 either way, the error in them grows by half at most (over all pixels it grows with their share
// too); and it is small to begin with.
SHADOW_TEST(Filters, PenumbraFollowsTheLight, Each)
{
  if (!ShadowStage::HasParameter(technique, "search"))
  {
    return;
  }
  const double error = MeasureBlocker(technique, 2.0, 2.0);
  ShadowTest::CheckAtMost(error, 0.06, "RMSE of the light as it is");
  const double sizes[][2] = { { 4.0, 4.0 }, { 1.0, 1.0 }, { 4.0, 1.0 }, { 1.0, 4.0 } };
  for (const auto& size : sizes)
  {
    ShadowTest::CheckAtMost(MeasureBlocker(technique, size[0], size[1]), 1.5 * error,
      std::to_string(size[0]) + " x " + std::to_string(size[1]) + ": RMSE");
  }
}

//------------------------------------------------------------------------------
// A sheet has no second side: its midpoint map is its map. Nor have two sheets, one under the other,
// whichever way they face: the middle between them is nowhere. A box has: its midpoint lies within.
SHADOW_TEST(Filters, MidpointFallsBack, Each)
{
  if (!ShadowStage::HasParameter(technique, "midpoint"))
  {
    return;
  }
  for (const bool closed : { false, true })
  {
    const auto show = [&](const char* midpoint)
    {
      return RenderVisibility(technique, { { "midpoint", midpoint } },
        [closed](ShadowStage& stage)
        {
          stage.AddFloor();
          if (closed)
          {
            stage.AddBox({ 0.0, 0.0, 1.2 }, { 1.5, 1.5, 1.2 });
          }
          else
          {
            stage.AddQuad({ -1.0, -1.0, 1.8 }, { 1.5, 0.0, 0.0 }, { 0.0, 1.5, 0.0 });
            // Whichever side it shows.
            stage.AddQuad({ -0.5, -0.5, 0.9 }, { 0.0, 1.5, 0.0 }, { 1.5, 0.0, 0.0 });
          }
          stage.AddLight(LightKind::Rectangle);
          stage.LookAt({ 3.5, -6.5, 4.5 }, { 0.2, 0.2, 0.3 });
        });
    };
    const Visibility off = show("off");
    const Visibility on = show("on");
    ShadowTest::CheckEqual(GetRange(on).first, 0.0, "there is a shadow");
    if (!closed)
    {
      ShadowTest::Check(Same(on, off), "the midpoint map of sheets is another");
    }
    else
    {
      // The same edges: what is behind the box is behind its middle too.
      ShadowTest::CheckAtMost(Compare(on, off, 0.5).Share, 0.01, "pixels that turn");
    }
  }
}

//------------------------------------------------------------------------------
// As the light shrinks, the blur that knows its surfaces comes to the hard shadow everywhere; the
// plain one stays as wide as it is in the picture, over silhouettes too: its halo.
SHADOW_TEST(Filters, BlurHasNoHalo, Each)
{
  if (!ShadowStage::HasParameter(technique, "blur"))
  {
    return;
  }
  const Visibility hard = ShowThings(technique, LightKind::Sphere, 0.0, {});
  const auto measure = [&](const char* blur)
  {
    return Compare(ShowThings(technique, LightKind::Sphere, 0.05, { { "blur", blur } }), hard, 0.2)
      .Share;
  };
  ShadowTest::CheckAtMost(measure("aware"), 0.01, "aware: pixels that differ from hard");
  ShadowTest::CheckAtLeast(measure("plain"), 0.03, "plain: pixels that differ from hard");
}

//------------------------------------------------------------------------------
// resolution=0 follows the picture in powers of two, so that few sizes need new maps.
SHADOW_TEST(Filters, ResolutionFollowsThePicture, Each)
{
  // Of depth maps. Of layers along planes: Planar.ResolutionFollowsThePicture.
  if (!ShadowStage::HasParameter(technique, "filter"))
  {
    return;
  }
  ShadowStage stage;
  stage.AddThings();
  stage.AddLight(LightKind::Point);
  stage.SetPass(technique, { { "resolution", "0" } });
  const auto check = [&](int width, int height, double side, double drawn)
  {
    stage.Window->SetSize(width, height);
    stage.Render();
    const std::string what = std::to_string(width) + " x " + std::to_string(height);
    const double bytes = stage.GetStatistics()["bytes"]["maps"];
    ShadowTest::CheckEqual(std::sqrt(bytes / 4.0), side, what + ": side of the map");
    ShadowTest::CheckEqual(stage.Count("mapsDrawn"), drawn, what + ": maps drawn");
  };
  check(160, 120, 1024.0, 1.0);
  check(200, 300, 1024.0, 0.0);
  check(1100, 100, 2048.0, 1.0);
}

//------------------------------------------------------------------------------
// A light that touches its casters: one warning, in however many frames, and a share all the same.
SHADOW_TEST(Filters, LightInACaster, Each)
{
  if (!IsFilter(technique))
  {
    return;
  }
  ShadowStage stage;
  stage.AddThings();
  stage.AddLight(LightKind::Sphere, { 0.9, -0.5, 1.5 }, { 0.0, 0.0, 0.0 })->SetRadius(0.5);
  stage.SetPass(technique);
  stage.Render();
  stage.Render();
  const auto range = GetRange(stage.GetVisibility());
  ShadowTest::CheckAtLeast(range.first, 0.0, "lowest V");
  ShadowTest::CheckAtMost(range.second, 1.0, "highest V");
  ShadowTest::CheckOneMessage(
    ShadowTest::Message::Warning, { technique, "among its casters" }, "the warning");
}

//------------------------------------------------------------------------------
// A light as large as the scene, and one that reaches into a caster: look-ups far beyond the map, and
// no rectangle of light or dark. Far from all casters all is lit; what differs is no border.
SHADOW_TEST(Filters, KernelWiderThanTheMap, Each)
{
  if (!ShadowStage::HasParameter(technique, "skipping"))
  {
    return;
  }
  for (const double radius : { 3.0, 8.0 })
  {
    ShadowStage stage;
    vtkActor* floor = stage.AddFloor(40.0);
    stage.AddBox({ 0.0, 0.0, 0.5 }, { 1.0, 1.0, 1.0 });
    stage.AddLight(LightKind::Sphere, { -2.5, -2.0, 6.0 }, { 0.0, 0.0, 0.0 })->SetRadius(radius);
    stage.LookAt({ 3.0, -20.0, 22.0 }, { 0.0, 0.0, 0.0 });
    stage.SetPass(technique);
    stage.Render();
    const Visibility visibility = stage.GetVisibility();
    const ShadowOracle oracle(stage);
    const auto mask = oracle.GetMask(floor);
    std::size_t far = 0;
    std::size_t dark = 0;
    for (std::size_t i = 0; i < mask.size(); ++i)
    {
      // The light sees past a box of 1.8 from there: it is behind at most a tenth of it.
      if (mask[i] && visibility.Mask[i] && glm::length(oracle.GetPixels()[i].Position) > 8.0)
      {
        ++far;
        dark += visibility.V[i] < 0.8f;
      }
    }
    ShadowTest::CheckAtLeast(static_cast<double>(far), 1000.0, "pixels far from the box");
    ShadowTest::CheckEqual(
      static_cast<double>(dark), 0.0, "radius " + std::to_string(radius) + ": dark far away");
    if (radius > 6.0 && IsFilter(technique))
    {
      // It reaches below the floor, which then is among what can cast.
      ShadowTest::CheckOneMessage(
        ShadowTest::Message::Warning, { technique, "among its casters" }, "the warning");
    }
  }
}

//------------------------------------------------------------------------------
// Maps that do not fit into the memory are drawn in batches: few views too, which are constants of the
// shader where they all lie there at once.
SHADOW_TEST(Filters, BatchesChangeNothing, Once)
{
  if (!vtkShadowTechniqueRegistration::Find("map-soft"))
  {
    return;
  }
  for (const char* samples : { "8", "40" })
  {
    Visibility visibility[2];
    for (const bool batches : { false, true })
    {
      ShadowStage stage;
      stage.AddThings();
      stage.AddLight(LightKind::Disk);
      stage.SetPass("map-soft",
        { { "samples", samples }, { "resolution", "512" }, { "memory", batches ? "1" : "512" } });
      stage.Render();
      visibility[batches] = stage.GetVisibility();
      ShadowTest::Check(
        (stage.Count("mapBatches") > 1.0) == batches, "batches where there is room");
    }
    ShadowTest::CheckAtMost(Compare(visibility[0], visibility[1]).Maximum, 1e-5,
      std::string(samples) + " samples: difference of V");
  }
}

//------------------------------------------------------------------------------
// What a thin thing hides from a map goes on behind it: the umbra of a plate has no light where a strip
// above it is all that the map shows. And beside the plate the strip's shadow is there: the plate alone
// leaves more light.
SHADOW_TEST(Filters, UmbraGoesOnBehindAStrip, Each)
{
  if (!ShadowStage::HasParameter(technique, "denoise"))
  {
    return;
  }
  const auto show = [&](bool strip)
  {
    return RenderVisibility(technique, {},
      [strip](ShadowStage& stage)
      {
        stage.AddFloor();
        stage.AddQuad({ -1.0, -1.0, 1.0 }, { 2.0, 0.0, 0.0 }, { 0.0, 2.0, 0.0 });
        if (strip)
        {
          stage.AddQuad({ -3.0, -0.05, 1.5 }, { 6.0, 0.0, 0.0 }, { 0.0, 0.1, 0.0 });
        }
        stage.AddLight(LightKind::Rectangle, { 0.0, 0.0, 6.0 }, { 0.0, 0.0, 0.0 });
        stage.LookAt({ 0.0, -7.0, 1.6 }, { 0.0, 0.0, 0.0 }, 40.0);
      });
  };
  const Visibility plate = show(false);
  const Visibility both = show(true);
  std::size_t umbra = 0;
  std::size_t lit = 0;
  for (std::size_t i = 0; i < plate.V.size(); ++i)
  {
    const bool dark = plate.Mask[i] && plate.V[i] == 0.0f;
    umbra += dark;
    lit += dark && both.V[i] > 0.0f;
  }
  ShadowTest::CheckAtLeast(static_cast<double>(umbra), 500.0, "pixels in the umbra");
  ShadowTest::CheckEqual(static_cast<double>(lit), 0.0, "of them lit below the strip");
  ShadowTest::CheckAtLeast(Compare(both, plate, 0.1).Share, 0.01, "pixels in the strip's shadow");
}

//------------------------------------------------------------------------------
// Over a plate, whose edge hides the light along one axis, and bars far below it, which hide it along the
// other, the light that is left is the product of what either leaves. One mean depth is of neither.
SHADOW_TEST(Filters, LayersAreToldApart, Each)
{
  if (!ShadowStage::HasParameter(technique, "blockers"))
  {
    return;
  }
  const auto show = [&](const char* blockers, bool plate, bool bars)
  {
    return RenderVisibility(technique,
      { { "blockers", blockers }, { "samples", "64" }, { "search", "36" },
        { "resolution", "1024" } },
      [=](ShadowStage& stage)
      {
        stage.AddFloor();
        if (plate)
        {
          stage.AddQuad({ -4.0, -4.0, 2.5 }, { 4.0, 0.0, 0.0 }, { 0.0, 8.0, 0.0 });
        }
        for (int i = -4; i <= 4 && bars; ++i)
        {
          stage.AddQuad({ -4.0, 0.8 * i - 0.2, 0.6 }, { 8.0, 0.0, 0.0 }, { 0.0, 0.4, 0.0 });
        }
        stage.AddLight(LightKind::Rectangle, { 0.0, 0.0, 6.0 }, { 0.0, 0.0, 0.0 });
        stage.LookAt({ 3.0, -6.0, 0.4 }, { 0.6, 0.0, 0.0 }, 30.0);
      });
  };
  const Visibility plate = show("layers", true, false);
  const Visibility bars = show("layers", false, true);
  const auto measure = [&](const char* blockers)
  {
    Visibility both = show(blockers, true, true);
    Visibility product = both;
    for (std::size_t i = 0; i < both.V.size(); ++i)
    {
      product.V[i] = plate.V[i] * bars.V[i];
      // Beneath the plate the map knows no bars.
      const bool inside = product.Mask[i] && plate.V[i] > 0.5f && plate.V[i] < 1.0f;
      both.Mask[i] = product.Mask[i] = inside;
    }
    return Compare(both, product).RMSE;
  };
  // A jittered compare of 64 is off by up to an eighth at an edge; by the mean a bar hides as wide as the plate does.
  ShadowTest::CheckAtMost(measure("layers"), 0.06, "RMSE of two layers against their product");
  ShadowTest::CheckAtLeast(measure("mean"), 0.1, "RMSE of their mean");
}
