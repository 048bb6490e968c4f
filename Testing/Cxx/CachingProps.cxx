// SPDX-License-Identifier: BSD-3-Clause
// As Caching.cxx, for what makes its geometry on the GPU, for blocks, clipping planes and levels, for
// translucent casters and for the window.

#include "ShadowStage.h"
#include "ShadowTest.h"

#include "vtkCellArray.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkConeSource.h"
#include "vtkCubeSource.h"
#include "vtkFloatArray.h"
#include "vtkFollower.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShadowVTKVersion.h"

namespace
{
/** Glyphs, balls, a clipped cube, blocks and a translucent box over a floor. */
class Props : public ShadowStage
{
public:
  explicit Props(const std::string& technique)
  {
    this->AddFloor();
    this->Light = this->AddLight(LightKind::Point);
    this->LookAt({ 3.5, -6.5, 5.5 }, { 0.2, 0.2, 0.3 });
    this->Parameters["translucent-casters"] = "weighted";

    vtkNew<vtkPoints> places;
    vtkNew<vtkCellArray> cells; // without, VTK does not draw the balls
    this->Sizes->SetName("size");
    for (int i = 0; i < 3; ++i)
    {
      const vtkIdType id = places->InsertNextPoint(-2.0 + 0.6 * i, -0.5, 0.6);
      cells->InsertNextCell(1, &id);
      this->Sizes->InsertNextValue(0.2f + 0.05f * static_cast<float>(i));
    }
    this->Points->SetPoints(places);
    this->Points->SetVerts(cells);
    this->Points->GetPointData()->AddArray(this->Sizes);
    this->Cone->SetHeight(0.5);
    this->Glyphs->SetInputData(this->Points);
    this->Glyphs->SetSourceConnection(this->Cone->GetOutputPort());
    this->Glyphs->SetScaleFactor(0.7);
    this->AddMapper(this->Glyphs);

    this->Balls->SetInputData(this->Points);
    this->Balls->SetScaleArray("size");
    this->AddMapper(this->Balls)->SetPosition(0.2, 1.5, 0.3);

    vtkNew<vtkCubeSource> cube;
    this->Plane->SetNormal(1.0, 0.0, 0.3);
    this->Plane->SetOrigin(1.2, -0.8, 0.6);
    this->Clipped->SetInputConnection(cube->GetOutputPort());
    this->Clipped->AddClippingPlane(this->Plane);
    this->AddMapper(this->Clipped)->SetPosition(1.2, -0.8, 0.6);

    for (int i = 0; i < 2; ++i)
    {
      vtkNew<vtkCubeSource> block;
      block->SetCenter(1.0 + 0.8 * i, 1.2, 0.5);
      block->SetXLength(0.4);
      block->Update();
      this->Blocks->SetBlock(i, block->GetOutput());
    }
    this->Composite->SetInputDataObject(this->Blocks);
    this->Composite->SetCompositeDataDisplayAttributes(this->Attributes);
    this->AddMapper(this->Composite);

    this->Glass = this->AddBox({ -0.5, 0.6, 1.6 }, { 0.8, 0.8, 0.2 });
    this->Glass->GetProperty()->SetOpacity(0.5);
    this->SetPass(technique, this->Parameters);
  }
  vtkActor* AddMapper(vtkMapper* mapper)
  {
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->Renderer->AddActor(actor);
    return actor;
  }

  ::Parameters Parameters;
  vtkAreaLight* Light;
  vtkNew<vtkPolyData> Points;
  vtkNew<vtkFloatArray> Sizes;
  vtkNew<vtkConeSource> Cone;
  vtkNew<vtkGlyph3DMapper> Glyphs;
  vtkNew<vtkOpenGLSphereMapper> Balls;
  vtkNew<vtkPolyDataMapper> Clipped;
  vtkNew<vtkPlane> Plane;
  vtkNew<vtkMultiBlockDataSet> Blocks;
  vtkNew<vtkShadowCompositeMapper> Composite;
  vtkNew<vtkCompositeDataDisplayAttributes> Attributes;
  vtkActor* Glass;
};

struct Edit
{
  const char* Name;
  bool Rebuilds; // the casters
  std::function<void(Props&)> Apply;
};

const std::vector<Edit>& GetEdits()
{
  static const std::vector<Edit> edits = {
    { "nothing", false, [](Props&) {} },
    { "camera moved", false,
      [](Props& props) {
        props.LookAt({ 3.0, -6.0, 6.5 }, { 0.0, 0.2, 0.3 });
      } },
    { "window resized", false, [](Props& props) { props.Window->SetSize(120, 140); } },
    { "glyphs' colour", false,
      [](Props& props)
      {
        vtkNew<vtkFloatArray> colors;
        colors->SetName("colors");
        for (int i = 0; i < 3; ++i)
        {
          colors->InsertNextValue(static_cast<float>(i));
        }
        props.Points->GetPointData()->AddArray(colors);
      } },
    { "a glyph moved", true,
      [](Props& props)
      {
        props.Points->GetPoints()->SetPoint(1, -1.2, -1.2, 0.9);
        props.Points->GetPoints()->Modified();
        props.Points->Modified();
      } },
    { "a glyph resized", true,
      [](Props& props)
      {
        props.Sizes->SetValue(1, 0.45f);
        props.Sizes->Modified();
        props.Points->Modified();
      } },
    { "glyphs' source", true, [](Props& props) { props.Cone->SetHeight(1.0); } },
    { "glyphs' scale", true, [](Props& props) { props.Glyphs->SetScaleFactor(1.5); } },
    { "clipping plane moved", true, [](Props& props) { props.Plane->SetOrigin(1.5, -0.8, 0.6); } },
    { "clipping plane removed", true,
      [](Props& props) { props.Clipped->RemoveAllClippingPlanes(); } },
    { "block hidden", true,
      [](Props& props)
      { props.Attributes->SetBlockVisibility(props.Blocks->GetBlock(1), false); } },
    { "opacity of what casts by it", true,
      [](Props& props) { props.Glass->GetProperty()->SetOpacity(0.8); } },
    { "made a catcher", true,
      [](Props& props) { vtkShadowPass::SetShadowCatcher(props.Glass, true); } },
    { "translucent-casters", true,
      [](Props& props) { props.Pass->SetParameter("translucent-casters", "opaque"); } },
  };
  return edits;
}
}

//------------------------------------------------------------------------------
// After an edit V is that of a new stage with the same edit, and casters were gathered anew just where
// they had to be.
SHADOW_TEST(Caching, PropsAreNotStale, Each)
{
  for (const Edit& edit : GetEdits())
  {
    Props fresh(technique);
    edit.Apply(fresh);
    fresh.Render();
    const Visibility expected = fresh.GetVisibility();

    Props stage(technique);
    stage.Render();
    const Visibility before = stage.GetVisibility();
    edit.Apply(stage);
    stage.Render();
    const std::string what = edit.Name;
    ShadowTest::CheckEqual(
      stage.Count("castersRebuilt"), edit.Rebuilds ? 1.0 : 0.0, what + ", castersRebuilt");
    for (const char* name : { "mapsDrawn", "meshesBuilt", "silhouettesFound" })
    {
      if (!edit.Rebuilds && stage.Count(name) >= 0.0)
      {
        ShadowTest::CheckEqual(stage.Count(name), 0.0, what + ", " + name);
      }
    }
    const Visibility after = stage.GetVisibility();
    ShadowTest::Check(Same(after, expected),
      what + ": V is stale, by at most " + std::to_string(Compare(after, expected).Maximum));
    if (edit.Rebuilds)
    {
      ShadowTest::Check(!Same(after, before), what + ": no change in V");
    }
    ShadowTest::CheckNoMessage(what);
  }
}

//------------------------------------------------------------------------------
// A follower turns with the camera, and its shadow with it.
SHADOW_TEST(Caching, FollowerFollows, Each)
{
  const auto build = [&technique](ShadowStage& stage)
  {
    stage.AddFloor();
    stage.AddLight(LightKind::Point);
    stage.LookAt({ 3.5, -6.5, 4.5 }, { 0.2, 0.2, 0.3 });
    vtkNew<vtkCubeSource> cube;
    cube->SetXLength(1.6);
    cube->SetZLength(0.1);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(cube->GetOutputPort());
    vtkNew<vtkFollower> follower;
    follower->SetMapper(mapper);
    follower->SetPosition(0.0, 0.0, 1.0);
    follower->SetCamera(stage.Renderer->GetActiveCamera());
    stage.Renderer->AddActor(follower);
    stage.SetPass(technique);
  };
  const auto turn = [](ShadowStage& stage) {
    stage.LookAt({ -4.5, -5.0, 4.5 }, { 0.2, 0.2, 0.3 });
  };
  ShadowStage stage;
  build(stage);
  stage.Render();
  turn(stage);
  stage.Render();
  ShadowTest::CheckEqual(stage.Count("castersRebuilt"), 1.0, "castersRebuilt");
  ShadowStage fresh;
  build(fresh);
  turn(fresh);
  fresh.Render();
  const Visibility visibility = stage.GetVisibility();
  ShadowTest::Check(Same(visibility, fresh.GetVisibility()), "V is stale");
  ShadowTest::CheckEqual(GetRange(visibility).first, 0.0, "there is a shadow");
}
