// SPDX-License-Identifier: BSD-3-Clause
#include "ExtremeScene.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCubeSource.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShadowPass.h"
#include "vtkSphereSource.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

//------------------------------------------------------------------------------
ExtremeScene::ExtremeScene(vtkRenderWindow* window, vtkRenderer* renderer)
  : Window(window)
  , Renderer(renderer)
{
  renderer->SetPass(nullptr);
  renderer->RemoveAllViewProps();
  renderer->RemoveAllLights();
  renderer->AutomaticLightCreationOff();
  vtkNew<vtkCamera> camera;
  renderer->SetActiveCamera(camera);
  renderer->SetBackground(0.2, 0.3, 0.4);
}

//------------------------------------------------------------------------------
vtkActor* ExtremeScene::Add(vtkPolyData* polygons)
{
  vtkNew<vtkPolyData> placed;
  placed->DeepCopy(polygons);
  placed->GetPointData()->SetNormals(nullptr); // facets, as they are measured
  vtkNew<vtkPoints> points;
  points->SetDataType(this->Place.Floats ? VTK_FLOAT : VTK_DOUBLE);
  points->SetNumberOfPoints(polygons->GetNumberOfPoints());
  for (vtkIdType i = 0; i < polygons->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 p;
    polygons->GetPoint(i, &p.x);
    p = this->Place.InPoints(p);
    points->SetPoint(i, &p.x);
  }
  placed->SetPoints(points);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(placed);
  mapper->ScalarVisibilityOff();
  if (auto* own = vtkOpenGLPolyDataMapper::SafeDownCast(mapper); own && this->Place.ShiftScale >= 0)
  {
    own->SetVBOShiftScaleMethod(this->Place.ShiftScale);
  }
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetInterpolationToFlat();
  actor->GetProperty()->SetSpecular(0.0);
  const glm::dvec3& scale = this->Place.ActorScale;
  const glm::dvec3& offset = this->Place.ActorOffset;
  if (this->Place.UserMatrix)
  {
    vtkNew<vtkMatrix4x4> matrix;
    for (int i = 0; i < 3; ++i)
    {
      matrix->SetElement(i, i, scale[i]);
      matrix->SetElement(i, 3, offset[i]);
    }
    actor->SetUserMatrix(matrix);
  }
  else
  {
    actor->SetScale(scale.x, scale.y, scale.z);
    actor->SetPosition(offset.x, offset.y, offset.z);
  }
  this->Renderer->AddActor(actor);
  double bounds[6];
  placed->GetBounds(bounds);
  const bool flat = bounds[0] == bounds[1] || bounds[2] == bounds[3] || bounds[4] == bounds[5];
  this->Actors.emplace_back(actor, flat);
  return actor;
}

//------------------------------------------------------------------------------
vtkActor* ExtremeScene::AddQuad(const glm::dvec3& corner, const glm::dvec3& a, const glm::dvec3& b)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const glm::dvec3& p : { corner, corner + a, corner + a + b, corner + b })
  {
    points->InsertNextPoint(&p.x);
  }
  vtkNew<vtkCellArray> triangles;
  triangles->InsertNextCell({ 0, 1, 2 });
  triangles->InsertNextCell({ 0, 2, 3 });
  vtkNew<vtkPolyData> polygons;
  polygons->SetPoints(points);
  polygons->SetPolys(triangles);
  return this->Add(polygons);
}

//------------------------------------------------------------------------------
vtkActor* ExtremeScene::AddFloor(double halfSide, double height)
{
  return this->AddQuad(
    { -halfSide, -halfSide, height }, { 2.0 * halfSide, 0.0, 0.0 }, { 0.0, 2.0 * halfSide, 0.0 });
}

//------------------------------------------------------------------------------
vtkActor* ExtremeScene::AddBox(const glm::dvec3& centre, const glm::dvec3& size)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  cube->SetCenter(centre.x, centre.y, centre.z);
  cube->SetXLength(size.x);
  cube->SetYLength(size.y);
  cube->SetZLength(size.z);
  cube->Update();
  return this->Add(cube->GetOutput());
}

//------------------------------------------------------------------------------
vtkActor* ExtremeScene::AddSphere(const glm::dvec3& centre, double radius, int resolution)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->SetCenter(centre.x, centre.y, centre.z);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(resolution);
  sphere->SetPhiResolution(resolution);
  sphere->Update();
  return this->Add(sphere->GetOutput());
}

//------------------------------------------------------------------------------
vtkAreaLight* ExtremeScene::AddLight(
  Shape shape, const glm::dvec3& position, const glm::dvec3& focus)
{
  vtkNew<vtkAreaLight> light;
  light->SetLightTypeToSceneLight();
  const glm::dvec3 p = this->Place(position);
  const glm::dvec3 f = this->Place(focus);
  const double unit = this->Place.GetUnit();
  light->SetPosition(p.x, p.y, p.z);
  light->SetFocalPoint(f.x, f.y, f.z);
  light->SetUpVector(0.0, 1.0, 0.0);
  light->SetRadius(0.5 * unit);
  light->SetWidth(1.2 * unit);
  light->SetHeight(0.8 * unit);
  switch (shape)
  {
    case Shape::Sphere:
      light->SetShapeToSphere();
      break;
    case Shape::Disk:
      light->SetShapeToDisk();
      break;
    case Shape::Rectangle:
      light->SetShapeToRectangle();
      break;
    case Shape::Directional:
      light->PositionalOff();
      light->SetAngularDiameter(8.0);
      break;
    default:
      light->SetShapeToPoint();
  }
  this->Renderer->AddLight(light);
  this->Lights.push_back(light);
  return light;
}

//------------------------------------------------------------------------------
void ExtremeScene::LookAt(const glm::dvec3& position, const glm::dvec3& focus, double viewAngle)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const glm::dvec3 p = this->Place(position);
  const glm::dvec3 f = this->Place(focus);
  camera->SetPosition(p.x, p.y, p.z);
  camera->SetFocalPoint(f.x, f.y, f.z);
  camera->SetViewUp(0.0, 0.0, 1.0);
  camera->SetViewAngle(viewAngle);
  const double distance = glm::length(p - f);
  camera->SetClippingRange(0.05 * distance, 4.0 * distance);
}

//------------------------------------------------------------------------------
void ExtremeScene::AddThings()
{
  this->AddFloor();
  this->AddBox({ -0.8, 0.3, 0.6 }, { 1.0, 1.0, 1.2 });
  this->AddSphere({ 0.9, -0.5, 1.3 }, 0.6);
  this->AddBox({ 0.3, 1.6, 1.0 }, { 0.1, 0.1, 2.0 });
  this->LookAt({ 3.5, -6.5, 4.5 }, { 0.2, 0.2, 0.3 });
}

//------------------------------------------------------------------------------
void ExtremeScene::MakeLightsPoints(bool points)
{
  if (points)
  {
    this->Sizes.clear();
  }
  for (std::size_t i = 0; i < this->Lights.size(); ++i)
  {
    vtkAreaLight* light = this->Lights[i];
    if (points)
    {
      this->Sizes.push_back(
        { light->GetRadius(), light->GetWidth(), light->GetHeight(), light->GetAngularDiameter() });
    }
    const Size size = points ? Size{} : this->Sizes[i];
    light->SetRadius(size.Radius);
    light->SetWidth(size.Width);
    light->SetHeight(size.Height);
    light->SetAngularDiameter(size.Angle);
  }
}

//------------------------------------------------------------------------------
glm::dvec3 ExtremeScene::FindFloor(double x, double y) const
{
  vtkNew<vtkMatrix4x4> toWorld;
  toWorld->DeepCopy(this->Renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
    this->Renderer->GetTiledAspectRatio(), -1.0, 1.0));
  toWorld->Invert();
  glm::dvec3 ends[2];
  for (int i = 0; i < 2; ++i)
  {
    const double clip[4] = { 2.0 * x - 1.0, 2.0 * y - 1.0, i == 0 ? -1.0 : 1.0, 1.0 };
    double p[4];
    toWorld->MultiplyPoint(clip, p);
    ends[i] = glm::dvec3(p[0], p[1], p[2]) / p[3];
  }
  return glm::mix(ends[0], ends[1], ends[0].z / (ends[0].z - ends[1].z));
}

//------------------------------------------------------------------------------
void ExtremeScene::LetBodiesReceive(bool receive)
{
  for (const auto& [actor, flat] : this->Actors)
  {
    if (!flat)
    {
      vtkShadowPass::SetReceiving(actor, receive);
    }
  }
}
