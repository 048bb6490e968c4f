// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowMesh.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkShadowAlpha.h"

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace
{
constexpr std::uint32_t Unused = std::numeric_limits<std::uint32_t>::max();

bool IsFinite(const glm::dvec3& p)
{
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

glm::dvec3 GetPoint(vtkPoints* points, vtkIdType id)
{
  double p[3];
  points->GetPoint(id, p);
  return { p[0], p[1], p[2] };
}

/** The plane of the largest triangle, if all vertices lie in it to float precision. */
void FindPlane(vtkShadowMesh& mesh)
{
  const auto at = [&mesh](std::size_t i)
  {
    const float* p = &mesh.Positions[3 * mesh.Indices[i]];
    return glm::dvec3(p[0], p[1], p[2]);
  };
  double largest = 0.0;
  for (std::size_t i = 0; i < mesh.Indices.size(); i += 3)
  {
    const glm::dvec3 normal = glm::cross(at(i + 1) - at(i), at(i + 2) - at(i));
    const double area = glm::length(normal);
    if (area > largest)
    {
      largest = area;
      mesh.Normal = normal / area;
      mesh.PlanePoint = at(i);
    }
  }
  const double rounding = 1e-6 * glm::length(mesh.Maximum - mesh.Minimum);
  const double tolerance =
    rounding + 1e-7 * glm::length(mesh.Centre); // far from the model's origin, if they were floats
  mesh.Flat = mesh.Sheet = largest > 0.0;
  for (std::size_t i = 0; mesh.Flat && i < mesh.Indices.size(); ++i)
  {
    const double distance = std::abs(glm::dot(mesh.Normal, at(i) - mesh.PlanePoint));
    mesh.Flat = distance <= tolerance;
    mesh.Sheet = mesh.Sheet && distance <= rounding;
  }
}

/** Tells the triangles of a mesh that alpha leaves nothing of, and those that have holes. */
class HoleFinder
{
public:
  HoleFinder(vtkPolyData* source, std::shared_ptr<const vtkShadowAlphaMap> map, float threshold)
    : Places(
        vtkFloatArray::SafeDownCast(source->GetPointData()->GetArray(vtkShadowAlpha::ArrayName)))
    , Map(std::move(map))
    , Threshold(threshold)
  {
  }
  /** Whether a triangle of points is one hole. */
  bool IsClear(const vtkIdType* ids)
  {
    if (!this->Places)
    {
      return false;
    }
    std::array<const float*, 3> corners;
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = this->Places->GetPointer(3 * ids[k]);
    }
    const auto alpha = std::minmax({ corners[0][2], corners[1][2], corners[2][2] });
    if (alpha.second < this->Threshold ||
        (this->Map && this->Map->IsBelow(this->Threshold / alpha.second, corners)))
    {
      return true;
    }
    const float least = alpha.first * (this->Map ? this->Map->Minimum : 1.0f);
    this->Found = this->Found || least < this->Threshold;
    return false;
  }
  /** The holes of the triangles that were asked for, by their points. */
  std::shared_ptr<const vtkShadowHoles> Get(const std::vector<vtkIdType>& points) const
  {
    if (!this->Found)
    {
      return nullptr;
    }
    auto holes = std::make_shared<vtkShadowHoles>();
    for (const vtkIdType id : points)
    {
      const float* place = this->Places->GetPointer(3 * id);
      holes->Places.insert(holes->Places.end(), place, place + 3);
    }
    holes->Map = this->Map;
    holes->Threshold = this->Threshold;
    return holes;
  }

private:
  vtkFloatArray* Places;
  std::shared_ptr<const vtkShadowAlphaMap> Map;
  float Threshold;
  bool Found = false;
};
}

//------------------------------------------------------------------------------
vtkMTimeType vtkShadowMesh::GetShapeTime(vtkPolyData* source)
{
  // Not vtkPolyData::GetMTime, which includes colours.
  vtkMTimeType time = source->vtkObject::GetMTime();
  if (source->GetPoints())
  {
    time = std::max(time, source->GetPoints()->GetMTime());
    time = std::max(time, source->GetPoints()->GetData()->GetMTime());
  }
  time = std::max(time, source->GetPolys()->GetMTime());
  return std::max(time, source->GetStrips()->GetMTime());
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> vtkShadowMesh::Triangulate(vtkPolyData* source)
{
  if (source->GetNumberOfStrips() == 0 && source->GetPolys()->GetMaxCellSize() <= 3)
  {
    return source;
  }
  // By what VTK's mappers fill their index buffers with: a quad that is not flat is then cut along
  // the diagonal that is drawn. Another one would lie beside the surface that receives.
  std::vector<unsigned int> indices;
  vtkOpenGLIndexBufferObject::AppendTriangleIndexBuffer(
    indices, source->GetPolys(), source->GetPoints(), 0, nullptr, nullptr);
  vtkOpenGLIndexBufferObject::AppendStripIndexBuffer(indices, source->GetStrips(), 0, false);
  vtkNew<vtkIdTypeArray> offsets;
  vtkNew<vtkIdTypeArray> connectivity;
  offsets->SetNumberOfValues(static_cast<vtkIdType>(indices.size() / 3 + 1));
  connectivity->SetNumberOfValues(static_cast<vtkIdType>(indices.size()));
  for (vtkIdType i = 0; i < offsets->GetNumberOfValues(); ++i)
  {
    offsets->SetValue(i, 3 * i);
  }
  std::copy(indices.begin(), indices.end(), connectivity->GetPointer(0));
  vtkNew<vtkCellArray> triangles;
  triangles->SetData(offsets, connectivity);
  vtkNew<vtkPolyData> result;
  result->SetPoints(source->GetPoints());
  result->SetPolys(triangles);
  result->GetPointData()->ShallowCopy(source->GetPointData());
  return result;
}

//------------------------------------------------------------------------------
bool vtkShadowMesh::IsSame(const vtkShadowMesh& other) const
{
  const bool sameHoles =
    this->Holes == other.Holes || (this->Holes && other.Holes && *this->Holes == *other.Holes);
  return sameHoles && this->Centre == other.Centre && this->Positions == other.Positions &&
         this->Indices == other.Indices && this->Dropped == other.Dropped &&
         this->NotFinite == other.NotFinite && this->Clear == other.Clear;
}

//------------------------------------------------------------------------------
std::shared_ptr<const vtkShadowMesh> vtkShadowMesh::Make(
  vtkPolyData* source, std::shared_ptr<const vtkShadowAlphaMap> map, float threshold)
{
  auto mesh = std::make_shared<vtkShadowMesh>();
  if (!source->GetPoints() || source->GetNumberOfPolys() + source->GetNumberOfStrips() == 0)
  {
    return mesh;
  }
  const vtkSmartPointer<vtkPolyData> triangles = Triangulate(source);
  vtkPoints* points = triangles->GetPoints();

  HoleFinder holes(source, std::move(map), threshold);

  // First the triangles that can cast, in the source's numbering, then their vertices alone.
  std::vector<vtkIdType> kept;
  kept.reserve(3 * triangles->GetNumberOfPolys());
  auto cell = vtk::TakeSmartPointer(triangles->GetPolys()->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* ids;
    cell->GetCurrentCell(size, ids);
    if (size == 3)
    {
      const glm::dvec3 a = GetPoint(points, ids[0]);
      const glm::dvec3 b = GetPoint(points, ids[1]);
      const glm::dvec3 c = GetPoint(points, ids[2]);
      // Edges scaled to 1 first: a small triangle is no degenerate one, whatever the unit.
      const double longest = std::max(glm::length(b - a), glm::length(c - a));
      const bool finite = IsFinite(a) && IsFinite(b) && IsFinite(c);
      mesh->NotFinite += finite ? 0 : 1;
      if (finite && longest > 0.0 &&
          glm::length(glm::cross((b - a) / longest, (c - a) / longest)) > 0.0)
      {
        if (holes.IsClear(ids))
        {
          ++mesh->Clear;
        }
        else
        {
          kept.insert(kept.end(), ids, ids + 3);
        }
        continue;
      }
    }
    ++mesh->Dropped;
  }
  if (kept.empty())
  {
    return mesh;
  }

  glm::dvec3 minimum(std::numeric_limits<double>::max());
  glm::dvec3 maximum(std::numeric_limits<double>::lowest());
  for (const vtkIdType id : kept)
  {
    const glm::dvec3 p = GetPoint(points, id);
    minimum = glm::min(minimum, p);
    maximum = glm::max(maximum, p);
  }
  mesh->Centre = 0.5 * (minimum + maximum);
  mesh->Minimum = minimum - mesh->Centre;
  mesh->Maximum = maximum - mesh->Centre;

  std::vector<std::uint32_t> number(triangles->GetNumberOfPoints(), Unused);
  std::vector<vtkIdType> used; // points, by their number in the mesh
  mesh->Indices.reserve(kept.size());
  for (const vtkIdType id : kept)
  {
    if (number[id] == Unused)
    {
      used.push_back(id);
      number[id] = static_cast<std::uint32_t>(mesh->Positions.size() / 3);
      const glm::dvec3 p = GetPoint(points, id) - mesh->Centre;
      for (int c = 0; c < 3; ++c)
      {
        mesh->Positions.push_back(static_cast<float>(p[c]));
      }
    }
    mesh->Indices.push_back(number[id]);
  }
  const auto& positions = mesh->Positions;
  for (std::size_t i = 0; i < positions.size(); i += 3)
  {
    mesh->Middle += glm::dvec3(positions[i], positions[i + 1], positions[i + 2]);
  }
  const std::size_t vertices = positions.size() / 3;
  mesh->Middle /= static_cast<double>(vertices);
  for (std::size_t i = 0; i < positions.size(); i += 3)
  {
    const glm::dvec3 p(positions[i], positions[i + 1], positions[i + 2]);
    mesh->Radius = std::max(mesh->Radius, glm::length(p - mesh->Middle));
  }
  mesh->Positions.push_back(0.0f);
  mesh->Positions.shrink_to_fit();
  FindPlane(*mesh);
  mesh->Holes = holes.Get(used);
  return mesh;
}
