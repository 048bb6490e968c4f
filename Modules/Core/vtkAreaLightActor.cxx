// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAreaLightActor.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShadowLight.h"
#include "vtkSmartPointer.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkAreaLightActor);

namespace
{
using Shape = vtkShadowLight::Shape;

/** Lines and points in the making. */
class Drawing
{
public:
  void AddLine(const std::vector<glm::dvec3>& points)
  {
    this->Lines->InsertNextCell(static_cast<int>(points.size()));
    for (const glm::dvec3& point : points)
    {
      this->Lines->InsertCellPoint(this->Points->InsertNextPoint(glm::value_ptr(point)));
    }
  }

  void AddPoint(const glm::dvec3& point)
  {
    const vtkIdType id = this->Points->InsertNextPoint(glm::value_ptr(point));
    this->Vertices->InsertNextCell(1, &id);
  }

  void AddEllipse(const glm::dvec3& centre, const glm::dvec3& u, const glm::dvec3& v)
  {
    constexpr int sides = 64;
    std::vector<glm::dvec3> points;
    for (int i = 0; i <= sides; ++i)
    {
      const double angle = glm::two_pi<double>() * (i % sides) / sides;
      points.push_back(centre + std::cos(angle) * u + std::sin(angle) * v);
    }
    this->AddLine(points);
  }

  void PutInto(vtkPolyData* data)
  {
    data->SetPoints(this->Points);
    data->SetLines(this->Lines);
    data->SetVerts(this->Vertices);
  }

  Drawing() { this->Points->SetDataTypeToDouble(); }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Lines;
  vtkNew<vtkCellArray> Vertices;
};

void DrawShape(Drawing& drawing, const vtkShadowLight& light)
{
  const glm::dvec3& centre = light.Position;
  if (light.IsPoint())
  {
    return;
  }
  if (light.Kind == Shape::Rectangle)
  {
    drawing.AddLine({ centre - light.U - light.V, centre + light.U - light.V,
      centre + light.U + light.V, centre - light.U + light.V, centre - light.U - light.V });
  }
  else
  {
    drawing.AddEllipse(centre, light.U, light.V);
  }
  const glm::dvec3 ahead = light.Direction * std::max(glm::length(light.U), glm::length(light.V));
  if (light.Kind == Shape::Sphere)
  {
    drawing.AddEllipse(centre, light.U, ahead);
    drawing.AddEllipse(centre, light.V, ahead);
  }
  else
  {
    drawing.AddLine({ centre, centre + ahead });
  }
}
}

class vtkAreaLightActor::Internals
{
public:
  vtkSmartPointer<vtkLight> Light;
  vtkNew<vtkPolyData> Data;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkActor> Actor;
  // Of what it was made: a camera light's matrix changes without its MTime.
  vtkMTimeType Time = 0;
  glm::dvec3 Position{ 0.0 };
  glm::dvec3 Focus{ 0.0 };
};

//------------------------------------------------------------------------------
vtkAreaLightActor::vtkAreaLightActor()
  : Internal(new Internals)
{
  Internals& my = *this->Internal;
  my.Mapper->SetInputData(my.Data);
  my.Actor->SetMapper(my.Mapper);
  vtkProperty* property = my.Actor->GetProperty();
  property->LightingOff();
  property->SetColor(0.95, 0.6, 0.05);
  property->SetLineWidth(2.0f);
  property->SetPointSize(4.0f);
}

//------------------------------------------------------------------------------
vtkAreaLightActor::~vtkAreaLightActor() = default;

//------------------------------------------------------------------------------
void vtkAreaLightActor::SetLight(vtkLight* light)
{
  if (this->Internal->Light != light)
  {
    this->Internal->Light = light;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkLight* vtkAreaLightActor::GetLight()
{
  return this->Internal->Light;
}

//------------------------------------------------------------------------------
vtkProperty* vtkAreaLightActor::GetProperty()
{
  return this->Internal->Actor->GetProperty();
}

//------------------------------------------------------------------------------
void vtkAreaLightActor::Update()
{
  Internals& my = *this->Internal;
  glm::dvec3 position(0.0);
  glm::dvec3 focus(0.0);
  if (my.Light)
  {
    position = glm::make_vec3(my.Light->GetTransformedPosition());
    focus = glm::make_vec3(my.Light->GetTransformedFocalPoint());
  }
  const vtkMTimeType time =
    std::max(this->Superclass::GetMTime(), my.Light ? my.Light->GetMTime() : 0);
  if (time == my.Time && position == my.Position && focus == my.Focus)
  {
    return;
  }
  my.Time = time;
  my.Position = position;
  my.Focus = focus;
  Drawing drawing;
  vtkShadowLight light;
  if (my.Light)
  {
    light = vtkShadowLight::Read(my.Light);
  }
  if (my.Light && light.IsFinite())
  {
    const double distance = light.IsDirectional() ? glm::length(focus - position) : 1.0;
    vtkShadowLight shown = light;
    shown.U *= distance;
    shown.V *= distance;
    DrawShape(drawing, shown);
    for (const auto& sample :
      this->Samples > 0 ? light.GetPlaces(this->Samples, focus) : std::vector<vtkLightSample>())
    {
      // Of a directional light a sample is a way to it: where that meets the disk.
      drawing.AddPoint(
        light.IsDirectional()
          ? focus - sample.Point * (distance / glm::dot(sample.Point, light.Direction))
          : sample.Point);
    }
  }
  drawing.PutInto(my.Data);
}

//------------------------------------------------------------------------------
double* vtkAreaLightActor::GetBounds()
{
  this->Update();
  vtkMath::UninitializeBounds(this->Bounds);
  if (this->Internal->Data->GetNumberOfPoints() > 0)
  {
    this->Internal->Data->GetBounds(this->Bounds);
  }
  return this->Bounds;
}

//------------------------------------------------------------------------------
int vtkAreaLightActor::RenderOpaqueGeometry(vtkViewport* viewport)
{
  this->Update();
  Internals& my = *this->Internal;
  return my.Data->GetNumberOfPoints() > 0 ? my.Actor->RenderOpaqueGeometry(viewport) : 0;
}

//------------------------------------------------------------------------------
void vtkAreaLightActor::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internal->Actor->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
vtkMTimeType vtkAreaLightActor::GetMTime()
{
  const Internals& my = *this->Internal;
  return std::max(
    { this->Superclass::GetMTime(), my.Actor->GetMTime(), my.Light ? my.Light->GetMTime() : 0 });
}

//------------------------------------------------------------------------------
void vtkAreaLightActor::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Light: " << this->Internal->Light.Get() << "\n";
  os << indent << "Samples: " << this->Samples << "\n";
}
