// SPDX-License-Identifier: BSD-3-Clause
// Visibility is of the world: however a camera splits what it shows between its view and its
// projection, scaled, sheared, mirrored or off its axis, V is the same.

#include "ShadowOracle.h"
#include "ShadowTest.h"

#include "vtkCamera.h"
#include "vtkGaussianBlurPass.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAAPass.h"
#include "vtkTransform.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
const glm::dvec3 Eye(3.5, -6.5, 4.5); // of ShadowStage::AddThings
const Parameters Fine = { { "resolution", "512" }, { "samples", "4" } };

glm::dmat4 Get(vtkMatrix4x4* matrix)
{
  return glm::transpose(glm::make_mat4(matrix->GetData()));
}

vtkSmartPointer<vtkMatrix4x4> Make(const glm::dmat4& matrix)
{
  auto result = vtkSmartPointer<vtkMatrix4x4>::New();
  result->DeepCopy(glm::value_ptr(glm::transpose(matrix)));
  return result;
}

/** Show what the camera shows, by a model transform and a projection that makes up for it. */
void Split(ShadowStage& stage, const glm::dmat4& model)
{
  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  const glm::dmat4 view = Get(camera->GetModelViewTransformMatrix());
  const glm::dmat4 projection =
    Get(camera->GetProjectionTransformMatrix(stage.Renderer->GetTiledAspectRatio(), -1.0, 1.0));
  camera->SetModelTransformMatrix(Make(model));
  const glm::dmat4 seen = Get(camera->GetModelViewTransformMatrix());
  camera->SetViewShear(0.0, 0.0, 1.0);
  camera->SetUserTransform(nullptr);
  camera->SetExplicitProjectionTransformMatrix(Make(projection * view * glm::inverse(seen)));
  camera->UseExplicitProjectionTransformMatrixOn();
}

glm::dmat4 Shear()
{
  glm::dmat4 shear(1.0);
  shear[2][0] = 0.4;
  shear[1][2] = -0.3;
  return shear;
}

struct Model
{
  const char* Name;
  glm::dmat4 Matrix;
};

std::vector<Model> GetModels()
{
  const glm::dmat4 one(1.0);
  return {
    { "scaled along z", glm::scale(one, { 1.0, 1.0, 10.0 }) },
    { "scaled down about the eye",
      glm::translate(one, Eye) * glm::scale(one, glm::dvec3(0.01)) * glm::translate(one, -Eye) },
    { "sheared and moved", glm::translate(one, { 2.0, -1.0, 3.0 }) * Shear() },
    { "mirrored and flattened", glm::scale(one, { -1.0, 0.2, 1.0 }) },
    { "mirrored", glm::scale(one, { 1.0, -1.0, 1.0 }) },
  };
}

struct Camera
{
  const char* Name;
  std::function<void(vtkCamera*)> Apply;
};

const std::vector<Camera>& GetCameras()
{
  static const std::vector<Camera> cameras = {
    { "perspective", [](vtkCamera*) {} },
    { "view shear", [](vtkCamera* camera) { camera->SetViewShear(0.15, -0.1, 0.5); } },
    { "parallel",
      [](vtkCamera* camera)
      {
        camera->ParallelProjectionOn();
        camera->SetParallelScale(2.6);
      } },
    { "mirrored picture",
      [](vtkCamera* camera)
      {
        vtkNew<vtkTransform> mirror;
        mirror->Scale(-1.0, 1.0, 1.0);
        camera->SetUserTransform(mirror);
      } },
  };
  return cameras;
}

LightKind GetAreaLight(const std::string& technique)
{
  return ShadowStage::Supports(technique, LightKind::Sphere) ? LightKind::Sphere : LightKind::Point;
}
}

//------------------------------------------------------------------------------
// The same picture of the same world: V can differ where an edge is met by rounding, and nowhere else.
SHADOW_TEST(Cameras, SplitInAnyWay, Each)
{
  for (const Camera& camera : GetCameras())
  {
    ShadowStage reference;
    reference.AddThings();
    reference.AddLight(GetAreaLight(technique));
    camera.Apply(reference.Renderer->GetActiveCamera());
    reference.SetPass(technique, Fine);
    reference.Render();
    const Visibility expected = reference.GetVisibility();
    const auto range = GetRange(expected);
    ShadowTest::Check(range.first < 0.1f && range.second == 1.0f, "no shadow to compare");
    for (const Model& model : GetModels())
    {
      ShadowStage stage;
      stage.AddThings();
      stage.AddLight(GetAreaLight(technique));
      camera.Apply(stage.Renderer->GetActiveCamera());
      Split(stage, model.Matrix);
      stage.SetPass(technique, Fine);
      stage.Render();
      const std::string what = std::string(camera.Name) + ", " + model.Name;
      const Difference difference = Compare(stage.GetVisibility(), expected, 0.1);
      ShadowTest::CheckAtMost(difference.Share, 0.004, what + ": pixels that differ");
      ShadowTest::CheckAtMost(std::abs(difference.Bias), 0.001, what + ": bias");
      ShadowTest::CheckAtMost(difference.MaskShare, 0.002, what + ": receivers that differ");
      ShadowTest::CheckNoMessage(what);
    }
  }
}

//------------------------------------------------------------------------------
// What is drawn is VTK's picture by that camera, times V; and a pass that goes from one kind of camera
// to the other and back draws as before.
SHADOW_TEST(Cameras, DrawWhatTheySee, Each)
{
  ShadowStage stage;
  stage.AddThings();
  vtkLight* light = stage.AddLight(LightKind::Point);
  stage.SetPass(technique, Fine);
  stage.Render();
  const Picture before = stage.GetPicture();
  const Visibility visibilityBefore = stage.GetVisibility();

  vtkCamera* camera = stage.Renderer->GetActiveCamera();
  camera->SetModelTransformMatrix(Make(glm::scale(glm::dmat4(1.0), { 1.0, 1.0, 1.6 })));
  stage.Renderer->SetPass(nullptr);
  stage.Render();
  const Picture plain = stage.GetPicture();
  light->SetIntensity(1e-6);
  stage.Render();
  const Picture out = stage.GetPicture();
  light->SetIntensity(1.0);
  stage.Renderer->SetPass(stage.Pass);
  stage.Render();
  const Picture picture = stage.GetPicture();
  CheckShadowed(
    picture, plain, out, GetRegions(stage.GetVisibility()), 5000.0, 300.0, "scaled along z");

  camera->SetModelTransformMatrix(Make(glm::dmat4(1.0)));
  stage.Render();
  ShadowTest::Check(Same(stage.GetPicture(), before), "not the picture of before");
  ShadowTest::Check(Same(stage.GetVisibility(), visibilityBefore), "not the visibility of before");
}

//------------------------------------------------------------------------------
// A projection off its axis shows a part of a larger picture.
SHADOW_TEST(Cameras, OffAxisIsAPart, Each)
{
  const auto build = [&](ShadowStage& stage)
  {
    stage.AddThings();
    // Random rays are another pixel's.
    stage.AddLight(
      ShadowStage::HasParameter(technique, "seed") ? LightKind::Point : GetAreaLight(technique));
    stage.SetPass(technique, Fine);
  };
  ShadowStage whole(320, 160);
  build(whole);
  whole.Render();
  const Visibility expected = whole.GetVisibility();
  ShadowStage part(160, 160);
  build(part);
  vtkCamera* camera = part.Renderer->GetActiveCamera();
  // Its right half: x of -1..1 is that of 0..1 in the whole.
  glm::dmat4 half(1.0);
  half[0][0] = 2.0;
  half[3][0] = -1.0;
  camera->SetExplicitProjectionTransformMatrix(
    Make(half * Get(camera->GetProjectionTransformMatrix(2.0, -1.0, 1.0))));
  camera->UseExplicitProjectionTransformMatrixOn();
  part.Render();
  const Visibility visibility = part.GetVisibility();
  std::size_t differ = 0;
  std::size_t compared = 0;
  const int border = technique == "map-blur" ? 40 : 0; // what a blur of the picture cannot know
  for (int y = border; y < 160 - border; ++y)
  {
    for (int x = border; x < 160 - border; ++x)
    {
      ++compared;
      differ += !(std::abs(visibility(x, y) - expected(x + 160, y)) <= 0.1f);
    }
  }
  ShadowTest::CheckAtMost(
    static_cast<double>(differ) / static_cast<double>(compared), 0.004, "pixels that differ");
}

//------------------------------------------------------------------------------
// A delegate that draws a larger picture (a blur's border, more samples) finds its pixels, off the
// axis too.
SHADOW_TEST(Cameras, LargerPictures, Each)
{
  for (const bool blurs : { true, false })
  {
    ShadowStage stage;
    stage.AddThings();
    vtkAreaLight* light = stage.AddLight(GetAreaLight(technique));
    ShadowStage::Shrink(light, 0.3);
    stage.Renderer->GetActiveCamera()->SetViewShear(0.15, -0.1, 0.5);
    if (!blurs)
    {
      Split(stage, GetModels()[0].Matrix); // a blur enlarges the view's angle
    }
    // Slices are united, so that umbrae are quite dark.
    stage.SetPass(technique,
      { { "evaluation", "screen" }, { "combine", "bits" }, { "double-projection", "on" } });
    stage.Render();
    const auto regions = GetRegions(stage.GetVisibility(), 3);

    const auto makeEffect = [blurs]() -> vtkSmartPointer<vtkRenderPass>
    {
      vtkNew<vtkRenderStepsPass> steps;
      vtkNew<vtkGaussianBlurPass> blur;
      vtkNew<vtkSSAAPass> samples;
      blur->SetDelegatePass(steps);
      samples->SetDelegatePass(steps);
      return blurs ? static_cast<vtkRenderPass*>(blur) : samples;
    };
    vtkSmartPointer<vtkRenderPass> effect = makeEffect();
    stage.Renderer->SetPass(effect);
    stage.Render();
    const Picture plain = stage.GetPicture();
    light->SetIntensity(1e-6);
    stage.Render();
    const Picture out = stage.GetPicture();
    light->SetIntensity(1.0);
    effect->ReleaseGraphicsResources(stage.Window);
    ShadowTest::TakeMessages(); // VTK's own
    effect = makeEffect();      // VTK's do not come back after a release
    stage.Pass->SetDelegatePass(effect);
    stage.Renderer->SetPass(stage.Pass);
    stage.Render();
    CheckShadowed(stage.GetPicture(), plain, out, regions, 3000.0, 300.0, blurs ? "blur" : "SSAA");
    effect->ReleaseGraphicsResources(stage.Window);
  }
}

//------------------------------------------------------------------------------
// What cannot be undone is drawn as VTK draws it, and said once.
SHADOW_TEST(Cameras, ThatCannotBeUndone, Once)
{
  glm::dmat4 notAffine(1.0);
  notAffine[3][3] = 2.0;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Model& model : { Model{ "flat", glm::scale(glm::dmat4(1.0), { 1.0, 1.0, 0.0 }) },
         Model{ "not affine", notAffine },
         Model{ "not finite", glm::scale(glm::dmat4(1.0), { nan, 1.0, 1.0 }) } })
  {
    ShadowStage stage;
    stage.AddThings();
    stage.AddLight(LightKind::Point);
    stage.Renderer->GetActiveCamera()->SetModelTransformMatrix(Make(model.Matrix));
    stage.Render();
    const Picture plain = stage.GetPicture();
    ShadowTest::TakeMessages(); // VTK's own
    stage.SetPass("map-hard");
    stage.Render();
    stage.Render();
    ShadowTest::Check(
      Same(stage.GetPicture(), plain), std::string(model.Name) + ": not VTK's picture");
    ShadowTest::CheckOneMessage(ShadowTest::Message::Warning, { "view transform" }, model.Name);
  }
}
