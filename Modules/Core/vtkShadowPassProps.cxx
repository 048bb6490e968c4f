// Props and lights as vtkShadowPass sees them: who casts, receives and catches, and their parts.

#include "vtkAbstractMapper3D.h"
#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkLODProp3D.h"
#include "vtkLight.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkShadowPass.h"

vtkInformationKeyMacro(vtkShadowPass, CASTS_SHADOW, Integer);
vtkInformationKeyMacro(vtkShadowPass, RECEIVES_SHADOW, Integer);
vtkInformationKeyMacro(vtkShadowPass, SHADOW_CATCHER, Integer);

namespace
{
bool GetSwitch(vtkInformation* keys, vtkInformationIntegerKey* key)
{
  return !keys || !keys->Has(key) || keys->Get(key) != 0;
}

/** The level that was drawn last, or the first one; nullptr where it is no actor. */
vtkActor* GetShownLevel(vtkLODProp3D* levels)
{
  // The level of a frame is chosen while it is drawn.
  const int last = levels->GetLastRenderedLODID();
  vtkNew<vtkPropCollection> actors;
  levels->GetActors(actors);
  for (int i = 0; i < actors->GetNumberOfItems(); ++i)
  {
    auto* actor = vtkActor::SafeDownCast(actors->GetItemAsObject(i));
    if (last < 0 ||
        static_cast<vtkAbstractMapper3D*>(actor->GetMapper()) == levels->GetLODMapper(last))
    {
      return actor;
    }
  }
  return nullptr;
}

/** What SetShadowCatcher has to undo, kept in the key. */
enum CatcherBits
{
  Catches = 1,
  MadeTranslucent = 2,
  MadePhong = 4
};

void SetSwitch(vtkProp* prop, vtkInformationIntegerKey* key, bool on)
{
  if (!prop->GetPropertyKeys())
  {
    vtkNew<vtkInformation> keys;
    prop->SetPropertyKeys(keys);
  }
  prop->GetPropertyKeys()->Set(key, on ? 1 : 0);
}
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetCasting(vtkProp* prop, bool casts)
{
  SetSwitch(prop, vtkShadowPass::CASTS_SHADOW(), casts);
}

//------------------------------------------------------------------------------
bool vtkShadowPass::GetCasting(vtkProp* prop)
{
  return GetSwitch(prop->GetPropertyKeys(), vtkShadowPass::CASTS_SHADOW());
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetReceiving(vtkProp* prop, bool receives)
{
  SetSwitch(prop, vtkShadowPass::RECEIVES_SHADOW(), receives);
}

//------------------------------------------------------------------------------
bool vtkShadowPass::GetReceiving(vtkProp* prop)
{
  return GetSwitch(prop->GetPropertyKeys(), vtkShadowPass::RECEIVES_SHADOW());
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetShadowCatcher(vtkProp* prop, bool catches)
{
  if (catches == vtkShadowPass::GetShadowCatcher(prop))
  {
    return;
  }
  vtkInformation* before = prop->GetPropertyKeys();
  int made = catches ? static_cast<int>(Catches) : before->Get(vtkShadowPass::SHADOW_CATCHER());
  vtkShadowPass::ForEachPart(prop,
    [&](vtkProp* part, vtkMatrix4x4*)
    {
      auto* actor = vtkActor::SafeDownCast(part);
      if (!actor)
      {
        return;
      }
      // It is blended over what lies behind; and only its lights are to count.
      if (catches && !actor->GetForceTranslucent())
      {
        actor->ForceTranslucentOn();
        made |= MadeTranslucent;
      }
      else if (!catches && (made & MadeTranslucent) != 0)
      {
        actor->ForceTranslucentOff();
      }
      if (catches && actor->GetProperty()->GetInterpolation() == VTK_PBR)
      {
        actor->GetProperty()->SetInterpolationToPhong();
        made |= MadePhong;
      }
      else if (!catches && (made & MadePhong) != 0)
      {
        actor->GetProperty()->SetInterpolationToPBR();
      }
    });
  SetSwitch(prop, vtkShadowPass::SHADOW_CATCHER(), catches);
  if (catches)
  {
    prop->GetPropertyKeys()->Set(vtkShadowPass::SHADOW_CATCHER(), made);
  }
}

//------------------------------------------------------------------------------
bool vtkShadowPass::GetShadowCatcher(vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  return keys && keys->Has(vtkShadowPass::SHADOW_CATCHER()) &&
         keys->Get(vtkShadowPass::SHADOW_CATCHER()) != 0;
}

//------------------------------------------------------------------------------
void vtkShadowPass::SetLightCasting(vtkLight* light, bool casts)
{
  if (!light->GetInformation())
  {
    vtkNew<vtkInformation> keys;
    light->SetInformation(keys);
  }
  light->GetInformation()->Set(vtkShadowPass::CASTS_SHADOW(), casts ? 1 : 0);
}

//------------------------------------------------------------------------------
bool vtkShadowPass::GetLightCasting(vtkLight* light)
{
  return GetSwitch(light->GetInformation(), vtkShadowPass::CASTS_SHADOW());
}

//------------------------------------------------------------------------------
void vtkShadowPass::ForEachPart(
  vtkProp* prop, const std::function<void(vtkProp*, vtkMatrix4x4*)>& function)
{
  const auto visit = [&function](vtkProp* part, vtkMatrix4x4* matrix)
  {
    auto* levels = vtkLODProp3D::SafeDownCast(part);
    vtkProp* shown = levels ? GetShownLevel(levels) : part;
    if (shown && matrix)
    {
      function(shown, matrix);
    }
  };
  if (prop->IsA("vtkAssembly") || prop->IsA("vtkPropAssembly"))
  {
    prop->InitPathTraversal();
    while (vtkAssemblyPath* path = prop->GetNextPath())
    {
      vtkAssemblyNode* node = path->GetLastNode();
      vtkProp* part = node->GetViewProp();
      vtkMatrix4x4* matrix = node->GetMatrix() ? node->GetMatrix() : part->GetMatrix();
      if (part->GetVisibility())
      {
        visit(part, matrix);
      }
    }
  }
  else
  {
    visit(prop, prop->GetMatrix());
  }
}
