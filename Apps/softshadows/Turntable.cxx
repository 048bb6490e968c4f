// SPDX-License-Identifier: BSD-3-Clause
#include "Turntable.h"

#include "vtkBoundingBox.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkNew.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkShadowScenes.h"
#include "vtkShadowTags.h"
#include "vtkTransform.h"

//------------------------------------------------------------------------------
Turntable::Turntable(vtkRenderer* renderer, int axis)
  : Axis(axis)
{
  vtkBoundingBox box;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    auto* solid = vtkProp3D::SafeDownCast(prop);
    vtkInformation* keys = prop->GetPropertyKeys();
    if (!solid || !solid->GetUseBounds() || (keys && keys->Has(vtkShadowScenes::GROUND())))
    {
      continue;
    }
    if (const double* bounds = solid->GetBounds())
    {
      box.AddBounds(bounds);
    }
    auto before = vtkSmartPointer<vtkMatrix4x4>::New();
    if (solid->GetUserMatrix())
    {
      before->DeepCopy(solid->GetUserMatrix());
    }
    this->Props.emplace_back(solid, before);
  }
  if (box.IsValid())
  {
    box.GetCenter(this->Middle);
    this->Size = box.GetDiagonalLength();
  }
}

//------------------------------------------------------------------------------
void Turntable::SetAngle(double degrees)
{
  vtkNew<vtkTransform> turn;
  turn->Translate(this->Middle);
  turn->RotateWXYZ(degrees, this->Axis == 0, this->Axis == 1, this->Axis == 2);
  turn->Translate(-this->Middle[0], -this->Middle[1], -this->Middle[2]);
  for (const auto& [prop, before] : this->Props)
  {
    vtkNew<vtkMatrix4x4> matrix;
    vtkMatrix4x4::Multiply4x4(turn->GetMatrix(), before, matrix);
    prop->SetUserMatrix(matrix);
  }
}
