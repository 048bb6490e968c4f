// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowStage.h"

#include "ShadowTest.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCubeSource.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShadowOpenGL.h"
#include "vtkShadowTechniques.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace
{
void GLAPIENTRY ReportGL(
  GLenum, GLenum type, GLuint, GLenum severity, GLsizei, const GLchar* text, const void*)
{
  if (type == GL_DEBUG_TYPE_ERROR || severity == GL_DEBUG_SEVERITY_HIGH)
  {
    ShadowTest::AddMessage(ShadowTest::Message::GL, text);
  }
}
}

//------------------------------------------------------------------------------
const char* GetName(LightKind kind)
{
  static const char* const names[] = { "point", "sphere", "disk", "rectangle", "directional",
    "spot" };
  return names[static_cast<int>(kind)];
}

//------------------------------------------------------------------------------
ShadowStage::ShadowStage(int width, int height, const Placement& place)
  : Place(place)
{
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(width, height);
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->AutomaticLightCreationOff();
  this->Renderer->SetBackground(0.2, 0.3, 0.4);
  vtkOpenGLRenderWindow::SafeDownCast(this->Window)->Initialize();
  if (ShadowTest::Check(glDebugMessageCallback != nullptr, "the context has no KHR_debug"))
  {
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(ReportGL, nullptr);
  }
}

//------------------------------------------------------------------------------
ShadowStage::~ShadowStage()
{
  this->Renderer->SetPass(nullptr);
  this->Pass = nullptr;
  this->Window->Finalize();
}

//------------------------------------------------------------------------------
vtkActor* ShadowStage::Add(vtkPolyData* polygons, const glm::dvec3& color)
{
  vtkNew<vtkPolyData> placed;
  placed->DeepCopy(polygons);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < polygons->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 p;
    polygons->GetPoint(i, &p.x);
    p = this->Place.ByActor ? p : this->Place(p);
    points->InsertNextPoint(&p.x);
  }
  placed->SetPoints(points);
  if (vtkDataArray* normals = placed->GetPointData()->GetNormals())
  {
    for (vtkIdType i = 0; !this->Place.ByActor && i < normals->GetNumberOfTuples(); ++i)
    {
      glm::dvec3 n;
      normals->GetTuple(i, &n.x);
      n = this->Place.Turn * n;
      normals->SetTuple(i, &n.x);
    }
  }
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(placed);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color.x, color.y, color.z);
  actor->GetProperty()->SetAmbient(0.2);
  actor->GetProperty()->SetDiffuse(0.8);
  actor->GetProperty()->SetSpecular(0.0);
  if (this->Place.ByActor)
  {
    vtkNew<vtkMatrix4x4> matrix;
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        matrix->SetElement(row, column, this->Place.Scale * this->Place.Turn[column][row]);
      }
    }
    actor->SetUserMatrix(matrix);
    // Moved as users do: by the actor's position, which the user matrix comes after.
    glm::dvec3 offset = glm::transpose(this->Place.Turn) * this->Place.Offset / this->Place.Scale;
    actor->SetPosition(&offset.x);
  }
  this->Renderer->AddActor(actor);
  return actor;
}

//------------------------------------------------------------------------------
vtkActor* ShadowStage::AddQuad(const glm::dvec3& corner, const glm::dvec3& a, const glm::dvec3& b)
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
vtkActor* ShadowStage::AddFloor(double halfSide, double height)
{
  return this->AddQuad(
    { -halfSide, -halfSide, height }, { 2.0 * halfSide, 0.0, 0.0 }, { 0.0, 2.0 * halfSide, 0.0 });
}

//------------------------------------------------------------------------------
vtkActor* ShadowStage::AddBox(const glm::dvec3& centre, const glm::dvec3& size)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  cube->SetCenter(centre.x, centre.y, centre.z);
  cube->SetXLength(size.x);
  cube->SetYLength(size.y);
  cube->SetZLength(size.z);
  cube->Update();
  return this->Add(cube->GetOutput(), { 0.8, 0.5, 0.4 });
}

//------------------------------------------------------------------------------
vtkActor* ShadowStage::AddSphere(const glm::dvec3& centre, double radius, int resolution)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->SetCenter(centre.x, centre.y, centre.z);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(resolution);
  sphere->SetPhiResolution(resolution);
  sphere->Update();
  return this->Add(sphere->GetOutput(), { 0.4, 0.6, 0.8 });
}

//------------------------------------------------------------------------------
vtkAreaLight* ShadowStage::AddLight(LightKind kind)
{
  return this->AddLight(kind, { -2.5, -2.0, 5.5 }, { 0.0, 0.0, 0.0 });
}

//------------------------------------------------------------------------------
vtkAreaLight* ShadowStage::AddLight(
  LightKind kind, const glm::dvec3& position, const glm::dvec3& focus)
{
  vtkNew<vtkAreaLight> light;
  light->SetLightTypeToSceneLight();
  const glm::dvec3 p = this->Place(position);
  const glm::dvec3 f = this->Place(focus);
  const glm::dvec3 up = this->Place.Turn * glm::dvec3(0.0, 1.0, 0.0);
  light->SetPosition(p.x, p.y, p.z);
  light->SetFocalPoint(f.x, f.y, f.z);
  light->SetUpVector(up.x, up.y, up.z);
  light->SetRadius(0.5 * this->Place.Scale);
  light->SetWidth(1.2 * this->Place.Scale);
  light->SetHeight(0.8 * this->Place.Scale);
  switch (kind)
  {
    case LightKind::Sphere:
      light->SetShapeToSphere();
      break;
    case LightKind::Disk:
      light->SetShapeToDisk();
      break;
    case LightKind::Rectangle:
      light->SetShapeToRectangle();
      break;
    case LightKind::Directional:
      light->PositionalOff();
      light->SetAngularDiameter(8.0);
      break;
    case LightKind::Spot:
      light->SetShapeToPoint();
      light->SetConeAngle(30.0);
      break;
    default:
      light->SetShapeToPoint();
  }
  this->Renderer->AddLight(light);
  return light;
}

//------------------------------------------------------------------------------
vtkLight* ShadowStage::AddPlainLight(bool positional, const glm::dvec3& position)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPositional(positional);
  light->SetConeAngle(180.0);
  light->SetPosition(position.x, position.y, position.z);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  this->Renderer->AddLight(light);
  return light;
}

//------------------------------------------------------------------------------
void ShadowStage::Shrink(vtkAreaLight* light, double factor)
{
  light->SetRadius(factor * light->GetRadius());
  light->SetWidth(factor * light->GetWidth());
  light->SetHeight(factor * light->GetHeight());
  light->SetAngularDiameter(factor * light->GetAngularDiameter());
}

//------------------------------------------------------------------------------
void ShadowStage::LookAt(const glm::dvec3& position, const glm::dvec3& focus, double viewAngle)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const glm::dvec3 p = this->Place(position);
  const glm::dvec3 f = this->Place(focus);
  const glm::dvec3 up = this->Place.Turn * glm::dvec3(0.0, 0.0, 1.0);
  camera->SetPosition(p.x, p.y, p.z);
  camera->SetFocalPoint(f.x, f.y, f.z);
  camera->SetViewUp(up.x, up.y, up.z);
  camera->SetViewAngle(viewAngle);
  // Wide enough for all scenes here; ResetCameraClippingRange would look at bounds that are NaN.
  const double distance = glm::length(p - f);
  camera->SetClippingRange(0.05 * distance, 4.0 * distance);
}

//------------------------------------------------------------------------------
vtkActor* ShadowStage::AddThings()
{
  this->AddFloor();
  vtkActor* box = this->AddBox({ -0.8, 0.3, 0.6 }, { 1.0, 1.0, 1.2 });
  this->AddSphere({ 0.9, -0.5, 1.3 }, 0.6);
  this->AddBox({ 0.3, 1.6, 1.0 }, { 0.1, 0.1, 2.0 });
  this->LookAt({ 3.5, -6.5, 4.5 }, { 0.2, 0.2, 0.3 });
  return box;
}

//------------------------------------------------------------------------------
vtkShadowPass* ShadowStage::SetPass(const std::string& technique, const Parameters& parameters)
{
  // Laws and closed forms are those of the geometry as it is.
  Parameters all = { { "samples", "16" }, { "resolution", "256" }, { "terminator", "facets" },
    { "antialias", "off" } };
  for (const auto& parameter : parameters)
  {
    all[parameter.first] = parameter.second;
  }
  this->Pass.TakeReference(vtkShadowTechniques::Create(technique));
  for (const auto& parameter : all)
  {
    if (ShadowStage::HasParameter(technique, parameter.first))
    {
      ShadowTest::Check(this->Pass->SetParameter(parameter.first, parameter.second),
        technique + " does not take " + parameter.first + " = " + parameter.second);
    }
  }
  this->Renderer->SetPass(this->Pass);
  return this->Pass;
}

//------------------------------------------------------------------------------
bool ShadowStage::HasParameter(const std::string& technique, const std::string& name)
{
  const auto has = [&](const std::vector<vtkShadowParameter>& list)
  {
    return std::any_of(
      list.begin(), list.end(), [&](const vtkShadowParameter& p) { return p.Name == name; });
  };
  return has(ShadowStage::Describe(technique).Parameters) || has(vtkShadowParameter::GetCommon());
}

//------------------------------------------------------------------------------
bool ShadowStage::Supports(const std::string& technique, LightKind kind)
{
  const int shape = kind == LightKind::Spot ? 0 : static_cast<int>(kind);
  return ShadowStage::Describe(technique).LightShapes[shape] != vtkShadowShapeSupport::Unsupported;
}

//------------------------------------------------------------------------------
const vtkShadowDeclaration& ShadowStage::Describe(const std::string& technique)
{
  return *vtkShadowTechniqueRegistration::Find(technique);
}

//------------------------------------------------------------------------------
void ShadowStage::Render()
{
  this->Window->Render();
}

//------------------------------------------------------------------------------
static Visibility Take(vtkImageData* image)
{
  Visibility result;
  if (!ShadowTest::Check(image != nullptr, "there is no visibility"))
  {
    return result;
  }
  int size[3];
  image->GetDimensions(size);
  result.Width = size[0];
  result.Height = size[1];
  vtkDataArray* values = image->GetPointData()->GetArray("Visibility");
  vtkDataArray* mask = image->GetPointData()->GetArray("Receiver");
  if (!ShadowTest::Check(values && mask && values->GetDataType() == VTK_FLOAT,
        "Visibility and Receiver are not what GetVisibility promises"))
  {
    return result;
  }
  result.Components = values->GetNumberOfComponents();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < result.Components; ++c)
    {
      result.V.push_back(static_cast<float>(values->GetComponent(i, c)));
    }
    result.Mask.push_back(static_cast<unsigned char>(mask->GetTuple1(i)));
  }
  return result;
}

//------------------------------------------------------------------------------
Visibility ShadowStage::GetVisibility(int light)
{
  return Take(this->Pass->GetVisibility(light));
}

//------------------------------------------------------------------------------
Visibility ShadowStage::GetVisibility(vtkLight* light)
{
  return Take(this->Pass->GetVisibility(light));
}

//------------------------------------------------------------------------------
Picture ShadowStage::GetPicture()
{
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(this->Window);
  grab->SetInputBufferTypeToRGB();
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  grab->Update();
  vtkImageData* image = grab->GetOutput();
  Picture picture;
  picture.Width = image->GetDimensions()[0];
  picture.Height = image->GetDimensions()[1];
  const auto* first = static_cast<const unsigned char*>(image->GetScalarPointer());
  picture.RGB.assign(first, first + 3 * image->GetNumberOfPoints());
  return picture;
}

//------------------------------------------------------------------------------
nlohmann::json ShadowStage::GetStatistics()
{
  return nlohmann::json::parse(this->Pass->GetStatistics());
}

//------------------------------------------------------------------------------
double ShadowStage::Count(const std::string& name)
{
  const auto counts = this->GetStatistics()["counts"];
  return counts.contains(name) ? counts[name].get<double>() : -1.0;
}

//------------------------------------------------------------------------------
int ShadowStage::CountGLObjects()
{
  this->Window->MakeCurrent();
  int count = 0;
  for (GLuint name = 1; name < 8192; ++name) // names are small numbers in every driver
  {
    count += glIsTexture(name) + glIsBuffer(name) + glIsFramebuffer(name) + glIsQuery(name) +
             glIsVertexArray(name);
  }
  return count;
}

//------------------------------------------------------------------------------
Visibility RenderVisibility(const std::string& technique, const Parameters& parameters,
  const std::function<void(ShadowStage&)>& build, const Placement& place)
{
  ShadowStage stage(160, 160, place);
  build(stage);
  stage.SetPass(technique, parameters);
  stage.Render();
  return stage.GetVisibility(0);
}
