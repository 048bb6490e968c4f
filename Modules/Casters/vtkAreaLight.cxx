// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAreaLight.h"

#include "vtkObjectFactory.h"
#include "vtkTexture.h"

#include <algorithm>

vtkStandardNewMacro(vtkAreaLight);

//------------------------------------------------------------------------------
vtkAreaLight::vtkAreaLight()
{
  this->PositionalOn();
  this->SetConeAngle(90.0);
}

//------------------------------------------------------------------------------
vtkAreaLight::~vtkAreaLight() = default;

//------------------------------------------------------------------------------
const char* vtkAreaLight::GetShapeAsString()
{
  static const char* const names[] = { "point", "sphere", "disk", "rectangle" };
  return names[this->Shape];
}

//------------------------------------------------------------------------------
void vtkAreaLight::SetTexture(vtkTexture* texture)
{
  if (this->Texture != texture)
  {
    this->Texture = texture;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkTexture* vtkAreaLight::GetTexture()
{
  return this->Texture;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkAreaLight::GetMTime()
{
  const vtkMTimeType own = this->Superclass::GetMTime();
  return this->Texture ? std::max(own, this->Texture->GetMTime()) : own;
}

//------------------------------------------------------------------------------
vtkLight* vtkAreaLight::ShallowClone()
{
  vtkAreaLight* clone = vtkAreaLight::New();
  clone->DeepCopy(this);
  clone->SetTransformMatrix(this->GetTransformMatrix());
  clone->SetInformation(this->GetInformation());
  return clone;
}

//------------------------------------------------------------------------------
void vtkAreaLight::DeepCopy(vtkLight* light)
{
  this->Superclass::DeepCopy(light);
  this->CopyArea(light);
}

//------------------------------------------------------------------------------
void vtkAreaLight::CopyArea(vtkLight* light)
{
  if (auto* area = vtkAreaLight::SafeDownCast(light))
  {
    this->SetShape(area->Shape);
    this->SetRadius(area->Radius);
    this->SetWidth(area->Width);
    this->SetHeight(area->Height);
    this->SetUpVector(area->UpVector);
    this->SetAngularDiameter(area->AngularDiameter);
    this->SetTexture(area->Texture);
  }
}

//------------------------------------------------------------------------------
void vtkAreaLight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Shape: " << this->GetShapeAsString() << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "Width: " << this->Width << "\n";
  os << indent << "Height: " << this->Height << "\n";
  os << indent << "UpVector: " << this->UpVector[0] << ", " << this->UpVector[1] << ", "
     << this->UpVector[2] << "\n";
  os << indent << "AngularDiameter: " << this->AngularDiameter << "\n";
  os << indent << "Texture: " << this->Texture.Get() << "\n";
}
