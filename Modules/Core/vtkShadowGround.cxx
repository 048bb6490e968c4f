// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowGround.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShadowLight.h"
#include "vtkShadowTags.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace
{
// Of half the scene's diagonal: as far as the shadow of a corner reaches under a light 25 degrees high.
constexpr double Reach = 2.2;
// Where it begins to fade, as a share of its radius.
constexpr double Fading = 0.4;
// How far it lies below the scene, as a share of half its diagonal: a floor there is not to flicker.
constexpr double Gap = 2e-3;
// Of a catcher: the shadow of a white ground.
constexpr double CatcherOpacity = 0.7;
// What the bounds may change by before it moves, likewise.
constexpr double Slack = 0.05;

/** A disk of radius 1 in the plane z = 0, white, with alpha that falls off smoothly. */
vtkSmartPointer<vtkPolyData> MakeDisk()
{
  constexpr int rings = 24;
  constexpr int sectors = 64;
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> normals;
  normals->SetNumberOfComponents(3);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("fading");
  colors->SetNumberOfComponents(4);
  const auto add = [&](double x, double y, double radius)
  {
    const double t = std::clamp((1.0 - radius) / (1.0 - Fading), 0.0, 1.0);
    const auto alpha = static_cast<unsigned char>(std::lround(255.0 * t * t * (3.0 - 2.0 * t)));
    points->InsertNextPoint(x, y, 0.0);
    normals->InsertNextTuple3(0.0, 0.0, 1.0);
    colors->InsertNextTuple4(255, 255, 255, alpha);
  };
  add(0.0, 0.0, 0.0);
  vtkNew<vtkCellArray> triangles;
  for (int ring = 1; ring <= rings; ++ring)
  {
    const double radius = static_cast<double>(ring) / rings;
    for (int sector = 0; sector < sectors; ++sector)
    {
      const double angle = 2.0 * vtkMath::Pi() * sector / sectors;
      add(radius * std::cos(angle), radius * std::sin(angle), radius);
      const vtkIdType outer = 1 + (ring - 1) * sectors + sector;
      const vtkIdType next = sector + 1 < sectors ? outer + 1 : outer + 1 - sectors;
      if (ring == 1)
      {
        triangles->InsertNextCell({ 0, outer, next });
        continue;
      }
      triangles->InsertNextCell({ outer - sectors, outer, next });
      triangles->InsertNextCell({ outer - sectors, next, next - sectors });
    }
  }
  auto disk = vtkSmartPointer<vtkPolyData>::New();
  disk->SetPoints(points);
  disk->SetPolys(triangles);
  disk->GetPointData()->SetNormals(normals);
  disk->GetPointData()->SetScalars(colors);
  return disk;
}
}

//------------------------------------------------------------------------------
vtkShadowGround::vtkShadowGround()
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(MakeDisk());
  this->Actor->SetMapper(mapper);
  this->Actor->UseBoundsOff(); // cameras are to fit what stands on it
  this->Actor->PickableOff();
  this->Actor->DragableOff();
  vtkProperty* property = this->Actor->GetProperty();
  property->BackfaceCullingOn();
  property->SetInterpolationToPhong();
  property->SetAmbient(0.1); // the key is not right above: together they make it nearly white
  vtkShadowTags::SetCasting(this->Actor, false);
}

//------------------------------------------------------------------------------
void vtkShadowGround::PutOn(vtkRenderer* renderer, const vtkBoundingBox& scene,
  const glm::dvec3& up, bool catches, bool withSSAO)
{
  this->Place(scene, up);
  this->Actor->SetForceOpaque(!withSSAO);
  if (catches != vtkShadowTags::GetShadowCatcher(this->Actor))
  {
    vtkShadowTags::SetShadowCatcher(this->Actor, catches);
    this->Actor->GetProperty()->SetOpacity(catches ? CatcherOpacity : 1.0);
  }
  if (!this->On)
  {
    renderer->AddActor(this->Actor);
    renderer->GetViewProps()->RemoveItem(this->Actor);
    renderer->GetViewProps()->InsertItem(-1, this->Actor); // the first
    this->On = true;
  }
}

//------------------------------------------------------------------------------
void vtkShadowGround::TakeOff(vtkRenderer* renderer)
{
  if (this->On)
  {
    renderer->RemoveActor(this->Actor);
    this->On = false;
  }
}

//------------------------------------------------------------------------------
void vtkShadowGround::Place(const vtkBoundingBox& scene, const glm::dvec3& up)
{
  double middle[3];
  double lengths[3];
  scene.GetCenter(middle);
  scene.GetLengths(lengths);
  const double half = 0.5 * scene.GetDiagonalLength();
  // Up is any direction: the box reaches so far against it.
  double reach = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    reach += 0.5 * lengths[i] * std::abs(up[i]);
  }
  const glm::dvec3 center = glm::make_vec3(middle) - up * (reach + Gap * half);
  const double radius = Reach * half;

  // It stays where it is while the bounds only tremble, but is never above what it lies under.
  const glm::dvec3 moved = center - this->Center;
  const double risen = glm::dot(moved, up);
  const bool stays = this->On && up == this->Up &&
                     std::abs(radius - this->Radius) <= Slack * this->Radius &&
                     risen >= -0.5 * Gap * half && glm::length(moved) <= Slack * half;
  if (stays)
  {
    return;
  }
  this->Up = up;
  this->Center = center;
  this->Radius = radius;
  const glm::dvec3 x = vtkShadowLight::Perpendicular(up);
  const glm::dvec3 y = glm::cross(up, x);
  vtkNew<vtkMatrix4x4> matrix;
  for (int i = 0; i < 3; ++i)
  {
    matrix->SetElement(i, 0, radius * x[i]);
    matrix->SetElement(i, 1, radius * y[i]);
    matrix->SetElement(i, 2, radius * up[i]);
    matrix->SetElement(i, 3, center[i]);
  }
  this->Actor->SetUserMatrix(matrix);
}

//------------------------------------------------------------------------------
void vtkShadowGround::Widen(vtkCamera* camera, double range[2]) const
{
  if (!this->On)
  {
    return;
  }
  const glm::dvec3 forward = glm::make_vec3(camera->GetDirectionOfProjection());
  const double middle = glm::dot(this->Center - glm::make_vec3(camera->GetPosition()), forward);
  const double slope = glm::dot(forward, this->Up);
  const double reach = this->Radius * std::sqrt(std::max(0.0, 1.0 - slope * slope));
  range[1] = std::max(range[1], middle + reach);
  double nearest = middle - reach;
  if (!camera->GetParallelProjection())
  {
    nearest = std::max(nearest, 0.01 * range[1]); // depth buffers divide the range's ends
  }
  range[0] = std::min(range[0], nearest);
}
