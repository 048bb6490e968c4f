// SPDX-License-Identifier: BSD-3-Clause
#include "Meshes.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkCleanPolyData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataNormals.h"
#include "vtkTriangleFilter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace
{
constexpr double FeatureAngle = 60.0; // degrees; a box stays a box, a coarse sphere is smooth

//------------------------------------------------------------------------------
bool IsUsable(const double point[3])
{
  // What OpenGL can take. A reader that clamps to floats gives just this for what is larger.
  constexpr double limit = std::numeric_limits<float>::max();
  return std::all_of(
    point, point + 3, [](double value) { return std::abs(value) < limit; }); // false for NaN
}

//------------------------------------------------------------------------------
// Copy the polygons, or the strips as triangles, whose points are all good.
void CopyGoodPolygons(vtkCellArray* cells, bool strips, const std::vector<bool>& good,
  vtkCellArray* copy, vtkIdType& lost)
{
  const auto count = static_cast<vtkIdType>(good.size());
  const auto exists = [&](vtkIdType id) { return id >= 0 && id < count; };
  const auto isGood = [&](vtkIdType id) { return good[id]; };
  auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(size, ids);
    if (!std::all_of(ids, ids + size, exists))
    {
      ++lost;
    }
    else if (!strips && std::all_of(ids, ids + size, isGood))
    {
      copy->InsertNextCell(size, ids);
    }
    for (vtkIdType i = 0; strips && i + 2 < size && std::all_of(ids, ids + size, exists); ++i)
    {
      const vtkIdType triangle[3] = { ids[i], ids[i + 1 + i % 2], ids[i + 2 - i % 2] };
      if (std::all_of(triangle, triangle + 3, isGood))
      {
        copy->InsertNextCell(3, triangle);
      }
    }
  }
}

//------------------------------------------------------------------------------
bool RefersToAll(vtkCellArray* cells, vtkIdType points)
{
  auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    cell->GetCurrentCell(size, ids);
    if (!std::all_of(ids, ids + size, [&](vtkIdType id) { return id >= 0 && id < points; }))
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
// The surface itself if all is well; else a copy without its bad polygons and points.
vtkSmartPointer<vtkPolyData> DropBad(vtkPolyData* surface, Meshes::Report& report)
{
  const vtkIdType count = surface->GetNumberOfPoints();
  std::vector<bool> good(count);
  vtkIdType bad = 0;
  vtkIdType firstGood = -1;
  for (vtkIdType i = 0; i < count; ++i)
  {
    double point[3];
    surface->GetPoint(i, point);
    good[i] = IsUsable(point);
    bad += good[i] ? 0 : 1;
    firstGood = firstGood < 0 && good[i] ? i : firstGood;
  }
  report.Points += count;
  report.BadPoints += bad;
  if (bad == 0 && RefersToAll(surface->GetPolys(), count) &&
      RefersToAll(surface->GetStrips(), count))
  {
    return surface;
  }
  vtkNew<vtkCellArray> polygons;
  CopyGoodPolygons(surface->GetPolys(), false, good, polygons, report.BadPolygons);
  CopyGoodPolygons(surface->GetStrips(), true, good, polygons, report.BadPolygons);

  // Nothing refers to the bad points now; they take another's place so that bounds are right.
  vtkNew<vtkPoints> points;
  points->SetDataType(count > 0 ? surface->GetPoints()->GetDataType() : VTK_FLOAT);
  points->SetNumberOfPoints(firstGood < 0 ? 0 : count);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    points->SetPoint(i, surface->GetPoint(good[i] ? i : firstGood));
  }
  auto copy = vtkSmartPointer<vtkPolyData>::New();
  copy->SetPoints(points);
  copy->SetPolys(polygons);
  if (firstGood >= 0)
  {
    copy->GetPointData()->ShallowCopy(surface->GetPointData());
  }
  return copy;
}

//------------------------------------------------------------------------------
bool HasNormals(vtkDataSetAttributes* data, vtkIdType count)
{
  vtkDataArray* normals = data->GetNormals();
  if (!normals || normals->GetNumberOfTuples() != count || normals->GetNumberOfComponents() != 3)
  {
    return false;
  }
  for (vtkIdType i = 0; i < count; ++i)
  {
    double normal[3];
    normals->GetTuple(i, normal);
    if (!IsUsable(normal))
    {
      return false;
    }
  }
  return true;
}
}

namespace Meshes
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Prepare(vtkPolyData* surface, Report& report)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(DropBad(surface, report));
  triangles->PassVertsOff();
  triangles->PassLinesOff();
  triangles->Update();
  vtkSmartPointer<vtkPolyData> mesh = triangles->GetOutput();
  const bool hasNormals = HasNormals(mesh->GetPointData(), mesh->GetNumberOfPoints()) ||
                          (!mesh->GetPointData()->GetNormals() &&
                            HasNormals(mesh->GetCellData(), mesh->GetNumberOfCells()));
  if (mesh->GetNumberOfPolys() == 0 || hasNormals)
  {
    return mesh;
  }
  mesh->GetPointData()->SetNormals(nullptr);
  mesh->GetCellData()->SetNormals(nullptr);

  vtkNew<vtkPolyDataNormals> normals;
  vtkNew<vtkCleanPolyData> merge;
  if (mesh->GetPointData()->GetNumberOfArrays() == 0)
  {
    // Files that give each triangle its own points, as STL does, are smooth only when joined.
    merge->SetInputData(mesh);
    merge->SetTolerance(0.0);
    merge->ConvertPolysToLinesOff();
    merge->ConvertLinesToPointsOff();
    normals->SetInputConnection(merge->GetOutputPort());
  }
  else
  {
    normals->SetInputData(mesh);
  }
  normals->SetFeatureAngle(FeatureAngle);
  normals->Update();
  mesh = normals->GetOutput();
  return mesh;
}

//------------------------------------------------------------------------------
vtkIdType CountTriangles(vtkPolyData* surface)
{
  vtkIdType count = 0;
  for (vtkCellArray* cells : { surface->GetPolys(), surface->GetStrips() })
  {
    count += cells->GetNumberOfConnectivityIds() - 2 * cells->GetNumberOfCells();
  }
  return std::max<vtkIdType>(count, 0);
}
}
