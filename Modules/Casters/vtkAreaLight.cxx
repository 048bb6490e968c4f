// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAreaLight.h"

#include "vtkBoundingBox.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkTexture.h"

#include <algorithm>
#include <cmath>

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
void vtkAreaLight::SetLength(const char* name, double& length, double value)
{
  if (!(value >= 0.0)) // nor NaN
  {
    vtkErrorMacro(<< name << " is zero or more, not " << value << "; it stays " << length << ".");
    return;
  }
  this->Placed = true;
  if (length != value)
  {
    length = value;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkAreaLight::SetRadius(double radius)
{
  this->SetLength("Radius", this->Radius, radius);
}

//------------------------------------------------------------------------------
void vtkAreaLight::SetWidth(double width)
{
  this->SetLength("Width", this->Width, width);
}

//------------------------------------------------------------------------------
void vtkAreaLight::SetHeight(double height)
{
  this->SetLength("Height", this->Height, height);
}

//------------------------------------------------------------------------------
void vtkAreaLight::SetAngularDiameter(double angle)
{
  this->SetLength("AngularDiameter", this->AngularDiameter, std::min(angle, 90.0));
}

//------------------------------------------------------------------------------
void vtkAreaLight::SetPosition(double x, double y, double z)
{
  this->Placed = true;
  this->Superclass::SetPosition(x, y, z);
}

//------------------------------------------------------------------------------
void vtkAreaLight::SetFocalPoint(double x, double y, double z)
{
  this->Placed = true;
  this->Superclass::SetFocalPoint(x, y, z);
}

//------------------------------------------------------------------------------
void vtkAreaLight::FitTo(const double bounds[6], double softness)
{
  const vtkBoundingBox box(bounds);
  if (!box.IsValid() || !std::isfinite(box.GetDiagonalLength()) || !(softness >= 0.0))
  {
    return;
  }
  double away[3];
  vtkMath::Subtract(this->Position, this->FocalPoint, away);
  if (!this->Placed || !(vtkMath::Normalize(away) > 0.0))
  {
    const double aboveLeft[3] = { -0.5, 0.7, 0.5 };
    std::copy_n(aboveLeft, 3, away);
    vtkMath::Normalize(away);
  }
  const double diagonal = box.GetDiagonalLength();
  double middle[3];
  box.GetCenter(middle);
  vtkMath::MultiplyScalar(away, 1.5 * diagonal);
  this->SetFocalPoint(middle[0], middle[1], middle[2]);
  this->SetPosition(middle[0] + away[0], middle[1] + away[1], middle[2] + away[2]);
  this->SetRadius(0.5 * softness * diagonal);
  this->SetWidth(softness * diagonal);
  this->SetHeight(softness * diagonal);
  this->SetAngularDiameter(2.0 * vtkMath::DegreesFromRadians(std::atan(softness / 3.0)));
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
    this->Placed = area->Placed;
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
  os << indent << "Placed: " << this->Placed << "\n";
  os << indent << "Texture: " << this->Texture.Get() << "\n";
}
