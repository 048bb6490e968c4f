// SPDX-License-Identifier: BSD-3-Clause
// The renderers of a vtkShadowPass: how it comes to one, what it holds for it, and when that ends.
//
// Mappers keep a pass in their caches long after it was taken off the renderer, so its end cannot be
// what frees the GPU's memory. It is freed when the pass
//
//   leaves the renderer's chain of passes   seen at once where the renderer's own pass changes, else at
//                                           the next frame's end
//   is not drawn in a frame                 where other classes hold it, which are not seen through; but
//                                           a frame from the renderer's backing store draws nothing
//   loses its context                       the window closes, whether the pass is still in the chain
//                                           or not
//   has another window, or is deleted

#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkShadowDeclaration.h"
#include "vtkShadowPassChain.h"
#include "vtkShadowPassInternals.h"

#include <algorithm>

namespace
{
constexpr const char* DefaultTechnique = "map-pcss";

/** The first shadow pass in a renderer's chain, but for this one. */
vtkShadowPass* FindOther(vtkRenderer* renderer, vtkShadowPass* known)
{
  vtkRenderPass* root = renderer ? renderer->GetPass() : nullptr;
  return vtkShadowPass::SafeDownCast(vtkShadowPassChain::Find(root,
    [known](vtkRenderPass* pass) { return pass != known && vtkShadowPass::SafeDownCast(pass); }));
}

void TakeOffOthers(vtkRenderer* renderer, vtkShadowPass* known)
{
  while (vtkShadowPass* pass = FindOther(renderer, known))
  {
    const vtkSmartPointer<vtkRenderPass> delegate = pass->GetDelegatePass();
    vtkShadowPassChain::Replace(renderer, pass, delegate);
  }
}
}

vtkStandardNewMacro(vtkShadowContextWatch);

//------------------------------------------------------------------------------
vtkShadowPass* vtkShadowPass::New()
{
  auto* pass = new vtkShadowPass;
  pass->InitializeObjectBase();
  if (vtkShadowTechniqueRegistration::Find(DefaultTechnique))
  {
    pass->SetTechnique(DefaultTechnique);
  }
  return pass;
}

//------------------------------------------------------------------------------
vtkShadowPass::vtkShadowPass()
  : Internal(new Internals(this))
{
  this->Internal->At.Context->Pass = this;
}

//------------------------------------------------------------------------------
vtkShadowPass::~vtkShadowPass()
{
  this->Detach();
  for (const auto& copy : this->Internal->At.Copies)
  {
    copy.Pass->Internal->At.Original = nullptr;
    copy.Pass->Detach();
  }
  this->Internal->At.Context->Pass = nullptr;
}

//------------------------------------------------------------------------------
vtkShadowPass* vtkShadowPass::FindOn(vtkRenderer* renderer)
{
  return FindOther(renderer, nullptr);
}

//------------------------------------------------------------------------------
void vtkShadowPass::PutOn(vtkRenderer* renderer)
{
  if (!renderer)
  {
    vtkErrorMacro("PutOn: there is no renderer.");
    return;
  }
  if (!this->IsInChain(renderer))
  {
    vtkShadowPass* before = vtkShadowPass::FindOn(renderer);
    this->SetDelegatePass(before ? before->GetDelegatePass() : renderer->GetPass());
    if (before)
    {
      vtkShadowPassChain::Replace(renderer, before, this);
    }
    else
    {
      renderer->SetPass(this);
    }
  }
  TakeOffOthers(renderer, this);
}

//------------------------------------------------------------------------------
void vtkShadowPass::TakeOff(vtkRenderer* renderer)
{
  TakeOffOthers(renderer, nullptr);
}

//------------------------------------------------------------------------------
// The copy that serves a renderer, brought up to date; nullptr where this pass does.
vtkShadowPass* vtkShadowPass::FindCopy(vtkRenderer* renderer)
{
  Internals& my = *this->Internal;
  const auto isDone = [this](const Internals::Attachment::CopyOf& copy) {
    return !copy.Renderer || (!copy.Pass->Internal->At.Holding && !this->IsInChain(copy.Renderer));
  };
  my.At.Copies.erase(
    std::remove_if(my.At.Copies.begin(), my.At.Copies.end(), isDone), my.At.Copies.end());
  auto copy = std::find_if(my.At.Copies.begin(), my.At.Copies.end(),
    [renderer](const Internals::Attachment::CopyOf& of) { return of.Renderer == renderer; });
  if (copy == my.At.Copies.end())
  {
    if (!my.At.Holding || my.At.Renderer == renderer)
    {
      return nullptr;
    }
    my.At.Copies.push_back(
      { renderer, vtkSmartPointer<vtkShadowPass>::Take(this->NewInstance()), {} });
    copy = my.At.Copies.end() - 1;
    copy->Pass->Internal->At.Original = this;
  }
  if (copy->Time < this->GetMTime())
  {
    copy->Pass->CopySettings(this);
    copy->Time.Modified();
  }
  return copy->Pass;
}

//------------------------------------------------------------------------------
bool vtkShadowPass::IsInChain(vtkRenderer* renderer)
{
  vtkShadowPass* original = this->Internal->At.Original;
  return vtkShadowPassChain::Holds(renderer->GetPass(), original ? original : this);
}

//------------------------------------------------------------------------------
void vtkShadowPass::Attach(vtkRenderer* renderer)
{
  Internals& my = *this->Internal;
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (my.At.Renderer != renderer || my.At.Window != window)
  {
    this->Detach();
    my.At.Renderer = renderer;
    my.At.Window = window;
    my.At.Observers[0] =
      renderer->AddObserver(vtkCommand::EndEvent, this, &vtkShadowPass::ReleaseWhenRemoved);
    my.At.Observers[1] =
      renderer->AddObserver(vtkCommand::ModifiedEvent, this, &vtkShadowPass::ReleaseWhenRemoved);
  }
  my.At.Context->SetContext(window);
  my.At.Seen = this->IsInChain(renderer);
  my.At.Drawn = true;
  my.At.Holding = true;
}

//------------------------------------------------------------------------------
void vtkShadowPass::Detach()
{
  Internals& my = *this->Internal;
  if (my.At.Renderer)
  {
    my.At.Renderer->RemoveObserver(my.At.Observers[0]);
    my.At.Renderer->RemoveObserver(my.At.Observers[1]);
  }
  my.At.Context->SetContext(nullptr); // nothing where the context has ended
  my.At.Renderer = nullptr;
  my.At.Window = nullptr;
  my.At.RemovedMeanwhile = false;
}

//------------------------------------------------------------------------------
void vtkShadowPass::ReleaseWhenRemoved(vtkObject*, unsigned long event, void*)
{
  Internals& my = *this->Internal;
  if (!my.At.Renderer)
  {
    return;
  }
  bool removed = my.At.Seen && !this->IsInChain(my.At.Renderer);
  if (event == vtkCommand::EndEvent)
  {
    removed = removed || (!my.At.Seen && !my.At.Drawn && !my.At.Renderer->GetBackingStore());
    my.At.Drawn = false;
  }
  if (removed && my.At.Rendering)
  {
    my.At.RemovedMeanwhile = true;
  }
  else if (removed)
  {
    this->Detach();
  }
}

//------------------------------------------------------------------------------
void vtkShadowPass::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& my = *this->Internal;
  auto* glWindow = vtkOpenGLRenderWindow::SafeDownCast(window);
  // A window that is being destroyed has already left the weak pointer.
  if (glWindow && (glWindow == my.At.Window || (!my.At.Window && my.At.Holding)))
  {
    my.At.Holding = false;
    my.Accumulation.Forget();
    my.Stages.Release(glWindow);
    my.Error.Release(glWindow);
    if (my.Technique)
    {
      my.Technique->Release(glWindow);
    }
    my.ReleaseRetired(glWindow);
    my.Active = false;
  }
  for (const auto& copy : my.At.Copies)
  {
    copy.Pass->ReleaseGraphicsResources(window);
  }
  if (my.Delegate)
  {
    my.Delegate->ReleaseGraphicsResources(window);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkShadowPass::Internals::ReleaseRetired(vtkOpenGLRenderWindow* window)
{
  for (const auto& technique : this->Retired)
  {
    technique->Release(window);
  }
  if (!this->Retired.empty())
  {
    this->Stages.ReleaseOfTechnique();
  }
  this->Retired.clear();
}
