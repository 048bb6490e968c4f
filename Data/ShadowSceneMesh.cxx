// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowSceneMesh.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkShadowVTKVersion.h"

#include <algorithm>
#include <cmath>

namespace
{
//------------------------------------------------------------------------------
// Some direction perpendicular to the given one.
vtkVector3d Perpendicular(const vtkVector3d& direction)
{
  const vtkVector3d axis = std::abs(direction[2]) < 0.9 * direction.Norm()
                             ? vtkVector3d(0.0, 0.0, 1.0)
                             : vtkVector3d(1.0, 0.0, 0.0);
  return axis.Cross(direction).Normalized();
}

//------------------------------------------------------------------------------
// Direction of a path at its i-th point.
vtkVector3d Tangent(const std::vector<vtkVector3d>& path, std::size_t i)
{
  const vtkVector3d before =
    i > 0 ? (path[i] - path[i - 1]).Normalized() : vtkVector3d(0.0, 0.0, 0.0);
  const vtkVector3d after =
    i + 1 < path.size() ? (path[i + 1] - path[i]).Normalized() : vtkVector3d(0.0, 0.0, 0.0);
  return (before + after).Normalized();
}

//------------------------------------------------------------------------------
template <typename ArrayType, typename ValueType>
vtkSmartPointer<ArrayType> MakeArray(const std::vector<ValueType>& values, int components)
{
  auto array = vtkSmartPointer<ArrayType>::New();
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}
}

//------------------------------------------------------------------------------
vtkIdType ShadowSceneMesh::GetNumberOfTriangles() const
{
  return static_cast<vtkIdType>(this->Connectivity.size()) / 3;
}

//------------------------------------------------------------------------------
vtkIdType ShadowSceneMesh::AddPoint(const vtkVector3d& point, const vtkVector3d& normal)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Points.push_back(static_cast<float>(point[axis]));
    this->Normals.push_back(static_cast<float>(normal[axis]));
  }
  return static_cast<vtkIdType>(this->Points.size()) / 3 - 1;
}

//------------------------------------------------------------------------------
void ShadowSceneMesh::AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
{
  this->Connectivity.push_back(a);
  this->Connectivity.push_back(b);
  this->Connectivity.push_back(c);
}

//------------------------------------------------------------------------------
void ShadowSceneMesh::AddGrid(int nu, int nv, bool wrapU, bool wrapV, const Surface& surface)
{
  const int columns = wrapU ? nu : nu + 1;
  const int rows = wrapV ? nv : nv + 1;
  const vtkIdType first = static_cast<vtkIdType>(this->Points.size()) / 3;
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      vtkVector3d point;
      vtkVector3d normal;
      surface(static_cast<double>(i) / nu, static_cast<double>(j) / nv, point, normal);
      this->AddPoint(point, normal.Normalized());
    }
  }
  for (int j = 0; j < nv; ++j)
  {
    const vtkIdType low = first + static_cast<vtkIdType>(j) * columns;
    const vtkIdType high = first + static_cast<vtkIdType>((j + 1) % rows) * columns;
    for (int i = 0; i < nu; ++i)
    {
      const int next = (i + 1) % columns;
      this->AddTriangle(low + i, low + next, high + next);
      this->AddTriangle(low + i, high + next, high + i);
    }
  }
}

//------------------------------------------------------------------------------
void ShadowSceneMesh::AddSphere(
  const vtkVector3d& center, const vtkVector3d& radii, int around, int rows)
{
  // The poles are tips of a tube whose rings follow the meridian; the normals are those of the
  // ellipsoid.
  const std::size_t firstPoint = this->Points.size() / 3;
  std::vector<vtkVector3d> path;
  std::vector<double> ring;
  for (int j = 0; j <= rows; ++j)
  {
    const double angle = vtkMath::Pi() * j / rows;
    path.emplace_back(0.0, 0.0, -std::cos(angle));
    ring.push_back(j == 0 || j == rows ? 0.0 : std::sin(angle));
  }
  this->AddTube(path, ring, around);
  for (std::size_t i = firstPoint; i < this->Points.size() / 3; ++i)
  {
    float* point = this->Points.data() + 3 * i;
    const vtkVector3d unit(point[0], point[1], point[2]);
    const vtkVector3d normal =
      vtkVector3d(unit[0] / radii[0], unit[1] / radii[1], unit[2] / radii[2]).Normalized();
    for (int axis = 0; axis < 3; ++axis)
    {
      point[axis] = static_cast<float>(center[axis] + radii[axis] * unit[axis]);
      this->Normals[3 * i + axis] = static_cast<float>(normal[axis]);
    }
  }
}

//------------------------------------------------------------------------------
void ShadowSceneMesh::AddSphere(const vtkVector3d& center, double radius, int around, int rows)
{
  this->AddSphere(center, vtkVector3d(radius, radius, radius), around, rows);
}

//------------------------------------------------------------------------------
void ShadowSceneMesh::AddCap(
  vtkIdType ring, int sides, const vtkVector3d& center, const vtkVector3d& normal)
{
  const vtkIdType middle = this->AddPoint(center, normal);
  for (int k = 0; k < sides; ++k)
  {
    const float* point = this->Points.data() + 3 * (ring + k);
    this->AddPoint(vtkVector3d(point[0], point[1], point[2]), normal);
  }
  // The rings run counter-clockwise about the path's direction: an end cap turns the same way.
  const float* first = this->Points.data() + 3 * (middle + 1);
  const float* second = this->Points.data() + 3 * (middle + 2);
  const vtkVector3d a = vtkVector3d(first[0], first[1], first[2]) - center;
  const vtkVector3d b = vtkVector3d(second[0], second[1], second[2]) - center;
  const bool forward = a.Cross(b).Dot(normal) > 0.0;
  for (int k = 0; k < sides; ++k)
  {
    const vtkIdType p = middle + 1 + k;
    const vtkIdType q = middle + 1 + (k + 1) % sides;
    this->AddTriangle(middle, forward ? p : q, forward ? q : p);
  }
}

//------------------------------------------------------------------------------
void ShadowSceneMesh::AddTube(
  const std::vector<vtkVector3d>& path, const std::vector<double>& radii, int sides)
{
  const std::size_t count = path.size();
  vtkVector3d across = Perpendicular(Tangent(path, 0));
  std::vector<vtkIdType> rings;
  for (std::size_t i = 0; i < count; ++i)
  {
    const vtkVector3d along = Tangent(path, i);
    across = (across - along.Dot(across) * along).Normalized();
    const vtkVector3d side = along.Cross(across);
    if (radii[i] <= 0.0)
    {
      rings.push_back(this->AddPoint(path[i], i == 0 ? -along : along));
      continue;
    }
    // A tube that tapers has normals that lean along it.
    const std::size_t before = i > 0 ? i - 1 : i;
    const std::size_t after = i + 1 < count ? i + 1 : i;
    const double run = (path[after] - path[i]).Norm() + (path[i] - path[before]).Norm();
    const double slope = (radii[after] - radii[before]) / run;
    for (int k = 0; k < sides; ++k)
    {
      const double angle = 2.0 * vtkMath::Pi() * k / sides;
      const vtkVector3d out = std::cos(angle) * across + std::sin(angle) * side;
      const vtkIdType id =
        this->AddPoint(path[i] + radii[i] * out, (out - slope * along).Normalized());
      if (k == 0)
      {
        rings.push_back(id);
      }
    }
  }
  for (std::size_t i = 0; i + 1 < count; ++i)
  {
    for (int k = 0; k < sides; ++k)
    {
      const int next = (k + 1) % sides;
      if (radii[i] > 0.0 && radii[i + 1] > 0.0)
      {
        this->AddTriangle(rings[i] + k, rings[i] + next, rings[i + 1] + next);
        this->AddTriangle(rings[i] + k, rings[i + 1] + next, rings[i + 1] + k);
      }
      else if (radii[i] > 0.0)
      {
        this->AddTriangle(rings[i] + k, rings[i] + next, rings[i + 1]);
      }
      else if (radii[i + 1] > 0.0)
      {
        this->AddTriangle(rings[i], rings[i + 1] + next, rings[i + 1] + k);
      }
    }
  }
  if (radii.front() > 0.0)
  {
    this->AddCap(rings.front(), sides, path.front(), -Tangent(path, 0));
  }
  if (radii.back() > 0.0)
  {
    this->AddCap(rings.back(), sides, path.back(), Tangent(path, count - 1));
  }
}

//------------------------------------------------------------------------------
void ShadowSceneMesh::AddTube(const std::vector<vtkVector3d>& path, double radius, int sides)
{
  this->AddTube(path, std::vector<double>(path.size(), radius), sides);
}

//------------------------------------------------------------------------------
void ShadowSceneMesh::AddVessel(
  const vtkVector3d& from, const vtkVector3d& to, double radius, double dome, int sides)
{
  const vtkVector3d along = (to - from).Normalized();
  const int steps = std::max(2, sides / 4);
  std::vector<vtkVector3d> path;
  std::vector<double> radii;
  for (int k = 0; k <= steps; ++k)
  {
    const double angle = 0.5 * vtkMath::Pi() * k / steps;
    path.push_back(from - dome * std::cos(angle) * along);
    radii.push_back(k == 0 ? 0.0 : radius * std::sin(angle));
  }
  for (int k = steps; k >= 0; --k)
  {
    const double angle = 0.5 * vtkMath::Pi() * k / steps;
    path.push_back(to + dome * std::cos(angle) * along);
    radii.push_back(k == 0 ? 0.0 : radius * std::sin(angle));
  }
  this->AddTube(path, radii, sides);
}

//------------------------------------------------------------------------------
void ShadowSceneMesh::AddBox(const vtkVector3d& center, const vtkVector3d& halfX,
  const vtkVector3d& halfY, const vtkVector3d& halfZ, int nx, int ny, int nz)
{
  const vtkVector3d axes[3] = { halfX, halfY, halfZ };
  const int pieces[3] = { nx, ny, nz };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double sign : { 1.0, -1.0 })
    {
      const int first = (axis + (sign > 0.0 ? 1 : 2)) % 3;
      const int second = (axis + (sign > 0.0 ? 2 : 1)) % 3;
      const vtkVector3d normal = axes[first].Cross(axes[second]).Normalized();
      this->AddGrid(pieces[first], pieces[second], false, false,
        [&](double u, double v, vtkVector3d& point, vtkVector3d& pointNormal)
        {
          point = center + sign * axes[axis] + (2.0 * u - 1.0) * axes[first] +
                  (2.0 * v - 1.0) * axes[second];
          pointNormal = normal;
        });
    }
  }
}

//------------------------------------------------------------------------------
void ShadowSceneMesh::AddBox(const vtkVector3d& center, const vtkVector3d& halfSize, double angle)
{
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  this->AddBox(center, vtkVector3d(c * halfSize[0], s * halfSize[0], 0.0),
    vtkVector3d(-s * halfSize[1], c * halfSize[1], 0.0), vtkVector3d(0.0, 0.0, halfSize[2]));
}

//------------------------------------------------------------------------------
void ShadowSceneMesh::AddBeam(const vtkVector3d& from, const vtkVector3d& to, double width,
  double height, const vtkVector3d& up)
{
  const vtkVector3d along = (to - from).Normalized();
  const vtkVector3d across = up.Cross(along).Normalized();
  const vtkVector3d top = along.Cross(across);
  this->AddBox(0.5 * (from + to), 0.5 * (to - from), 0.5 * width * across, 0.5 * height * top);
}

//------------------------------------------------------------------------------
void ShadowSceneMesh::AddIBeam(const vtkVector3d& from, const vtkVector3d& to, double width,
  double height, const vtkVector3d& up)
{
  const vtkVector3d along = (to - from).Normalized();
  const vtkVector3d top = along.Cross(up.Cross(along).Normalized());
  const double flange = 0.16 * height;
  const vtkVector3d lift = 0.5 * (height - flange) * top;
  this->AddBeam(from + lift, to + lift, width, flange, up);
  this->AddBeam(from - lift, to - lift, width, flange, up);
  this->AddBeam(from, to, 0.16 * width, height - 2.0 * flange, up);
}

//------------------------------------------------------------------------------
std::vector<vtkVector3d> ShadowSceneMesh::RoundPath(
  const std::vector<vtkVector3d>& corners, double radius, int segments)
{
  std::vector<vtkVector3d> path;
  path.push_back(corners.front());
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
  {
    const vtkVector3d in = (corners[i] - corners[i - 1]).Normalized();
    const vtkVector3d out = (corners[i + 1] - corners[i]).Normalized();
    const double turn = std::acos(vtkMath::ClampValue(in.Dot(out), -1.0, 1.0));
    // Each leg gives at most 0.45 of its length to an arc, so that two arcs never meet.
    const double reach = std::min({ radius * std::tan(0.5 * turn),
      0.45 * (corners[i] - corners[i - 1]).Norm(), 0.45 * (corners[i + 1] - corners[i]).Norm() });
    const double arc = reach / std::tan(0.5 * turn);
    const vtkVector3d inward = (out - in.Dot(out) * in).Normalized();
    const vtkVector3d center = corners[i] - reach * in + arc * inward;
    for (int k = 0; k <= segments; ++k)
    {
      const double angle = turn * k / segments;
      path.push_back(center + arc * (std::sin(angle) * in - std::cos(angle) * inward));
    }
  }
  path.push_back(corners.back());
  return path;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ShadowSceneMesh::MakePolyData() const
{
  auto polyData = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetData(MakeArray<vtkFloatArray>(this->Points, 3));
  polyData->SetPoints(points);
  auto normals = MakeArray<vtkFloatArray>(this->Normals, 3);
  normals->SetName("Normals");
  polyData->GetPointData()->SetNormals(normals);
  vtkNew<vtkCellArray> triangles;
  triangles->SetData(3, MakeArray<vtkIdTypeArray>(this->Connectivity, 1));
  polyData->SetPolys(triangles);
  return polyData;
}
