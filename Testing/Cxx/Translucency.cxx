// SPDX-License-Identifier: BSD-3-Clause
// Translucent props: by which rule they cast, and that they are drawn, in order, and receive.

#include "ShadowOracle.h"
#include "ShadowTest.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkProperty.h"
#include "vtkTexture.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double EdgeShare = 0.015; // as in LightKinds.cxx
const Parameters Fine = { { "resolution", "1024" }, { "samples", "4" } };

Parameters With(const std::string& rule)
{
  Parameters parameters = Fine;
  parameters["translucent-casters"] = rule;
  return parameters;
}

std::vector<unsigned char> Not(std::vector<unsigned char> mask)
{
  for (auto& pixel : mask)
  {
    pixel = !pixel;
  }
  return mask;
}

/** A floor, an opaque post, and two translucent boxes, whose shadows all overlap. */
struct Scene
{
  ShadowStage Stage;
  vtkActor* Post;
  vtkActor* Pale;
  vtkActor* Dense;
  vtkLight* Light;

  explicit Scene(double pale = 0.25, double dense = 0.75)
  {
    this->Stage.AddFloor();
    this->Post = this->Stage.AddBox({ -1.0, -0.7, 1.0 }, { 0.3, 0.3, 2.0 });
    this->Pale = this->Stage.AddBox({ -0.4, 0.2, 1.0 }, { 1.2, 0.8, 0.3 });
    this->Dense = this->Stage.AddBox({ 0.2, 0.5, 1.7 }, { 0.8, 1.2, 0.3 });
    this->Pale->GetProperty()->SetOpacity(pale);
    this->Dense->GetProperty()->SetOpacity(dense);
    this->Light = this->Stage.AddLight(LightKind::Point);
    this->Stage.LookAt({ 3.5, -6.5, 4.5 }, { 0.2, 0.2, 0.3 });
  }
  /** Pixels at which no translucent box is in front, whose surfaces are not asked. */
  std::vector<unsigned char> GetOthers()
  {
    const ShadowOracle oracle(this->Stage);
    auto mask = oracle.GetMask(this->Pale);
    const auto dense = oracle.GetMask(this->Dense);
    std::transform(mask.begin(), mask.end(), dense.begin(), mask.begin(),
      [](unsigned char a, unsigned char b) { return a || b; });
    return Not(mask);
  }
};
}

//------------------------------------------------------------------------------
// "off" casts nothing, "opaque" all, and of "weighted" the most opaque in a row counts: V is the sum,
// over the opacities that occur, of the V of what is at least so opaque.
SHADOW_TEST(Translucency, Rules, Each)
{
  Scene scene;
  const auto others = scene.GetOthers();
  const auto getTruth = [&](const std::set<vtkActor*>& ignored)
  { return ShadowOracle(scene.Stage, ignored).GetHard(scene.Light, technique); };
  const Visibility all = getTruth({});
  const Visibility dense = getTruth({ scene.Pale });
  const Visibility none = getTruth({ scene.Pale, scene.Dense });
  Visibility weighted = all;
  for (std::size_t i = 0; i < all.V.size(); ++i)
  {
    weighted.V[i] = 0.25f * all.V[i] + 0.5f * dense.V[i] + 0.25f * none.V[i];
  }
  const std::pair<const char*, const Visibility&> rules[] = { { "off", none }, { "opaque", all },
    { "weighted", weighted } };
  for (const auto& rule : rules)
  {
    scene.Stage.SetPass(technique, With(rule.first));
    scene.Stage.Render();
    const Visibility visibility = scene.Stage.GetVisibility();
    ShadowTest::CheckAtMost(Compare(visibility, rule.second, 0.02, others).Share, EdgeShare,
      std::string(rule.first) + ": pixels that differ");
  }
  // And the debug view shows the same.
  scene.Stage.Pass->SetDebugView("visibility");
  scene.Stage.Render();
  const Picture picture = scene.Stage.GetPicture();
  const Visibility visibility = scene.Stage.GetVisibility();
  int worst = 0;
  for (std::size_t i = 0; i < visibility.V.size(); ++i)
  {
    worst = std::max(worst,
      visibility.Mask[i] ? std::abs(picture.RGB[3 * i] - static_cast<int>(255 * visibility.V[i]))
                         : 0);
  }
  ShadowTest::CheckAtMost(worst, 1.0, "debug view against V, of 255");
}

//------------------------------------------------------------------------------
// An opacity that changes is followed by V at once; what is clear casts nothing, what is 1 is opaque.
SHADOW_TEST(Translucency, OpacityChanges, Each)
{
  Scene scene(0.4, 0.4);
  scene.Stage.SetPass(technique, With("weighted"));
  const auto others = scene.GetOthers();
  for (const double opacity : { 0.4, 0.8, 0.0, 1.0, 0.1 })
  {
    scene.Dense->GetProperty()->SetOpacity(opacity);
    scene.Stage.Render();
    const Visibility visibility = scene.Stage.GetVisibility();
    const Visibility with =
      ShadowOracle(scene.Stage, { scene.Pale }).GetHard(scene.Light, technique);
    const Visibility without =
      ShadowOracle(scene.Stage, { scene.Pale, scene.Dense }).GetHard(scene.Light, technique);
    const Visibility pale =
      ShadowOracle(scene.Stage, { scene.Dense }).GetHard(scene.Light, technique);
    std::size_t wrong = 0;
    std::size_t used = 0;
    for (std::size_t i = 0; i < others.size(); ++i)
    {
      if (others[i] && visibility.Mask[i] && without.V[i] == 1.0f && pale.V[i] == 1.0f &&
          with.V[i] == 0.0f)
      {
        ++used;
        wrong += std::abs(visibility.V[i] - (1.0 - opacity)) > 1e-3;
      }
    }
    ShadowTest::CheckAtLeast(static_cast<double>(used), 200.0, "pixels in the box's shadow alone");
    ShadowTest::CheckAtMost(static_cast<double>(wrong), 0.02 * static_cast<double>(used),
      std::to_string(opacity) + ": pixels that differ from 1 - opacity, at its edges");
  }
}

//------------------------------------------------------------------------------
// More opacities than there are parts of lights for: 3 lights leave 4 levels between 0 and 1, and
// opacities are rounded by at most half of one.
SHADOW_TEST(Translucency, ManyOpacities, Each)
{
  ShadowStage stage;
  vtkActor* floor = stage.AddFloor();
  for (int i = 0; i < 25; ++i)
  {
    const glm::dvec3 centre(-2.0 + i % 5, -2.0 + static_cast<int>(i / 5), 0.5);
    stage.AddBox(centre, { 0.6, 0.6, 0.02 })->GetProperty()->SetOpacity((i + 1) / 26.0);
  }
  for (int i = 0; i < 3; ++i)
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPosition(1.0, 0.0, 1.0);
    light->SetFocalPoint(0.0, 0.0, 0.0);
    stage.Renderer->AddLight(light);
  }
  stage.LookAt({ 0.0, -0.1, 9.0 }, { 0.0, 0.0, 0.0 });
  stage.SetPass(technique, With("weighted"));
  stage.Render();
  const Visibility visibility = stage.GetVisibility(1);
  ShadowTest::CheckNoMessage("many opacities");
  const ShadowOracle oracle(stage);
  std::set<float> levels;
  double worst = 0.0;
  for (int i = 0; i < 160 * 160; ++i)
  {
    const SurfacePoint& pixel = oracle.GetPixels()[i];
    const glm::dvec3 shifted = pixel.Position + glm::dvec3(2.5, 2.0, 0.0); // to the box above it
    const int column = static_cast<int>(std::round(shifted.x));
    const int row = static_cast<int>(std::round(shifted.y));
    if (pixel.Actor == floor && column >= 0 && column < 5 && row >= 0 && row < 5 &&
        std::abs(shifted.x - column) < 0.25 && std::abs(shifted.y - row) < 0.25)
    {
      levels.insert(std::round(1000.0f * visibility.V[i]));
      worst = std::max(worst, std::abs(visibility.V[i] - (1.0 - (5 * row + column + 1) / 26.0)));
    }
  }
  ShadowTest::CheckEqual(
    static_cast<double>(levels.size()), 6.0, "different V in the boxes' shadows");
  ShadowTest::CheckAtMost(worst, 0.1001, "difference of V from 1 - opacity");
}

//------------------------------------------------------------------------------
// A pane before a floor, both half in the shadow of a box: where all that a pixel shows sees the light,
// the picture is VTK's, and where nothing does, it is VTK's with the light all but out. In forward and
// screen evaluation, blended and peeled.
SHADOW_TEST(Translucency, PanesReceive, Each)
{
  for (const char* order : { "blended", "dual peeled", "peeled" })
  {
    for (const char* evaluation : { "forward", "screen" })
    {
      const bool blended = std::string(order) == "blended";
      if (!blended && std::string(evaluation) == "forward" && technique != "map-hard")
      {
        continue; // the same shader
      }
      ShadowStage stage;
      stage.Renderer->SetUseDepthPeeling(!blended);
      stage.Renderer->SetUseDepthPeelingForVolumes(std::string(order) == "dual peeled");
      stage.Renderer->SetMaximumNumberOfPeels(4);
      stage.AddFloor();
      stage.AddBox({ -1.4, -0.3, 2.2 }, { 0.8, 1.6, 0.8 });
      vtkActor* pane = stage.AddQuad({ -1.5, -0.6, 0.2 }, { 3.0, 0.0, 0.0 }, { 0.0, 0.0, 1.4 });
      pane->GetProperty()->SetOpacity(0.5);
      pane->GetProperty()->SetColor(0.9, 0.5, 0.2);
      vtkAreaLight* light = stage.AddLight(LightKind::Point);
      stage.LookAt({ 1.5, -6.5, 3.5 }, { 0.0, 0.0, 0.3 });
      stage.Render();
      const Picture plain = stage.GetPicture();
      light->SetIntensity(1e-6);
      stage.Render();
      const Picture out = stage.GetPicture();
      light->SetIntensity(1.0);
      Parameters parameters = Fine;
      parameters["evaluation"] = evaluation;
      stage.SetPass(technique, parameters);
      stage.Render();
      ShadowTest::TakeMessages(); // of a technique that has no forward evaluation
      stage.Render();
      const Picture picture = stage.GetPicture();
      const std::string what = std::string(order) + ", " + evaluation;
      ShadowTest::CheckNoMessage(what);

      const ShadowOracle front(stage, { pane });
      const Visibility near = front.GetHard(light, technique);
      const auto paneMask = front.GetMask(pane);
      const auto inner = front.GetInner(2);
      pane->VisibilityOff();
      const ShadowOracle back(stage);
      const Visibility far = back.GetHard(light, technique);
      const auto innerFar = back.GetInner(2);
      pane->VisibilityOn();
      std::size_t pixels[2] = { 0, 0 };
      std::size_t wrong[2] = { 0, 0 };
      for (std::size_t i = 0; i < paneMask.size(); ++i)
      {
        if (paneMask[i] && inner[i] && innerFar[i] && near.V[i] == far.V[i])
        {
          const int dark = near.V[i] == 0.0f;
          ++pixels[dark];
          wrong[dark] += picture.Difference(dark ? out : plain, i) > 1;
        }
      }
      ShadowTest::CheckAtLeast(static_cast<double>(pixels[0]), 500.0, what + ", lit pixels");
      ShadowTest::CheckAtLeast(static_cast<double>(pixels[1]), 100.0, what + ", dark pixels");
      for (const int dark : { 0, 1 })
      {
        // At a shadow's edge, which a texel or a pixel's corner decides otherwise than its middle.
        ShadowTest::CheckAtMost(static_cast<double>(wrong[dark]), 15.0,
          what + (dark ? ", dark" : ", lit") + ": pixels that differ");
      }
    }
  }
}

//------------------------------------------------------------------------------
// Two panes of different colours, one behind the other: away from the shadow of a post, the picture is
// VTK's, which shows them in their order under depth peeling.
SHADOW_TEST(Translucency, InOrder, Each)
{
  ShadowStage stage;
  stage.Renderer->UseDepthPeelingOn();
  stage.Renderer->SetMaximumNumberOfPeels(6);
  stage.AddFloor();
  stage.AddBox({ 2.5, 1.0, 0.5 }, { 0.3, 0.3, 1.0 });
  vtkActor* panes[2];
  for (int i = 0; i < 2; ++i)
  {
    panes[i] =
      stage.AddQuad({ -1.2 + 0.4 * i, -0.4 * i, 0.2 }, { 1.8, 0.0, 0.0 }, { 0.0, 0.0, 1.4 });
    panes[i]->GetProperty()->SetOpacity(0.6);
    panes[i]->GetProperty()->SetColor(i ? 0.1 : 0.9, 0.3, i ? 0.9 : 0.1);
  }
  stage.AddLight(LightKind::Point);
  stage.LookAt({ 0.5, -6.5, 3.0 }, { 0.0, 0.0, 0.4 });
  stage.Render();
  const Picture plain = stage.GetPicture();
  stage.SetPass(technique, Fine);
  stage.Render();
  const Picture picture = stage.GetPicture();
  ShadowTest::CheckEqual(stage.Count("lights"), 1.0, "the pass is at work: lights");
  const ShadowOracle oracle(stage);
  std::size_t shown = 0;
  int worst = 0;
  for (std::size_t i = 0; i < oracle.GetPixels().size(); ++i)
  {
    if (oracle.GetPixels()[i].Actor == panes[0] || oracle.GetPixels()[i].Actor == panes[1])
    {
      ++shown;
      worst = std::max(worst, picture.Difference(plain, i));
    }
  }
  ShadowTest::CheckAtLeast(static_cast<double>(shown), 2000.0, "pixels of the panes");
  ShadowTest::CheckAtMost(worst, 1.0, "difference from VTK's picture, of 255");
}
