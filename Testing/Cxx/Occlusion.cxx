// SPDX-License-Identifier: BSD-3-Clause
// What occlusion textures promise beside the laws: exact means of one slice, samples that unite slices, and
// a visibility that moves as things do.

#include "ShadowOracle.h"
#include "ShadowStage.h"
#include "ShadowTest.h"

#include "vtkShadowScenes.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace
{
const std::string Name = "occlusion-textures";

Visibility Show(ShadowStage& stage, const Parameters& parameters)
{
  stage.SetPass(Name, parameters);
  stage.Render();
  return stage.GetVisibility();
}
}

//------------------------------------------------------------------------------
// A slice at a flat blocker is exact but for texels: of 512 along the blocker, 2.0 wide, the penumbra is
// 0.5 wide at the blocker, 128 texels, whose border errs by half a one. N-buffers blend two boxes, which
// errs by up to 0.027 in the penumbra.
SHADOW_TEST(Occlusion, OneSliceIsExact, Once)
{
  ShadowStage stage(400, 400);
  vtkShadowScenes::Build("blocker", stage.Renderer);
  auto* floor = vtkActor::SafeDownCast(stage.Renderer->GetViewProps()->GetItemAsObject(0));
  const ShadowOracle oracle(stage);
  const auto inner = oracle.GetInner(1);
  auto use = oracle.GetMask(floor);
  auto penumbra = use;
  Visibility truth;
  truth.Width = truth.Height = 400;
  truth.Mask.assign(use.size(), 1);
  for (std::size_t i = 0; i < use.size(); ++i)
  {
    const glm::dvec3& p = oracle.GetPixels()[i].Position;
    const double v = use[i] ? vtkShadowScenes::BlockerVisibility(p.x, p.y) : 1.0;
    truth.V.push_back(static_cast<float>(v));
    use[i] = use[i] && inner[i];
    penumbra[i] = use[i] && v > 0.02 && v < 0.98;
  }
  const auto check = [&](const std::string& prefilter, double all, double inPenumbra)
  {
    const Visibility v = Show(stage, { { "prefilter", prefilter }, { "resolution", "512" } });
    ShadowTest::CheckAtMost(Compare(v, truth, 0.1, use).RMSE, all, prefilter + ": RMSE");
    ShadowTest::CheckAtMost(
      Compare(v, truth, 0.1, penumbra).RMSE, inPenumbra, prefilter + ": in the penumbra");
  };
  check("summed-area", 0.004, 0.008);
  check("n-buffers", 0.01, 0.025);
}

//------------------------------------------------------------------------------
// A slanted wall through all slices, each of which hides some of the light: as if independent it is too
// light by more than 0.2 in places; sample by sample it is what it is, with each slice on the next plane too,
// or light would leak between two. 256 samples err by 0.008 in the penumbra, 144 rays of the truth by 0.012.
SHADOW_TEST(Occlusion, SamplesUniteSlices, Once)
{
  ShadowStage stage(160, 160);
  vtkActor* floor = stage.AddFloor(5.0);
  stage.AddQuad({ -2.0, -3.0, 1.0 }, { 0.0, 6.0, 0.0 }, { 4.0, 0.0, 4.0 });
  vtkAreaLight* light = stage.AddLight(LightKind::Rectangle, { 0.0, 0.0, 10.0 }, glm::dvec3(0.0));
  light->SetWidth(3.0);
  light->SetHeight(3.0);
  stage.LookAt({ 7.0, -9.0, 6.0 }, { 0.0, 0.0, 0.0 });
  const Visibility product = Show(stage, { { "resolution", "512" } });
  const Visibility bits = Show(stage, { { "resolution", "512" }, { "combine", "bits" },
                                        { "samples", "256" }, { "double-projection", "on" } });
  const ShadowOracle oracle(stage);
  const auto mask = oracle.GetMask(floor);
  const auto inner = oracle.GetInner(1);
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < mask.size(); i += 3)
  {
    if (!mask[i] || !inner[i])
    {
      continue;
    }
    constexpr int side = 12;
    int seen = 0;
    for (int k = 0; k < side * side; ++k)
    {
      const int row = k / side;
      const glm::dvec3 place(
        3.0 * ((k % side + 0.5) / side - 0.5), 3.0 * ((row + 0.5) / side - 0.5), 10.0);
      seen += oracle.IsBlocked(oracle.GetPixels()[i], place) ? 0 : 1;
    }
    const double truth = static_cast<double>(seen) / (side * side);
    if (std::abs(product.V[i] - truth) > 0.2)
    {
      sum += std::abs(bits.V[i] - truth);
      ++count;
    }
  }
  ShadowTest::CheckAtLeast(count, 50.0, "pixels where the product is off by more than 0.2");
  ShadowTest::CheckAtMost(sum / std::max(count, 1), 0.02, "mean error of samples there");
}

//------------------------------------------------------------------------------
// A hundredth of a slice, which is 0.0006 here, moves the penumbra, 0.5 wide at the least, by a
// thousandth, and a step of a texel's border in a kernel of 8 texels is 1/8 of what a texel moves. No pixel
// of the floor changes by more than 0.03.
SHADOW_TEST(Occlusion, VisibilityIsContinuous, Once)
{
  ShadowStage stage(200, 200);
  vtkActor* floor = stage.AddFloor();
  vtkActor* box = stage.AddBox({ 0.0, 0.0, 2.5 }, { 2.0, 2.0, 1.0 });
  vtkAreaLight* light = stage.AddLight(LightKind::Rectangle, { 0.3, 0.2, 6.0 }, { 0.3, 0.2, 0.0 });
  light->SetWidth(2.0);
  light->SetHeight(2.0);
  stage.LookAt({ 3.6, -11.0, 6.4 }, { 0.0, 0.0, 0.7 });
  const double step = 0.01 / 16.0;
  for (const std::string prefilter : { "n-buffers", "summed-area" })
  {
    stage.SetPass(Name, { { "prefilter", prefilter }, { "resolution", "512" } });
    const auto use = ShadowOracle(stage).GetMask(floor);
    const auto render = [&]()
    {
      stage.Render();
      return stage.GetVisibility();
    };
    const Visibility before = render();
    box->SetPosition(step, 0.0, 0.0);
    ShadowTest::CheckAtMost(
      Compare(render(), before, 0.1, use).Maximum, 0.03, prefilter + ": caster moved");
    box->SetPosition(0.0, 0.0, 0.0);
    light->SetPosition(0.3 + step, 0.2, 6.0);
    light->SetFocalPoint(0.3 + step, 0.2, 0.0);
    ShadowTest::CheckAtMost(
      Compare(render(), before, 0.1, use).Maximum, 0.03, prefilter + ": light moved");
    light->SetPosition(0.3, 0.2, 6.0);
    light->SetFocalPoint(0.3, 0.2, 0.0);
    floor->SetPosition(0.0, 0.0, step);
    ShadowTest::CheckAtMost(
      Compare(render(), before, 0.1, use).Maximum, 0.03, prefilter + ": receiver moved");
    floor->SetPosition(0.0, 0.0, 0.0);
  }
}

//------------------------------------------------------------------------------
// A box on its way through a slice, a hundredth of it at a time: its faces cross slice planes. What spans n
// slices then spans one more or less: as if independent, where each hides o that changes the light by
// o (1 - o)^n, 0.067 at the most for the five that the box fills at the least. The upper face comes to lie
// a slice above where it was: that, 0.15 above the 1.8 of the lower one, moves its edge in the kernel by
// 1/12. Two quads hold the slices in place.
SHADOW_TEST(Occlusion, CrossingASlicePlaneChangesLittle, Once)
{
  ShadowStage stage(80, 80);
  vtkActor* floor = stage.AddFloor();
  stage.AddQuad({ 1.5, -0.1, 3.6 }, { 0.2, 0.0, 0.0 }, { 0.0, 0.2, 0.0 });
  stage.AddQuad({ 1.5, -0.1, 1.2 }, { 0.2, 0.0, 0.0 }, { 0.0, 0.2, 0.0 });
  vtkActor* box = stage.AddBox({ 0.0, 0.0, 2.37 }, { 1.5, 1.5, 1.0 });
  vtkAreaLight* light = stage.AddLight(LightKind::Rectangle, { 0.3, 0.2, 6.0 }, { 0.3, 0.2, 0.0 });
  light->SetWidth(2.0);
  light->SetHeight(2.0);
  stage.LookAt({ 3.6, -11.0, 6.4 }, { 0.0, 0.0, 0.7 });
  const double slice = (3.6 - 1.2) / 16.0;
  for (const std::string combine : { "product", "bits" })
  {
    stage.SetPass(Name, { { "combine", combine }, { "samples", "256" }, { "resolution", "512" } });
    box->SetPosition(0.0, 0.0, slice);
    auto use = ShadowOracle(stage).GetMask(floor);
    box->SetPosition(0.0, 0.0, 0.0);
    const auto free = ShadowOracle(stage).GetMask(floor);
    std::transform(use.begin(), use.end(), free.begin(), use.begin(), std::logical_and<>());
    double most = 0.0;
    Visibility before;
    for (int i = 0; i <= 100; ++i)
    {
      box->SetPosition(0.0, 0.0, 0.01 * i * slice);
      stage.Render();
      Visibility now = stage.GetVisibility();
      if (i > 0)
      {
        most = std::max(most, Compare(now, before, 0.1, use).Maximum);
      }
      before = std::move(now);
    }
    ShadowTest::CheckAtMost(GetRange(before).first, 0.3, combine + ": there is a shadow");
    ShadowTest::CheckAtMost(most, 0.1, combine + ": most that a step changes");
  }
}
