// SPDX-License-Identifier: BSD-3-Clause
// Life and death of passes: frames from the backing store, several renderers, passes within passes,
// contexts that end, and what a pass or a catcher leaves behind. See also Memory.cxx.

#include "ShadowStage.h"
#include "ShadowTest.h"

#include "vtkAssembly.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkObjectFactory.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAOPass.h"
#include "vtkShadowTechniques.h"

#include <string>
#include <vector>

namespace
{
/** Holds a pass in a way that nobody else knows of. */
class Wrapper : public vtkRenderPass
{
public:
  static Wrapper* New();
  vtkTypeMacro(Wrapper, vtkRenderPass);
  void Render(const vtkRenderState* s) override { this->Inner->Render(s); }
  vtkSmartPointer<vtkRenderPass> Inner;
};
vtkStandardNewMacro(Wrapper);

/** A window, a renderer and a camera that are not OpenGL's. */
class PlainWindow : public vtkRenderWindow
{
public:
  static PlainWindow* New();
  vtkTypeMacro(PlainWindow, vtkRenderWindow);
};
vtkStandardNewMacro(PlainWindow);

class PlainRenderer : public vtkRenderer
{
public:
  static PlainRenderer* New();
  vtkTypeMacro(PlainRenderer, vtkRenderer);
  int UpdateGeometry(vtkFrameBufferObjectBase*) override { return ++this->Drawn; }
  int Drawn = 0;
};
vtkStandardNewMacro(PlainRenderer);

class PlainCamera : public vtkCamera
{
public:
  static PlainCamera* New();
  vtkTypeMacro(PlainCamera, vtkCamera);
};
vtkStandardNewMacro(PlainCamera);

void Build(ShadowStage& stage, const std::string& technique)
{
  stage.AddThings();
  stage.AddLight(
    ShadowStage::Supports(technique, LightKind::Sphere) ? LightKind::Sphere : LightKind::Point);
}

/** What the first renderer shows, from elsewhere, in the right half. */
void Share(ShadowStage& stage, vtkRenderer* second)
{
  stage.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  second->SetViewport(0.5, 0.0, 1.0, 1.0);
  second->AutomaticLightCreationOff();
  second->SetBackground(0.5, 0.1, 0.1);
  stage.Window->AddRenderer(second);
  vtkPropCollection* props = stage.Renderer->GetViewProps();
  for (int i = 0; i < props->GetNumberOfItems(); ++i)
  {
    second->AddViewProp(vtkProp::SafeDownCast(props->GetItemAsObject(i)));
  }
  second->AddLight(vtkLight::SafeDownCast(stage.Renderer->GetLights()->GetItemAsObject(0)));
  second->GetActiveCamera()->SetPosition(-4.0, -6.0, 5.0);
  second->GetActiveCamera()->SetFocalPoint(0.2, 0.2, 0.3);
  second->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
  second->ResetCameraClippingRange();
}
}

//------------------------------------------------------------------------------
// A frame that the renderer takes from its store draws nothing, and frees nothing.
SHADOW_TEST(Lifetime, FrameFromTheStore, Each)
{
  for (const bool hidden : { false, true })
  {
    const std::string what = hidden ? "within a pass that is not seen through" : "by itself";
    ShadowStage stage;
    Build(stage, technique);
    stage.SetPass(technique);
    if (hidden)
    {
      vtkNew<Wrapper> wrapper;
      wrapper->Inner = stage.Pass;
      stage.Renderer->SetPass(wrapper);
    }
    stage.Renderer->BackingStoreOn();
    stage.Render();
    const Picture first = stage.GetPicture();
    stage.Render(); // drawn, since taking the picture has modified the window
    const double frames = stage.GetStatistics()["frame"];
    const auto bytes = static_cast<double>(stage.GetBytes());
    ShadowTest::CheckAtLeast(bytes, 1.0, what + ": bytes");
    stage.Render();
    stage.Render();
    ShadowTest::CheckEqual(stage.GetStatistics()["frame"], frames, what + ": frames drawn");
    ShadowTest::CheckEqual(static_cast<double>(stage.GetBytes()), bytes, what + ": bytes kept");
    ShadowTest::Check(Same(stage.GetPicture(), first), what + ": the picture of the store differs");
    stage.Renderer->SetPass(nullptr);
    stage.Renderer->BackingStoreOff();
    stage.Window->Finalize();
    ShadowTest::CheckEqual(static_cast<double>(stage.GetBytes()), 0.0, what + ": bytes at the end");
  }
}

//------------------------------------------------------------------------------
// One pass on two renderers of a window: each as with a pass of its own, nothing is built twice, and
// all is freed.
SHADOW_TEST(Lifetime, TwoRenderers, Each)
{
  ShadowStage stage(220, 130);
  Build(stage, technique);
  vtkNew<vtkRenderer> second;
  Share(stage, second);
  stage.Render();
  const int plain = stage.CountGLObjects();

  // Two passes.
  const vtkSmartPointer<vtkShadowPass> other = stage.SetPass(technique);
  second->SetPass(other);
  stage.SetPass(technique);
  stage.Render();
  const Picture expected = stage.GetPicture();
  second->SetPass(nullptr);

  // And one.
  stage.SetPass(technique);
  second->SetPass(stage.Pass);
  stage.Render();
  ShadowTest::Check(Same(stage.GetPicture(), expected), "the picture is not that of two passes");
  const Visibility before = stage.GetVisibility();
  ShadowTest::CheckEqual(before.Width, 110, "the last renderer's width");
  for (int frame = 0; frame < 2; ++frame)
  {
    for (vtkRenderer* drawn : { stage.Renderer.Get(), second.Get() })
    {
      const std::string what =
        std::string(drawn == second ? "second" : "first") + ", frame " + std::to_string(frame);
      stage.Renderer->SetDraw(drawn == stage.Renderer);
      second->SetDraw(drawn == second);
      stage.Render();
      ShadowTest::CheckEqual(stage.Count("castersRebuilt"), 0.0, what + ": castersRebuilt");
      ShadowTest::CheckAtMost(stage.Count("silhouettesFound"), 0.0, what + ": silhouettesFound");
      if (technique != "planar-hard" || frame > 0) // its maps are those of what is in view
      {
        ShadowTest::CheckAtMost(stage.Count("mapsDrawn"), 0.0, what + ": mapsDrawn");
      }
    }
  }
  stage.Renderer->DrawOn();
  second->DrawOn();
  stage.Render();
  ShadowTest::Check(Same(stage.GetPicture(), expected), "the picture after turns differs");
  ShadowTest::Check(Same(stage.GetVisibility(), before), "V after turns differs");

  // A setting counts for both.
  vtkSmartPointer<vtkShadowPass> shown = stage.Pass;
  shown->SetDebugView("visibility");
  stage.Render();
  const Picture debug = stage.GetPicture();
  shown->SetDebugView("none");
  for (const int left : { 0, 110 })
  {
    const Picture a = Crop(debug, left, 0, 110, 130);
    ShadowTest::Check(!Same(a, Crop(expected, left, 0, 110, 130)), "no debug view");
  }
  stage.Render();
  ShadowTest::Check(Same(stage.GetPicture(), expected), "the picture after the debug view differs");

  // The first one goes, and the second one's remains; then both are gone.
  stage.Renderer->SetPass(nullptr);
  stage.Render();
  ShadowTest::Check(
    Same(Crop(stage.GetPicture(), 110, 0, 110, 130), Crop(expected, 110, 0, 110, 130)),
    "the second one's picture, alone");
  ShadowTest::CheckAtLeast(static_cast<double>(stage.GetBytes()), 1.0, "the second one's bytes");
  second->SetPass(nullptr);
  ShadowTest::CheckEqual(static_cast<double>(stage.GetBytes()), 0.0, "bytes at the end");
  ShadowTest::CheckEqual(stage.CountGLObjects(), plain, "objects at the end");
}

//------------------------------------------------------------------------------
// A shadow pass within another one says so and draws no shadows; all else is drawn.
SHADOW_TEST(Lifetime, OneWithinAnother, Each)
{
  ShadowStage stage;
  Build(stage, technique);
  stage.SetPass(technique);
  stage.Render();
  const Picture expected = stage.GetPicture();
  for (const bool between : { false, true })
  {
    const std::string what = between ? "with steps between" : "as the delegate";
    vtkSmartPointer<vtkShadowPass> inner = stage.SetPass(technique);
    stage.Render(); // it has drawn already
    stage.SetPass(technique);
    vtkSmartPointer<vtkRenderPass> delegate = inner;
    if (between)
    {
      vtkNew<Wrapper> wrapper;
      wrapper->Inner = inner;
      delegate = wrapper;
    }
    stage.Pass->SetDelegatePass(delegate);
    stage.Render();
    ShadowTest::Check(Same(stage.GetPicture(), expected), what + ": not the outer one's picture");
    ShadowTest::CheckOneMessage(
      ShadowTest::Message::Warning, { "within another shadow pass" }, what);
    stage.Render();
    ShadowTest::CheckNoMessage(what + ", again");
    const auto bytes = nlohmann::json::parse(inner->GetStatistics())["bytes"]["total"];
    ShadowTest::CheckEqual(bytes, 0.0, what + ": bytes of the inner one");
  }
}

//------------------------------------------------------------------------------
// An outer pass that nobody sees through is taken off, and the window closes before another frame:
// what was there is freed with its context, and a new one shows the same.
SHADOW_TEST(Lifetime, OuterPassGoesThenTheWindow, Each)
{
  ShadowStage stage;
  Build(stage, technique);
  stage.SetPass(technique);
  vtkNew<Wrapper> wrapper;
  wrapper->Inner = stage.Pass;
  stage.Renderer->SetPass(wrapper);
  stage.Render();
  const Picture expected = stage.GetPicture();
  const Visibility visibility = stage.GetVisibility();
  stage.Renderer->SetPass(nullptr);
  stage.Window->Finalize();
  ShadowTest::CheckEqual(static_cast<double>(stage.GetBytes()), 0.0, "bytes after the window");
  stage.Render(); // names that were freed are used anew
  const int plain = stage.CountGLObjects();
  const Picture without = stage.GetPicture();
  stage.Renderer->SetPass(wrapper);
  stage.Render();
  ShadowTest::Check(Same(stage.GetPicture(), expected), "the picture in the new window differs");
  ShadowTest::Check(Same(stage.GetVisibility(), visibility), "V in the new window differs");
  stage.Renderer->SetPass(nullptr);
  stage.Render();
  ShadowTest::Check(Same(stage.GetPicture(), without), "the picture without the pass differs");
  ShadowTest::CheckEqual(stage.CountGLObjects(), plain, "objects at the end");
  ShadowTest::CheckNoMessage("outer pass");
}

//------------------------------------------------------------------------------
// The window closes at a frame's begin or end, or the frame is broken off amid its props: nothing is
// lost, and the next frame is right. (VTK itself aborts where a window closes between both.)
SHADOW_TEST(Lifetime, WindowClosesWhileRendering, Each)
{
  ShadowStage stage;
  vtkActor* box = stage.AddThings();
  stage.AddLight(LightKind::Point);
  stage.SetPass(technique);
  stage.Render();
  const Picture expected = stage.GetPicture();
  const std::pair<vtkObject*, unsigned long> moments[] = {
    { stage.Window, vtkCommand::StartEvent },
    { box->GetMapper(), vtkCommand::UpdateShaderEvent },
    { stage.Window, vtkCommand::EndEvent },
  };
  for (const auto& [object, event] : moments)
  {
    const std::string what = vtkCommand::GetStringFromEventId(event);
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(stage.Window.Get());
    command->SetCallback(
      [](vtkObject*, unsigned long id, void* data, void*)
      {
        auto* window = static_cast<vtkRenderWindow*>(data);
        id == vtkCommand::UpdateShaderEvent ? window->SetAbortRender(1) : window->Finalize();
      });
    const unsigned long observer = object->AddObserver(event, command);
    stage.Render();
    object->RemoveObserver(observer);
    stage.Window->SetAbortRender(0);
    stage.Render();
    ShadowTest::Check(Same(stage.GetPicture(), expected), what + ": the next frame differs");
    ShadowTest::CheckNoMessage(what);
  }
}

//------------------------------------------------------------------------------
// The same, where VTK's own pass is around and only it is told.
SHADOW_TEST(Lifetime, TakenOutOfAnotherPass, Each)
{
  ShadowStage stage;
  Build(stage, technique);
  vtkNew<vtkSSAOPass> outer;
  outer->SetRadius(0.5);
  vtkNew<vtkRenderStepsPass> steps;
  outer->SetDelegatePass(steps);
  stage.Renderer->SetPass(outer);
  stage.Render();
  const Picture without = stage.GetPicture();
  const int plain = stage.CountGLObjects();
  stage.SetPass(technique);
  stage.Pass->SetDelegatePass(steps);
  outer->SetDelegatePass(stage.Pass);
  stage.Renderer->SetPass(outer);
  stage.Render();
  stage.GetVisibility();
  ShadowTest::CheckAtLeast(static_cast<double>(stage.GetBytes()), 1.0, "bytes held");
  vtkShadowPass::TakeOff(stage.Renderer);
  stage.Render();
  ShadowTest::Check(Same(stage.GetPicture(), without), "the picture without shadows differs");
  ShadowTest::CheckEqual(static_cast<double>(stage.GetBytes()), 0.0, "bytes");
  ShadowTest::CheckEqual(stage.CountGLObjects(), plain, "objects");
  stage.Renderer->SetPass(nullptr);
  outer->ReleaseGraphicsResources(stage.Window);
}

//------------------------------------------------------------------------------
// A pass that outlives its window answers, and asks no context.
SHADOW_TEST(Lifetime, StatisticsWithoutAContext, Each)
{
  vtkSmartPointer<vtkShadowPass> pass;
  {
    ShadowStage stage;
    Build(stage, technique);
    pass = stage.SetPass(technique);
    vtkNew<Wrapper> wrapper;
    wrapper->Inner = pass;
    stage.Renderer->SetPass(wrapper);
    stage.Render();
  }
  const auto statistics = nlohmann::json::parse(pass->GetStatistics());
  ShadowTest::CheckEqual(statistics["bytes"]["total"], 0.0, "bytes");
  ShadowTest::Check(
    statistics["milliseconds"].contains("shading"), "the last frame's times are lost");
  ShadowTest::CheckNoMessage("statistics");
  ShadowTest::Check(pass->GetVisibility(0) == nullptr, "V of no window");
  ShadowTest::CheckOneMessage(ShadowTest::Message::Error, { "no frame" }, "V of no window");
}

//------------------------------------------------------------------------------
// A window that is not OpenGL's is told, and drawn as without the pass.
SHADOW_TEST(Lifetime, WindowOfAnotherKind, Each)
{
  vtkNew<PlainWindow> window;
  vtkNew<PlainRenderer> renderer;
  window->AddRenderer(renderer);
  vtkNew<PlainCamera> camera;
  renderer->SetActiveCamera(camera);
  vtkSmartPointer<vtkShadowPass> pass =
    vtkSmartPointer<vtkShadowPass>::Take(vtkShadowTechniques::Create(technique));
  vtkRenderState state(renderer);
  state.SetPropArrayAndCount(nullptr, 0);
  for (int i = 0; i < 2; ++i)
  {
    pass->Render(&state);
  }
  ShadowTest::CheckEqual(renderer->Drawn, 2.0, "times drawn");
  ShadowTest::CheckOneMessage(
    ShadowTest::Message::Warning, { "without shadows", "vtkOpenGLRenderWindow" }, "the window");
  const auto statistics = nlohmann::json::parse(pass->GetStatistics());
  ShadowTest::CheckEqual(statistics["bytes"]["total"], 0.0, "bytes");
}

//------------------------------------------------------------------------------
// VTK's own shadows do not count while the pass draws them; the renderer's switch stays as it is.
SHADOW_TEST(Lifetime, SwitchOfVTKsShadows, Each)
{
  ShadowStage stage;
  Build(stage, technique);
  stage.SetPass(technique);
  stage.Render();
  const Picture expected = stage.GetPicture();
  stage.Renderer->UseShadowsOn();
  for (int i = 0; i < 2; ++i)
  {
    stage.Render();
    ShadowTest::Check(Same(stage.GetPicture(), expected), "VTK's shadows are in the picture");
    ShadowTest::CheckEqual(stage.Renderer->GetUseShadows(), 1.0, "UseShadows");
  }
  ShadowTest::CheckOneMessage(ShadowTest::Message::Warning, { "UseShadows" }, "UseShadows");
  stage.Renderer->UseShadowsOff();
}

//------------------------------------------------------------------------------
// What makes a prop a catcher is undone, part by part; what the user has set is not.
SHADOW_TEST(Lifetime, CatcherNoMore, Once)
{
  const auto makeActor = [](bool physical)
  {
    auto actor = vtkSmartPointer<vtkActor>::New();
    physical ? actor->GetProperty()->SetInterpolationToPBR()
             : actor->GetProperty()->SetInterpolationToFlat();
    return actor;
  };
  const auto describe = [](const std::vector<vtkActor*>& actors)
  {
    std::string text;
    for (vtkActor* actor : actors)
    {
      text += std::to_string(actor->GetForceTranslucent()) + " " +
              actor->GetProperty()->GetInterpolationAsString() + "; ";
    }
    return text;
  };
  const auto check = [&describe](const std::vector<vtkActor*>& actors, const std::string& expected,
                       const std::string& what)
  {
    ShadowTest::Check(
      describe(actors) == expected, what + ": " + describe(actors) + "not " + expected);
  };
  // Parts of an assembly, of which the user has made one translucent.
  {
    const auto a = makeActor(true);
    const auto b = makeActor(false);
    vtkNew<vtkAssembly> assembly;
    assembly->AddPart(a);
    assembly->AddPart(b);
    b->ForceTranslucentOn();
    vtkShadowPass::SetShadowCatcher(assembly, true);
    check({ a, b }, "1 Phong; 1 Flat; ", "parts that catch");
    vtkShadowPass::SetShadowCatcher(assembly, false);
    check({ a, b }, "0 Physically based rendering; 1 Flat; ", "parts that do not");
    // Again, and a part leaves meanwhile.
    vtkShadowPass::SetShadowCatcher(assembly, true);
    assembly->RemovePart(a);
    vtkShadowPass::SetShadowCatcher(assembly, false);
    check({ a, b }, "0 Physically based rendering; 1 Flat; ", "a part that has left");
  }
  // A property of two catchers, and of a third prop that is none.
  {
    const auto a = makeActor(true);
    const auto b = makeActor(true);
    b->SetProperty(a->GetProperty());
    vtkShadowPass::SetShadowCatcher(a, true);
    vtkShadowPass::SetShadowCatcher(b, true);
    vtkShadowPass::SetShadowCatcher(a, false);
    check({ a, b }, "0 Phong; 1 Phong; ", "one of two catches");
    vtkShadowPass::SetShadowCatcher(b, false);
    check({ a, b }, "0 Physically based rendering; 0 Physically based rendering; ", "none catches");
  }
  // What the user sets meanwhile stays: the interpolation, and another property.
  {
    const auto a = makeActor(true);
    vtkShadowPass::SetShadowCatcher(a, true);
    a->GetProperty()->SetInterpolationToFlat();
    vtkShadowPass::SetShadowCatcher(a, false);
    check({ a }, "0 Flat; ", "set meanwhile");
    const auto b = makeActor(true);
    const vtkSmartPointer<vtkProperty> property = b->GetProperty();
    vtkShadowPass::SetShadowCatcher(b, true);
    vtkNew<vtkProperty> other;
    b->SetProperty(other);
    vtkShadowPass::SetShadowCatcher(b, false);
    check({ b }, "0 Gouraud; ", "another property");
    ShadowTest::CheckEqual(property->GetInterpolation(), VTK_PBR, "the property before");
  }
  // A catcher that is deleted leaves a property that others use as it was.
  {
    const auto a = makeActor(true);
    auto b = makeActor(true);
    b->SetProperty(a->GetProperty());
    vtkShadowPass::SetShadowCatcher(b, true);
    b = nullptr;
    check({ a }, "0 Physically based rendering; ", "deleted");
  }
}
