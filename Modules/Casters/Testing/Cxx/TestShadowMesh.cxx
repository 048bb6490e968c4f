// SPDX-License-Identifier: BSD-3-Clause
// vtkShadowMesh: which triangles cast, what they become, and whether they are flat.

#include "ShadowTesting.h"

#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkCubeSource.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkShadowMesh.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

#include <glm/geometric.hpp>

#include <initializer_list>
#include <limits>
#include <vector>

namespace
{
using Place = std::vector<glm::dvec3>;
using Cells = std::vector<std::vector<vtkIdType>>;

//------------------------------------------------------------------------------
vtkSmartPointer<vtkCellArray> NewCells(const Cells& cells)
{
  auto array = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& cell : cells)
  {
    array->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
  }
  return array;
}

vtkSmartPointer<vtkPolyData> NewMesh(const Place& places, const Cells& polygons)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& p : places)
  {
    points->InsertNextPoint(p.x, p.y, p.z);
  }
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(NewCells(polygons));
  return mesh;
}

glm::dvec3 GetVertex(const vtkShadowMesh& mesh, std::size_t corner)
{
  const float* p = &mesh.Positions[3 * mesh.Indices[corner]];
  return mesh.Centre + glm::dvec3(p[0], p[1], p[2]);
}

double GetArea(const vtkShadowMesh& mesh)
{
  double area = 0.0;
  for (std::size_t i = 0; i < mesh.Indices.size(); i += 3)
  {
    const glm::dvec3 a = GetVertex(mesh, i);
    area += 0.5 * glm::length(glm::cross(GetVertex(mesh, i + 1) - a, GetVertex(mesh, i + 2) - a));
  }
  return area;
}

/** One of the numbers is padding; see vtkShadowMesh. */
void CheckStorage(const vtkShadowMesh& mesh)
{
  CHECK_EQUAL(mesh.Positions.size(), 3 * mesh.GetNumberOfVertices() + 1);
  for (const auto index : mesh.Indices)
  {
    CHECK(index < mesh.GetNumberOfVertices());
  }
  for (const float value : mesh.Positions)
  {
    CHECK(std::isfinite(value));
  }
}

//------------------------------------------------------------------------------
void TestTriangle()
{
  // Far from the origin: relative to its centre it loses nothing.
  const glm::dvec3 far(1e7, -1e7, 5e6);
  const auto source = NewMesh({ far + glm::dvec3(9, 9, 9), far, far + glm::dvec3(0.001, 0, 0),
                                far + glm::dvec3(0, 0.002, 0) },
    { { 1, 2, 3 } });
  const auto mesh = vtkShadowMesh::Make(source);
  CheckStorage(*mesh);
  CHECK_EQUAL(mesh->GetNumberOfTriangles(), std::size_t(1));
  CHECK_EQUAL(mesh->GetNumberOfVertices(), std::size_t(3)); // the unused point went
  CHECK_EQUAL(mesh->Dropped, std::size_t(0));
  CHECK_NEAR(glm::length(mesh->Centre - far - glm::dvec3(0.0005, 0.001, 0)), 0.0, 1e-8);
  CHECK_NEAR(GetArea(*mesh), 1e-6, 1e-11);
  CHECK_NEAR(mesh->Maximum.y - mesh->Minimum.y, 0.002, 1e-8);
  CHECK(mesh->Flat);
}

//------------------------------------------------------------------------------
void TestNotFinite()
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  const auto mesh =
    vtkShadowMesh::Make(NewMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 1, 1, nan },
                                  { infinite, 0, 0 }, { 0, -infinite, 1 } },
      { { 0, 1, 2 }, { 0, 1, 3 }, { 2, 3, 1 }, { 4, 1, 2 }, { 0, 5, 1 }, { 3, 4, 5 } }));
  CheckStorage(*mesh);
  CHECK_EQUAL(mesh->GetNumberOfTriangles(), std::size_t(1));
  CHECK_EQUAL(mesh->GetNumberOfVertices(), std::size_t(3));
  CHECK_EQUAL(mesh->Dropped, std::size_t(5));
  CHECK_NEAR(mesh->Maximum.x, 0.5, 0.0); // the bounds are those of what casts

  const auto none = vtkShadowMesh::Make(
    NewMesh({ { nan, nan, nan }, { nan, 0, 0 }, { 0, nan, 0 } }, { { 0, 1, 2 } }));
  CHECK(none->Indices.empty());
  CHECK_EQUAL(none->Dropped, std::size_t(1));
  CHECK(!none->Flat);
}

//------------------------------------------------------------------------------
void TestDegenerate()
{
  const auto mesh = vtkShadowMesh::Make(
    NewMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 0, 1, 0 }, { 0, 0, 0 }, { 1, 0, 0 } },
      { { 0, 0, 1 }, { 0, 1, 2 }, { 0, 4, 3 }, { 1, 5, 3 }, { 0, 1, 3 }, { 4, 4, 4 } }));
  CheckStorage(*mesh);
  CHECK_EQUAL(mesh->GetNumberOfTriangles(), std::size_t(1));
  CHECK_EQUAL(mesh->Dropped, std::size_t(5));

  // Small or large is not degenerate, whatever the unit.
  for (const double scale : { 1e-12, 1e-6, 1.0, 1e9, 1e12 })
  {
    const auto scaled = vtkShadowMesh::Make(
      NewMesh({ { 0, 0, 0 }, { scale, 0, 0 }, { 0, scale, 0 } }, { { 0, 1, 2 } }));
    CHECK_EQUAL(scaled->GetNumberOfTriangles(), std::size_t(1));
    CHECK_NEAR(GetArea(*scaled) / (0.5 * scale * scale), 1.0, 1e-5);
    CHECK(scaled->Flat);
  }
}

//------------------------------------------------------------------------------
void TestPolygonsAndStrips()
{
  const Place grid = { { 0, 0, 0 }, { 0, 1, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 2, 0, 0 },
    { 2, 1, 0 } };
  const auto quads = vtkShadowMesh::Make(NewMesh(grid, { { 0, 2, 3, 1 }, { 2, 4, 5, 3 } }));
  CheckStorage(*quads);
  CHECK_EQUAL(quads->GetNumberOfTriangles(), std::size_t(4));
  CHECK_NEAR(GetArea(*quads), 2.0, 1e-6);

  // A polygon that is not convex: an L, of area 3.
  const auto ell = vtkShadowMesh::Make(
    NewMesh({ { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 1, 1, 0 }, { 1, 2, 0 }, { 0, 2, 0 } },
      { { 0, 1, 2, 3, 4, 5 } }));
  CHECK_EQUAL(ell->GetNumberOfTriangles(), std::size_t(4));
  CHECK_NEAR(GetArea(*ell), 3.0, 1e-6);

  // A strip of four triangles, a quad and a triangle together; lines and vertices cast nothing.
  auto mixed = NewMesh(grid, { { 0, 2, 3, 1 }, { 2, 4, 5 } });
  mixed->SetStrips(NewCells({ { 0, 1, 2, 3, 4, 5 } }));
  mixed->SetLines(NewCells({ { 0, 1 } }));
  mixed->SetVerts(NewCells({ { 0 } }));
  const auto both = vtkShadowMesh::Make(mixed);
  CheckStorage(*both);
  CHECK_EQUAL(both->GetNumberOfTriangles(), std::size_t(7));
  CHECK_NEAR(GetArea(*both), 3.5, 1e-6);

  auto strip = NewMesh(grid, {});
  strip->SetStrips(NewCells({ { 0, 1, 2, 3, 4, 5 } }));
  CHECK_NEAR(GetArea(*vtkShadowMesh::Make(strip)), 2.0, 1e-6);

  // A quad one of whose corners is not a number keeps no triangle with that corner.
  Place broken = grid;
  broken[3].z = std::numeric_limits<double>::quiet_NaN();
  const auto partly = vtkShadowMesh::Make(NewMesh(broken, { { 0, 2, 3, 1 }, { 0, 2, 1 } }));
  CheckStorage(*partly);
  CHECK(partly->GetNumberOfTriangles() >= 1);

  // Two corners are no polygon.
  const auto two = vtkShadowMesh::Make(NewMesh(grid, { { 0, 1 }, { 0, 2, 3 } }));
  CHECK_EQUAL(two->GetNumberOfTriangles(), std::size_t(1));
  CHECK_EQUAL(two->Dropped, std::size_t(1));
}

//------------------------------------------------------------------------------
void TestEmpty()
{
  vtkNew<vtkPolyData> nothing;
  CHECK(vtkShadowMesh::Make(nothing)->Indices.empty());
  CHECK_EQUAL(vtkShadowMesh::Make(nothing)->Dropped, std::size_t(0));

  auto lines = NewMesh({ { 0, 0, 0 }, { 1, 0, 0 } }, {});
  lines->SetLines(NewCells({ { 0, 1 } }));
  const auto mesh = vtkShadowMesh::Make(lines);
  CHECK(mesh->Indices.empty() && mesh->Positions.empty() && !mesh->Flat);
}

//------------------------------------------------------------------------------
void TestFlat()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(10.0, 20.0, 30.0);
  plane->SetPoint1(11.0, 20.3, 30.0);
  plane->SetPoint2(10.0, 21.0, 30.7);
  plane->SetResolution(7, 5);
  plane->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  plane->Update();
  const auto tilted = vtkShadowMesh::Make(plane->GetOutput());
  CHECK(tilted->Flat);
  const glm::dvec3 normal =
    glm::normalize(glm::cross(glm::dvec3(1.0, 0.3, 0.0), glm::dvec3(0.0, 1.0, 0.7)));
  CHECK_NEAR(std::abs(glm::dot(tilted->Normal, normal)), 1.0, 1e-6);
  CHECK_NEAR(glm::dot(normal, tilted->Centre + tilted->PlanePoint - glm::dvec3(10.0, 20.0, 30.0)),
    0.0, 1e-5);
  // In floats, where the plane passes near the model's origin.
  plane->SetOutputPointsPrecision(vtkAlgorithm::SINGLE_PRECISION);
  plane->SetCenter(0.1, 0.2, 0.3);
  plane->Update();
  CHECK(vtkShadowMesh::Make(plane->GetOutput())->Flat);

  // Two patches in one plane are flat together; a step between them is not, however small it is.
  const auto patches = [](double step)
  {
    return NewMesh(
      { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 5, 5, step }, { 6, 5, step }, { 5, 6, step } },
      { { 0, 1, 2 }, { 3, 4, 5 } });
  };
  CHECK(vtkShadowMesh::Make(patches(0.0))->Flat);
  CHECK(!vtkShadowMesh::Make(patches(1e-3))->Flat);
  CHECK(!vtkShadowMesh::Make(patches(-1e-3))->Flat);

  vtkNew<vtkCubeSource> cube;
  cube->Update();
  const auto box = vtkShadowMesh::Make(cube->GetOutput());
  CHECK(!box->Flat);
  CHECK_EQUAL(box->GetNumberOfTriangles(), std::size_t(12));
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  CHECK(!vtkShadowMesh::Make(sphere->GetOutput())->Flat);
}

//------------------------------------------------------------------------------
// Colours do not make a mesh anew; points and cells do.
void TestShapeTime()
{
  auto source = NewMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } });
  vtkNew<vtkFloatArray> colors;
  colors->SetNumberOfTuples(3);
  source->GetPointData()->SetScalars(colors);
  vtkMTimeType time = vtkShadowMesh::GetShapeTime(source);
  colors->Modified();
  CHECK_EQUAL(vtkShadowMesh::GetShapeTime(source), time);
  source->GetPoints()->Modified();
  CHECK(vtkShadowMesh::GetShapeTime(source) > time);
  time = vtkShadowMesh::GetShapeTime(source);
  source->GetPoints()->GetData()->Modified();
  CHECK(vtkShadowMesh::GetShapeTime(source) > time);
  time = vtkShadowMesh::GetShapeTime(source);
  source->GetPolys()->Modified();
  CHECK(vtkShadowMesh::GetShapeTime(source) > time);
}
}

//------------------------------------------------------------------------------
int TestShadowMesh(int, char*[])
{
  TestTriangle();
  TestNotFinite();
  TestDegenerate();
  TestPolygonsAndStrips();
  TestEmpty();
  TestFlat();
  TestShapeTime();
  return ShadowTesting::Result();
}
