// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowReceiverDrawing.h"

#include "vtkActor.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkOpenGLActor.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPointGaussianMapper.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"
#include "vtkShadowFrame.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowScreen.h"
#include "vtkShadowTags.h"

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
      vtkShadowTags::ForEachPart(
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
  vtkShadowTags::ForEachPart(prop,
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
void vtkShadowReceiverDrawing::Draw(vtkShadowInjector& injector, const vtkShadowInjector::Use& use,
  vtkOpenGLRenderPass* pass, const std::vector<vtkSmartPointer<vtkProp>>& props, const Which& which)
{
  const vtkShadowFrame& frame = *use.Frame;
  vtkShadowScreen& screen = *use.Written;
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  vtkOpenGLState::ScopedglColorMask colorMask(state);
  vtkOpenGLState::ScopedglDepthFunc depthFunc(state);
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkShadowFramebuffer::Scope target(frame.Window, screen.Receivers.GetFramebuffer(),
    &screen.Receivers.GetTexture(), &screen.Receivers.GetDepth(), 0);
  state->vtkglDepthMask(GL_TRUE);
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  const float nothing[] = { 0.0f, 0.0f, 0.0f, 0.0f };
  const float farthest = 1.0f;
  glClearBufferfv(GL_COLOR, 0, nothing);
  glClearBufferfv(GL_DEPTH, 0, &farthest);

  const OtherPasses others(props);
  injector.Update(use);
  vtkShadowTexture& visibility = screen.Visibility.GetTarget();
  if (visibility.GetHandle())
  {
    visibility.Activate(frame.Window);
  }
  {
    const vtkShadowInjector::Marks marks(injector, pass, props);
    const DepthMasks depthMasks(marks.Get());
    // First what hides receivers, wherever it stands among the props.
    for (vtkProp* prop : props)
    {
      if (!which.Translucent && GetRole(prop) == Role::Hides)
      {
        state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        prop->RenderOpaqueGeometry(frame.Renderer);
      }
    }
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    for (vtkProp* prop : props)
    {
      if (GetRole(prop) != Role::Receives)
      {
        continue;
      }
      if (!which.Translucent)
      {
        prop->RenderOpaqueGeometry(frame.Renderer);
      }
      if ((which.Translucent || (which.Catchers && vtkShadowTags::GetShadowCatcher(prop))) &&
          prop->HasTranslucentPolygonalGeometry())
      {
        prop->RenderTranslucentPolygonalGeometry(frame.Renderer);
      }
    }
  }
  visibility.Deactivate(frame.Window);
  screen.Drawn = true;
}
