// SPDX-License-Identifier: BSD-3-Clause
// Laws: limits are what they tend to. A light without size is hard; a shadow begins at its caster.

#include "ShadowOracle.h"
#include "ShadowTest.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace
{
Visibility Show(
  const std::string& technique, LightKind kind, double size, const Parameters& parameters = {})
{
  return RenderVisibility(technique, parameters,
    [&](ShadowStage& stage)
    {
      stage.AddThings();
      ShadowStage::Shrink(stage.AddLight(kind), size);
    });
}

/** Pixels within some of an edge of a hard visibility. */
std::vector<unsigned char> GetEdges(const Visibility& hard, int reach)
{
  std::vector<unsigned char> edges(hard.V.size(), 0);
  for (int y = 0; y < hard.Height; ++y)
  {
    for (int x = 0; x < hard.Width; ++x)
    {
      for (int k = 0; k < (2 * reach + 1) * (2 * reach + 1); ++k)
      {
        const int nx = std::clamp(x + k % (2 * reach + 1) - reach, 0, hard.Width - 1);
        const int ny = std::clamp(y + k / (2 * reach + 1) - reach, 0, hard.Height - 1);
        if (hard(nx, ny) != hard(x, y) ||
            hard.Mask[ny * hard.Width + nx] != hard.Mask[y * hard.Width + x])
        {
          edges[y * hard.Width + x] = 1;
        }
      }
    }
  }
  return edges;
}
}

//------------------------------------------------------------------------------
SHADOW_TEST(Law, ZeroSizeIsHard, Each)
{
  const Visibility point = Show(technique, LightKind::Point, 0.0);
  for (const LightKind kind : { LightKind::Sphere, LightKind::Disk, LightKind::Rectangle })
  {
    if (!ShadowStage::Supports(technique, kind))
    {
      continue;
    }
    const std::string name = GetName(kind);
    // The same light by another name.
    ShadowTest::Check(Same(Show(technique, kind, 0.0), point), name + " of no size is not a point");
    if (ShadowStage::Describe(technique).Traits.Hard)
    {
      ShadowTest::Check(
        Same(Show(technique, kind, 3.0), point), name + ": its size counts, but it is hard");
    }
    else
    {
      ShadowTest::CheckAtLeast(Compare(Show(technique, kind, 1.0), point).RMSE, 0.01,
        name + ": its size makes a difference");
    }
  }

  // Against the truth. A texel is a sixth of a pixel: what differs is a share of 500 pixels at edges.
  ShadowStage stage;
  stage.AddThings();
  vtkLight* light = stage.AddLight(LightKind::Point);
  const Visibility truth = ShadowOracle(stage).GetHard(light, technique);
  const Visibility fine = Show(technique, LightKind::Point, 0.0, { { "resolution", "1024" } });
  ShadowTest::CheckAtMost(
    Compare(fine, truth, 0.5).Share, 0.015, "pixels that differ from the truth");
  // An interpolated layer along a plane begins within a texel before its caster's foot, which a map
  // shows.
  auto edges = GetEdges(truth, 2);
  const auto inner = ShadowOracle(stage).GetInner(2);
  for (std::size_t i = 0;
       ShadowStage::Describe(technique).Traits.PlanarReceivers && i < edges.size(); ++i)
  {
    edges[i] = edges[i] || !inner[i];
  }
  std::size_t between = 0;
  for (std::size_t i = 0; i < fine.V.size(); ++i)
  {
    between += fine.Mask[i] && !edges[i] && fine.V[i] > 0.02f && fine.V[i] < 0.98f;
  }
  ShadowTest::CheckEqual(static_cast<double>(between), 0.0, "pixels between 0 and 1 off all edges");
}

//------------------------------------------------------------------------------
// The soft technique of maps takes its hard path: with equal maps the picture is map-hard's.
SHADOW_TEST(Law, ZeroSizeMapsAreHardMaps, Once)
{
  if (!vtkShadowTechniqueRegistration::Find("map-soft"))
  {
    return;
  }
  for (const std::string filter : { "nearest", "bilinear" })
  {
    const Parameters parameters = { { "resolution", "300" }, { "filter", filter } };
    const Visibility hard = Show("map-hard", LightKind::Rectangle, 1.0, parameters);
    const Visibility soft = Show("map-soft", LightKind::Rectangle, 0.0, parameters);
    ShadowTest::Check(Same(hard, soft), "map-soft is not map-hard with filter " + filter);
    ShadowTest::CheckEqual(GetRange(soft).first, 0.0, "there is a shadow");
  }
}

//------------------------------------------------------------------------------
// V tends to the hard one as the light shrinks: each third brings it nearer, and at 1e-6 only edges
// that rounding turns are left. The hard one is the technique's own, on its hard path.
SHADOW_TEST(Law, SmallSizeTendsToHard, Each)
{
  for (const LightKind kind :
    { LightKind::Sphere, LightKind::Disk, LightKind::Rectangle, LightKind::Directional })
  {
    if (!ShadowStage::Supports(technique, kind))
    {
      continue;
    }
    const std::string name = GetName(kind);
    const Visibility hard = Show(technique, kind, 0.0);
    double last = 1.0;
    for (const double size : { 1.0, 0.3, 0.1, 0.03 })
    {
      const double error = Compare(Show(technique, kind, size), hard).RMSE;
      ShadowTest::CheckAtMost(error, last, name + " x " + std::to_string(size) + ": RMSE to hard");
      last = error;
    }
    const Difference difference = Compare(Show(technique, kind, 1e-6), hard, 0.1);
    ShadowTest::CheckAtMost(difference.Share, 10.0 / 25600.0, name + " x 1e-6: pixels that differ");
  }
}

//------------------------------------------------------------------------------
// A shadow begins where its caster stands, and ends where it should. Maps of 64 texels, seen so
// closely that a texel is many pixels: of the floor that the oracle says is dark, what is lit must lie
// within 1.5 texels of the shadow's border or the box's foot, and what is lit and shown as dark within
// 1.5 of the border: half a texel is the map's, one at most the bias', which is what a look-up reads.
//
// A map hugs the box: seen from the light it is no wider than the largest distance d between two of
// the box's corners on a plane at distance 1. On the floor at distance w along the light's axis, where
// the cosine of the angle of incidence is c, a texel covers up to d w / 64 / c. A technique without
// maps has a thousandth of the box instead.
SHADOW_TEST(Law, ShadowTouchesItsCaster, Each)
{
  const bool maps = ShadowStage::HasParameter(technique, "resolution");
  for (const double lift : { 0.0, 1e-6, 1e-3, 0.02 })
  {
    for (const double height : { 4.0, 1.5 })
    {
      const glm::dvec3 size(1.0, 0.8, 0.6);
      const glm::dvec3 centre(0.0, 0.0, 0.5 * size.z + lift);
      const glm::dvec3 place(-3.0, -1.0, height);
      ShadowStage stage(200, 200);
      vtkActor* floor = stage.AddFloor();
      stage.AddBox(centre, size);
      vtkLight* light = stage.AddLight(LightKind::Point, place, { 0.0, 0.0, 0.0 });
      // Close to the foot; from farther the whole shadow is seen.
      stage.LookAt({ 1.6, 0.9, 1.1 }, { 0.55, 0.2, 0.0 }, lift == 1e-3 ? 70.0 : 30.0);
      stage.SetPass(technique, { { "resolution", "64" } });
      stage.Render();
      const Visibility visibility = stage.GetVisibility();
      const ShadowOracle oracle(stage);
      const Visibility truth = oracle.GetHard(light, technique);
      const auto mask = oracle.GetMask(floor);
      const auto& pixels = oracle.GetPixels();

      const glm::dvec3 axis = glm::normalize(centre - place);
      std::vector<glm::dvec3> corners;
      for (int k = 0; k < 8; ++k)
      {
        const glm::dvec3 signs(k & 1 ? 0.5 : -0.5, k & 2 ? 0.5 : -0.5, k & 4 ? 0.5 : -0.5);
        const glm::dvec3 arm = centre + signs * size - place;
        corners.push_back(arm / glm::dot(arm, axis));
      }
      double extent = 0.0;
      for (int k = 0; k < 64; ++k)
      {
        extent = std::max(extent, glm::length(corners[k % 8] - corners[k / 8]));
      }
      const auto isFoot = [&](const glm::dvec3& p)
      {
        const glm::dvec3 inBox = glm::abs(p - centre) - 0.5 * size;
        return inBox.x < 0.0 && inBox.y < 0.0;
      };

      double widest[2] = { 0.0, 0.0 }; // in texels: lit in the dark, dark in the light
      std::size_t counts[2] = { 0, 0 };
      for (std::size_t i = 0; i < mask.size(); ++i)
      {
        if (!mask[i] || !visibility.Mask[i])
        {
          continue;
        }
        const int lit = truth.V[i] > 0.0f ? 1 : 0;
        ++counts[lit];
        if ((visibility.V[i] >= 0.5f) == (lit == 1))
        {
          continue;
        }
        const glm::dvec3 ray = place - pixels[i].Position;
        const double texel = maps ? extent / 64.0 * -glm::dot(ray, axis) * glm::length(ray) / ray.z
                                  : 1e-3 * glm::length(size);
        // The smallest circle of floor around it that reaches the border.
        double depth = 10.0 * texel;
        for (double r = 0.1 * texel; r < depth; r += 0.1 * texel)
        {
          for (int k = 0; k < 32; ++k)
          {
            SurfacePoint other = pixels[i];
            other.Position += r * glm::dvec3(std::cos(0.19635 * k), std::sin(0.19635 * k), 0.0);
            const bool blocked = oracle.IsBlocked(other, place);
            depth = (!lit && isFoot(other.Position)) || blocked == (lit == 1) ? r : depth;
          }
        }
        widest[lit] = std::max(widest[lit], depth / texel);
      }
      const std::string what =
        "lifted by " + std::to_string(lift) + ", light at " + std::to_string(height).substr(0, 3);
      ShadowTest::CheckAtLeast(static_cast<double>(counts[0]), 1000.0, what + ": dark pixels");
      ShadowTest::CheckAtLeast(static_cast<double>(counts[1]), 200.0, what + ": lit pixels");
      ShadowTest::CheckAtMost(widest[0], 1.5, what + ": light in the shadow, texels");
      ShadowTest::CheckAtMost(widest[1], 1.5, what + ": shadow in the light, texels");
    }
  }
}
