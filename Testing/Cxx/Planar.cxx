// SPDX-License-Identifier: BSD-3-Clause
// What shadows on planes promise beyond the laws: which planes, which casters, and what a frame costs.

#include "ShadowOracle.h"
#include "ShadowTest.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkPlanarShadowPass.h"
#include "vtkProperty.h"
#include "vtkTransform.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
bool IsPlanar(const std::string& technique)
{
  return ShadowStage::Describe(technique).Traits.PlanarReceivers;
}

vtkPlanarShadowPass* GetPass(ShadowStage& stage)
{
  return vtkPlanarShadowPass::SafeDownCast(stage.Pass);
}

const Parameters Fine = { { "resolution", "1024" } };

/** A floor, a light of no size above it, and a camera on both. */
vtkActor* Stand(ShadowStage& stage, const glm::dvec3& light = { -1.5, -1.0, 5.0 })
{
  vtkActor* floor = stage.AddFloor();
  stage.AddLight(LightKind::Point, light, { 0.0, 0.0, 0.0 });
  stage.LookAt({ 3.5, -6.5, 4.5 }, { 0.2, 0.2, 0.3 });
  return floor;
}

/** Pixels of an edge of 160 pixels' length at most may see the other side. */
void CheckTruth(const std::string& technique, ShadowStage& stage, const std::string& what,
  double bound = 0.006, int light = 0)
{
  vtkCollectionSimpleIterator cookie;
  vtkLightCollection* lights = stage.Renderer->GetLights();
  lights->InitTraversal(cookie);
  vtkLight* casting = nullptr;
  for (int i = 0; i <= light; ++i)
  {
    casting = lights->GetNextLight(cookie);
  }
  stage.Render();
  const Visibility truth = ShadowOracle(stage).GetHard(casting, technique);
  ShadowTest::CheckAtMost(Compare(stage.GetVisibility(casting), truth, 0.5).Share, bound,
    what + ": pixels that differ from the truth");
}

/** The width of x along y = 0 on the floor where V is between these. */
double GetPenumbraWidth(const std::string& technique, double height, double size)
{
  ShadowStage stage(400, 100);
  stage.AddFloor(6.0);
  stage.AddQuad({ -16.0, -16.0, height }, { 16.0, 0.0, 0.0 }, { 0.0, 32.0, 0.0 });
  vtkAreaLight* light = stage.AddLight(LightKind::Rectangle, { 0.0, 0.0, 6.0 }, { 0.0, 0.0, 0.0 });
  light->SetWidth(size);
  light->SetHeight(size);
  stage.Renderer->GetActiveCamera()->SetViewUp(0.0, 1.0, 0.0);
  // From below the edge's height, straight down: a pixel is as wide everywhere.
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetPosition(0.0, 0.0, 0.4);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5); // 4 x 1
  camera->SetClippingRange(0.01, 1.0);
  stage.SetPass(technique, { { "resolution", "1024" }, { "samples", "256" } });
  stage.Render();
  const Visibility visibility = stage.GetVisibility();
  double width = 0.0;
  for (int x = 0; x < 400; ++x)
  {
    width += visibility(x, 50) > 0.1f && visibility(x, 50) < 0.9f ? 0.01 : 0.0;
  }
  return width;
}
}

//------------------------------------------------------------------------------
// What is below the plane, above the light or level with either casts nothing; what crosses the plane
// or reaches beside the light casts with the part that is between them.
SHADOW_TEST(Planar, CastersBetweenLightAndPlane, Each)
{
  if (!IsPlanar(technique))
  {
    return;
  }
  struct
  {
    const char* Name;
    glm::dvec3 Centre, Size;
    bool Casts;
  } const cases[] = {
    { "below the plane", { 0.5, 0.5, -1.0 }, { 1.0, 1.0, 1.2 }, false },
    { "under the plane, touching it", { 0.5, 0.5, -0.5 }, { 1.0, 1.0, 1.0 }, false },
    { "through the plane", { 0.5, 0.5, 0.1 }, { 1.0, 0.8, 1.4 }, true },
    { "standing on the plane", { 0.5, 0.5, 0.4 }, { 1.0, 0.8, 0.8 }, true },
    { "in the air", { 0.3, 0.3, 1.2 }, { 1.0, 0.8, 0.5 }, true },
    { "above the light", { -1.0, -1.0, 6.5 }, { 2.0, 2.0, 1.0 }, false },
    { "from below the light to above it", { -0.2, -0.2, 4.5 }, { 0.5, 0.4, 3.0 }, true },
    { "from below the plane to above the light", { 0.5, 0.5, 3.0 }, { 0.3, 0.3, 8.0 }, true },
  };
  for (const auto& test : cases)
  {
    ShadowStage stage;
    vtkActor* floor = Stand(stage);
    stage.AddBox(test.Centre, test.Size);
    stage.SetPass(technique, Fine);
    CheckTruth(technique, stage, test.Name);
    const ShadowOracle oracle(stage);
    const auto mask = oracle.GetMask(floor);
    const Visibility visibility = stage.GetVisibility();
    float lowest = 1.0f;
    for (std::size_t i = 0; i < mask.size(); ++i)
    {
      lowest = mask[i] ? std::min(lowest, visibility.V[i]) : lowest;
    }
    ShadowTest::CheckEqual(
      lowest, test.Casts ? 0.0 : 1.0, std::string(test.Name) + ": lowest V on the floor");
    ShadowTest::CheckEqual(stage.Count("planarMapsDrawn") + stage.Count("planarMapsReused"),
      test.Casts ? 1.0 : 0.0, std::string(test.Name) + ": layers");
  }
}

//------------------------------------------------------------------------------
// Below the floor, whose upper side is then dark by itself; in the floor's plane; and a directional
// light from below and along it.
SHADOW_TEST(Planar, LightsBelowAndLevel, Each)
{
  if (!IsPlanar(technique))
  {
    return;
  }
  for (const bool positional : { true, false })
  {
    for (const double height : { -2.0, 0.0 })
    {
      ShadowStage stage;
      stage.AddFloor();
      stage.AddBox({ 0.5, 0.5, 0.5 }, { 1.0, 1.0, 1.0 });
      vtkAreaLight* light = stage.AddLight(positional ? LightKind::Point : LightKind::Directional,
        { -2.0, -1.0, height }, { 0.0, 0.0, 0.0 });
      light->SetAngularDiameter(0.0);
      stage.LookAt({ 3.5, -6.5, 4.5 }, { 0.2, 0.2, 0.3 });
      stage.SetPass(technique, Fine);
      stage.Render();
      const std::string what =
        std::string(positional ? "position" : "direction") + " at height " + std::to_string(height);
      const auto range = GetRange(stage.GetVisibility());
      ShadowTest::CheckAtLeast(range.first, 0.0, what + ": lowest V");
      ShadowTest::CheckAtMost(range.second, 1.0, what + ": highest V");
      ShadowTest::CheckEqual(stage.Count("planarMapsDrawn"), 0.0, what + ": layers drawn");
    }
  }
}

//------------------------------------------------------------------------------
// A large light that reaches through the floor: the part below hides behind the floor, so that V is
// what the part above leaves. From below, the same the other way round.
SHADOW_TEST(Planar, LightThroughThePlane, Each)
{
  if (!IsPlanar(technique) || ShadowStage::Describe(technique).Traits.Hard ||
      technique == "planar-fake")
  {
    return; // these take the light's centre
  }
  const auto show = [](const std::string& name)
  {
    ShadowStage stage;
    stage.AddFloor();
    stage.AddBox({ 0.5, 0.5, 0.6 }, { 0.6, 0.6, 1.2 });
    // Upright, from 2.4 below to 3.6 above.
    vtkAreaLight* light =
      stage.AddLight(LightKind::Rectangle, { -4.0, -3.0, 0.6 }, { 0.0, 0.0, 0.6 });
    light->SetUpVector(0.0, 0.0, 1.0);
    light->SetWidth(0.4);
    light->SetHeight(6.0);
    stage.LookAt({ 3.5, -6.5, 4.5 }, { 0.2, 0.2, 0.3 });
    stage.SetPass(name, { { "samples", "256" }, { "resolution", "1024" } });
    stage.Render();
    Visibility visibility = stage.GetVisibility();
    const ShadowOracle oracle(stage);
    const auto flat = oracle.GetFlatMask();
    const auto inner = oracle.GetInner(2);
    for (std::size_t i = 0; i < flat.size(); ++i)
    {
      visibility.Mask[i] = visibility.Mask[i] && flat[i] && inner[i];
    }
    return visibility;
  };
  const Visibility planar = show(technique);
  if (vtkShadowTechniqueRegistration::Find("ray-traced"))
  {
    const Difference difference = Compare(planar, show("ray-traced"), 0.1);
    ShadowTest::CheckAtLeast(static_cast<double>(difference.Pixels), 5000.0, "pixels");
    ShadowTest::CheckAtMost(difference.RMSE, 0.015, "RMSE against rays");
  }
  ShadowTest::CheckAtMost(GetRange(planar).second, 0.65, "what of the light is above");
}

//------------------------------------------------------------------------------
// Planes that are given are taken, and no others; a caster in one of them casts nothing onto it. What is
// no plane gives one error.
SHADOW_TEST(Planar, GivenPlanes, Each)
{
  if (!IsPlanar(technique))
  {
    return;
  }
  ShadowStage stage;
  Stand(stage);
  stage.AddQuad({ -4.0, 3.0, 0.0 }, { 8.0, 0.0, 0.0 }, { 0.0, 0.0, 3.0 }); // a wall
  stage.AddBox({ 0.5, 2.2, 0.6 }, { 0.8, 0.8, 1.2 });
  stage.SetPass(technique, Fine);
  stage.Render();
  ShadowTest::CheckEqual(stage.Count("planesFound"), 2.0, "planes found");
  const Visibility found = stage.GetVisibility();

  vtkPlanarShadowPass* pass = GetPass(stage);
  ShadowTest::CheckEqual(pass->GetNumberOfPlanes(), 0, "planes given");
  // The floor, by another point and length of normal, upside down.
  ShadowTest::Check(pass->AddPlane(7.0, -3.0, 0.0, 0.0, 0.0, -12.0), "the floor is refused");
  stage.Render();
  ShadowTest::CheckEqual(stage.Count("planes"), 1.0, "planes in use");
  const Visibility floorAlone = stage.GetVisibility();
  ShadowTest::Check(!Same(floorAlone, found), "the wall still receives");
  pass->AddPlane(0.0, 3.0, 0.0, 0.0, 1e-9, 0.0);
  pass->AddPlane(1.0, 3.0, 1.0, 0.0, -3.0, 0.0); // the same again
  ShadowTest::CheckEqual(pass->GetNumberOfPlanes(), 3, "planes given");
  CheckTruth(technique, stage, "floor and wall given", 0.01);
  ShadowTest::CheckEqual(stage.Count("planes"), 2.0, "planes in use");

  const double infinity = std::numeric_limits<double>::infinity();
  const double bad[][6] = { { 0, 0, 0, 0, 0, 0 }, { 0, 0, 0, std::nan(""), 0, 1 },
    { infinity, 0, 0, 0, 0, 1 }, { 0, 0, 0, 0, 0, -infinity } };
  for (const auto& b : bad)
  {
    ShadowTest::Check(
      !pass->AddPlane(b[0], b[1], b[2], b[3], b[4], b[5]), "what is no plane was taken");
    ShadowTest::CheckOneMessage(
      ShadowTest::Message::Error, { "AddPlane", "no plane" }, "what is no plane");
  }
  ShadowTest::CheckEqual(pass->GetNumberOfPlanes(), 3, "planes after bad ones");
  pass->RemoveAllPlanes();
  stage.Render();
  ShadowTest::Check(Same(stage.GetVisibility(), found), "without given planes: not as found");
}

//------------------------------------------------------------------------------
// The floor of a body that is no flat prop receives once its plane is given, at any place and scale.
SHADOW_TEST(Planar, GivenPlaneOfABody, Each)
{
  if (!IsPlanar(technique))
  {
    return;
  }
  for (const double scale : { 1.0, 1e-5, 1e6 })
  {
    Placement place;
    place.Scale = scale;
    place.Turn =
      glm::dmat3(glm::rotate(glm::dmat4(1.0), 0.7, glm::normalize(glm::dvec3(1.0, 2.0, 3.0))));
    place.Offset = scale * glm::dvec3(100.0, -200.0, 50.0);
    ShadowStage stage(160, 160, place);
    vtkActor* slab = stage.AddBox({ 0.0, 0.0, -0.2 }, { 8.0, 8.0, 0.4 });
    stage.AddBox({ 0.3, 0.3, 0.6 }, { 0.8, 0.8, 1.2 });
    stage.AddLight(LightKind::Point);
    stage.LookAt({ 3.5, -6.5, 4.5 }, { 0.2, 0.2, 0.3 });
    stage.SetPass(technique, Fine);
    stage.Render();
    const std::string what = "scale " + std::to_string(scale);
    ShadowTest::CheckEqual(stage.Count("planesFound"), 0.0, what + ": planes found");
    ShadowTest::CheckOneMessage(
      ShadowTest::Message::Warning, { "nothing receives", "AddPlane" }, what + ": without a plane");
    const glm::dvec3 point = place({ 1.0, 0.0, 0.0 });
    const glm::dvec3 normal = place.Turn * glm::dvec3(0.0, 0.0, 1.0);
    GetPass(stage)->AddPlane(point.x, point.y, point.z, normal.x, normal.y, normal.z);
    stage.Render();
    auto* light = vtkLight::SafeDownCast(stage.Renderer->GetLights()->GetItemAsObject(0));
    const ShadowOracle oracle(stage);
    auto use = oracle.GetMask(slab);
    const glm::dvec3 up = normal;
    for (std::size_t i = 0; i < use.size(); ++i)
    {
      use[i] = use[i] && glm::dot(oracle.GetPixels()[i].Normal, up) > 0.9;
    }
    ShadowTest::CheckAtMost(Compare(stage.GetVisibility(), oracle.GetHard(light), 0.5, use).Share,
      0.01, what + ": pixels of the slab's top that differ from the truth");
    ShadowTest::CheckEqual(GetRange(stage.GetVisibility()).first, 0.0, what + ": a shadow");
  }
}

//------------------------------------------------------------------------------
// Floor and wall, two lights of different kinds: each plane has each light's shadow, and the wall casts
// onto the floor.
SHADOW_TEST(Planar, TwoPlanesTwoLights, Each)
{
  if (!IsPlanar(technique))
  {
    return;
  }
  ShadowStage stage;
  Stand(stage, { -2.0, -2.0, 4.0 });
  stage.AddQuad({ -4.0, 2.0, 0.0 }, { 8.0, 0.0, 0.0 }, { 0.0, 0.0, 3.0 });
  stage.AddBox({ 0.5, 0.8, 0.7 }, { 0.7, 0.7, 1.4 });
  vtkAreaLight* sun = stage.AddLight(LightKind::Directional, { 3.0, -4.0, 4.0 }, { 0.0, 0.0, 0.0 });
  sun->SetAngularDiameter(0.0);
  vtkAreaLight* behind = stage.AddLight(LightKind::Point, { 0.0, 5.0, 4.0 }, { 0.0, 0.0, 0.0 });
  behind->SetAngularDiameter(0.0);
  stage.SetPass(technique, Fine);
  for (int light = 0; light < 3; ++light)
  {
    CheckTruth(technique, stage, "light " + std::to_string(light), 0.012, light);
  }
  ShadowTest::CheckEqual(stage.Count("planes"), 2.0, "planes");
  // The box onto both from the first two lights; from behind the wall, box and wall onto the floor.
  ShadowTest::CheckEqual(
    stage.Count("planarMapsDrawn") + stage.Count("planarMapsReused"), 5.0, "layers");
}

//------------------------------------------------------------------------------
// Of more planes than the limit, the largest are taken, and the statistics tell of the others.
SHADOW_TEST(Planar, LimitIsTold, Each)
{
  if (!IsPlanar(technique))
  {
    return;
  }
  ShadowStage stage;
  Stand(stage);
  for (int i = 0; i < 5; ++i)
  {
    stage.AddQuad({ -2.0 + i, 1.0, 0.2 + 0.2 * i }, { 0.8, 0.0, 0.0 }, { 0.0, 0.8, 0.0 });
  }
  stage.SetPass(technique, { { "planes", "1" }, { "resolution", "1024" } });
  stage.Render();
  ShadowTest::CheckEqual(stage.Count("planesFound"), 6.0, "found");
  ShadowTest::CheckEqual(stage.Count("planes"), 1.0, "in use");
  ShadowTest::CheckEqual(stage.Count("planesLeftOut"), 5.0, "left out");
  ShadowTest::CheckEqual(GetRange(stage.GetVisibility()).first, 0.0, "the floor has its shadows");
  ShadowTest::CheckNoMessage("more planes than the limit");
  stage.Pass->SetParameter("planes", "16");
  stage.Render();
  ShadowTest::CheckEqual(stage.Count("planesLeftOut"), 0.0, "left out, limit 16");
  CheckTruth(technique, stage, "six planes", 0.015);
}

//------------------------------------------------------------------------------
// A tile that lies in the floor's plane is one plane with it, casts nothing onto it and receives.
SHADOW_TEST(Planar, CasterInThePlane, Each)
{
  if (!IsPlanar(technique))
  {
    return;
  }
  ShadowStage stage;
  stage.AddQuad({ -4.0, -4.0, 0.0 }, { 4.0, 0.0, 0.0 }, { 0.0, 8.0, 0.0 });
  stage.AddQuad({ 0.0, -4.0, 0.0 }, { 4.0, 0.0, 0.0 }, { 0.0, 8.0, 0.0 });
  stage.AddLight(LightKind::Point);
  stage.LookAt({ 3.5, -6.5, 4.5 }, { 0.2, 0.2, 0.3 });
  stage.SetPass(technique, Fine);
  stage.Render();
  ShadowTest::CheckEqual(stage.Count("planesFound"), 1.0, "planes of two tiles");
  ShadowTest::CheckEqual(GetRange(stage.GetVisibility()).first, 1.0, "lowest V of tiles alone");
  stage.AddBox({ 0.0, 0.5, 0.5 }, { 1.0, 1.0, 1.0 });
  CheckTruth(technique, stage, "a box on both tiles", 0.01);
}

//------------------------------------------------------------------------------
// Translucent floors and those that do not cast receive: of these there is a box, and it is flat.
SHADOW_TEST(Planar, ReceiversThatDoNotCast, Each)
{
  if (!IsPlanar(technique))
  {
    return;
  }
  for (const bool translucent : { false, true })
  {
    ShadowStage stage;
    vtkActor* floor = Stand(stage);
    stage.AddBox({ 0.0, 0.5, 0.5 }, { 1.0, 1.0, 1.0 });
    stage.SetPass(technique, Fine);
    stage.Render();
    const Picture casting = stage.GetPicture();
    translucent ? floor->GetProperty()->SetOpacity(0.999) : vtkShadowPass::SetCasting(floor, false);
    stage.Render();
    ShadowTest::CheckEqual(stage.Count("planesFound"), 1.0, "planes");
    const Picture picture = stage.GetPicture();
    std::size_t other = 0;
    for (std::size_t i = 0; i < picture.RGB.size() / 3; ++i)
    {
      other += picture.Difference(casting, i) > 6;
    }
    // Windows hug what casts: texels shift.
    ShadowTest::CheckAtMost(static_cast<double>(other), 160.0,
      translucent ? "translucent: pixels that differ" : "not casting: pixels that differ");
  }
}

//------------------------------------------------------------------------------
// Layers along a plane are kept while the camera moves; a mask of pixels is drawn while it moves, and
// not out of view.
SHADOW_TEST(Planar, CameraMoves, Each)
{
  if (!IsPlanar(technique))
  {
    return;
  }
  const bool hard = ShadowStage::Describe(technique).Traits.Hard;
  ShadowStage stage;
  stage.AddThings();
  stage.AddLight(LightKind::Rectangle);
  stage.SetPass(technique);
  stage.Render();
  ShadowTest::CheckEqual(stage.Count("planarMapsDrawn"), 1.0, "first frame");
  stage.Render();
  ShadowTest::CheckEqual(stage.Count("planarMapsDrawn"), 0.0, "the same frame");
  ShadowTest::CheckEqual(stage.Count("planarMapsReused"), 1.0, "the same frame, reused");
  stage.LookAt({ 3.0, -6.0, 5.0 }, { 0.2, 0.2, 0.3 });
  stage.Render();
  ShadowTest::CheckEqual(stage.Count("planarMapsDrawn"), hard ? 1.0 : 0.0, "camera moved");
  stage.LookAt({ 30.0, 0.0, 4.0 }, { 60.0, 0.0, 4.0 });
  stage.Render();
  ShadowTest::CheckEqual(stage.Count("planarMapsDrawn"), 0.0, "away");
  ShadowTest::CheckEqual(stage.Count("planarMapsOutOfView"), hard ? 1.0 : 0.0, "away, out of view");
}

//------------------------------------------------------------------------------
// The penumbra of a straight edge at height h under a light of width w at height H is w h / (H - h)
// wide; V goes from 0.1 to 0.9 on four fifths of it.
SHADOW_TEST(Planar, PenumbraFollowsSizeAndHeight, Each)
{
  if (!IsPlanar(technique) || ShadowStage::Describe(technique).Traits.Hard)
  {
    return;
  }
  for (const double height : { 0.5, 1.0, 2.0 })
  {
    for (const double size : { 0.5, 1.0, 2.0 })
    {
      const double expected = 0.8 * size * height / (6.0 - height);
      const double width = GetPenumbraWidth(technique, height, size);
      // A pixel at either end, and a texel.
      ShadowTest::CheckAtMost(std::abs(width - expected), 0.04 + 0.05 * expected,
        "edge at " + std::to_string(height) + ", light of " + std::to_string(size) +
          ": penumbra's width is " + std::to_string(width) + " and off by");
    }
  }
}

//------------------------------------------------------------------------------
// resolution=0 follows the picture in powers of two, so that few sizes need new layers.
SHADOW_TEST(Planar, ResolutionFollowsThePicture, Each)
{
  if (!IsPlanar(technique) || !ShadowStage::HasParameter(technique, "resolution"))
  {
    return;
  }
  ShadowStage stage;
  stage.AddThings();
  stage.AddLight(LightKind::Point);
  stage.SetPass(technique, { { "resolution", "0" } });
  const auto measure = [&](int width, int height, double drawn)
  {
    stage.Window->SetSize(width, height);
    stage.Render();
    ShadowTest::CheckEqual(stage.Count("planarMapsDrawn"), drawn,
      std::to_string(width) + " x " + std::to_string(height) + ": layers drawn");
    return stage.GetStatistics()["bytes"]["planes"].get<double>();
  };
  const double bytes = measure(160, 120, 1.0);
  ShadowTest::CheckAtLeast(bytes, 512.0 * 512.0 * 4.0, "bytes");
  ShadowTest::CheckEqual(measure(200, 300, 0.0), bytes, "bytes of a taller picture");
  ShadowTest::CheckAtMost(std::abs(measure(600, 100, 1.0) / bytes - 4.0), 0.001,
    "bytes of a wider picture, four times as many");
}

//------------------------------------------------------------------------------
// Of a caster's shadow no pixel's centre is missed: a mask is drawn with VTK's own camera, whatever its
// kind.
SHADOW_TEST(Planar, MaskFitsThePicture, Once)
{
  if (!vtkShadowTechniqueRegistration::Find("planar-hard"))
  {
    return;
  }
  const std::pair<const char*, std::function<void(vtkCamera*)>> cameras[] = {
    { "plain", [](vtkCamera*) {} },
    { "window's centre moved", [](vtkCamera* camera) { camera->SetWindowCenter(0.3, -0.2); } },
    { "parallel",
      [](vtkCamera* camera)
      {
        camera->ParallelProjectionOn();
        camera->SetParallelScale(3.0);
      } },
    { "near plane behind the shadow",
      [](vtkCamera* camera) { camera->SetClippingRange(6.0, 20.0); } },
    { "mirrored view",
      [](vtkCamera* camera)
      {
        vtkNew<vtkTransform> mirror;
        mirror->Scale(-1.0, 1.0, 1.0);
        camera->SetUserViewTransform(mirror);
      } },
    { "mirrored picture",
      [](vtkCamera* camera)
      {
        vtkNew<vtkTransform> mirror;
        mirror->Scale(-1.0, 1.0, 1.0);
        camera->SetUserTransform(mirror);
      } },
  };
  for (const auto& test : cameras)
  {
    ShadowStage stage(200, 140);
    vtkActor* floor = Stand(stage);
    stage.AddBox({ 0.4, 0.4, 0.8 }, { 0.9, 0.7, 0.6 });
    test.second(stage.Renderer->GetActiveCamera());
    stage.SetPass("planar-hard");
    stage.Render();
    const Visibility planar = stage.GetVisibility();
    // Rays from the receivers' own positions: the same pixels but for those that rounding turns.
    stage.SetPass("ray-traced", { { "samples", "1" } });
    stage.Render();
    const Visibility traced = stage.GetVisibility();
    vtkShadowPass::SetReceiving(floor, false);
    stage.Render();
    const Visibility others = stage.GetVisibility();
    std::vector<unsigned char> use;
    std::size_t dark = 0;
    for (std::size_t i = 0; i < traced.V.size(); ++i)
    {
      use.push_back(traced.Mask[i] && !others.Mask[i]);
      dark += use.back() && traced.V[i] == 0.0f;
    }
    const Difference difference = Compare(planar, traced, 0.5, use);
    ShadowTest::CheckAtLeast(
      static_cast<double>(dark), 200.0, std::string(test.first) + ": dark pixels");
    ShadowTest::CheckAtMost(
      static_cast<double>(dark), 2000.0, std::string(test.first) + ": dark pixels");
    ShadowTest::CheckAtMost(difference.Share * static_cast<double>(difference.Pixels), 2.0,
      std::string(test.first) + ": pixels of the floor that differ from rays");
  }
}

//------------------------------------------------------------------------------
// Sixteen lights and more planes than uniforms hold.
SHADOW_TEST(Planar, ManyLightsAndPlanes, Each)
{
  if (!IsPlanar(technique))
  {
    return;
  }
  ShadowStage stage;
  stage.AddFloor();
  for (int i = 0; i < 7; ++i)
  {
    stage.AddQuad({ -3.0 + i, 1.0, 0.3 + 0.1 * i }, { 0.7, 0.0, 0.0 }, { 0.0, 0.7, 0.0 });
  }
  for (int i = 0; i < 16; ++i)
  {
    const double angle = 0.3927 * i;
    stage.AddLight(LightKind::Point,
      { 2.5 * std::cos(angle), 2.5 * std::sin(angle), 4.0 + 0.1 * i }, { 0.0, 0.0, 0.0 });
  }
  stage.LookAt({ 3.5, -6.5, 4.5 }, { 0.2, 0.2, 0.3 });
  stage.SetPass(technique, { { "planes", "8" }, { "resolution", "512" } });
  for (const int light : { 0, 7, 15 })
  {
    CheckTruth(technique, stage, "light " + std::to_string(light), 0.02, light);
  }
  ShadowTest::CheckEqual(stage.Count("planes"), 8.0, "planes");
}

//------------------------------------------------------------------------------
// A light without size beside one that has a size: the shader that filters serves both.
SHADOW_TEST(Planar, PointBesideAreaLight, Each)
{
  if (!ShadowStage::Describe(technique).Traits.PlanarReceivers)
  {
    return;
  }
  const auto look = [&](bool both)
  {
    ShadowStage stage;
    stage.AddFloor();
    stage.AddBox({ 0.0, 0.0, 0.6 }, { 1.0, 1.0, 1.2 });
    vtkAreaLight* point = stage.AddLight(LightKind::Point, { -2.5, -2.0, 5.5 }, { 0, 0, 0 });
    if (both)
    {
      stage.AddLight(LightKind::Disk, { 2.5, -2.0, 5.5 }, { 0, 0, 0 });
    }
    stage.LookAt({ 3.0, -7.0, 4.0 }, { 0.0, 0.0, 0.3 });
    stage.SetPass(technique);
    stage.Render();
    return stage.GetVisibility(point);
  };
  const Visibility alone = look(false);
  ShadowTest::CheckEqual(GetRange(alone).first, 0.0, "lowest V of the point light alone");
  ShadowTest::CheckAtMost(
    Compare(look(true), alone).Share, 0.001, "pixels other than those of the point light alone");
}
