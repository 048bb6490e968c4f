// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowSceneBuilders.h"

#include "ShadowSceneMesh.h"
#include "ShadowSceneStage.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPerlinNoise.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkShadowVTKVersion.h"
#include "vtkStreamTracer.h"
#include "vtkTriangleFilter.h"
#include "vtkTubeFilter.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace stage = ShadowSceneStage;

namespace
{
//------------------------------------------------------------------------------
// Point colours that run through the given ones from the lowest point to the highest.
void ColorByHeight(vtkPolyData* polyData, const std::vector<stage::Color>& colors)
{
  double bounds[6];
  polyData->GetBounds(bounds);
  const vtkIdType count = polyData->GetNumberOfPoints();
  vtkNew<vtkUnsignedCharArray> rgb;
  rgb->SetName("Colors");
  rgb->SetNumberOfComponents(3);
  rgb->SetNumberOfTuples(count);
  const auto last = static_cast<double>(colors.size() - 1);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double height = (polyData->GetPoint(i)[2] - bounds[4]) / (bounds[5] - bounds[4]);
    const double place = vtkMath::ClampValue(height * last, 0.0, last);
    const auto index = std::min(static_cast<std::size_t>(place), colors.size() - 2);
    const double t = place - static_cast<double>(index);
    const stage::Color& a = colors[index];
    const stage::Color& b = colors[index + 1];
    const double mixed[3] = { 255.0 * ((1.0 - t) * a.Red + t * b.Red),
      255.0 * ((1.0 - t) * a.Green + t * b.Green), 255.0 * ((1.0 - t) * a.Blue + t * b.Blue) };
    rgb->SetTuple(i, mixed);
  }
  polyData->GetPointData()->SetScalars(rgb);
}

//------------------------------------------------------------------------------
// Polygons and strips to triangles.
vtkSmartPointer<vtkPolyData> Triangulate(vtkPolyData* polyData)
{
  vtkNew<vtkTriangleFilter> filter;
  filter->SetInputData(polyData);
  filter->PassLinesOff();
  filter->PassVertsOff();
  filter->Update();
  return filter->GetOutput();
}

//------------------------------------------------------------------------------
// Fill an image, whose points are given, with a field of `components` numbers per point.
template <typename Function>
void Sample(vtkImageData* image, int components, const Function& function)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName("Field");
  values->SetNumberOfComponents(components);
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    function(vtkVector3d(image->GetPoint(id)), values->GetPointer(components * id));
  }
  if (components == 1)
  {
    image->GetPointData()->SetScalars(values);
  }
  else
  {
    image->GetPointData()->SetVectors(values);
  }
}
}

//------------------------------------------------------------------------------
// A gyroid wall, cut by a ball with rounded edges: closed, and full of holes to shine through.
void ShadowSceneBuilders::Isosurface(vtkRenderer* renderer, int)
{
  constexpr int cells = 80;
  constexpr double half = 1.1;
  constexpr double spacing = 2.0 * half / (cells - 1);
  vtkNew<vtkImageData> field;
  field->SetDimensions(cells, cells, cells);
  field->SetOrigin(-half, -half, -half);
  field->SetSpacing(spacing, spacing, spacing);
  Sample(field, 1,
    [](const vtkVector3d& point, double* value)
    {
      const vtkVector3d q = 7.0 * point;
      const double gyroid = std::sin(q[0]) * std::cos(q[1]) + std::sin(q[1]) * std::cos(q[2]) +
                            std::sin(q[2]) * std::cos(q[0]);
      const double wall = 0.45 - std::abs(gyroid);
      const double ball = 7.0 * (1.0 - point.Norm());
      *value = -std::log(std::exp(-5.0 * wall) + std::exp(-5.0 * ball)) / 5.0; // smooth minimum
    });
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(field);
  contour->SetValue(0, 1.3e-4);
  contour->ComputeNormalsOn();
  contour->ComputeScalarsOff();
  contour->Update();

  stage::AddFloor(renderer, 6.0);
  vtkActor* actor = stage::AddActor(renderer, contour->GetOutput(), stage::Teal);
  double bounds[6];
  actor->GetBounds(bounds);
  actor->SetPosition(0.0, 0.0, -bounds[4]);
  stage::AddSphereLight(renderer, vtkVector3d(-2.4, -1.8, 4.6), vtkVector3d(0.0, 0.0, 1.0), 0.25);
  stage::SetCamera(renderer, vtkVector3d(2.2, -6.0, 3.6), vtkVector3d(0.2, 0.1, 0.85));
}

//------------------------------------------------------------------------------
void ShadowSceneBuilders::Streamtubes(vtkRenderer* renderer, int)
{
  constexpr int cells = 49;
  constexpr double half = 2.4;
  constexpr double spacing = 2.0 * half / (cells - 1);
  vtkNew<vtkImageData> field;
  field->SetDimensions(cells, cells, cells);
  field->SetOrigin(-half, -half, 0.0);
  field->SetSpacing(spacing, spacing, spacing);
  Sample(field, 3,
    [](const vtkVector3d& point, double* velocity)
    {
      // Around a core that sways and widens with height; inwards below, outwards above.
      const double x = point[0] - 0.25 * std::sin(1.1 * point[2]);
      const double y = point[1] - 0.25 * std::cos(1.1 * point[2]) + 0.25;
      const double core = 0.25 + 0.09 * point[2] * point[2];
      const double radius = std::hypot(x, y);
      const double swirl = 2.2 / (core * core + radius * radius);
      const double outward = 0.22 * (point[2] - 1.7);
      velocity[0] = -swirl * y + outward * x;
      velocity[1] = swirl * x + outward * y;
      velocity[2] = 0.18 + 0.9 * std::exp(-radius * radius / (4.0 * core * core));
    });

  vtkNew<vtkPoints> seedPoints;
  for (int k = 0; k < 14; ++k)
  {
    const double angle = 2.4 * k; // golden angle
    const double radius = 0.25 + 0.11 * k;
    seedPoints->InsertNextPoint(radius * std::cos(angle), radius * std::sin(angle), 0.12);
  }
  vtkNew<vtkPolyData> seeds;
  seeds->SetPoints(seedPoints);
  vtkNew<vtkStreamTracer> tracer;
  tracer->SetInputData(field);
  tracer->SetSourceData(seeds);
  tracer->SetIntegratorTypeToRungeKutta4();
  tracer->SetIntegrationDirectionToForward();
  tracer->SetIntegrationStepUnit(vtkStreamTracer::LENGTH_UNIT);
  tracer->SetInitialIntegrationStep(0.05);
  tracer->SetMaximumPropagation(34.0);
  tracer->SetMaximumNumberOfSteps(2000);
  tracer->SetComputeVorticity(false);
  tracer->Update();
  vtkNew<vtkPolyData> lines;
  lines->SetPoints(tracer->GetOutput()->GetPoints());
  lines->SetLines(tracer->GetOutput()->GetLines());
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(lines);
  tubes->SetRadius(0.035);
  tubes->SetNumberOfSides(8);
  tubes->CappingOn();
  tubes->Update();
  const auto mesh = Triangulate(tubes->GetOutput());
  ColorByHeight(mesh, { stage::Sky, stage::Teal, stage::Sage, stage::Ochre, stage::Clay });

  stage::AddFloor(renderer, 9.0);
  stage::AddActor(renderer, mesh, stage::Sky);
  stage::AddSphereLight(renderer, vtkVector3d(-5.0, -4.0, 8.5), vtkVector3d(0.0, 0.0, 1.5), 0.5);
  stage::SetCamera(renderer, vtkVector3d(4.5, -11.5, 7.5), vtkVector3d(0.0, 0.0, 2.0));
}

//------------------------------------------------------------------------------
// Six octaves of VTK's Perlin noise, the large ones folded to ridges. There is no floor.
void ShadowSceneBuilders::Terrain(vtkRenderer* renderer, int)
{
  constexpr int quads = 180;
  constexpr double size = 12.0;
  vtkNew<vtkPerlinNoise> noise;
  const auto height = [&noise](double x, double y)
  {
    double sum = 0.0;
    double amplitude = 1.5;
    double frequency = 0.21;
    for (int octave = 0; octave < 6; ++octave)
    {
      noise->SetFrequency(frequency, frequency, 1.0);
      double place[3] = { x + 31.7 * octave + 3.1, y - 17.3 * octave + 8.9, 0.37 };
      const double value = noise->EvaluateFunction(place);
      sum += amplitude * (octave < 3 ? 0.6 - 1.4 * std::abs(value) : value);
      amplitude *= 0.40;
      frequency *= 2.03;
    }
    return std::max(0.0, sum + 0.35);
  };
  ShadowSceneMesh mesh;
  mesh.AddGrid(quads, quads, false, false,
    [&height](double u, double v, vtkVector3d& point, vtkVector3d& normal)
    {
      const double x = size * (u - 0.5);
      const double y = size * (v - 0.5);
      const double step = 0.5 * size / quads;
      point.Set(x, y, height(x, y));
      normal.Set(height(x - step, y) - height(x + step, y),
        height(x, y - step) - height(x, y + step), 2.0 * step);
    });
  const auto polyData = mesh.MakePolyData();
  ColorByHeight(polyData, { { 0.58, 0.67, 0.55 }, { 0.66, 0.68, 0.52 }, { 0.74, 0.67, 0.54 },
                            { 0.70, 0.62, 0.55 }, { 0.90, 0.89, 0.88 } });
  vtkActor* actor = stage::AddActor(renderer, polyData, stage::Sage);
  actor->GetProperty()->SetSpecular(0.0);
  stage::AddSphereLight(renderer, vtkVector3d(-30.0, -16.0, 19.0), vtkVector3d(0.0, 0.0, 0.0), 1.2);
  stage::SetCamera(renderer, vtkVector3d(8.0, -25.0, 17.0), vtkVector3d(-0.5, 0.0, 0.4));
}
