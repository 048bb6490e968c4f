// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowStudio.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCommand.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkShadowGround.h"
#include "vtkShadowLight.h"
#include "vtkShadowNumber.h"
#include "vtkShadowPass.h"
#include "vtkShadowTags.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkShadowStudio);

namespace
{
/** In a renderer's information. */
vtkInformationObjectBaseKey* StudioKey()
{
  static auto* key = vtkInformationObjectBaseKey::MakeKey("STUDIO", "vtkShadowStudio");
  return key;
}

/** What is shown and stands on a ground: surfaces, volumes, images; no axes and other annotation. */
vtkBoundingBox GetSceneBounds(vtkRenderer* renderer, vtkProp* without)
{
  vtkBoundingBox box;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator cookie;
  props->InitTraversal(cookie);
  while (vtkProp* prop = props->GetNextProp(cookie))
  {
    if (prop == without || !prop->GetVisibility() || !prop->GetUseBounds())
    {
      continue;
    }
    bool drawn = false;
    vtkShadowTags::ForEachPart(prop,
      [&](vtkProp* part, vtkMatrix4x4*)
      {
        auto* actor = vtkActor::SafeDownCast(part);
        drawn = drawn || (actor && actor->GetMapper()) || part->IsA("vtkVolume") ||
                part->IsA("vtkImageSlice");
      });
    const double* bounds = drawn ? prop->GetBounds() : nullptr;
    if (bounds && vtkMath::AreBoundsInitialized(bounds) &&
        std::all_of(bounds, bounds + 6, [](double value) { return std::isfinite(value); }))
    {
      box.AddBounds(bounds);
    }
  }
  return box;
}

/** The axis that is nearest to a direction, with its sign. */
glm::dvec3 GetNearestAxis(const double direction[3])
{
  int axis = 0;
  for (int i = 1; i < 3; ++i)
  {
    axis = std::abs(direction[i]) > std::abs(direction[axis]) ? i : axis;
  }
  glm::dvec3 result(0.0);
  result[axis] = direction[axis] < 0.0 ? -1.0 : 1.0;
  return result;
}

double GetDarknessOfPass(vtkRenderer* renderer)
{
  vtkShadowPass* pass = vtkShadowPass::FindOn(renderer);
  const bool has = pass && !pass->GetTechnique().empty();
  return has ? vtkShadowNumber::Parse(pass->GetParameter("darkness")).value_or(1.0) : 1.0;
}
}

class vtkShadowStudio::Internals
{
public:
  vtkWeakPointer<vtkRenderer> Renderer;
  vtkNew<vtkAreaLight> Key;
  vtkNew<vtkLight> Fill;
  vtkNew<vtkLight> Side;
  vtkShadowGround Ground;
  std::vector<vtkWeakPointer<vtkLight>> SwitchedOff;
  unsigned long Observers[2] = { 0, 0 };

  bool Aimed = false;
  glm::dvec3 Up{ 0.0, 0.0, 1.0 };

  // The renderer's own settings of SSAO, while they are ours.
  struct
  {
    bool SSAO, Blur;
    double Radius, Bias;
  } Before{};
  bool Shading = false;

  // The clipping range that the camera had, and that it was given.
  vtkWeakPointer<vtkCamera> Widened;
  double RangeBefore[2] = { 0.0, 0.0 };
  double RangeGiven[2] = { 0.0, 0.0 };
};

//------------------------------------------------------------------------------
vtkShadowStudio::vtkShadowStudio()
  : Internal(new Internals)
{
  Internals& my = *this->Internal;
  my.Key->PositionalOff();
  my.Fill->SetLightTypeToHeadlight();
  my.Side->SetLightTypeToCameraLight();
  vtkShadowTags::SetLightCasting(my.Fill, false);
  vtkShadowTags::SetLightCasting(my.Side, false);
  vtkShadowTags::SetFilled(my.Key, true);
}

//------------------------------------------------------------------------------
vtkShadowStudio::~vtkShadowStudio()
{
  this->Detach();
}

//------------------------------------------------------------------------------
vtkShadowStudio* vtkShadowStudio::FindOn(vtkRenderer* renderer)
{
  vtkInformation* keys = renderer ? renderer->GetInformation() : nullptr;
  return keys ? vtkShadowStudio::SafeDownCast(keys->Get(StudioKey())) : nullptr;
}

//------------------------------------------------------------------------------
void vtkShadowStudio::TakeOff(vtkRenderer* renderer)
{
  if (vtkSmartPointer<vtkShadowStudio> studio = vtkShadowStudio::FindOn(renderer))
  {
    studio->Detach();
  }
}

//------------------------------------------------------------------------------
void vtkShadowStudio::PutOn(vtkRenderer* renderer)
{
  if (!renderer)
  {
    vtkErrorMacro("PutOn: there is no renderer.");
    return;
  }
  Internals& my = *this->Internal;
  if (my.Renderer == renderer)
  {
    return;
  }
  const vtkSmartPointer<vtkShadowStudio> kept = this; // the renderer before may hold it alone
  this->Detach();
  vtkShadowStudio::TakeOff(renderer);
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator cookie;
  lights->InitTraversal(cookie);
  while (vtkLight* light = lights->GetNextLight(cookie))
  {
    if (light->GetSwitch())
    {
      light->SwitchOff();
      my.SwitchedOff.emplace_back(light);
    }
  }
  renderer->AddLight(my.Key);
  renderer->AddLight(my.Fill);
  renderer->AddLight(my.Side);
  my.Renderer = renderer;
  my.Aimed = false;
  my.Observers[0] = renderer->AddObserver(vtkCommand::StartEvent, this, &vtkShadowStudio::Update);
  my.Observers[1] = renderer->AddObserver(
    vtkCommand::ResetCameraClippingRangeEvent, this, &vtkShadowStudio::WidenClippingRange);
  if (!renderer->GetInformation())
  {
    vtkNew<vtkInformation> keys;
    renderer->SetInformation(keys);
  }
  renderer->GetInformation()->Set(StudioKey(), this);
}

//------------------------------------------------------------------------------
void vtkShadowStudio::Detach()
{
  Internals& my = *this->Internal;
  vtkRenderer* renderer = my.Renderer;
  my.Renderer = nullptr;
  if (!renderer)
  {
    my.SwitchedOff.clear();
    return;
  }
  for (const unsigned long observer : my.Observers)
  {
    renderer->RemoveObserver(observer);
  }
  renderer->RemoveLight(my.Key);
  renderer->RemoveLight(my.Fill);
  renderer->RemoveLight(my.Side);
  my.Ground.TakeOff(renderer);
  for (vtkLight* light : my.SwitchedOff)
  {
    if (light)
    {
      light->SwitchOn();
    }
  }
  my.SwitchedOff.clear();
  if (my.Shading)
  {
    my.Renderer = renderer;
    this->EndContactShading();
    my.Renderer = nullptr;
  }
  if (my.Widened && std::equal(my.RangeGiven, my.RangeGiven + 2, my.Widened->GetClippingRange()))
  {
    my.Widened->SetClippingRange(my.RangeBefore);
  }
  my.Widened = nullptr;
  // It may hold this for the last time.
  if (renderer->GetInformation()->Get(StudioKey()) == this)
  {
    renderer->GetInformation()->Remove(StudioKey());
  }
}

//------------------------------------------------------------------------------
void vtkShadowStudio::Aim()
{
  this->Internal->Aimed = false;
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkShadowStudio::AimNow()
{
  if (this->Internal->Renderer)
  {
    this->AimAtCamera();
    this->Internal->Aimed = true;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
// Before each frame.
void vtkShadowStudio::Update()
{
  Internals& my = *this->Internal;
  vtkRenderer* renderer = my.Renderer;
  const vtkBoundingBox scene = GetSceneBounds(renderer, my.Ground.GetActor());
  if (!my.Aimed || this->FollowCamera)
  {
    this->AimAtCamera();
    my.Aimed = scene.IsValid();
  }
  this->UpdateLights();
  if (this->Ground != None && scene.IsValid())
  {
    const bool before = my.Ground.IsOn();
    my.Ground.PutOn(renderer, scene, my.Up, this->Ground == Catcher, this->ContactShading);
    if (!before)
    {
      this->WidenClippingRange();
    }
  }
  else
  {
    my.Ground.TakeOff(renderer);
  }
  this->UpdateContactShading(scene.IsValid() ? 0.5 * scene.GetDiagonalLength() : 0.0);
}

//------------------------------------------------------------------------------
void vtkShadowStudio::AimAtCamera()
{
  Internals& my = *this->Internal;
  vtkCamera* camera = my.Renderer->GetActiveCamera();
  const glm::dvec3 given = glm::make_vec3(this->UpVector);
  my.Up = glm::length(given) > 0.0 ? glm::normalize(given) : GetNearestAxis(camera->GetViewUp());
  // Level with the ground, towards the camera; from right above, the picture's lower edge is in front.
  const glm::dvec3 toCamera = -glm::make_vec3(camera->GetDirectionOfProjection());
  glm::dvec3 front = toCamera - my.Up * glm::dot(toCamera, my.Up);
  if (glm::length(front) < 1e-3)
  {
    const glm::dvec3 viewUp = glm::make_vec3(camera->GetViewUp());
    front = my.Up * glm::dot(viewUp, my.Up) - viewUp;
  }
  front = glm::length(front) > 0.0 ? glm::normalize(front) : vtkShadowLight::Perpendicular(my.Up);
  const glm::dvec3 right = glm::cross(my.Up, front);
  const double elevation = vtkMath::RadiansFromDegrees(this->Elevation);
  const double azimuth = vtkMath::RadiansFromDegrees(this->Azimuth);
  const glm::dvec3 level = front * std::cos(azimuth) + right * std::sin(azimuth);
  glm::dvec3 toKey = my.Up * std::sin(elevation) + level * std::cos(elevation);
  my.Key->SetPosition(glm::value_ptr(toKey));
  my.Key->SetFocalPoint(0.0, 0.0, 0.0);
}

//------------------------------------------------------------------------------
void vtkShadowStudio::UpdateLights()
{
  Internals& my = *this->Internal;
  my.Key->SetAngularDiameter(2.0 * vtkMath::DegreesFromRadians(std::atan(this->Softness / 3.0)));
  vtkCamera* camera = my.Renderer->GetActiveCamera();
  const glm::dvec3 toKey =
    glm::make_vec3(my.Key->GetPosition()) - glm::make_vec3(my.Key->GetFocalPoint());
  const glm::dvec3 toCamera = -glm::make_vec3(camera->GetDirectionOfProjection());
  const glm::dvec3 right = glm::cross(glm::make_vec3(camera->GetViewUp()), toCamera);
  const double lies = glm::dot(toKey, right) > 0.0 ? -1.0 : 1.0; // the key on the other side
  // The fills' directions have a cosine of a third: three quarters of a light from each make the whole of it
  // on what faces either, and 1.22 of it between them.
  constexpr double cosine = 1.0 / 3.0;
  const double sine = std::sqrt(1.0 - cosine * cosine);
  const double share = 1.0 / (1.0 + cosine);
  const double most = 1.0 / (share * std::sqrt(2.0 + 2.0 * cosine));
  const double fill = std::min(1.0 - this->Darkness * GetDarknessOfPass(my.Renderer), most) * share;
  const glm::dvec3 side =
    cosine * toCamera + lies * sine * (glm::length(right) > 0.0 ? glm::normalize(right) : right);
  my.Side->SetPosition(lies * sine, 0.0, cosine);
  my.Side->SetFocalPoint(0.0, 0.0, 0.0);
  my.Fill->SetIntensity(fill);
  my.Side->SetIntensity(fill);

  // |k key + fills| is the brightest that a surface gets that these lights reach, whatever way it faces: it is
  // to be 1. What the camera does not see may be brighter.
  double key = 1.0;
  for (const glm::dvec3& fills : { fill * toCamera, fill * (toCamera + side) })
  {
    const double along = std::max(0.0, glm::dot(fills, toKey));
    const double across2 = glm::dot(fills, fills) - along * along;
    key = std::min(key, std::sqrt(std::max(0.0, 1.0 - across2)) - along);
  }
  my.Key->SetIntensity(std::max(0.0, key));
}

//------------------------------------------------------------------------------
void vtkShadowStudio::UpdateContactShading(double size)
{
  Internals& my = *this->Internal;
  vtkRenderer* renderer = my.Renderer;
  const bool shading = this->ContactShading && size > 0.0;
  if (shading && !my.Shading)
  {
    my.Before = { renderer->GetUseSSAO(), renderer->GetSSAOBlur(), renderer->GetSSAORadius(),
      renderer->GetSSAOBias() };
    renderer->UseSSAOOn();
    renderer->SSAOBlurOn();
  }
  else if (!shading && my.Shading)
  {
    this->EndContactShading();
  }
  my.Shading = shading;
  if (shading)
  {
    renderer->SetSSAORadius(0.15 * size);
    renderer->SetSSAOBias(0.003 * size);
  }
}

//------------------------------------------------------------------------------
void vtkShadowStudio::EndContactShading()
{
  Internals& my = *this->Internal;
  vtkRenderer* renderer = my.Renderer;
  renderer->SetUseSSAO(my.Before.SSAO);
  renderer->SetSSAOBlur(my.Before.Blur);
  renderer->SetSSAORadius(my.Before.Radius);
  renderer->SetSSAOBias(my.Before.Bias);
  my.Shading = false;
}

//------------------------------------------------------------------------------
// The ground is not part of the bounds that a camera's range is made for.
void vtkShadowStudio::WidenClippingRange()
{
  Internals& my = *this->Internal;
  vtkCamera* camera = my.Renderer->GetActiveCamera();
  double range[2];
  camera->GetClippingRange(range);
  const double before[2] = { range[0], range[1] };
  my.Ground.Widen(camera, range);
  if (range[0] < before[0] || range[1] > before[1])
  {
    camera->SetClippingRange(range);
    my.Widened = camera;
    std::copy_n(before, 2, my.RangeBefore);
    camera->GetClippingRange(my.RangeGiven);
  }
}

//------------------------------------------------------------------------------
vtkAreaLight* vtkShadowStudio::GetKeyLight()
{
  return this->Internal->Key;
}

//------------------------------------------------------------------------------
vtkLight* vtkShadowStudio::GetFillLight()
{
  return this->Internal->Fill;
}

//------------------------------------------------------------------------------
vtkLight* vtkShadowStudio::GetSideLight()
{
  return this->Internal->Side;
}

//------------------------------------------------------------------------------
vtkActor* vtkShadowStudio::GetGroundActor()
{
  return this->Internal->Ground.GetActor();
}

//------------------------------------------------------------------------------
void vtkShadowStudio::PrintSelf(ostream& os, vtkIndent indent)
{
  static const char* const grounds[] = { "none", "catcher", "solid" };
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Softness: " << this->Softness << "\n";
  os << indent << "Darkness: " << this->Darkness << "\n";
  os << indent << "Elevation: " << this->Elevation << "\n";
  os << indent << "Azimuth: " << this->Azimuth << "\n";
  os << indent << "FollowCamera: " << this->FollowCamera << "\n";
  os << indent << "UpVector: " << this->UpVector[0] << ", " << this->UpVector[1] << ", "
     << this->UpVector[2] << "\n";
  os << indent << "Ground: " << grounds[this->Ground] << "\n";
  os << indent << "ContactShading: " << this->ContactShading << "\n";
}
