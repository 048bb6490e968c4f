// The screen-space side of vtkShadowPass: receivers, visibility, debug views.

#include "vtkActor.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLState.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPropCollection.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkShadowDebugFS.h"
#include "vtkShadowPassInternals.h"
#include "vtkShadowVTKVersion.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace
{
/**
 * Takes other passes off props while it lives: one around this pass (vtkSSAOPass) would have them
 * write to its own framebuffer's targets, which are not what is drawn into.
 */
class OtherPasses
{
public:
  explicit OtherPasses(const std::vector<vtkSmartPointer<vtkProp>>& props)
  {
    for (vtkProp* prop : props)
    {
      this->TakeOff(prop);
      vtkShadowPass::ForEachPart(
        prop, [this](vtkProp* part, vtkMatrix4x4*) { this->TakeOff(part); });
    }
  }
  ~OtherPasses()
  {
    for (const auto& taken : this->Taken)
    {
      for (vtkObjectBase* pass : taken.Passes)
      {
        taken.Keys->Append(vtkOpenGLRenderPass::RenderPasses(), pass);
      }
    }
  }
  OtherPasses(const OtherPasses&) = delete;
  void operator=(const OtherPasses&) = delete;

private:
  struct Of
  {
    vtkSmartPointer<vtkInformation> Keys;
    std::vector<vtkSmartPointer<vtkObjectBase>> Passes;
  };

  void TakeOff(vtkProp* prop)
  {
    vtkInformation* keys = prop->GetPropertyKeys();
    const int count = keys ? keys->Length(vtkOpenGLRenderPass::RenderPasses()) : 0;
    if (count == 0)
    {
      return;
    }
    Of taken{ keys, {} };
    for (int i = 0; i < count; ++i)
    {
      taken.Passes.emplace_back(keys->Get(vtkOpenGLRenderPass::RenderPasses(), 0));
      // One by one: removed all at once, VTK keeps a reference to each for ever.
      keys->Remove(vtkOpenGLRenderPass::RenderPasses(), 0);
    }
    keys->Remove(vtkOpenGLRenderPass::RenderPasses());
    this->Taken.push_back(std::move(taken));
  }

  std::vector<Of> Taken;
};

/** VTK does not write the depth of translucent props, but here the nearest counts: while it lives. */
class DepthMasks
{
public:
  explicit DepthMasks(const std::vector<vtkSmartPointer<vtkInformation>>& ofProps)
  {
    vtkInformationIntegerKey* key = vtkOpenGLActor::GLDepthMaskOverride();
    for (vtkInformation* keys : ofProps)
    {
      this->Before.emplace_back(keys, keys->Has(key) ? keys->Get(key) : None);
      keys->Set(key, 1);
    }
  }
  ~DepthMasks()
  {
    for (auto before = this->Before.rbegin(); before != this->Before.rend(); ++before)
    {
      if (before->second == None)
      {
        before->first->Remove(vtkOpenGLActor::GLDepthMaskOverride());
      }
      else
      {
        before->first->Set(vtkOpenGLActor::GLDepthMaskOverride(), before->second);
      }
    }
  }
  DepthMasks(const DepthMasks&) = delete;
  void operator=(const DepthMasks&) = delete;

private:
  static constexpr int None = -1;
  std::vector<std::pair<vtkSmartPointer<vtkInformation>, int>> Before;
};

/** What a prop does where receivers are drawn. */
enum class Role
{
  Receives, // by the code that is injected, which also tells what is unlit
  Hides,    // drawn by shaders that nothing is injected into
  Nothing   // blended over the picture though VTK takes it for opaque: it hides nothing
};

Role GetRole(vtkProp* prop)
{
  Role role = Role::Hides;
  vtkShadowPass::ForEachPart(prop,
    [&role](vtkProp* part, vtkMatrix4x4*)
    {
      auto* actor = vtkActor::SafeDownCast(part);
      if (!actor || !actor->GetMapper() ||
          (actor->GetShaderProperty()->HasFragmentShaderCode() &&
            !vtkShadowInjection::CanFill(actor->GetShaderProperty()->GetFragmentShaderCode())))
      {
        return; // such as vtkCubeAxesActor, which draws by actors of its own
      }
      role = Role::Receives;
      if (auto* points = vtkPointGaussianMapper::SafeDownCast(actor->GetMapper()))
      {
        const char* splat = points->GetSplatShaderCode();
        role = points->GetEmissive() || !splat || !*splat ? Role::Nothing : Role::Receives;
      }
    });
  return role;
}
}

//------------------------------------------------------------------------------
void vtkShadowPass::EvaluateVisibility(bool withCatchers)
{
  Internals& my = *this->Internal;
  my.BufferValid = this->EvaluateReceivers(my.Buffer, false, withCatchers);
  const bool translucent =
    my.ScreenSpace && std::any_of(my.Props.begin(), my.Props.end(),
                        [](vtkProp* prop) { return prop->HasTranslucentPolygonalGeometry(); });
  my.GlassValid = translucent && my.Active && this->EvaluateReceivers(my.Glass, true, true);
  if (!translucent)
  {
    my.Glass.Release(my.Window);
  }
}

//------------------------------------------------------------------------------
bool vtkShadowPass::EvaluateReceivers(
  vtkVisibilityBuffer& buffer, bool translucent, bool withCatchers)
{
  Internals& my = *this->Internal;
  vtkShadowFrame& frame = my.Frame;
  if (!buffer.Allocate(my.Window, my.Size[0], my.Size[1],
        std::max<int>(1, static_cast<int>(frame.Lights.size())), frame.Color))
  {
    this->ErrorOnce("no memory for the visibility of " + std::to_string(my.Size[0]) + " x " +
                    std::to_string(my.Size[1]) + " pixels; drawn without shadows.");
    my.Active = false;
    return false;
  }
  {
    vtkShadowTimers::Scope timer(my.Timers, "receivers");
    this->RenderReceivers(buffer, translucent, withCatchers);
  }
  if (my.Active)
  {
    vtkShadowTimers::Scope timer(my.Timers, "visibility");
    buffer.SetQuantity(my.Window, "");
    this->ActivateLightData(frame);
    this->FillVisibility(frame, buffer);
    this->DeactivateLightData(frame);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkShadowPass::RenderReceivers(
  vtkVisibilityBuffer& buffer, bool translucent, bool withCatchers)
{
  Internals& my = *this->Internal;
  vtkOpenGLState* state = my.Window->GetState();
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  vtkOpenGLState::ScopedglColorMask colorMask(state);
  vtkOpenGLState::ScopedglDepthFunc depthFunc(state);
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkShadowFramebuffer::Scope target(
    my.Window, buffer.GetFramebuffer(), &buffer.GetReceivers(), &buffer.GetReceiverDepth(), 0);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  const float nothing[] = { 0.0f, 0.0f, 0.0f, 0.0f };
  const float farthest = 1.0f;
  glClearBufferfv(GL_COLOR, 0, nothing);
  glClearBufferfv(GL_DEPTH, 0, &farthest);

  const OtherPasses others(my.Props);
  this->UpdateInjection(true);
  my.Written = &buffer;
  buffer.GetTarget().Activate(my.Window);
  this->MarkProps(true);
  const DepthMasks depthMasks(my.Marked);
  // First what hides receivers, wherever it stands among the props.
  for (vtkProp* prop : my.Props)
  {
    if (!translucent && GetRole(prop) == Role::Hides)
    {
      state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
      prop->RenderOpaqueGeometry(my.Renderer);
    }
  }
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  for (vtkProp* prop : my.Props)
  {
    if (GetRole(prop) != Role::Receives)
    {
      continue;
    }
    if (!translucent)
    {
      prop->RenderOpaqueGeometry(my.Renderer);
    }
    if ((translucent || (withCatchers && vtkShadowPass::GetShadowCatcher(prop))) &&
        prop->HasTranslucentPolygonalGeometry())
    {
      prop->RenderTranslucentPolygonalGeometry(my.Renderer);
    }
  }
  this->MarkProps(false);
  buffer.GetTarget().Deactivate(my.Window);
}

//------------------------------------------------------------------------------
void vtkShadowPass::FillVisibility(vtkShadowFrame& frame, vtkVisibilityBuffer& buffer)
{
  vtkShadowFramebuffer::Scope target(
    frame.Window, buffer.GetFramebuffer(), &buffer.GetTarget(), nullptr, 0);
  for (std::size_t i = 0; i < frame.Lights.size(); ++i)
  {
    target.SetLayer(static_cast<int>(i));
    this->DrawEvaluation(frame, buffer, static_cast<int>(i));
  }
}

//------------------------------------------------------------------------------
void vtkShadowPass::DrawEvaluation(
  vtkShadowFrame& frame, vtkVisibilityBuffer& buffer, int light, double share)
{
  Internals& my = *this->Internal;
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  state->vtkglDisable(GL_DEPTH_TEST);
  const std::string source = vtkShadowInjection::GetEvaluation(
    my.GetPreamble() +
      (buffer.GetQuantity().empty() ? ""
                                    : "#define SHADOW_QUANTITY " + buffer.GetQuantity() + "\n") +
      (share > 0.0 ? "#define SHADOW_OUTPUT_CHANGE\n" : ""),
    this->GetVisibilityGLSL());
  this->DrawQuad(source,
    [&](vtkShaderProgram* program)
    {
      buffer.GetReceivers().Activate(frame.Window);
      program->SetUniformi("shadowReceivers", buffer.GetReceivers().GetUnit());
      program->SetUniformi("shadowLight", light);
      program->SetUniformf("shadowShare", static_cast<float>(share));
      my.SetLights(program);
      this->SetVisibilityParameters(program);
    });
  buffer.GetReceivers().Deactivate(frame.Window);
}

//------------------------------------------------------------------------------
void vtkShadowPass::DrawQuad(
  const std::string& fragmentShader, const std::function<void(vtkShaderProgram*)>& setParameters)
{
  this->Internal->Quad.Draw(this->Internal->Window, fragmentShader, setParameters);
}

//------------------------------------------------------------------------------
void vtkShadowPass::DrawDebug()
{
  Internals& my = *this->Internal;
  vtkOpenGLState* state = my.Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  const std::string quantity = this->GetDebugQuantity(my.DebugView);
  const bool penumbra = my.DebugView == "penumbra";
  if (quantity.empty() && !penumbra && my.DebugView != "visibility")
  {
    this->DrawDebugView(my.Frame, my.DebugView);
    return;
  }
  double white = 1.0;
  if (!quantity.empty())
  {
    my.Buffer.SetQuantity(my.Window, quantity);
    this->FillVisibility(my.Frame, my.Buffer);
    white = this->GetMaximumCost();
    if (my.DebugView != "cost")
    {
      white = 0.0;
      for (std::size_t i = 0; i < my.Frame.Lights.size(); ++i)
      {
        const auto values = my.Buffer.ReadTarget(my.Window, static_cast<int>(i));
        white = std::max<double>(white, *std::max_element(values.begin(), values.end()));
      }
    }
    my.Frame.Counts["debugViewWhite"] = white;
  }
  int viewport[4];
  state->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  std::string source = vtkShadowDebugFS;
  vtkShaderProgram::Substitute(source, "SHADOW_DEBUG_SWIZZLE",
    my.Buffer.IsColor() && quantity.empty() ? "texel.rgb" : "texel.rrr");
  my.Buffer.GetTarget().Activate(my.Window);
  my.Buffer.GetReceivers().Activate(my.Window);
  this->DrawQuad(source,
    [&](vtkShaderProgram* program)
    {
      program->SetUniformi("shadowReceivers", my.Buffer.GetReceivers().GetUnit());
      program->SetUniformi("shadowBuffer", my.Buffer.GetTarget().GetUnit());
      program->SetUniform2i("shadowOrigin", viewport);
      const int lights = static_cast<int>(my.Frame.Lights.size());
      int slots[Internals::MaximumLights] = {};
      float shares[Internals::MaximumLights] = {};
      for (int i = 0; i < lights; ++i)
      {
        slots[i] = my.Frame.Lights[i].Slot;
        shares[i] = static_cast<float>(my.Frame.Lights[i].Share);
      }
      program->SetUniformi("shadowLights", lights);
      program->SetUniform1iv("shadowSlots", lights, slots);
      program->SetUniform1fv("shadowShares", lights, shares);
      program->SetUniformi("shadowView", quantity.empty() ? (penumbra ? 1 : 0) : 2);
      program->SetUniformf("shadowScale", white > 0.0 ? static_cast<float>(1.0 / white) : 0.0f);
    });
  my.Buffer.GetReceivers().Deactivate(my.Window);
  my.Buffer.GetTarget().Deactivate(my.Window);
  my.Buffer.SetQuantity(my.Window, "");
}

//------------------------------------------------------------------------------
vtkImageData* vtkShadowPass::GetVisibility(vtkLight* light)
{
  if (vtkShadowPass* copy = this->Internal->Copy)
  {
    return copy->GetVisibility(light);
  }
  if (!this->UpdateVisibility())
  {
    return nullptr;
  }
  const auto lights = this->Internal->GetLights();
  if (std::find(lights.begin(), lights.end(), light) == lights.end())
  {
    vtkErrorMacro("GetVisibility: the light is not in the renderer, which has "
                  << std::to_string(lights.size()) << ".");
    return nullptr;
  }
  return this->MakeVisibility(light);
}

//------------------------------------------------------------------------------
vtkImageData* vtkShadowPass::GetVisibility(int light)
{
  if (vtkShadowPass* copy = this->Internal->Copy)
  {
    return copy->GetVisibility(light);
  }
  if (!this->UpdateVisibility())
  {
    return nullptr;
  }
  const auto lights = this->Internal->GetLights();
  const int count = static_cast<int>(lights.size());
  if (count == 0 && light == 0)
  {
    return this->MakeVisibility(nullptr); // nothing is lit
  }
  if (light < 0 || light >= count)
  {
    vtkErrorMacro(
      "GetVisibility: there is no light "
      << std::to_string(light) << ". "
      << (count == 0 ? "The renderer has none."
                     : "Those of the renderer are 0 to " + std::to_string(count - 1) + "."));
    return nullptr;
  }
  return this->MakeVisibility(lights[light]);
}

//------------------------------------------------------------------------------
// Those that cast in the frame, then the renderer's others. The former may be gone since.
std::vector<vtkLight*> vtkShadowPass::Internals::GetLights() const
{
  std::vector<vtkLight*> lights;
  for (const auto& part : this->Frame.Lights)
  {
    if (lights.empty() || lights.back() != part.Light)
    {
      lights.push_back(part.Light);
    }
  }
  vtkCollectionSimpleIterator cookie;
  vtkLightCollection* all = this->Renderer->GetLights();
  all->InitTraversal(cookie);
  while (vtkLight* light = all->GetNextLight(cookie))
  {
    if (std::find(lights.begin(), lights.end(), light) == lights.end())
    {
      lights.push_back(light);
    }
  }
  return lights;
}

//------------------------------------------------------------------------------
bool vtkShadowPass::UpdateVisibility()
{
  Internals& my = *this->Internal;
  if (!my.Window || !my.Renderer || !my.Holding)
  {
    vtkErrorMacro("GetVisibility: there is no frame; render with this pass first.");
    return false;
  }
  my.Window->MakeCurrent();
  my.BufferAskedFor = true;
  if (!my.BufferValid || my.HasCatchers)
  {
    // Of what is in the renderer now, whatever the frame showed.
    my.Props.clear();
    vtkCollectionSimpleIterator cookie;
    vtkPropCollection* props = my.Renderer->GetViewProps();
    props->InitTraversal(cookie);
    while (vtkProp* prop = props->GetNextProp(cookie))
    {
      if (prop->GetVisibility())
      {
        my.Props.emplace_back(prop);
      }
    }
    vtkOpenGLState* state = my.Window->GetState();
    state->Push();
    const auto counts = my.Frame.Counts; // statistics are about the frame
    my.Active = this->PrepareShadows(my.Renderer);
    this->EvaluateVisibility(true);
    my.Props.clear();
    my.Frame.Counts = counts;
    state->Pop();
  }
  return my.BufferValid; // EvaluateVisibility has reported why not
}

//------------------------------------------------------------------------------
vtkImageData* vtkShadowPass::MakeVisibility(vtkLight* light)
{
  Internals& my = *this->Internal;
  const int width = my.Buffer.GetWidth();
  const int height = my.Buffer.GetHeight();
  const int stored = my.Buffer.GetComponents();
  const int components = stored == 1 ? 1 : 3;
  const vtkIdType pixels = static_cast<vtkIdType>(width) * height;
  const auto receivers = my.Buffer.ReadReceivers(my.Window);

  vtkNew<vtkFloatArray> visibility;
  visibility->SetName("Visibility");
  visibility->SetNumberOfComponents(components);
  visibility->SetNumberOfTuples(pixels);
  visibility->Fill(1.0);
  for (std::size_t part = 0; my.Active && part < my.Frame.Lights.size(); ++part)
  {
    if (my.Frame.Lights[part].Light == light)
    {
      const float share = static_cast<float>(my.Frame.Lights[part].Share);
      const auto values = my.Buffer.ReadTarget(my.Window, static_cast<int>(part));
      float* sum = visibility->GetPointer(0);
      for (vtkIdType i = 0; i < pixels * components; ++i)
      {
        // Sums of weights come to 1 but for rounding.
        const float value = values[i / components * stored + i % components];
        sum[i] -= share * (1.0f - std::clamp(value, 0.0f, 1.0f));
      }
    }
  }
  vtkNew<vtkUnsignedCharArray> mask;
  mask->SetName("Receiver");
  mask->SetNumberOfTuples(pixels);
  for (vtkIdType i = 0; i < pixels; ++i)
  {
    mask->SetValue(i, receivers[i].w != 0.0f);
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(width, height, 1);
  image->GetPointData()->SetScalars(visibility);
  image->GetPointData()->AddArray(mask);
  // One is kept for each light that there still is.
  const auto lights = my.GetLights();
  for (auto kept = my.VisibilityImages.begin(); kept != my.VisibilityImages.end();)
  {
    const bool gone = std::find(lights.begin(), lights.end(), kept->first) == lights.end();
    kept = gone ? my.VisibilityImages.erase(kept) : std::next(kept);
  }
  my.VisibilityImages[light] = image;
  return image;
}
