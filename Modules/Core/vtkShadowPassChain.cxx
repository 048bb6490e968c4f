// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowPassChain.h"

#include "vtkCameraPass.h"
#include "vtkDualDepthPeelingPass.h"
#include "vtkImageProcessingPass.h"
#include "vtkNew.h"
#include "vtkOrderIndependentTranslucentPass.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkRenderer.h"
#include "vtkSSAAPass.h"
#include "vtkSequencePass.h"
#include "vtkShadowPass.h"
#include "vtkSmartPointer.h"

#include <set>
#include <vector>

namespace
{
/** A place that holds a pass, and what puts another one there. */
struct Place
{
  vtkRenderPass* Held;
  std::function<void(vtkRenderPass*)> Put;
};

/** Adds one place of a pass of this class, if it is one. */
template <typename Owner>
void Add(std::vector<Place>& places, vtkRenderPass* pass, vtkRenderPass* (Owner::*get)(),
  void (Owner::*put)(vtkRenderPass*))
{
  auto* owner = Owner::SafeDownCast(pass);
  vtkRenderPass* held = owner ? (owner->*get)() : nullptr;
  if (held)
  {
    places.push_back({ held, [owner, put](vtkRenderPass* other) { (owner->*put)(other); } });
  }
}

std::vector<Place> GetPlaces(vtkRenderPass* pass)
{
  using Steps = vtkRenderStepsPass;
  std::vector<Place> places;
  Add(places, pass, &vtkShadowPass::GetDelegatePass, &vtkShadowPass::SetDelegatePass);
  Add(places, pass, &vtkCameraPass::GetDelegatePass, &vtkCameraPass::SetDelegatePass);
  Add(places, pass, &vtkSSAAPass::GetDelegatePass, &vtkSSAAPass::SetDelegatePass);
  Add(places, pass, &vtkImageProcessingPass::GetDelegatePass,
    &vtkImageProcessingPass::SetDelegatePass);
  Add(places, pass, &vtkDepthPeelingPass::GetTranslucentPass,
    &vtkDepthPeelingPass::SetTranslucentPass);
  Add(places, pass, &vtkDualDepthPeelingPass::GetVolumetricPass,
    &vtkDualDepthPeelingPass::SetVolumetricPass);
  Add(places, pass, &vtkOrderIndependentTranslucentPass::GetTranslucentPass,
    &vtkOrderIndependentTranslucentPass::SetTranslucentPass);
  Add(places, pass, &Steps::GetLightsPass, &Steps::SetLightsPass);
  Add(places, pass, &Steps::GetOpaquePass, &Steps::SetOpaquePass);
  Add(places, pass, &Steps::GetTranslucentPass, &Steps::SetTranslucentPass);
  Add(places, pass, &Steps::GetVolumetricPass, &Steps::SetVolumetricPass);
  Add(places, pass, &Steps::GetOverlayPass, &Steps::SetOverlayPass);
  Add(places, pass, &Steps::GetPostProcessPass, &Steps::SetPostProcessPass);
  if (auto* steps = Steps::SafeDownCast(pass))
  {
    if (vtkRenderPass* camera = steps->GetCameraPass())
    {
      places.push_back({ camera, [](vtkRenderPass*) {} }); // of no other class
    }
  }
  auto* sequence = vtkSequencePass::SafeDownCast(pass);
  vtkRenderPassCollection* passes = sequence ? sequence->GetPasses() : nullptr;
  for (int i = 0; passes && i < passes->GetNumberOfItems(); ++i)
  {
    places.push_back({ vtkRenderPass::SafeDownCast(passes->GetItemAsObject(i)),
      [passes, i](vtkRenderPass* other) { passes->ReplaceItem(i, other); } });
  }
  return places;
}

/** Call a function with each place from here on, once, until it gives true. */
bool Visit(const Place& place, const std::function<bool(const Place&)>& function,
  std::set<vtkRenderPass*>& visited)
{
  if (!place.Held)
  {
    return false;
  }
  if (function(place))
  {
    return true;
  }
  if (!visited.insert(place.Held).second)
  {
    return false; // shared, or a chain that bites its tail
  }
  for (const auto& inner : GetPlaces(place.Held))
  {
    if (Visit(inner, function, visited))
    {
      return true;
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
vtkRenderPass* vtkShadowPassChain::Find(
  vtkRenderPass* root, const std::function<bool(vtkRenderPass*)>& isMeant)
{
  vtkRenderPass* found = nullptr;
  std::set<vtkRenderPass*> visited;
  Visit(
    { root, {} },
    [&](const Place& place)
    {
      found = isMeant(place.Held) ? place.Held : nullptr;
      return found != nullptr;
    },
    visited);
  return found;
}

//------------------------------------------------------------------------------
bool vtkShadowPassChain::Holds(vtkRenderPass* root, vtkRenderPass* pass)
{
  return Find(root, [pass](vtkRenderPass* held) { return held == pass; }) != nullptr;
}

//------------------------------------------------------------------------------
void vtkShadowPassChain::Replace(vtkRenderer* renderer, vtkRenderPass* pass, vtkRenderPass* other)
{
  const vtkSmartPointer<vtkRenderPass> kept = pass; // until it is replaced everywhere
  if (renderer->GetPass() == pass)
  {
    renderer->SetPass(other);
  }
  vtkNew<vtkRenderStepsPass> steps;
  std::vector<Place> places; // all of them before any is changed
  std::set<vtkRenderPass*> visited{ pass, other };
  Visit(
    { renderer->GetPass(), {} },
    [&](const Place& place)
    {
      if (place.Held == pass)
      {
        places.push_back(place);
      }
      return false;
    },
    visited);
  for (const auto& place : places)
  {
    if (place.Put)
    {
      place.Put(other ? other : steps.Get());
    }
  }
}
