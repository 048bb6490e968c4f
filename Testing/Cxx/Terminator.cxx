// SPDX-License-Identifier: BSD-3-Clause
// `terminator`: on a prop that its normals shade, facets hide nothing of what those normals light; the
// shadows of other things stay where they are; and what is flat stays as it is, bit by bit.

#include "ShadowStage.h"
#include "ShadowTest.h"

#include "vtkCamera.h"
#include "vtkCylinderSource.h"
#include "vtkGlyph3DMapper.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"
#include "vtkTransform.h"

#include <algorithm>

namespace
{
constexpr int Coarse = 8; // as VTK's sphere is by default

vtkSmartPointer<vtkPolyData> MakeBall(int resolution)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  sphere->SetThetaResolution(resolution);
  sphere->SetPhiResolution(resolution);
  sphere->Update();
  return sphere->GetOutput();
}

vtkSmartPointer<vtkPolyData> MakeColumn()
{
  vtkNew<vtkCylinderSource> cylinder;
  cylinder->SetResolution(Coarse);
  cylinder->SetHeight(2.0);
  cylinder->SetRadius(0.7);
  cylinder->CappingOff();
  cylinder->Update();
  return cylinder->GetOutput();
}

/** A body that bulges everywhere, and how it is drawn. */
struct Body
{
  const char* Name;
  std::function<void(ShadowStage&)> Add;
};

const std::vector<Body>& GetBodies()
{
  static const std::vector<Body> bodies = {
    { "ball", [](ShadowStage& stage) { stage.Add(MakeBall(Coarse)); } },
    { "column", [](ShadowStage& stage) { stage.Add(MakeColumn())->RotateX(90.0); } },
    { "ball with edges",
      [](ShadowStage& stage)
      {
        // By a geometry shader.
        vtkProperty* property = stage.Add(MakeBall(Coarse))->GetProperty();
        property->EdgeVisibilityOn();
        property->SetEdgeColor(0.8, 0.8, 0.8);
      } },
    { "stretched ball",
      [](ShadowStage& stage) { stage.Add(MakeBall(Coarse))->SetScale(1.2, 0.5, 0.9); } },
    { "ball under a camera that scales",
      [](ShadowStage& stage)
      {
        stage.Add(MakeBall(Coarse));
        vtkNew<vtkTransform> stretch;
        stretch->Scale(1.0, 1.4, 0.8);
        stage.Renderer->GetActiveCamera()->SetModelTransformMatrix(stretch->GetMatrix());
      } },
    { "glyph",
      [](ShadowStage& stage)
      {
        vtkNew<vtkPoints> points;
        points->InsertNextPoint(0.0, 0.0, 0.0);
        vtkNew<vtkPolyData> place;
        place->SetPoints(points);
        vtkNew<vtkGlyph3DMapper> mapper;
        mapper->SetInputData(place);
        mapper->SetSourceData(MakeBall(Coarse));
        vtkNew<vtkActor> actor;
        actor->SetMapper(mapper);
        stage.Renderer->AddActor(actor);
      } },
    { "ball in parallel projection",
      [](ShadowStage& stage)
      {
        stage.Add(MakeBall(Coarse));
        stage.Renderer->GetActiveCamera()->ParallelProjectionOn();
        stage.Renderer->GetActiveCamera()->SetParallelScale(1.3);
      } },
  };
  return bodies;
}

const Parameters Fine = { { "terminator", "smooth" }, { "resolution", "512" } };

bool HasCurvedReceivers(const std::string& technique)
{
  return !ShadowStage::Describe(technique).Traits.PlanarReceivers;
}
}

//------------------------------------------------------------------------------
// Under lights from the side and from behind, small ones: what VTK lights stays lit. Of an 8 x 8 ball
// facets take a tenth and more.
SHADOW_TEST(Terminator, HidesNothingOfWhatBulges, Each)
{
  if (!HasCurvedReceivers(technique))
  {
    return;
  }
  for (const Body& body : GetBodies())
  {
    for (const glm::dvec3& direction :
      { glm::dvec3(8.0, -2.0, 1.6), glm::dvec3(-6.0, 2.0, 5.0), glm::dvec3(2.0, -3.0, 7.0) })
    {
      ShadowStage stage(240, 240);
      stage.Renderer->SetBackground(0.0, 0.0, 0.0);
      stage.LookAt({ 0.0, -6.0, 0.0 }, glm::dvec3(0.0), 28.0);
      body.Add(stage);
      ShadowStage::Shrink(stage.AddLight(LightKind::Sphere, direction, glm::dvec3(0.0)), 0.01);
      stage.Render();
      const Picture plain = stage.GetPicture();
      const auto lose = [&](const char* terminator)
      {
        Parameters parameters = Fine;
        parameters["terminator"] = terminator;
        stage.SetPass(technique, parameters);
        stage.Render();
        const Picture shaded = stage.GetPicture();
        std::size_t lit = 0;
        std::size_t lost = 0;
        for (std::size_t i = 0; i < plain.RGB.size() / 3; ++i)
        {
          const bool is = plain.RGB[3 * i] > 20;
          lit += is ? 1 : 0;
          lost += is && plain.Difference(shaded, i) > 12 ? 1 : 0;
        }
        return static_cast<double>(lost) / static_cast<double>(lit);
      };
      ShadowTest::CheckAtMost(lose("smooth"), 0.002, std::string(body.Name) + ", smooth");
      if (direction.x == 8.0)
      {
        ShadowTest::CheckAtLeast(lose("facets"), 0.01, std::string(body.Name) + ", facets");
      }
    }
  }
}

//------------------------------------------------------------------------------
// What was flat when its shader was made, and is bent in place, is smooth from then on.
SHADOW_TEST(Terminator, FollowsItsData, Each)
{
  if (!HasCurvedReceivers(technique))
  {
    return;
  }
  const auto draw = [&](bool later)
  {
    ShadowStage stage(240, 240);
    const vtkSmartPointer<vtkPolyData> ball = MakeBall(Coarse);
    vtkNew<vtkPolyDataMapper> mapper;
    vtkNew<vtkPoints> flat;
    flat->DeepCopy(ball->GetPoints());
    for (vtkIdType i = 0; i < flat->GetNumberOfPoints(); ++i)
    {
      glm::dvec3 p;
      flat->GetPoint(i, &p.x);
      flat->SetPoint(i, p.x, 0.0, p.z);
    }
    vtkNew<vtkPolyData> shown;
    shown->ShallowCopy(ball);
    mapper->SetInputData(shown);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    stage.Renderer->AddActor(actor);
    stage.LookAt({ 0.0, -6.0, 0.0 }, glm::dvec3(0.0), 28.0);
    stage.AddLight(LightKind::Directional, { 8.0, -2.0, 1.6 }, glm::dvec3(0.0));
    stage.SetPass(technique, Fine);
    if (later)
    {
      shown->SetPoints(flat);
      stage.Render();
      ball->GetPoints()->Modified(); // or VTK keeps the bounds
      shown->SetPoints(ball->GetPoints());
    }
    stage.Render();
    return stage.GetVisibility();
  };
  const Difference difference = Compare(draw(true), draw(false), 0.0);
  ShadowTest::CheckAtMost(
    difference.Share, 0.002, "pixels unlike those of what was bent from the first");
}

//------------------------------------------------------------------------------
// Points and lines have normals, but no facets: they receive what falls onto them.
SHADOW_TEST(Terminator, PointsAndLinesReceive, Each)
{
  if (!HasCurvedReceivers(technique))
  {
    return;
  }
  for (const char* evaluation : { "forward", "screen" })
  {
    for (const bool lines : { false, true })
    {
      ShadowStage stage;
      stage.Renderer->SetBackground(0.0, 0.0, 0.0);
      vtkActor* ball = stage.Add(MakeBall(32));
      ball->SetPosition(0.0, 0.0, -1.0);
      if (lines)
      {
        ball->GetProperty()->SetRepresentationToWireframe();
      }
      else
      {
        ball->GetProperty()->SetRepresentationToPoints();
        ball->GetProperty()->SetPointSize(3.0);
      }
      vtkShadowPass::SetCasting(ball, false);
      stage.AddQuad({ -2.0, -2.0, 1.0 }, { 2.0, 0.0, 0.0 }, { 0.0, 4.0, 0.0 });
      ShadowStage::Shrink(
        stage.AddLight(LightKind::Directional, { 0.0, 0.0, 4.0 }, glm::dvec3(0.0)), 0.0);
      stage.LookAt({ 4.0, -0.5, 2.5 }, { 0.0, 0.0, -0.5 }, 30.0);
      stage.Render();
      const Picture plain = stage.GetPicture();
      Parameters parameters = Fine;
      parameters["evaluation"] = evaluation;
      stage.SetPass(technique, parameters);
      stage.Render();
      ShadowTest::TakeMessages(); // an evaluation may not be had
      const Picture shaded = stage.GetPicture();
      std::size_t dark = 0;
      std::size_t same = 0;
      for (std::size_t i = 0; i < plain.RGB.size() / 3; ++i)
      {
        const bool lit = plain.RGB[3 * i] > 60;
        dark += lit && 2 * shaded.RGB[3 * i] < plain.RGB[3 * i] ? 1 : 0;
        same += lit && plain.Difference(shaded, i) <= 2 ? 1 : 0;
      }
      const std::string what = std::string(evaluation) + (lines ? ", lines: " : ", points: ");
      ShadowTest::CheckAtLeast(static_cast<double>(dark), 100.0, what + "pixels in the shadow");
      ShadowTest::CheckAtLeast(static_cast<double>(same), 100.0, what + "pixels in the light");
    }
  }
}

//------------------------------------------------------------------------------
// Both evaluations see the same surface.
SHADOW_TEST(Terminator, IsTheSameInBothEvaluations, Each)
{
  if (!HasCurvedReceivers(technique))
  {
    return;
  }
  const auto draw = [&](const char* evaluation)
  {
    ShadowStage stage;
    stage.AddThings();
    stage.Add(MakeBall(Coarse));
    stage.AddLight(LightKind::Rectangle);
    Parameters parameters = Fine;
    parameters["evaluation"] = evaluation;
    stage.SetPass(technique, parameters);
    stage.Render();
    ShadowTest::TakeMessages(); // one of them may not be had
    return stage.GetPicture();
  };
  const Picture forward = draw("forward");
  const Picture screen = draw("screen");
  std::size_t off = 0;
  for (std::size_t i = 0; i < forward.RGB.size() / 3; ++i)
  {
    off += forward.Difference(screen, i) > 8 ? 1 : 0;
  }
  ShadowTest::CheckAtMost(static_cast<double>(off), 0.005 * forward.RGB.size() / 3, "pixels off");
}

//------------------------------------------------------------------------------
// A board's shadow on a coarse ball lies nearer to where rays find it on a fine one than the facets' own.
SHADOW_TEST(Terminator, ShadowsOfOthersStay, Each)
{
  if (!HasCurvedReceivers(technique))
  {
    return;
  }
  std::vector<unsigned char> lit(200 * 200, 1); // by all that are drawn
  const auto draw = [&](const std::string& name, int resolution, const char* terminator)
  {
    ShadowStage stage(200, 200);
    stage.Renderer->SetBackground(0.0, 0.0, 0.0);
    stage.Add(MakeBall(resolution));
    stage.AddQuad({ -2.0, -2.0, 1.8 }, { 2.0, 0.0, 0.0 }, { 0.0, 4.0, 0.0 });
    stage.LookAt({ 3.0, -5.0, 2.0 }, glm::dvec3(0.0), 26.0);
    ShadowStage::Shrink(
      stage.AddLight(LightKind::Directional, { 1.0, -0.5, 4.0 }, glm::dvec3(0.0)), 0.0);
    stage.Render();
    const Picture plain = stage.GetPicture();
    for (std::size_t i = 0; i < lit.size(); ++i)
    {
      lit[i] = lit[i] && plain.RGB[3 * i] > 40 ? 1 : 0;
    }
    Parameters parameters = Fine;
    parameters["terminator"] = terminator;
    stage.SetPass(name, parameters);
    stage.Render();
    return stage.GetVisibility();
  };
  const Visibility truth = draw("ray-traced", 64, "facets");
  const Visibility rounded = draw(technique, Coarse, "smooth");
  const Visibility faceted = draw(technique, Coarse, "facets");
  const double smooth = Compare(rounded, truth, 0.1, lit).RMSE;
  const double facets = Compare(faceted, truth, 0.1, lit).RMSE;
  ShadowTest::CheckAtMost(smooth, 0.9 * facets, "RMSE to the fine ball");
}

//------------------------------------------------------------------------------
SHADOW_TEST(Terminator, LeavesWhatIsFlat, Each)
{
  const auto draw = [&](const char* terminator)
  {
    ShadowStage stage;
    stage.AddThings();
    stage.Add(MakeBall(Coarse))->SetPosition(-0.5, -1.0, 0.4);
    vtkPropCollection* props = stage.Renderer->GetViewProps();
    for (int i = 0; i < props->GetNumberOfItems(); ++i)
    {
      vtkActor::SafeDownCast(props->GetItemAsObject(i))->GetProperty()->SetInterpolationToFlat();
    }
    stage.AddLight(LightKind::Rectangle);
    Parameters parameters = Fine;
    parameters["terminator"] = terminator;
    stage.SetPass(technique, parameters);
    stage.Render();
    return stage.GetVisibility();
  };
  const Visibility smooth = draw("smooth");
  const Visibility facets = draw("facets");
  ShadowTest::Check(smooth.V == facets.V && smooth.Mask == facets.Mask, "the same bit by bit");
}
