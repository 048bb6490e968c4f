// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowTags.h"

#include "vtkAbstractMapper3D.h"
#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkLODProp3D.h"
#include "vtkLight.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkWeakPointer.h"

#include <vector>

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

/** In a property's information: how many catchers' parts want Phong of it, which was PBR. */
vtkInformationIntegerKey* MadePhongKey()
{
  static auto* key =
    vtkInformationIntegerKey::MakeKey("SHADOW_CATCHER_MADE_PHONG", "vtkShadowPass");
  return key;
}

/** In a light's information. */
vtkInformationIntegerKey* FilledKey()
{
  static auto* key = vtkInformationIntegerKey::MakeKey("FILLED", "vtkShadowPass");
  return key;
}

/**
 * What a catcher changes of its parts, undone when this goes: where the prop ceases to be one, or is
 * deleted. What the user has set, before or meanwhile, stays. It stands in the catcher's keys, which
 * VTK lends to the parts of an assembly, and keeps none of them.
 */
class CatcherChanges : public vtkObjectBase
{
public:
  vtkBaseTypeMacro(CatcherChanges, vtkObjectBase);
  static CatcherChanges* New()
  {
    auto* result = new CatcherChanges;
    result->InitializeObjectBase();
    return result;
  }
  static vtkInformationObjectBaseKey* Key()
  {
    static auto* key =
      vtkInformationObjectBaseKey::MakeKey("SHADOW_CATCHER_CHANGES", "vtkShadowPass");
    return key;
  }

  void Change(vtkActor* actor)
  {
    // It is blended over what lies behind; and only its lights are to count.
    if (!actor->GetForceTranslucent())
    {
      actor->ForceTranslucentOn();
      this->Translucent.emplace_back(actor);
    }
    vtkProperty* property = actor->GetProperty();
    vtkInformation* information = property->GetInformation();
    const int others = information->Has(MadePhongKey()) ? information->Get(MadePhongKey()) : 0;
    if (others > 0 || property->GetInterpolation() == VTK_PBR)
    {
      property->SetInterpolationToPhong();
      information->Set(MadePhongKey(), others + 1);
      this->Phong.emplace_back(property);
    }
  }

private:
  ~CatcherChanges() override
  {
    for (vtkActor* actor : this->Translucent)
    {
      if (actor)
      {
        actor->ForceTranslucentOff();
      }
    }
    for (vtkProperty* property : this->Phong)
    {
      vtkInformation* information = property ? property->GetInformation() : nullptr;
      const int others =
        information && information->Has(MadePhongKey()) ? information->Get(MadePhongKey()) - 1 : 0;
      if (others > 0)
      {
        information->Set(MadePhongKey(), others);
      }
      else if (information)
      {
        information->Remove(MadePhongKey());
        if (property->GetInterpolation() == VTK_PHONG)
        {
          property->SetInterpolationToPBR();
        }
      }
    }
  }

  std::vector<vtkWeakPointer<vtkActor>> Translucent;
  std::vector<vtkWeakPointer<vtkProperty>> Phong;
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
vtkInformationIntegerKey* vtkShadowTags::CASTS_SHADOW()
{
  static auto* key = vtkInformationIntegerKey::MakeKey("CASTS_SHADOW", "vtkShadowPass");
  return key;
}

//------------------------------------------------------------------------------
vtkInformationIntegerKey* vtkShadowTags::RECEIVES_SHADOW()
{
  static auto* key = vtkInformationIntegerKey::MakeKey("RECEIVES_SHADOW", "vtkShadowPass");
  return key;
}

//------------------------------------------------------------------------------
vtkInformationIntegerKey* vtkShadowTags::SHADOW_CATCHER()
{
  static auto* key = vtkInformationIntegerKey::MakeKey("SHADOW_CATCHER", "vtkShadowPass");
  return key;
}

//------------------------------------------------------------------------------
void vtkShadowTags::SetCasting(vtkProp* prop, bool casts)
{
  SetSwitch(prop, vtkShadowTags::CASTS_SHADOW(), casts);
}

//------------------------------------------------------------------------------
bool vtkShadowTags::GetCasting(vtkProp* prop)
{
  return GetSwitch(prop->GetPropertyKeys(), vtkShadowTags::CASTS_SHADOW());
}

//------------------------------------------------------------------------------
void vtkShadowTags::SetReceiving(vtkProp* prop, bool receives)
{
  SetSwitch(prop, vtkShadowTags::RECEIVES_SHADOW(), receives);
}

//------------------------------------------------------------------------------
bool vtkShadowTags::GetReceiving(vtkProp* prop)
{
  return GetSwitch(prop->GetPropertyKeys(), vtkShadowTags::RECEIVES_SHADOW());
}

//------------------------------------------------------------------------------
void vtkShadowTags::SetShadowCatcher(vtkProp* prop, bool catches)
{
  if (catches == vtkShadowTags::GetShadowCatcher(prop))
  {
    return;
  }
  SetSwitch(prop, vtkShadowTags::SHADOW_CATCHER(), catches);
  if (!catches)
  {
    prop->GetPropertyKeys()->Remove(CatcherChanges::Key());
    return;
  }
  vtkNew<CatcherChanges> changes;
  prop->GetPropertyKeys()->Set(CatcherChanges::Key(), changes);
  vtkShadowTags::ForEachPart(prop,
    [&changes](vtkProp* part, vtkMatrix4x4*)
    {
      if (auto* actor = vtkActor::SafeDownCast(part))
      {
        changes->Change(actor);
      }
    });
}

//------------------------------------------------------------------------------
bool vtkShadowTags::GetShadowCatcher(vtkProp* prop)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  return keys && keys->Has(vtkShadowTags::SHADOW_CATCHER()) &&
         keys->Get(vtkShadowTags::SHADOW_CATCHER()) != 0;
}

//------------------------------------------------------------------------------
void vtkShadowTags::SetLightCasting(vtkLight* light, bool casts)
{
  if (!light->GetInformation())
  {
    vtkNew<vtkInformation> keys;
    light->SetInformation(keys);
  }
  light->GetInformation()->Set(vtkShadowTags::CASTS_SHADOW(), casts ? 1 : 0);
}

//------------------------------------------------------------------------------
bool vtkShadowTags::GetLightCasting(vtkLight* light)
{
  return GetSwitch(light->GetInformation(), vtkShadowTags::CASTS_SHADOW());
}

//------------------------------------------------------------------------------
void vtkShadowTags::SetFilled(vtkLight* light, bool filled)
{
  if (!light->GetInformation())
  {
    vtkNew<vtkInformation> keys;
    light->SetInformation(keys);
  }
  light->GetInformation()->Set(FilledKey(), filled ? 1 : 0);
}

//------------------------------------------------------------------------------
bool vtkShadowTags::GetFilled(vtkLight* light)
{
  vtkInformation* keys = light->GetInformation();
  return keys && keys->Has(FilledKey()) && keys->Get(FilledKey()) != 0;
}

//------------------------------------------------------------------------------
void vtkShadowTags::ForEachPart(
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
