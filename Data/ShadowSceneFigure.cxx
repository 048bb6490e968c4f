// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowSceneBuilders.h"

#include "ShadowSceneMesh.h"
#include "ShadowSceneRandom.h"
#include "ShadowSceneStage.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkShadowVTKVersion.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace stage = ShadowSceneStage;

namespace
{
constexpr double Half = 1.5;    // of the cube that the data fill, on the floor
constexpr double Level = 0.9;   // of the isosurface
constexpr double SliceY = 1.52; // behind all else

struct Source
{
  vtkVector3d Center;
  double Radius;
};

//------------------------------------------------------------------------------
double Sample(const std::vector<Source>& sources, const vtkVector3d& point)
{
  double sum = 0.0;
  for (const Source& source : sources)
  {
    const double distance = (point - source.Center).Norm() / source.Radius;
    sum += std::exp(-distance * distance);
  }
  return sum;
}

//------------------------------------------------------------------------------
// Around the middle, and up where it is fast.
vtkVector3d Flow(const vtkVector3d& point)
{
  const double x = point[0] - 0.2 * std::sin(2.0 * point[2]);
  const double y = point[1] + 0.2 * std::cos(2.0 * point[2]);
  const double swirl = 1.0 / (0.3 + x * x + y * y);
  return { -swirl * y - 0.1 * x, swirl * x - 0.1 * y, 0.18 + 0.15 * swirl };
}

//------------------------------------------------------------------------------
void AddIsosurface(vtkRenderer* renderer, const std::vector<Source>& sources)
{
  constexpr int cells = 56;
  constexpr double spacing = 2.0 * Half / (cells - 1);
  vtkNew<vtkImageData> field;
  field->SetDimensions(cells, cells, cells);
  field->SetOrigin(-Half, -Half, 0.0);
  field->SetSpacing(spacing, spacing, spacing);
  vtkNew<vtkDoubleArray> values;
  values->SetNumberOfTuples(field->GetNumberOfPoints());
  for (vtkIdType id = 0; id < field->GetNumberOfPoints(); ++id)
  {
    values->SetValue(id, Sample(sources, vtkVector3d(field->GetPoint(id))));
  }
  field->GetPointData()->SetScalars(values);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(field);
  contour->SetValue(0, Level);
  contour->ComputeNormalsOn();
  contour->ComputeScalarsOff();
  contour->Update();
  stage::AddActor(renderer, contour->GetOutput(), stage::Teal);
}

//------------------------------------------------------------------------------
void AddTubes(vtkRenderer* renderer, ShadowSceneRandom& random)
{
  ShadowSceneMesh tubes;
  for (int k = 0; k < 14; ++k)
  {
    const double angle = random.Between(0.0, 2.0 * vtkMath::Pi());
    const double distance = random.Between(0.5, 1.3);
    vtkVector3d place(distance * std::cos(angle), distance * std::sin(angle), 0.15);
    std::vector<vtkVector3d> path;
    for (int step = 0; step < 160 && place[2] < 2.0 * Half; ++step)
    {
      path.push_back(place);
      place = place + 0.05 * Flow(place).Normalized();
    }
    tubes.AddTube(path, 0.018, 8);
  }
  stage::AddActor(renderer, tubes, stage::Ochre);
}

//------------------------------------------------------------------------------
// An arrow a point of two levels: a shaft and a tip.
void AddArrows(vtkRenderer* renderer)
{
  ShadowSceneMesh arrows;
  constexpr int perSide = 7;
  for (int i = 0; i < 2 * perSide * perSide; ++i)
  {
    const double x = (2.0 * (i % perSide) / (perSide - 1) - 1.0) * 0.9 * Half;
    const double y = (2.0 * (i / perSide % perSide) / (perSide - 1) - 1.0) * 0.9 * Half;
    const vtkVector3d from(x, y, i < perSide * perSide ? 0.45 : 2.1);
    const vtkVector3d along = Flow(from).Normalized();
    const double length = 0.16 + 0.1 * std::min(1.0, Flow(from).Norm());
    const auto at = [&](double share) { return from + share * length * along; };
    arrows.AddTube({ at(0.0), at(0.65), at(0.66), at(1.0) }, { 0.012, 0.012, 0.04, 0.0 }, 10);
  }
  stage::AddActor(renderer, arrows, stage::Clay);
}

//------------------------------------------------------------------------------
// A sheet, coloured by the field.
void AddSlice(vtkRenderer* renderer, const std::vector<Source>& sources)
{
  ShadowSceneMesh slice;
  slice.AddGrid(60, 60, false, false,
    [](double u, double v, vtkVector3d& point, vtkVector3d& normal)
    {
      point.Set((2.0 * u - 1.0) * Half, SliceY, 2.0 * Half * v);
      normal.Set(0.0, -1.0, 0.0);
    });
  const auto polyData = slice.MakePolyData();
  vtkNew<vtkUnsignedCharArray> rgb;
  rgb->SetName("Colors");
  rgb->SetNumberOfComponents(3);
  rgb->SetNumberOfTuples(polyData->GetNumberOfPoints());
  for (vtkIdType i = 0; i < polyData->GetNumberOfPoints(); ++i)
  {
    vtkVector3d place(polyData->GetPoint(i));
    place[1] = 0.0;
    const double t = std::min(1.0, Sample(sources, place) / (1.5 * Level));
    const double color[3] = { 255.0 * ((1.0 - t) * stage::Sky.Red + t * stage::Clay.Red),
      255.0 * ((1.0 - t) * stage::Sky.Green + t * stage::Clay.Green),
      255.0 * ((1.0 - t) * stage::Sky.Blue + t * stage::Clay.Blue) };
    rgb->SetTuple(i, color);
  }
  polyData->GetPointData()->SetScalars(rgb);
  stage::AddActor(renderer, polyData, stage::Sky);
}
}

//------------------------------------------------------------------------------
// What a script of a scientist draws: an isosurface, tubes, arrows and a slice over a ground, in several
// layers as the light sees them, under a light a quarter as wide as they are.
void ShadowSceneBuilders::Figure(vtkRenderer* renderer, int)
{
  ShadowSceneRandom random(23);
  std::vector<Source> sources;
  for (int k = 0; k < 9; ++k)
  {
    const vtkVector3d center(
      random.Between(-0.7, 0.7), random.Between(-0.7, 0.7), random.Between(0.8, 2.2));
    sources.push_back({ center, random.Between(0.3, 0.5) });
  }
  stage::AddFloor(renderer, 9.0);
  AddIsosurface(renderer, sources);
  AddTubes(renderer, random);
  AddArrows(renderer);
  AddSlice(renderer, sources);
  stage::AddSphereLight(
    renderer, vtkVector3d(-4.0, -4.5, 8.0), vtkVector3d(0.0, 0.0, 1.0), 0.25 * Half);
  stage::SetCamera(renderer, vtkVector3d(3.3, -8.3, 5.6), vtkVector3d(0.35, 0.0, 1.0));
}
