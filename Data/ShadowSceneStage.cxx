// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowSceneStage.h"

#include "ShadowSceneMesh.h"
#include "vtkShadowScenes.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkShadowVTKVersion.h"

#include <algorithm>
#include <cmath>

namespace ShadowSceneStage
{
//------------------------------------------------------------------------------
Frame GetFrame(int upAxis)
{
  Frame frame;
  frame.Up = vtkVector3d(0.0, 0.0, 0.0);
  frame.Up[upAxis] = 1.0;
  frame.Right = vtkVector3d(upAxis == 0 ? 0.0 : 1.0, upAxis == 0 ? 1.0 : 0.0, 0.0);
  frame.Front = frame.Right.Cross(frame.Up);
  return frame;
}

//------------------------------------------------------------------------------
vtkActor* AddActor(vtkRenderer* renderer, vtkPolyData* polyData, const Color& color)
{
  if (polyData->GetNumberOfPolys() == 0)
  {
    return nullptr;
  }
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(polyData);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkProperty* property = actor->GetProperty();
  property->SetColor(color.Red, color.Green, color.Blue);
  property->SetAmbient(0.28);
  property->SetDiffuse(0.85);
  property->SetSpecular(0.12);
  property->SetSpecularPower(24.0);
  renderer->AddActor(actor);
  return actor;
}

//------------------------------------------------------------------------------
vtkActor* AddActor(vtkRenderer* renderer, const ShadowSceneMesh& mesh, const Color& color)
{
  return AddActor(renderer, mesh.MakePolyData(), color);
}

//------------------------------------------------------------------------------
void MarkGround(vtkActor* actor)
{
  actor->GetProperty()->SetSpecular(0.0);
  vtkNew<vtkInformation> keys;
  keys->Set(vtkShadowScenes::GROUND(), 1);
  actor->SetPropertyKeys(keys);
}

//------------------------------------------------------------------------------
vtkActor* AddSquare(vtkRenderer* renderer, const vtkVector3d& center, double halfSide, int upAxis)
{
  const Frame frame = GetFrame(upAxis);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  const double corners[4][2] = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } };
  for (const auto& corner : corners)
  {
    // Right, back, up is right-handed.
    const vtkVector3d point =
      center + halfSide * corner[0] * frame.Right - halfSide * corner[1] * frame.Front;
    points->InsertNextPoint(point.GetData());
    normals->InsertNextTuple(frame.Up.GetData());
  }
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({ 0, 1, 2 });
  triangles->InsertNextCell({ 0, 2, 3 });
  vtkNew<vtkPolyData> square;
  square->SetPoints(points);
  square->SetPolys(triangles);
  square->GetPointData()->SetNormals(normals);
  vtkActor* actor = AddActor(renderer, square, Floor);
  MarkGround(actor);
  return actor;
}

//------------------------------------------------------------------------------
vtkActor* AddFloor(vtkRenderer* renderer, double halfSide, double centerX, double centerY)
{
  return AddSquare(renderer, vtkVector3d(centerX, centerY, 0.0), halfSide, 2);
}

//------------------------------------------------------------------------------
static vtkAreaLight* AddAreaLight(
  vtkRenderer* renderer, const vtkVector3d& position, const vtkVector3d& focus)
{
  vtkNew<vtkAreaLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPosition(position[0], position[1], position[2]);
  light->SetFocalPoint(focus[0], focus[1], focus[2]);
  renderer->AddLight(light);
  return light;
}

//------------------------------------------------------------------------------
vtkAreaLight* AddSphereLight(
  vtkRenderer* renderer, const vtkVector3d& position, const vtkVector3d& focus, double radius)
{
  vtkAreaLight* light = AddAreaLight(renderer, position, focus);
  light->SetShapeToSphere();
  light->SetRadius(radius);
  return light;
}

//------------------------------------------------------------------------------
vtkAreaLight* AddDiskLight(
  vtkRenderer* renderer, const vtkVector3d& position, const vtkVector3d& focus, double radius)
{
  vtkAreaLight* light = AddAreaLight(renderer, position, focus);
  light->SetShapeToDisk();
  light->SetRadius(radius);
  return light;
}

//------------------------------------------------------------------------------
vtkAreaLight* AddRectangleLight(vtkRenderer* renderer, const vtkVector3d& position,
  const vtkVector3d& focus, double width, double height)
{
  vtkAreaLight* light = AddAreaLight(renderer, position, focus);
  light->SetShapeToRectangle();
  light->SetWidth(width);
  light->SetHeight(height);
  light->SetUpVector(0.0, 1.0, 0.0);
  return light;
}

//------------------------------------------------------------------------------
void SetCamera(vtkRenderer* renderer, const vtkVector3d& position, const vtkVector3d& focus)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(position[0], position[1], position[2]);
  camera->SetFocalPoint(focus[0], focus[1], focus[2]);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(30.0);
}

//------------------------------------------------------------------------------
void FitCamera(vtkRenderer* renderer, const double bounds[6], const vtkVector3d& direction,
  const vtkVector3d& up, double margin)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  double aspect[2] = { 1.0, 1.0 };
  if (renderer->GetVTKWindow())
  {
    renderer->ComputeAspect();
    renderer->GetAspect(aspect);
  }
  const double tangentY =
    std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle())) / margin;
  const double tangentX = tangentY * aspect[0] / aspect[1];

  const vtkVector3d back = direction.Normalized();
  const vtkVector3d right = up.Cross(back).Normalized();
  const vtkVector3d upright = back.Cross(right);
  const vtkVector3d center(
    0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]), 0.5 * (bounds[4] + bounds[5]));
  double distance = 0.0;
  double halfHeight = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const vtkVector3d arm = vtkVector3d(bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)],
                              bounds[4 + ((corner >> 2) & 1)]) -
                            center;
    const double x = std::abs(arm.Dot(right));
    const double y = std::abs(arm.Dot(upright));
    distance = std::max(distance, arm.Dot(back) + std::max(x / tangentX, y / tangentY));
    halfHeight = std::max({ halfHeight, y, x * aspect[1] / aspect[0] });
  }
  // A single point fits from any distance.
  distance = distance > 0.0 ? distance : 1.0;
  halfHeight = halfHeight > 0.0 ? halfHeight : 1.0;

  const vtkVector3d position = center + distance * back;
  camera->SetFocalPoint(center.GetData());
  camera->SetPosition(position.GetData());
  camera->SetViewUp(up.GetData());
  camera->SetParallelScale(margin * halfHeight);
}
}
