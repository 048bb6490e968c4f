// SPDX-License-Identifier: BSD-3-Clause
// What is unchanged is kept (the statistics count it), and what changed is never stale.

#include "ShadowStage.h"
#include "ShadowTest.h"

#include "vtkAssembly.h"
#include "vtkCubeSource.h"
#include "vtkFloatArray.h"
#include "vtkMapper.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <map>

namespace
{
LightKind GetKind(const std::string& technique)
{
  return ShadowStage::Supports(technique, LightKind::Rectangle) ? LightKind::Rectangle
                                                                : LightKind::Point;
}

/** A stage with a box whose source is at hand, and a pair of posts within an assembly. */
class CachingStage : public ShadowStage
{
public:
  explicit CachingStage(const std::string& technique)
  {
    this->Things = this->AddThings();
    this->Light = this->AddLight(GetKind(technique));
    this->Cube->SetCenter(1.8, 1.0, 0.5);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(this->Cube->GetOutputPort());
    this->Sourced->SetMapper(mapper);
    this->Renderer->AddActor(this->Sourced);
    for (int i = 0; i < 2; ++i)
    {
      vtkNew<vtkCubeSource> post;
      post->SetCenter(-2.0 + 0.5 * i, -1.0, 0.6);
      post->SetXLength(0.15);
      post->SetYLength(0.15);
      post->SetZLength(1.2);
      vtkNew<vtkPolyDataMapper> postMapper;
      postMapper->SetInputConnection(post->GetOutputPort());
      this->Posts[i]->SetMapper(postMapper);
      this->Assembly->AddPart(this->Posts[i]);
    }
    this->Renderer->AddActor(this->Assembly);
  }
  vtkPolyData* GetMesh()
  {
    return vtkPolyData::SafeDownCast(this->Things->GetMapper()->GetInputDataObject(0, 0));
  }

  vtkActor* Things;
  vtkAreaLight* Light;
  vtkNew<vtkCubeSource> Cube;
  vtkNew<vtkActor> Sourced;
  vtkNew<vtkAssembly> Assembly;
  vtkNew<vtkActor> Posts[2];
};

/** What an edit may make a technique do anew. */
enum Rebuilt
{
  Nothing,
  LightData, // that of a light, not the casters
  Casters    // and all light data that shows them
};

struct Edit
{
  const char* Name;
  Rebuilt Expected;
  std::function<void(CachingStage&)> Apply;
};

const std::vector<Edit>& GetEdits()
{
  static const std::vector<Edit> edits = {
    { "nothing", Nothing, [](CachingStage&) {} },
    { "camera moved", Nothing,
      [](CachingStage& stage) {
        stage.LookAt({ 4.0, -5.0, 6.0 }, { 0.0, 0.2, 0.3 });
      } },
    { "camera near a part", Nothing,
      [](CachingStage& stage) {
        stage.LookAt({ 1.0, -2.5, 1.5 }, { -0.8, 0.3, 0.3 });
      } },
    { "an actor's colour", Nothing,
      [](CachingStage& stage) { stage.Things->GetProperty()->SetColor(0.1, 0.9, 0.2); } },
    { "an actor's shininess", Nothing,
      [](CachingStage& stage) { stage.Things->GetProperty()->SetSpecular(0.4); } },
    { "point scalars", Nothing,
      [](CachingStage& stage)
      {
        vtkPolyData* mesh = stage.GetMesh();
        vtkNew<vtkFloatArray> scalars;
        for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
        {
          scalars->InsertNextValue(static_cast<float>(i));
        }
        mesh->GetPointData()->SetScalars(scalars);
        stage.Things->GetMapper()->ScalarVisibilityOn();
      } },
    { "the light's colour", Nothing,
      [](CachingStage& stage) { stage.Light->SetDiffuseColor(0.9, 0.8, 0.7); } },
    { "the light's strength", Nothing,
      [](CachingStage& stage) { stage.Light->SetIntensity(0.5); } },
    { "the shadow's strength", Nothing,
      [](CachingStage& stage) { stage.Light->SetShadowAttenuation(0.5); } },
    { "light moved", LightData,
      [](CachingStage& stage) { stage.Light->SetPosition(2.0, -3.0, 5.0); } },
    { "light moved a hair", LightData,
      [](CachingStage& stage) { stage.Light->SetPosition(-2.5, -2.01, 5.5); } },
    { "actor moved", Casters,
      [](CachingStage& stage) { stage.Things->SetPosition(0.3, -0.6, 0.1); } },
    { "actor turned", Casters, [](CachingStage& stage) { stage.Things->RotateZ(30.0); } },
    { "actor scaled", Casters, [](CachingStage& stage) { stage.Things->SetScale(0.5); } },
    { "actor hidden", Casters, [](CachingStage& stage) { stage.Things->VisibilityOff(); } },
    { "actor removed", Casters,
      [](CachingStage& stage) { stage.Renderer->RemoveActor(stage.Things); } },
    { "actor added", Casters,
      [](CachingStage& stage) {
        stage.AddBox({ -1.0, -2.0, 0.5 }, { 0.5, 0.5, 1.0 });
      } },
    { "actor's casting off", Casters,
      [](CachingStage& stage) { vtkShadowPass::SetCasting(stage.Things, false); } },
    { "actor made translucent", Casters,
      [](CachingStage& stage) { stage.Things->GetProperty()->SetOpacity(0.5); } },
    { "actor made a wireframe", Casters,
      [](CachingStage& stage) { stage.Things->GetProperty()->SetRepresentationToWireframe(); } },
    { "mesh edited at its source", Casters,
      [](CachingStage& stage) { stage.Cube->SetZLength(2.0); } },
    { "mesh's points edited in place", Casters,
      [](CachingStage& stage)
      {
        vtkPoints* points = stage.GetMesh()->GetPoints();
        for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
        {
          double p[3];
          points->GetPoint(i, p);
          points->SetPoint(i, p[0], p[1], 0.5 * p[2]);
        }
        points->Modified();
      } },
    { "mesh exchanged", Casters,
      [](CachingStage& stage)
      { stage.Things->GetMapper()->SetInputConnection(stage.Cube->GetOutputPort()); } },
    { "assembly moved", Casters,
      [](CachingStage& stage) { stage.Assembly->SetPosition(0.4, -0.3, 0.0); } },
    { "part of an assembly moved", Casters,
      [](CachingStage& stage) { stage.Posts[1]->SetPosition(0.4, -0.3, 0.3); } },
    { "part of an assembly hidden", Casters,
      [](CachingStage& stage) { stage.Posts[1]->VisibilityOff(); } },
  };
  return edits;
}
}

//------------------------------------------------------------------------------
// After an edit V is that of a new pass on a new scene with the same edit: nothing is stale.
SHADOW_TEST(Caching, NothingIsStale, Each)
{
  for (const Edit& edit : GetEdits())
  {
    CachingStage fresh(technique);
    edit.Apply(fresh);
    fresh.SetPass(technique);
    fresh.Render();
    const Visibility expected = fresh.GetVisibility();

    CachingStage stage(technique);
    stage.SetPass(technique);
    stage.Render();
    const Visibility before = stage.GetVisibility();
    edit.Apply(stage);
    stage.Render();
    const Visibility after = stage.GetVisibility();
    ShadowTest::Check(Same(after, expected), std::string(edit.Name) + ": V is stale, by at most " +
                                               std::to_string(Compare(after, expected).Maximum));
    if (edit.Expected != Nothing)
    {
      ShadowTest::Check(!Same(after, before), std::string(edit.Name) + ": no change in V");
    }
  }
}

//------------------------------------------------------------------------------
SHADOW_TEST(Caching, OnlyTheChangedIsRebuilt, Each)
{
  for (const Edit& edit : GetEdits())
  {
    CachingStage stage(technique);
    stage.SetPass(technique);
    stage.Render();
    ShadowTest::CheckEqual(stage.Count("castersRebuilt"), 1.0, "first frame, castersRebuilt");
    edit.Apply(stage);
    stage.Render();
    const std::string what = edit.Name;
    // What a technique declares of the camera is what it does.
    const bool byCamera =
      ShadowStage::Describe(technique).Traits.CameraDependent && what.compare(0, 6, "camera") == 0;
    const Rebuilt expected = byCamera ? LightData : edit.Expected;
    ShadowTest::CheckEqual(stage.Count("castersRebuilt"), edit.Expected == Casters ? 1.0 : 0.0,
      what + ", castersRebuilt");
    // Of the techniques that have them.
    for (const char* name : { "mapsDrawn", "planarMapsDrawn", "silhouettesFound" })
    {
      const double count = stage.Count(name);
      if (count >= 0.0 && expected == Nothing)
      {
        ShadowTest::CheckEqual(count, 0.0, what + ", " + name);
      }
      else if (count >= 0.0)
      {
        ShadowTest::CheckAtLeast(count, 1.0, what + ", " + name);
      }
    }
    if (stage.Count("meshesBuilt") >= 0.0 && edit.Expected != Casters)
    {
      ShadowTest::CheckEqual(stage.Count("meshesBuilt"), 0.0, what + ", meshesBuilt");
    }
    stage.Render();
    ShadowTest::CheckEqual(
      stage.Count("castersRebuilt"), 0.0, what + ", castersRebuilt in the frame after");
  }
}

//------------------------------------------------------------------------------
// A parameter that was set again counts as one that was set from the start.
SHADOW_TEST(Caching, ParametersAreNotStale, Each)
{
  for (const auto& parameter : ShadowStage::Describe(technique).Parameters)
  {
    std::string value;
    switch (parameter.ValueType)
    {
      case vtkShadowParameter::Type::Integer:
        value = parameter.Name == "resolution" ? "100" : (parameter.Name == "samples" ? "7" : "2");
        break;
      case vtkShadowParameter::Type::Real:
        value = std::to_string(0.5 * (parameter.Minimum + parameter.Maximum));
        break;
      case vtkShadowParameter::Type::Boolean:
        value = parameter.Default == "on" ? "off" : "on";
        break;
      default:
        value = parameter.Choices.front() == parameter.Default ? parameter.Choices.back()
                                                               : parameter.Choices.front();
    }
    Parameters others;
    if (parameter.Name == "samples" && ShadowStage::HasParameter(technique, "overlap"))
    {
      others["overlap"] = "count"; // or there are none
    }
    Parameters all = others;
    all[parameter.Name] = value;
    CachingStage fresh(technique);
    fresh.SetPass(technique, all);
    fresh.Render();

    CachingStage stage(technique);
    stage.SetPass(technique, others);
    stage.Render();
    const Visibility before = stage.GetVisibility();
    ShadowTest::Check(
      stage.Pass->SetParameter(parameter.Name, value), "cannot set " + parameter.Name);
    stage.Render();
    const Visibility after = stage.GetVisibility();
    ShadowTest::Check(
      Same(after, fresh.GetVisibility()), parameter.Name + " = " + value + ": V is stale");
    if (parameter.Name == "resolution" || parameter.Name == "samples")
    {
      ShadowTest::Check(!Same(after, before), parameter.Name + " = " + value + ": no change in V");
    }
  }
}
