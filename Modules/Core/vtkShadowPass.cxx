#include "vtkShadowPass.h"

#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkLightCollection.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLError.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLState.h"
#include "vtkRenderState.h"
#include "vtkShadowInjection.h"
#include "vtkShadowPassInternals.h"
#include "vtkShadowVTKVersion.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkShadowCatcherMark);

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

/** Whether a shadow pass is drawing a prop. */
bool IsMarked(vtkProp* prop)
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
  my.Copy = this->FindCopy(renderer);
  if (my.Copy)
  {
    my.Copy->Render(s);
    this->NumberOfRenderedProps = my.Copy->GetNumberOfRenderedProps();
    return;
  }
  if (my.Rendering)
  {
    this->ErrorOnce("the pass is its own delegate, or within it: it draws nothing there.");
    return;
  }
  my.Rendering = true; // what is drawn may take the pass off the renderer
  this->NumberOfRenderedProps = 0;
  if (renderer->GetSelector())
  {
    // Selection needs no shadows, but has not taken the pass off either.
    my.Drawn = my.Drawn || my.Renderer == renderer;
    this->RenderDelegate(s);
  }
  else if (!vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()))
  {
    this->IsSupported(renderer->GetRenderWindow());
    this->WarnOnce("drawn without shadows: " + this->GetUnsupportedReason() + ".");
    this->RenderDelegate(s);
  }
  else if (std::any_of(s->GetPropArray(), s->GetPropArray() + s->GetPropArrayCount(), IsMarked))
  {
    this->WarnOnce(
      "drawn without shadows: this pass is within another shadow pass, and one at a time draws the "
      "shadows of a renderer. PutOn puts one in the other's place.");
    this->Detach();
    this->RenderDelegate(s);
  }
  else
  {
    this->RenderShadowed(s);
  }
  my.Rendering = false;
  if (my.RemovedMeanwhile)
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
  my.Window->MakeCurrent();
  my.Timers.StartFrame();
  ++my.Frames;
  my.BufferValid = my.GlassValid = false;
  if (renderer->GetUseShadows())
  {
    this->WarnOnce("the renderer's UseShadows counts for nothing: this pass draws the shadows.");
  }

  my.Props.assign(s->GetPropArray(), s->GetPropArray() + s->GetPropArrayCount());
  my.HasCatchers = std::any_of(my.Props.begin(), my.Props.end(),
    [](vtkProp* prop) { return vtkShadowPass::GetShadowCatcher(prop); });
  if (s->GetFrameBuffer())
  {
    s->GetFrameBuffer()->GetLastSize(my.Size); // within another pass, which may have its own size
  }
  else
  {
    int origin[2];
    renderer->GetTiledSizeAndOrigin(&my.Size[0], &my.Size[1], &origin[0], &origin[1]);
  }
  // Headlights and camera lights follow the camera before their shadows do.
  this->UpdateLightGeometry(renderer);
  this->UpdateLights(renderer);
  my.Active = this->PrepareShadows(renderer);
  const bool debug = my.DebugView != "none";
  if (my.Active && (my.ScreenSpace || debug))
  {
    this->EvaluateVisibility(debug);
  }
  else if (!my.BufferAskedFor)
  {
    my.Buffer.Release(my.Window);
    my.Glass.Release(my.Window);
  }
  my.BufferAskedFor = false;

  this->UpdateInjection(false);
  if (my.Active)
  {
    this->ActivateLightData(my.Frame);
    for (auto* buffer : { &my.Buffer, &my.Glass })
    {
      if (my.ScreenSpace && (buffer == &my.Buffer || my.GlassValid))
      {
        buffer->GetReceivers().Activate(my.Window);
        buffer->GetTarget().Activate(my.Window);
      }
    }
  }
  {
    vtkShadowTimers::Scope timer(my.Timers, "shading");
    const WithoutVTKShadows without(renderer);
    this->MarkProps(true);
    this->RenderDelegate(s);
    this->MarkProps(false);
  }
  // The mappers keep this pass in their caches: it must keep nothing that keeps them.
  my.Props.clear();
  if (my.Active)
  {
    for (auto* buffer : { &my.Buffer, &my.Glass })
    {
      buffer->GetReceivers().Deactivate(my.Window);
      buffer->GetTarget().Deactivate(my.Window);
    }
    if (debug)
    {
      this->DrawDebug();
    }
    this->DeactivateLightData(my.Frame);
  }
  vtkOpenGLCheckErrorMacro("failed after vtkShadowPass::Render");
}

//------------------------------------------------------------------------------
bool vtkShadowPass::PrepareShadows(vtkRenderer* renderer)
{
  Internals& my = *this->Internal;
  vtkShadowFrame& frame = my.Frame;
  frame.Renderer = renderer;
  frame.Window = my.Window;
  frame.Casters = &my.Casters;
  frame.Timers = &my.Timers;
  frame.Quad = &my.Quad;
  frame.Size[0] = my.Size[0];
  frame.Size[1] = my.Size[1];
  frame.Lights.clear();
  frame.Counts.clear();
  my.LightNotes.clear();
  if (!my.Technique)
  {
    this->WarnOnce(
      std::string(this->GetClassName()) + " has no technique: its module is not linked.");
    return false;
  }
  if (!this->IsSupported(my.Window))
  {
    this->WarnOnce("drawn without shadows: " + this->GetUnsupportedReason() + ".");
    return false;
  }

  std::vector<vtkShadowLight> lights = vtkShadowLight::Gather(renderer, this->DefaultLightRadius);
  for (auto& light : lights)
  {
    const int shape = light.Emission ? 5 : static_cast<int>(light.Kind);
    const char* name = vtkShadowTechnique::ShapeNames[shape];
    std::string note = std::string(name) + ": shadowed";
    if (!light.IsFinite())
    {
      note = std::string(name) + ": position or size is not finite, casts no shadow";
      this->WarnOnce("a light's position or size is not finite: it casts no shadow.");
    }
    else if (my.Technique->LightShapes[shape] == vtkShadowShapeSupport::Unsupported)
    {
      note = std::string(name) + ": not supported by this technique, casts no shadow";
      this->WarnOnce("a " + note + ".");
    }
    else if (static_cast<int>(frame.Lights.size()) >= Internals::MaximumLights)
    {
      note = std::string(name) + ": one casting light too many, casts no shadow";
      this->WarnOnce("more than 16 casting lights: the rest cast no shadow.");
    }
    else
    {
      frame.Lights.push_back(light);
    }
    my.LightNotes.push_back(note);
  }
  frame.Counts["lights"] = renderer->GetLights()->GetNumberOfItems();
  frame.Counts["lightsSkipped"] = frame.Counts["lights"] - frame.Lights.size();
  if (frame.Lights.empty())
  {
    return false;
  }

  const std::string rule = this->GetText("translucent-casters");
  const bool changed = my.Casters.Update(renderer,
    rule == "off"      ? vtkTranslucentCasters::Off
    : rule == "opaque" ? vtkTranslucentCasters::Opaque
                       : vtkTranslucentCasters::Weighted,
    Internals::MaximumLights / static_cast<int>(frame.Lights.size()) - 1,
    this->GetReal("alpha-threshold"));
  this->SplitLights();
  frame.Counts["casters"] = static_cast<double>(my.Casters.Get().size());
  frame.Counts["castersRebuilt"] = changed ? 1 : 0;
  frame.Counts["vertices"] = static_cast<double>(my.Casters.GetNumberOfVertices());
  frame.Counts["triangles"] = static_cast<double>(my.Casters.GetNumberOfTriangles());
  frame.Counts["trianglesDropped"] = static_cast<double>(my.Casters.GetNumberOfDroppedTriangles());
  if (const std::size_t count = my.Casters.GetNumberOfTrianglesNotFinite())
  {
    this->WarnOnce(
      std::to_string(count) + " triangles have points that are not finite: they cast no shadow.");
  }
  frame.Counts["trianglesClear"] = static_cast<double>(my.Casters.GetNumberOfClearTriangles());
  frame.Counts["castersWithHoles"] = static_cast<double>(my.Casters.GetNumberWithHoles());
  if (const std::size_t count = my.Casters.GetNumberOfUnknownAlphas())
  {
    this->WarnOnce(std::to_string(count) +
                   " props have alpha in several textures at once, in a texture of glyphs or in an "
                   "image slice: it makes no holes in what they cast.");
  }
  if (frame.Counts["triangles"] == 0)
  {
    return false;
  }

  frame.Color = std::any_of(frame.Lights.begin(), frame.Lights.end(),
    [](const vtkShadowLight& light) { return light.Emission != nullptr; });
  frame.Hard = my.Technique->Hard || std::all_of(frame.Lights.begin(), frame.Lights.end(),
                                       [](const vtkShadowLight& light) { return light.IsPoint(); });
  vtkCamera* camera = renderer->GetActiveCamera();
  glm::dmat4 VTKToClip(1.0);
  if (auto* glCamera = vtkOpenGLCamera::SafeDownCast(camera))
  {
    vtkMatrix4x4 *wcvc, *vcdc, *wcdc; // transposed already, and the camera's own
    vtkMatrix3x3* normals;
    glCamera->GetKeyMatrices(renderer, wcvc, normals, vcdc, wcdc);
    VTKToClip = glm::make_mat4(vcdc->GetData());
  }
  if (!frame.SetCamera(
        glm::transpose(glm::make_mat4(camera->GetModelViewTransformMatrix()->GetData())),
        VTKToClip))
  {
    this->WarnOnce("drawn without shadows: the camera's view transform flattens, is not finite, or "
                   "is not affine.");
    return false;
  }
  if (my.Size[0] <= 0 || my.Size[1] <= 0)
  {
    return false;
  }
  {
    vtkShadowTimers::Scope timer(my.Timers, "light data");
    if (!this->UpdateLightData(frame))
    {
      return false;
    }
  }
  const std::string choice = this->GetText("evaluation");
  const bool canForward = this->CanEvaluateForward();
  if (choice == "forward" && !canForward)
  {
    this->WarnOnce("cannot be evaluated forward with these parameters; it is in screen space.");
  }
  my.ScreenSpace =
    choice == "screen" || !canForward || (choice == "auto" && !this->PrefersForward(frame));
  return true;
}

//------------------------------------------------------------------------------
// A part of each light for each opacity of the casters, and one that only opaque ones hide.
void vtkShadowPass::SplitLights()
{
  Internals& my = *this->Internal;
  std::vector<vtkShadowLight> parts;
  for (const auto& light : my.Frame.Lights)
  {
    double before = 0.0;
    for (const double opacity : my.Casters.GetOpacities())
    {
      parts.push_back(light);
      parts.back().LeastOpacity = opacity;
      parts.back().Share = opacity - before;
      before = opacity;
    }
    parts.push_back(light);
    parts.back().LeastOpacity = 1.0;
    parts.back().Share = 1.0 - before;
  }
  my.Frame.Lights = std::move(parts);
}

//------------------------------------------------------------------------------
void vtkShadowPass::MarkProps(bool mark)
{
  Internals& my = *this->Internal;
  my.UpToDatePrograms.clear();
  if (!mark)
  {
    for (vtkInformation* keys : my.Marked)
    {
      keys->Remove(vtkOpenGLRenderPass::RenderPasses(), this);
      keys->Remove(vtkOpenGLRenderPass::RenderPasses(), my.CatcherMark);
      if (keys->Length(vtkOpenGLRenderPass::RenderPasses()) == 0)
      {
        keys->Remove(vtkOpenGLRenderPass::RenderPasses());
      }
    }
    my.Marked.clear();
    return;
  }
  // Not vtkOpenGLRenderPass::PreRender: actors within assemblies need the key too, but a
  // vtkAssembly lends its own keys to its parts, and a pass that stands there twice injects twice.
  const auto markOne = [this, &my](vtkProp* prop)
  {
    if (!prop->GetPropertyKeys())
    {
      vtkNew<vtkInformation> keys;
      prop->SetPropertyKeys(keys);
    }
    vtkInformation* keys = prop->GetPropertyKeys();
    for (int i = 0; i < keys->Length(vtkOpenGLRenderPass::RenderPasses()); ++i)
    {
      if (keys->Get(vtkOpenGLRenderPass::RenderPasses(), i) == this)
      {
        return;
      }
    }
    keys->Append(vtkOpenGLRenderPass::RenderPasses(), this);
    if (vtkShadowPass::GetShadowCatcher(prop))
    {
      keys->Append(vtkOpenGLRenderPass::RenderPasses(), my.CatcherMark);
    }
    my.Marked.emplace_back(keys);
  };
  for (vtkProp* prop : my.Props)
  {
    markOne(prop);
    vtkShadowPass::ForEachPart(prop, [&markOne](vtkProp* part, vtkMatrix4x4*) { markOne(part); });
  }
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
