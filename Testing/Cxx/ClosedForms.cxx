// SPDX-License-Identifier: BSD-3-Clause
// Closed forms: the truth at every pixel, by formula.
//
// Bounds are of the RMSE over all of the floor's pixels. N stratified samples of a light that an edge
// cuts err where the edge crosses their cells, by about 0.5 N^-0.75 in the penumbra, whose share f of
// the pixels makes that 0.5 N^-0.75 sqrt(f). It is never to be above 0.003 for 1024 rays, 0.03 for 64
// maps and 0.015 for 256. The errors are of both signs: their mean, the bias, is to be a tenth of that.

#include "ClosedForms.h"

#include "ShadowTest.h"

#include "vtkShadowScenes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace
{
struct Accuracy
{
  const char* Technique;
  int Samples;
  double Cap;        // of the RMSE, whatever the penumbra's share
  bool Exact = true; // converges; else the cap is all
};

// A technique that converges to the truth gets rows here.
constexpr Accuracy Accuracies[] = {
  { "ray-traced", 64, 0.015 },
  { "ray-traced", 1024, 0.003 },
  { "map-soft", 64, 0.03 },
  { "map-soft", 256, 0.015 },
  { "planar-soft", 64, 0.03 },
  { "planar-soft", 256, 0.015 },
  // Blockers that are parallel to the light have one depth each, so that one map tells all.
  { "map-pcss", 64, 0.02, false },
  // By formula, of floats, and positions that are off by 2^-19 of their distance.
  { "wedges", 64, 0.001, false },
  { "map-combined", 64, 0.02, false },
  { "map-trace", 16, 0.015, false },
  { "map-trace", 64, 0.015, false },
};

double Clamp(double value)
{
  return std::clamp(value, 0.0, 1.0);
}

/**
 * Visible share of a rectangle at a height, side 2a along x and 2b along y, past a rectangle
 * parallel to it, side 2c and 2d, both centred over the origin: by similar triangles the blocker
 * covers an interval of the light in x and one in y.
 */
double SeeRectangle(const glm::dvec3& p, const glm::dvec2& light, double lightHeight,
  const glm::dvec2& blocker, double blockerHeight)
{
  const double scale = (lightHeight - p.z) / (blockerHeight - p.z);
  double covered = 1.0;
  for (int c = 0; c < 2; ++c)
  {
    const double low = p[c] + scale * (-blocker[c] - p[c]);
    const double high = p[c] + scale * (blocker[c] - p[c]);
    covered *= light[c] > 0.0 ? std::max(0.0, std::min(high, light[c]) - std::max(low, -light[c])) /
                                  (2.0 * light[c])
                              : (low < 0.0 && high > 0.0 ? 1.0 : 0.0);
  }
  return Clamp(1.0 - covered);
}
}

//------------------------------------------------------------------------------
void CheckClosedForm(const std::string& technique, LightKind kind, ShadowStage& stage,
  vtkActor* receiver, const std::function<double(const glm::dvec3& point)>& soft,
  const std::function<double(const glm::dvec3& point)>& hard, double slack)
{
  const ShadowOracle oracle(stage);
  const auto inner = oracle.GetInner(1);
  auto use = oracle.GetMask(receiver);
  Visibility truth;
  Visibility truthHard;
  truth.Width = truthHard.Width = stage.Window->GetSize()[0];
  truth.Height = truthHard.Height = stage.Window->GetSize()[1];
  truth.Mask.assign(use.size(), 1);
  truthHard.Mask = truth.Mask;
  std::size_t penumbra = 0;
  for (std::size_t i = 0; i < use.size(); ++i)
  {
    const glm::dvec3& p = oracle.GetPixels()[i].Position;
    use[i] = use[i] && inner[i];
    const double v = use[i] ? soft(p) : 0.0;
    penumbra += use[i] && v > 0.02 && v < 0.98;
    truth.V.push_back(static_cast<float>(v));
    truthHard.V.push_back(static_cast<float>(use[i] ? hard(p) : 0.0));
  }
  const double share = static_cast<double>(penumbra) / static_cast<double>(std::count(use.begin(),
                                                         use.end(), static_cast<unsigned char>(1)));
  // What is measured is there.
  ShadowTest::CheckAtLeast(static_cast<double>(penumbra), 0.01 * use.size(), "penumbra's pixels");

  const auto measure = [&](const Parameters& parameters)
  {
    Parameters all = { { "resolution", "512" } };
    all.insert(parameters.begin(), parameters.end());
    stage.SetPass(technique, all);
    stage.Render();
    return stage.GetVisibility();
  };
  if (ShadowStage::Describe(technique).Traits.Hard)
  {
    ShadowTest::CheckAtMost(
      Compare(measure({ { "resolution", "1024" } }), truthHard, 0.5, use).Share, 0.015,
      "pixels that differ from the truth of the light's centre");
    return;
  }
  const bool exact = ShadowStage::Describe(technique).LightShapes[static_cast<int>(kind)] ==
                     vtkShadowShapeSupport::Exact;
  bool declared = false;
  for (const Accuracy& accuracy : Accuracies)
  {
    if ((exact || !accuracy.Exact) && technique == accuracy.Technique)
    {
      declared = true;
      const std::string samples = std::to_string(accuracy.Samples);
      const double stratified = 0.5 * std::pow(accuracy.Samples, -0.75) * std::sqrt(share);
      const double bound =
        slack + (accuracy.Exact ? std::min(accuracy.Cap, stratified) : accuracy.Cap);
      const Difference difference = Compare(measure({ { "samples", samples } }), truth, 0.1, use);
      ShadowTest::CheckAtMost(difference.RMSE, bound, samples + " samples: RMSE");
      if (accuracy.Exact)
      {
        ShadowTest::CheckAtMost(std::abs(difference.Bias), 0.1 * bound, samples + " samples: bias");
      }
    }
  }
  if (!declared)
  {
    ShadowTest::CheckAtMost(Compare(measure({ { "samples", "64" } }), truth, 0.1, use).RMSE,
      Compare(truthHard, truth, 0.1, use).RMSE, "RMSE, with that of a hard shadow as bound");
  }
}

//------------------------------------------------------------------------------
// The scene that is measured against: its own closed form, that of this test, and the picture.
SHADOW_TEST(ClosedForm, Rectangle, Each)
{
  if (!ShadowStage::Supports(technique, LightKind::Rectangle))
  {
    return;
  }
  ShadowStage stage(400, 400);
  vtkShadowScenes::Build("blocker", stage.Renderer);
  auto* floor = vtkActor::SafeDownCast(stage.Renderer->GetViewProps()->GetItemAsObject(0));
  double worst = 0.0;
  for (double x = -3.0; x <= 3.0; x += 0.17)
  {
    for (double y = -3.0; y <= 3.0; y += 0.19)
    {
      worst = std::max(
        worst, std::abs(vtkShadowScenes::BlockerVisibility(x, y) -
                        SeeRectangle({ x, y, 0.0 }, { 1.0, 1.0 }, 6.0, { 1.0, 1.0 }, 2.0)));
    }
  }
  ShadowTest::CheckAtMost(worst, 1e-12, "the scene's closed form against this test's");
  CheckClosedForm(
    technique, LightKind::Rectangle, stage, floor,
    [](const glm::dvec3& p) { return vtkShadowScenes::BlockerVisibility(p.x, p.y); },
    [](const glm::dvec3& p) {
      return SeeRectangle(p, { 0.0, 0.0 }, 6.0, { 1.0, 1.0 }, 2.0);
    });
}

//------------------------------------------------------------------------------
// A light of 4 : 1, turned so that width and height must not be confused, both ways.
SHADOW_TEST(ClosedForm, StretchedRectangle, Each)
{
  if (!ShadowStage::Supports(technique, LightKind::Rectangle))
  {
    return;
  }
  for (const bool turned : { false, true })
  {
    ShadowStage stage(200, 200);
    vtkActor* floor = stage.AddFloor();
    stage.AddQuad({ -1.0, -0.8, 1.5 }, { 2.0, 0.0, 0.0 }, { 0.0, 1.6, 0.0 });
    vtkAreaLight* light = stage.AddLight(LightKind::Rectangle, { 0, 0, 6 }, { 0, 0, 0 });
    // Width runs along focal direction x up = -z x y = x, or, with x up, along -y.
    light->SetWidth(4.0);
    light->SetHeight(1.0);
    turned ? light->SetUpVector(1.0, 0.0, 0.0) : light->SetUpVector(0.0, 1.0, 0.0);
    const glm::dvec2 half = turned ? glm::dvec2(0.5, 2.0) : glm::dvec2(2.0, 0.5);
    stage.LookAt({ 3.0, -8.0, 3.5 }, { 0.0, 0.0, 0.3 });
    CheckClosedForm(
      technique, LightKind::Rectangle, stage, floor,
      [&](const glm::dvec3& p) {
        return SeeRectangle(p, half, 6.0, { 1.0, 0.8 }, 1.5);
      },
      [](const glm::dvec3& p) {
        return SeeRectangle(p, { 0.0, 0.0 }, 6.0, { 1.0, 0.8 }, 1.5);
      });
  }
}
