// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowPass.h"

#include "vtkAreaLight.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkLightCollection.h"
#include "vtkOpenGLError.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"
#include "vtkShadowAdvice.h"
#include "vtkShadowDebugViews.h"
#include "vtkShadowDeclaration.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowPassInternals.h"
#include "vtkShadowReceiverDrawing.h"
#include "vtkShadowShaderFiles.h"
#include "vtkShadowTags.h"

#include <algorithm>
#include <exception>
#include <sstream>

namespace
{
/** VTK's own shadow maps are left out while it lives; the renderer's switch stays the user's. */
class WithoutVTKShadows
{
public:
  explicit WithoutVTKShadows(vtkRenderer* renderer)
    : Renderer(renderer)
    , Used(renderer->GetUseShadows())
  {
    if (this->Used)
    {
      renderer->UseShadowsOff();
    }
  }
  ~WithoutVTKShadows()
  {
    if (this->Used)
    {
      this->Renderer->SetUseShadows(this->Used);
    }
  }
  WithoutVTKShadows(const WithoutVTKShadows&) = delete;
  void operator=(const WithoutVTKShadows&) = delete;

private:
  vtkRenderer* Renderer;
  vtkTypeBool Used;
};

/** Set while it lives, however its scope ends. */
class Flag
{
public:
  explicit Flag(bool& flag)
    : Value(flag)
  {
    this->Value = true;
  }
  ~Flag() { this->Value = false; }
  Flag(const Flag&) = delete;
  void operator=(const Flag&) = delete;

private:
  bool& Value;
};

/** Whether a shadow pass is drawing a prop. */
bool IsBeingDrawn(vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  const int count = keys ? keys->Length(vtkOpenGLRenderPass::RenderPasses()) : 0;
  for (int i = 0; i < count; ++i)
  {
    if (vtkShadowPass::SafeDownCast(keys->Get(vtkOpenGLRenderPass::RenderPasses(), i)))
    {
      return true;
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
void vtkShadowPass::Render(const vtkRenderState* s)
{
  Internals& my = *this->Internal;
  vtkRenderer* renderer = s->GetRenderer();
  my.At.Copy = this->FindCopy(renderer);
  if (my.At.Copy)
  {
    my.At.Copy->Render(s);
    this->NumberOfRenderedProps = my.At.Copy->GetNumberOfRenderedProps();
    return;
  }
  if (my.At.Rendering)
  {
    my.Messages.Error("the pass is its own delegate, or within it: it draws nothing there.");
    return;
  }
  {
    const Flag rendering(my.At.Rendering); // what is drawn may take the pass off the renderer
    this->NumberOfRenderedProps = 0;
    if (renderer->GetSelector())
    {
      // Selection needs no shadows, but has not taken the pass off either.
      my.At.Drawn = my.At.Drawn || my.At.Renderer == renderer;
      this->RenderDelegate(s);
    }
    else if (!vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()))
    {
      this->IsSupported(renderer->GetRenderWindow());
      my.Messages.Warn("drawn without shadows: " + this->GetUnsupportedReason() + ".");
      this->RenderDelegate(s);
    }
    else if (std::any_of(
               s->GetPropArray(), s->GetPropArray() + s->GetPropArrayCount(), IsBeingDrawn))
    {
      my.Messages.Warn("drawn without shadows: this pass is within another shadow pass, and one at "
                       "a time draws the "
                       "shadows of a renderer. PutOn puts one in the other's place.");
      this->Detach();
      this->RenderDelegate(s);
    }
    else
    {
      this->RenderShadowed(s);
    }
  }
  if (my.At.RemovedMeanwhile)
  {
    this->Detach();
  }
}

//------------------------------------------------------------------------------
void vtkShadowPass::RenderShadowed(const vtkRenderState* s)
{
  Internals& my = *this->Internal;
  vtkRenderer* renderer = s->GetRenderer();
  vtkOpenGLClearErrorMacro();
  this->Attach(renderer);
  vtkOpenGLRenderWindow* window = my.At.Window;
  window->MakeCurrent();
  my.ReleaseRetired(window);
  my.Stages.GetTimers().StartFrame();
  ++my.Frames;
  if (renderer->GetUseShadows())
  {
    my.Messages.Warn("the renderer's UseShadows counts for nothing: this pass draws the shadows.");
  }

  my.Props.assign(s->GetPropArray(), s->GetPropArray() + s->GetPropArrayCount());
  my.HasCatchers = std::any_of(my.Props.begin(), my.Props.end(), &vtkShadowTags::GetShadowCatcher);
  if (s->GetFrameBuffer())
  {
    s->GetFrameBuffer()->GetLastSize(my.Size); // within another pass, which may have its own size
  }
  else
  {
    int origin[2];
    renderer->GetTiledSizeAndOrigin(&my.Size[0], &my.Size[1], &origin[0], &origin[1]);
  }
  this->FitUnplacedLights(renderer);
  // Headlights and camera lights follow the camera before their shadows do.
  this->UpdateLightGeometry(renderer);
  this->UpdateLights(renderer);
  vtkShadowStages& stages = my.Stages;
  vtkShadowFrame& frame = stages.GetFrame();
  const bool debug = my.DebugView != "none";
  my.Active = this->PrepareShadows(renderer, !debug);
  if (my.Active && (stages.IsInScreenSpace() || debug))
  {
    my.Active = this->EvaluateVisibility(debug);
  }
  else if (!my.BufferAskedFor)
  {
    stages.Opaque.Release(window);
    stages.Translucent.Release(window);
  }
  my.BufferAskedFor = false;
  my.Accumulation.End(frame, my.Active);

  // What is drawn may set another technique.
  vtkShadowTechnique* technique = my.Technique.get();
  my.Active = my.Active && stages.Guard(*technique,
                             [&]
                             {
                               my.Injector.Update(my.GetUse());
                               technique->Activate(frame);
                               return true;
                             });
  const bool active = my.Active;
  if (active)
  {
    for (auto* screen : { &stages.Opaque, &stages.Translucent })
    {
      if (stages.IsInScreenSpace() && screen->Valid)
      {
        screen->Activate(window);
      }
    }
  }
  else
  {
    frame.Parts.clear();
    my.Injector.Update(my.GetUse());
  }
  {
    vtkShadowTimers::Scope timer(stages.GetTimers(), "shading");
    const WithoutVTKShadows without(renderer);
    const vtkShadowInjector::Marks marks(my.Injector, this, my.Props);
    this->RenderDelegate(s);
  }
  // The mappers keep this pass in their caches: it must keep nothing that keeps them.
  my.Props.clear();
  if (active)
  {
    stages.Opaque.Deactivate(window);
    stages.Translucent.Deactivate(window);
    if (debug)
    {
      stages.Guard(*technique,
        [&]
        {
          vtkShadowDebugViews::Draw(frame, *technique, stages.Opaque, my.DebugView);
          return true;
        });
    }
    technique->Deactivate(frame);
  }
  stages.Finish();
  vtkOpenGLCheckErrorMacro("failed after vtkShadowPass::Render");
}

//------------------------------------------------------------------------------
// Area lights that nobody has placed.
void vtkShadowPass::FitUnplacedLights(vtkRenderer* renderer)
{
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator cookie;
  lights->InitTraversal(cookie);
  while (vtkLight* light = lights->GetNextLight(cookie))
  {
    auto* area = vtkAreaLight::SafeDownCast(light);
    if (area && !area->GetPlaced() && area->LightTypeIsSceneLight())
    {
      area->FitTo(renderer->ComputeVisiblePropBounds());
    }
  }
}

//------------------------------------------------------------------------------
// Stages 1 and 2, of a frame that may be one of several that add up. False where no shadows are drawn.
bool vtkShadowPass::PrepareShadows(vtkRenderer* renderer, bool accumulates)
{
  Internals& my = *this->Internal;
  vtkShadowStages& stages = my.Stages;
  stages.Start(renderer, my.At.Window, my.Size, &my.Messages);
  if (!my.Technique)
  {
    my.Messages.Warn(
      std::string(this->GetClassName()) + " has no technique. Known: " +
      (vtkShadowTechniqueRegistration::GetAll().empty()
          ? vtkShadowTechniqueRegistration::GetHint()
          : std::string("others than its own, whose module is not linked or not initialized by "
                        "vtk_module_autoinit; see SetTechnique")) +
      ".");
    return false;
  }
  if (!this->IsSupported(my.At.Window))
  {
    my.Messages.Warn("drawn without shadows: " + this->GetUnsupportedReason() + ".");
    return false;
  }
  if (!stages.Gather(my.Settings, this->DefaultLightRadius, this->DefaultLightAngle))
  {
    return false;
  }
  if (vtkShadowPass::GetAdvice() && !my.Advised)
  {
    const std::string advice =
      vtkShadowAdvice::Find(stages.GetFrame(), *my.Settings.GetDeclaration());
    my.Advised = !advice.empty();
    if (my.Advised)
    {
      my.Messages.Warn(advice);
    }
  }
  this->PrepareTechnique(*my.Technique);
  if (accumulates)
  {
    my.Accumulation.Begin(stages.GetFrame(), my.Props, *my.Technique, this->GetMTime());
  }
  else
  {
    my.Accumulation.Forget(); // receivers and visibility become others
    my.Technique->BeginFrame(false);
  }
  if (my.Accumulation.IsOn() && my.Accumulation.IsFinished())
  {
    return true; // with the last frame's light data
  }
  if (my.Technique->GetTraits().NeedsReceivers)
  {
    // As they are drawn again with the picture, by the same shaders: in screen space.
    stages.ChooseEvaluation(nullptr, my.Settings);
    my.Active = true;
    if (!stages.Allocate(stages.Opaque))
    {
      return false;
    }
    if (my.Accumulation.GetBefore() == 0)
    {
      this->DrawReceivers(false, false);
    }
    stages.GetFrame().Receivers = &stages.Opaque.Receivers;
  }
  if (!stages.UpdateLightData(*my.Technique))
  {
    return false;
  }
  if (vtkShadowPass::GetAdvice() && !my.Advised)
  {
    const std::string advice = vtkShadowAdvice::FindBroken(stages.GetFrame());
    my.Advised = !advice.empty();
    if (my.Advised)
    {
      my.Messages.Warn(advice);
    }
  }
  return stages.Guard(*my.Technique,
    [&]
    {
      stages.ChooseEvaluation(my.Accumulation.IsOn() ? nullptr : my.Technique.get(), my.Settings);
      return true;
    });
}

//------------------------------------------------------------------------------
vtkShadowInjector::Use vtkShadowPass::Internals::GetUse()
{
  vtkShadowInjector::Use use;
  use.Frame = &this->Stages.GetFrame();
  use.Technique = this->Active ? this->Technique.get() : nullptr;
  use.ScreenSpace = this->Stages.IsInScreenSpace();
  use.Smooth = this->Active && this->Settings.GetChoice("terminator") == "smooth";
  use.Opaque = &this->Stages.Opaque;
  use.Translucent = this->Stages.Translucent.Valid ? &this->Stages.Translucent : nullptr;
  return use;
}

//------------------------------------------------------------------------------
// Of a screen that has room for them.
void vtkShadowPass::DrawReceivers(bool translucent, bool withCatchers)
{
  Internals& my = *this->Internal;
  vtkShadowScreen& screen = translucent ? my.Stages.Translucent : my.Stages.Opaque;
  vtkShadowTimers::Scope timer(my.Stages.GetTimers(), "receivers");
  vtkShadowInjector::Use use = my.GetUse();
  use.Written = &screen;
  vtkShadowReceiverDrawing::Draw(my.Injector, use, this, my.Props, { translucent, withCatchers });
}

//------------------------------------------------------------------------------
// Stage 3. False where shadows cannot be drawn after all.
bool vtkShadowPass::EvaluateVisibility(bool withCatchers)
{
  Internals& my = *this->Internal;
  vtkShadowStages& stages = my.Stages;
  const bool translucent = my.Active && stages.IsInScreenSpace() &&
                           std::any_of(my.Props.begin(), my.Props.end(),
                             [](vtkProp* prop) { return prop->HasTranslucentPolygonalGeometry(); });
  if (my.Accumulation.IsOn() && my.Accumulation.IsFinished())
  {
    stages.Opaque.Valid = true;
    stages.Translucent.Valid = translucent;
    return true;
  }
  if (!this->EvaluateScreen(false, withCatchers))
  {
    return false;
  }
  if (!translucent)
  {
    stages.Translucent.Release(my.At.Window);
  }
  else if (!this->EvaluateScreen(true, true))
  {
    return false;
  }
  if (my.Accumulation.IsOn())
  {
    my.Accumulation.Count();
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkShadowPass::EvaluateScreen(bool translucent, bool withCatchers)
{
  Internals& my = *this->Internal;
  vtkShadowStages& stages = my.Stages;
  vtkShadowScreen& screen = translucent ? stages.Translucent : stages.Opaque;
  if (!stages.Allocate(screen))
  {
    return false;
  }
  // Receivers that light data was made from are without catchers, which a debug view shows. Those of a
  // frame that adds to the last one are its.
  const int before = my.Accumulation.GetBefore();
  if (before == 0 && (!screen.Drawn || withCatchers))
  {
    this->DrawReceivers(translucent, withCatchers);
  }
  screen.Valid = !my.Active || stages.Evaluate(*my.Technique, screen);
  if (!my.Accumulation.IsOn())
  {
    screen.Visibility.ForgetMean(my.At.Window);
  }
  else if (screen.Valid)
  {
    screen.Valid = stages.Accumulate(screen, before);
  }
  return screen.Valid;
}

//------------------------------------------------------------------------------
void vtkShadowPass::RenderDelegate(const vtkRenderState* s)
{
  Internals& my = *this->Internal;
  if (my.Delegate)
  {
    my.Delegate->Render(s);
    this->NumberOfRenderedProps += my.Delegate->GetNumberOfRenderedProps();
    return;
  }
  vtkRenderer* renderer = s->GetRenderer();
  auto* framebuffer = vtkOpenGLFramebufferObject::SafeDownCast(s->GetFrameBuffer());
  if (!framebuffer)
  {
    // Just what the renderer does when it has no pass.
    this->UpdateCamera(renderer);
    this->UpdateLightGeometry(renderer);
    this->UpdateLights(renderer);
    this->UpdateGeometry(renderer);
    return;
  }
  // Within another pass: the framebuffer is the viewport.
  int size[2];
  framebuffer->GetLastSize(size);
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  state->vtkglViewport(0, 0, size[0], size[1]);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(0, 0, size[0], size[1]);
  if (window->GetErase() && renderer->GetErase())
  {
    renderer->Clear();
  }
  this->UpdateLightGeometry(renderer);
  this->UpdateLights(renderer);
  this->UpdateGeometry(renderer, framebuffer);
}

//------------------------------------------------------------------------------
bool vtkShadowPass::PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
  std::string& fragmentShader, vtkAbstractMapper*, vtkProp* prop)
{
  vtkShadowInjector::Mark({ vertexShader, geometryShader, fragmentShader }, prop);
  return true;
}

//------------------------------------------------------------------------------
bool vtkShadowPass::PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
  std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop)
{
  Internals& my = *this->Internal;
  const std::string problem =
    my.Injector.Fill({ vertexShader, geometryShader, fragmentShader }, mapper, prop);
  if (!problem.empty())
  {
    std::ostringstream text;
    text << "the fragment shader of a " << prop->GetClassName() << " (" << prop
         << ") is drawn without shadows, or without some of them: " << problem << ".";
    my.Messages.Warn(text.str());
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkShadowPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  Internals& my = *this->Internal;
  try
  {
    my.Injector.SetParameters(program, mapper, prop);
    vtkShadowShaderFiles::Write(program, "prop");
  }
  catch (const std::exception& exception)
  {
    // Between VTK's own calls: the frame goes on with whatever the program has.
    my.Messages.Error(
      std::string("the technique failed to set its parameters: ") + exception.what());
  }
  return true;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkShadowPass::GetShaderStageMTime()
{
  return this->Internal->Injector.GetTime();
}
