// SPDX-License-Identifier: BSD-3-Clause
// The pass in VTK's windows: several viewports and layers, sizes that change, two eyes, pickers.

#include "ShadowOracle.h"
#include "ShadowTest.h"

#include "vtkAreaPicker.h"
#include "vtkCamera.h"
#include "vtkCellPicker.h"
#include "vtkProp3DCollection.h"
#include "vtkPropPicker.h"
#include "vtkProperty.h"
#include "vtkRenderedAreaPicker.h"
#include "vtkStereoCompositor.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWorldPointPicker.h"

#include <cmath>
#include <sstream>

namespace
{
vtkAreaLight* Build(ShadowStage& stage)
{
  stage.AddThings();
  return stage.AddLight(LightKind::Point);
}

/** The picture with the light all but out. */
Picture DrawOut(ShadowStage& stage, vtkLight* light)
{
  light->SetIntensity(1e-6);
  stage.Render();
  light->SetIntensity(1.0);
  return stage.GetPicture();
}

/** A pass beside the stage's own one, set on this renderer. */
vtkSmartPointer<vtkShadowPass> SetPassOf(
  ShadowStage& stage, vtkRenderer* renderer, const std::string& technique)
{
  const vtkSmartPointer<vtkShadowPass> own = stage.Pass;
  const vtkSmartPointer<vtkRenderPass> set = stage.Renderer->GetPass();
  vtkSmartPointer<vtkShadowPass> pass = stage.SetPass(technique);
  stage.Pass = own;
  stage.Renderer->SetPass(set);
  renderer->SetPass(pass);
  return pass;
}

Visibility GetVisibilityOf(ShadowStage& stage, vtkShadowPass* pass)
{
  const vtkSmartPointer<vtkShadowPass> own = stage.Pass;
  stage.Pass = pass;
  Visibility visibility = stage.GetVisibility();
  stage.Pass = own;
  return visibility;
}
}

//------------------------------------------------------------------------------
// Three viewports of odd sizes show the same props and light from elsewhere, two with a pass each:
// each of them is as it is drawn, and the third is as without passes.
SHADOW_TEST(Windows, Viewports, Each)
{
  ShadowStage stage(203, 117);
  vtkAreaLight* light = Build(stage);
  const double borders[3][4] = { { 0.0, 0.0, 0.37, 1.0 }, { 0.37, 0.0, 1.0, 0.61 },
    { 0.37, 0.61, 1.0, 1.0 } };
  const double eyes[3][3] = { { 3.5, -6.5, 4.5 }, { -4.0, -6.0, 5.0 }, { 0.5, -7.0, 3.5 } };
  vtkNew<vtkRenderer> others[2];
  vtkRenderer* const renderers[] = { stage.Renderer, others[0], others[1] };
  vtkPropCollection* props = stage.Renderer->GetViewProps();
  for (int i = 0; i < 3; ++i)
  {
    if (i > 0)
    {
      stage.Window->AddRenderer(renderers[i]);
      renderers[i]->SetBackground(0.5, 0.1, 0.1 * i);
      renderers[i]->AutomaticLightCreationOff();
      renderers[i]->AddLight(light);
      for (int p = 0; p < props->GetNumberOfItems(); ++p)
      {
        renderers[i]->AddViewProp(vtkProp::SafeDownCast(props->GetItemAsObject(p)));
      }
    }
    renderers[i]->SetViewport(borders[i][0], borders[i][1], borders[i][2], borders[i][3]);
    vtkCamera* camera = renderers[i]->GetActiveCamera();
    camera->SetPosition(eyes[i][0], eyes[i][1], eyes[i][2]);
    camera->SetFocalPoint(0.2, 0.2, 0.3);
    camera->SetViewUp(0.0, 0.0, 1.0);
    camera->SetViewAngle(35.0);
    camera->SetClippingRange(0.4, 40.0);
  }
  // Alone: VTK 9.1 takes one renderer's lights for those of all that draw by the same shaders.
  const auto drawAlone = [&](int i)
  {
    for (vtkRenderer* renderer : renderers)
    {
      renderer->SetDraw(renderer == renderers[i]);
    }
    light->Modified();
    stage.Render();
    return stage.GetPicture();
  };
  Picture plain[3];
  Picture out[3];
  for (int i = 0; i < 3; ++i)
  {
    plain[i] = drawAlone(i);
    light->SetIntensity(1e-6);
    out[i] = drawAlone(i);
    light->SetIntensity(1.0);
  }
  for (vtkRenderer* renderer : renderers)
  {
    renderer->DrawOn();
  }
  stage.SetPass(technique);
  const auto second = SetPassOf(stage, others[0], technique);
  for (int frame = 0; frame < 2; ++frame)
  {
    stage.Render();
    const Picture picture = stage.GetPicture();
    for (int i = 0; i < 3; ++i)
    {
      const std::string what = "viewport " + std::to_string(i) + ", frame " + std::to_string(frame);
      int size[2];
      int origin[2];
      renderers[i]->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
      const auto crop = [&](const Picture& of)
      { return Crop(of, origin[0], origin[1], size[0], size[1]); };
      if (i == 2)
      {
        ShadowTest::Check(Same(crop(picture), crop(plain[i])), what + ": not VTK's own");
        continue;
      }
      const Visibility visibility = i == 0 ? stage.GetVisibility() : GetVisibilityOf(stage, second);
      ShadowTest::CheckEqual(visibility.Width, size[0], what + ", width");
      ShadowTest::CheckEqual(visibility.Height, size[1], what + ", height");
      CheckShadowed(
        crop(picture), crop(plain[i]), crop(out[i]), GetRegions(visibility), 3000.0, 150.0, what);
    }
    ShadowTest::CheckNoMessage("frame " + std::to_string(frame));
  }
  others[0]->SetPass(nullptr);
}

//------------------------------------------------------------------------------
// A window that changes its size between frames shows what a new one of that size shows.
SHADOW_TEST(Windows, Resized, Each)
{
  ShadowStage stage(160, 160);
  Build(stage);
  stage.SetPass(technique);
  stage.Render();
  const int sizes[][2] = { { 210, 120 }, { 97, 141 }, { 160, 160 } };
  for (const auto& size : sizes)
  {
    stage.Window->SetSize(size[0], size[1]);
    stage.Render();
    ShadowStage fresh(size[0], size[1]);
    Build(fresh);
    fresh.SetPass(technique);
    fresh.Render();
    const std::string what = std::to_string(size[0]) + " x " + std::to_string(size[1]);
    ShadowTest::Check(Same(stage.GetPicture(), fresh.GetPicture()), what + ": picture");
    ShadowTest::Check(Same(stage.GetVisibility(), fresh.GetVisibility()), what + ": V");
    ShadowTest::CheckNoMessage(what);
  }
}

//------------------------------------------------------------------------------
// An upper layer, transparent where it draws nothing, with and without a pass of its own: it lies
// over the lower one's picture, and its things cast on it alone.
SHADOW_TEST(Windows, Layers, Each)
{
  ShadowStage stage;
  vtkAreaLight* light = Build(stage);
  stage.Render();
  const Picture plainLower = stage.GetPicture();
  stage.SetPass(technique);
  stage.Render();
  const Picture lower = stage.GetPicture();
  stage.Renderer->SetPass(nullptr);

  const vtkSmartPointer<vtkActor> added[] = { stage.AddBox({ 0.6, -2.3, 0.9 }, { 0.5, 0.5, 0.2 }),
    stage.AddQuad({ -0.4, -3.3, 0.2 }, { 2.4, 0.0, 0.0 }, { 0.0, 1.9, 0.0 }) };
  vtkNew<vtkRenderer> upper;
  upper->AutomaticLightCreationOff();
  upper->AddLight(light);
  upper->SetActiveCamera(stage.Renderer->GetActiveCamera());
  for (vtkActor* actor : added)
  {
    stage.Renderer->RemoveActor(actor);
    upper->AddActor(actor);
    actor->GetProperty()->SetColor(1.0, 0.1, 1.0); // like nothing below
  }
  stage.Window->SetNumberOfLayers(2);
  upper->SetLayer(1);
  stage.Window->AddRenderer(upper);
  stage.Render();
  const Picture plain = stage.GetPicture();
  const Picture out = DrawOut(stage, light);
  ShadowTest::CheckNoMessage("without passes");

  for (const bool both : { false, true })
  {
    const std::string what = both ? "a pass for each" : "a pass for the lower";
    stage.SetPass(technique);
    stage.Render();
    vtkSmartPointer<vtkShadowPass> pass;
    if (both)
    {
      pass = SetPassOf(stage, upper, technique);
      stage.Render();
    }
    const Picture picture = stage.GetPicture();
    ShadowTest::CheckNoMessage(what);
    std::size_t covered = 0;
    std::size_t wrong = 0;
    std::vector<unsigned char> above;
    for (std::size_t i = 0; i < picture.RGB.size() / 3; ++i)
    {
      above.push_back(plain.Difference(plainLower, i) > 0);
      covered += above[i];
      wrong +=
        above[i] ? !both && picture.Difference(plain, i) > 0 : picture.Difference(lower, i) > 0;
    }
    ShadowTest::CheckAtLeast(static_cast<double>(covered), 1500.0, what + ", pixels of the upper");
    ShadowTest::CheckEqual(static_cast<double>(wrong), 0.0, what + ", wrong pixels");
    if (both)
    {
      CheckShadowed(picture, plain, out, GetRegions(GetVisibilityOf(stage, pass), 0, above), 800.0,
        100.0, what);
      upper->SetPass(nullptr);
    }
  }
  // The upper layer alone has one.
  stage.Renderer->SetPass(nullptr);
  const auto pass = SetPassOf(stage, upper, technique);
  stage.Render();
  const Picture picture = stage.GetPicture();
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < picture.RGB.size() / 3; ++i)
  {
    wrong += plain.Difference(plainLower, i) == 0 && picture.Difference(plain, i) > 0;
  }
  ShadowTest::CheckEqual(static_cast<double>(wrong), 0.0, "upper alone, wrong pixels below it");
  upper->SetPass(nullptr);
}

//------------------------------------------------------------------------------
// Each eye's picture keeps to the law of all pictures; VTK's pictures of both eyes are made of those;
// and the second eye finds the light data of the first.
SHADOW_TEST(Windows, Stereo, Each)
{
  ShadowStage stage;
  vtkAreaLight* light = Build(stage);
  stage.Window->SetStereoTypeToLeft();
  stage.Window->StereoRenderOn();
  // Wider than the default of 2 degrees: what is drawn for the other eye is then out of place.
  stage.Renderer->GetActiveCamera()->SetEyeAngle(5.0);
  Picture eyes[2];
  for (int eye = 0; eye < 2; ++eye)
  {
    const std::string what = eye == 0 ? "left" : "right";
    stage.Window->SetStereoType(eye == 0 ? VTK_STEREO_LEFT : VTK_STEREO_RIGHT);
    stage.Renderer->SetPass(nullptr);
    stage.Render();
    const Picture plain = stage.GetPicture();
    const Picture out = DrawOut(stage, light);
    stage.SetPass(technique);
    stage.Render();
    eyes[eye] = stage.GetPicture();
    CheckShadowed(eyes[eye], plain, out, GetRegions(stage.GetVisibility()), 10000.0, 1500.0, what);
    ShadowTest::CheckNoMessage(what);
  }
  const int types[] = { VTK_STEREO_RED_BLUE, VTK_STEREO_ANAGLYPH, VTK_STEREO_INTERLACED,
    VTK_STEREO_CHECKERBOARD, VTK_STEREO_DRESDEN, VTK_STEREO_SPLITVIEWPORT_HORIZONTAL };
  for (const int type : types)
  {
    stage.SetPass(technique);
    stage.Window->SetStereoType(type);
    const std::string what = stage.Window->GetStereoTypeAsString();
    stage.Render();
    ShadowTest::CheckEqual(
      stage.Count("castersRebuilt"), 0.0, what + ", castersRebuilt of the right eye");
    ShadowTest::CheckAtMost(stage.Count("mapsDrawn"), 0.0, what + ", mapsDrawn of the right eye");
    ShadowTest::CheckAtMost(
      stage.Count("silhouettesFound"), 0.0, what + ", silhouettesFound of the right eye");
    const Picture picture = stage.GetPicture();
    ShadowTest::CheckNoMessage(what);

    vtkNew<vtkUnsignedCharArray> both[2];
    for (int eye = 0; eye < 2; ++eye)
    {
      both[eye]->SetNumberOfComponents(3);
      both[eye]->SetNumberOfTuples(160 * 160);
      std::copy(eyes[eye].RGB.begin(), eyes[eye].RGB.end(), both[eye]->GetPointer(0));
    }
    vtkNew<vtkStereoCompositor> compositor;
    const int size[2] = { 160, 160 };
    switch (type)
    {
      case VTK_STEREO_RED_BLUE:
        compositor->RedBlue(both[0], both[1]);
        break;
      case VTK_STEREO_ANAGLYPH:
        compositor->Anaglyph(both[0], both[1], stage.Window->GetAnaglyphColorSaturation(),
          stage.Window->GetAnaglyphColorMask());
        break;
      case VTK_STEREO_INTERLACED:
        compositor->Interlaced(both[0], both[1], size);
        break;
      case VTK_STEREO_CHECKERBOARD:
        compositor->Checkerboard(both[0], both[1], size);
        break;
      case VTK_STEREO_DRESDEN:
        compositor->Dresden(both[0], both[1], size);
        break;
      default:
        compositor->SplitViewportHorizontal(both[0], both[1], size);
    }
    ShadowTest::Check(std::equal(picture.RGB.begin(), picture.RGB.end(), both[0]->GetPointer(0)),
      what + ": not VTK's composition of both eyes");
  }
}

//------------------------------------------------------------------------------
// What pickers find does not depend on the pass.
SHADOW_TEST(Windows, Pickers, Each)
{
  ShadowStage stage;
  Build(stage);
  const auto pickAll = [&stage]
  {
    std::vector<std::string> found;
    vtkPropCollection* props = stage.Renderer->GetViewProps();
    const auto nameOf = [props](vtkProp* prop)
    { return std::to_string(props->IsItemPresent(prop)); };
    for (const auto& at :
      { std::pair<int, int>(70, 90), { 30, 60 }, { 96, 100 }, { 90, 125 }, { 2, 158 } })
    {
      stage.Render(); // what lies in the depth buffer is this frame's
      std::ostringstream text;
      text << at.first << " " << at.second << ":";
      vtkNew<vtkPropPicker> propPicker;
      text << " prop " << propPicker->Pick(at.first, at.second, 0.0, stage.Renderer) << " "
           << nameOf(propPicker->GetViewProp());
      if (propPicker->GetViewProp())
      {
        text << " " << propPicker->GetPickPosition()[0] << " " << propPicker->GetPickPosition()[2];
      }
      vtkNew<vtkCellPicker> cellPicker;
      text << " cell " << cellPicker->Pick(at.first, at.second, 0.0, stage.Renderer) << " "
           << nameOf(cellPicker->GetViewProp()) << " " << cellPicker->GetCellId();
      stage.Render();
      vtkNew<vtkWorldPointPicker> pointPicker;
      pointPicker->Pick(at.first, at.second, 0.0, stage.Renderer);
      text << " point";
      for (int c = 0; c < 3; ++c)
      {
        text << " " << pointPicker->GetPickPosition()[c];
      }
      vtkNew<vtkAreaPicker> areaPicker;
      vtkNew<vtkRenderedAreaPicker> renderedPicker;
      for (vtkAreaPicker* picker : std::vector<vtkAreaPicker*>{ areaPicker, renderedPicker })
      {
        text << " area "
             << picker->AreaPick(
                  at.first - 8, at.second - 8, at.first + 8, at.second + 8, stage.Renderer);
        vtkProp3DCollection* picked = picker->GetProp3Ds();
        for (int i = 0; i < picked->GetNumberOfItems(); ++i)
        {
          text << " " << nameOf(vtkProp::SafeDownCast(picked->GetItemAsObject(i)));
        }
      }
      found.push_back(text.str());
    }
    return found;
  };
  const auto expected = pickAll();
  stage.SetPass(technique);
  stage.Render();
  const Picture before = stage.GetPicture();
  const auto found = pickAll();
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    ShadowTest::Check(found[i] == expected[i], "not " + expected[i] + "\n   but " + found[i]);
  }
  ShadowTest::Check(expected[0].find("prop 1 2") != std::string::npos &&
                      expected[4].find("prop 0 0") != std::string::npos,
    "the points do not show what the test is about: " + expected[0] + "; " + expected[4]);
  stage.Render();
  ShadowTest::Check(Same(stage.GetPicture(), before), "the picture after picking differs");
}
