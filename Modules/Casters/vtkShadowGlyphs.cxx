// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowGlyphs.h"

#include "vtkBitArray.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCylinderSource.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkGlyph3DMapper.h"
#include "vtkNew.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkOpenGLStickMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkQuaternion.h"
#include "vtkShadowAlpha.h"
#include "vtkShadowMesh.h"
#include "vtkSphereSource.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace
{
// What VTK's classes tell their subclasses alone.
struct Glyph3D : vtkGlyph3DMapper
{
  static constexpr auto Mask = &Glyph3D::GetMaskArray;
  static constexpr auto Index = &Glyph3D::GetSourceIndexArray;
  static constexpr auto Orientation = &Glyph3D::GetOrientationArray;
  static constexpr auto Scale = &Glyph3D::GetScaleArray;
};
struct Spheres : vtkOpenGLSphereMapper
{
  static constexpr auto Scale = &Spheres::ScaleArray;
};
struct Sticks : vtkOpenGLStickMapper
{
  static constexpr auto Scale = &Sticks::ScaleArray;
  static constexpr auto Orientation = &Sticks::OrientationArray;
};

/** Copies of polygons, each by a matrix. */
class Copies
{
public:
  void Add(vtkPolyData* source, const glm::dmat4& matrix)
  {
    const vtkIdType first = this->Points->GetNumberOfPoints();
    vtkPoints* points = source->GetPoints();
    for (vtkIdType i = 0; points && i < points->GetNumberOfPoints(); ++i)
    {
      const double* p = points->GetPoint(i);
      const glm::dvec4 q = matrix * glm::dvec4(p[0], p[1], p[2], 1.0);
      this->Points->InsertNextPoint(q.x, q.y, q.z);
    }
    auto cell = vtk::TakeSmartPointer(source->GetPolys()->NewIterator());
    for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
    {
      vtkIdType size;
      const vtkIdType* ids;
      cell->GetCurrentCell(size, ids);
      this->Polygons->InsertNextCell(static_cast<int>(size));
      for (vtkIdType i = 0; i < size; ++i)
      {
        this->Polygons->InsertCellPoint(first + ids[i]);
      }
    }
  }
  vtkSmartPointer<vtkPolyData> Get()
  {
    auto result = vtkSmartPointer<vtkPolyData>::New();
    result->SetPoints(this->Points);
    result->SetPolys(this->Polygons);
    return result;
  }

private:
  vtkNew<vtkPoints> Points; // floats, as VTK places them on the GPU
  vtkNew<vtkCellArray> Polygons;
};

/** Sides of a circle that stand for the round, so that all together have two million triangles. */
int GetSides(double count)
{
  return std::clamp(static_cast<int>(std::sqrt(2e6 / std::max(count, 1.0))), 8, 32);
}

glm::dvec3 GetVector(vtkDataArray* array, vtkIdType i)
{
  const double* tuple = array->GetTuple(i);
  return { tuple[0], tuple[1], tuple[2] };
}

vtkDataArray* GetArray(vtkPolyData* input, const char* name)
{
  return name ? input->GetPointData()->GetArray(name) : nullptr;
}

vtkMTimeType GetTime(vtkObject* object)
{
  return object ? object->GetMTime() : 0;
}

/** A sphere at each place. */
vtkSmartPointer<vtkPolyData> MakeSpheres(vtkPolyData* input, const std::vector<vtkIdType>& places,
  const std::function<double(vtkIdType)>& getRadius)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1.0);
  const int sides = GetSides(static_cast<double>(places.size()));
  sphere->SetThetaResolution(sides);
  sphere->SetPhiResolution(sides / 2 + 1);
  sphere->Update();
  Copies copies;
  for (const vtkIdType i : places)
  {
    const double radius = getRadius(i);
    if (radius > 0.0) // not NaN either
    {
      const double* p = input->GetPoint(i);
      copies.Add(sphere->GetOutput(),
        glm::scale(
          glm::translate(glm::dmat4(1.0), glm::dvec3(p[0], p[1], p[2])), glm::dvec3(radius)));
    }
  }
  return copies.Get();
}

/** Which points of data are there, by their colours' alpha. */
std::function<bool(vtkIdType)> GetPresence(vtkMapper* mapper, vtkDataSet* data, double threshold)
{
  return [points = vtkShadowAlpha::FindPoints(mapper, data, threshold)](vtkIdType i)
  { return points.empty() || points[i]; };
}

std::vector<vtkIdType> GetAllPoints(vtkPolyData* input)
{
  std::vector<vtkIdType> all(input->GetNumberOfPoints());
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    all[i] = static_cast<vtkIdType>(i);
  }
  return all;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeSphereImposters(
  vtkOpenGLSphereMapper* mapper, vtkPolyData* input, double threshold)
{
  vtkDataArray* scales = GetArray(input, mapper->*Spheres::Scale);
  const double radius = mapper->GetRadius();
  const auto isThere = GetPresence(mapper, input, threshold);
  return MakeSpheres(input, GetAllPoints(input),
    [=](vtkIdType i) { return isThere(i) ? (scales ? scales->GetComponent(i, 0) : radius) : 0.0; });
}

//------------------------------------------------------------------------------
// Cylinders around their points, along a direction times a length.
vtkSmartPointer<vtkPolyData> MakeSticks(
  vtkOpenGLStickMapper* mapper, vtkPolyData* input, double threshold)
{
  vtkDataArray* sizes = GetArray(input, mapper->*Sticks::Scale);
  vtkDataArray* directions = GetArray(input, mapper->*Sticks::Orientation);
  const auto isThere = GetPresence(mapper, input, threshold);
  Copies copies;
  if (sizes && directions && sizes->GetNumberOfComponents() >= 2 &&
      directions->GetNumberOfComponents() == 3)
  {
    vtkNew<vtkCylinderSource> cylinder; // along y, of length and radius 1
    cylinder->SetRadius(1.0);
    cylinder->SetResolution(GetSides(input->GetNumberOfPoints() * 8.0));
    cylinder->Update();
    for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
    {
      const glm::dvec3 along = sizes->GetComponent(i, 0) * GetVector(directions, i);
      const double radius = sizes->GetComponent(i, 1);
      const double length = glm::length(along);
      if (length > 0.0 && radius > 0.0 && isThere(i))
      {
        // Any two axes across; the longest component of `along` leaves another axis well clear of it.
        const glm::dvec3 axis =
          std::abs(along.x) < 0.7 * length ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        const glm::dvec3 x = glm::normalize(glm::cross(along, axis));
        const glm::dvec3 z = glm::cross(x, along / length);
        const double* p = input->GetPoint(i);
        copies.Add(
          cylinder->GetOutput(), glm::dmat4(glm::dvec4(radius * x, 0.0), glm::dvec4(along, 0.0),
                                   glm::dvec4(radius * z, 0.0), glm::dvec4(p[0], p[1], p[2], 1.0)));
      }
    }
  }
  return copies.Get();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeGaussians(
  vtkPointGaussianMapper* mapper, vtkPolyData* input, double threshold)
{
  std::vector<vtkIdType> places;
  if (!mapper->GetEmissive() && mapper->GetScaleFactor() > 0.0)
  {
    auto cell = vtk::TakeSmartPointer(input->GetVerts()->NewIterator());
    for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell())
    {
      vtkIdType size;
      const vtkIdType* ids;
      cell->GetCurrentCell(size, ids);
      places.insert(places.end(), ids, ids + size);
    }
    if (places.empty())
    {
      places = GetAllPoints(input);
    }
  }
  vtkDataArray* scales = GetArray(input, mapper->GetScaleArray());
  vtkPiecewiseFunction* function = mapper->GetScaleFunction();
  const int component = mapper->GetScaleArrayComponent();
  const std::string splat = mapper->GetSplatShaderCode() ? mapper->GetSplatShaderCode() : "";
  // exp(-r^2 / 2) is a half at this r; a shader of the user's is taken to fill its radius.
  const double edge = splat.empty() ? std::sqrt(2.0 * std::log(2.0)) : 1.0;
  const auto isThere = GetPresence(mapper, input, threshold);
  return MakeSpheres(input, places,
    [=](vtkIdType i)
    {
      if (!isThere(i))
      {
        return 0.0;
      }
      double size = 1.0;
      if (scales)
      {
        const int components = scales->GetNumberOfComponents();
        // Beyond the components stands their magnitude.
        size = component < components ? scales->GetComponent(i, component)
                                      : vtkMath::Norm(scales->GetTuple(i), components);
      }
      return edge * mapper->GetScaleFactor() * (function ? function->GetValue(size) : size);
    });
}

//------------------------------------------------------------------------------
// The sources of a vtkGlyph3DMapper: of each number in its table, the polygons.
std::vector<std::vector<vtkPolyData*>> GetSources(vtkGlyph3DMapper* mapper)
{
  std::vector<std::vector<vtkPolyData*>> sources;
  const auto add = [&sources](vtkDataObject* source)
  {
    std::vector<vtkPolyData*> polygons;
    if (auto* tree = vtkDataObjectTree::SafeDownCast(source))
    {
      for (vtkDataObject* leaf : vtk::Range(tree))
      {
        if (auto* part = vtkPolyData::SafeDownCast(leaf))
        {
          polygons.push_back(part);
        }
      }
    }
    else if (auto* part = vtkPolyData::SafeDownCast(source))
    {
      polygons.push_back(part);
    }
    sources.push_back(polygons);
  };
  if (mapper->GetUseSourceTableTree())
  {
    if (vtkDataObjectTree* table = mapper->GetSourceTableTree())
    {
      for (vtkDataObject* child : vtk::Range(table, vtk::DataObjectTreeOptions::None))
      {
        add(child);
      }
    }
  }
  else
  {
    for (int i = 0; i < mapper->GetNumberOfInputConnections(1); ++i)
    {
      add(mapper->GetSource(i));
    }
  }
  return sources;
}

/** The input's data sets that are shown: itself, or its blocks by their own switches. */
std::vector<vtkDataSet*> GetShown(vtkGlyph3DMapper* mapper)
{
  vtkDataObject* input = mapper->GetInputDataObject(0, 0);
  if (auto* data = vtkDataSet::SafeDownCast(input))
  {
    return { data };
  }
  std::vector<vtkDataSet*> shown;
  if (auto* tree = vtkDataObjectTree::SafeDownCast(input))
  {
    vtkCompositeDataDisplayAttributes* attributes = mapper->GetBlockAttributes();
    for (vtkDataObject* block : vtk::Range(tree))
    {
      auto* data = vtkDataSet::SafeDownCast(block);
      if (data && (!attributes || attributes->GetBlockVisibility(block)))
      {
        shown.push_back(data);
      }
    }
  }
  return shown;
}

glm::dmat3 GetTurn(int mode, vtkDataArray* array, vtkIdType i)
{
  glm::dmat3 turn(1.0);
  if (mode == vtkGlyph3DMapper::QUATERNION && array->GetNumberOfComponents() == 4)
  {
    double rows[3][3];
    vtkQuaterniond(array->GetTuple(i)).ToMatrix3x3(rows);
    for (int k = 0; k < 9; ++k)
    {
      turn[k % 3][k / 3] = rows[k / 3][k % 3];
    }
  }
  else if (mode == vtkGlyph3DMapper::ROTATION && array->GetNumberOfComponents() == 3)
  {
    // About y, then x, then z, as a vtkProp3D.
    const glm::dvec3 angles = glm::radians(GetVector(array, i));
    glm::dmat4 all = glm::rotate(glm::dmat4(1.0), angles.z, glm::dvec3(0, 0, 1));
    all = glm::rotate(all, angles.x, glm::dvec3(1, 0, 0));
    turn = glm::dmat3(glm::rotate(all, angles.y, glm::dvec3(0, 1, 0)));
  }
  else if (mode == vtkGlyph3DMapper::DIRECTION && array->GetNumberOfComponents() == 3)
  {
    // The half turn that brings x there.
    const glm::dvec3 direction = GetVector(array, i);
    const double length = glm::length(direction);
    glm::dvec3 half = direction + glm::dvec3(length, 0, 0);
    if (direction.y == 0.0 && direction.z == 0.0)
    {
      if (!(direction.x < 0.0))
      {
        return turn;
      }
      half = glm::dvec3(0, 1, 0);
    }
    half = glm::normalize(half);
    turn = 2.0 * glm::outerProduct(half, half) - glm::dmat3(1.0);
  }
  return turn;
}

glm::dvec3 GetScale(vtkGlyph3DMapper* mapper, vtkDataArray* array, vtkIdType i)
{
  glm::dvec3 scale(1.0);
  const int mode = array ? mapper->GetScaleMode() : vtkGlyph3DMapper::NO_DATA_SCALING;
  if (mode == vtkGlyph3DMapper::SCALE_BY_MAGNITUDE)
  {
    scale = glm::dvec3(vtkMath::Norm(array->GetTuple(i), array->GetNumberOfComponents()));
  }
  else if (mode == vtkGlyph3DMapper::SCALE_BY_COMPONENTS && array->GetNumberOfComponents() == 3)
  {
    scale = GetVector(array, i);
  }
  if (mode != vtkGlyph3DMapper::NO_DATA_SCALING && mapper->GetClamping())
  {
    const double* range = mapper->GetRange();
    const double width = range[1] != range[0] ? range[1] - range[0] : 1.0;
    scale = (glm::clamp(scale, glm::dvec3(range[0]), glm::dvec3(range[1])) - range[0]) / width;
  }
  return scale * mapper->GetScaleFactor();
}

vtkSmartPointer<vtkPolyData> MakeGlyphs(vtkGlyph3DMapper* mapper, double threshold)
{
  std::vector<std::vector<vtkSmartPointer<vtkPolyData>>> sources;
  for (const auto& parts : GetSources(mapper))
  {
    sources.emplace_back();
    for (vtkPolyData* part : parts)
    {
      sources.back().push_back(vtkShadowMesh::Triangulate(part));
    }
  }
  Copies copies;
  for (vtkDataSet* data : GetShown(mapper))
  {
    vtkDataArray* orientations = (mapper->*Glyph3D::Orientation)(data);
    vtkDataArray* indices = (mapper->*Glyph3D::Index)(data);
    vtkDataArray* scales = (mapper->*Glyph3D::Scale)(data);
    auto* mask =
      mapper->GetMasking() ? vtkBitArray::SafeDownCast((mapper->*Glyph3D::Mask)(data)) : nullptr;
    const auto isThere = GetPresence(mapper, data, threshold);
    for (vtkIdType i = 0; i < data->GetNumberOfPoints() && !sources.empty(); ++i)
    {
      if ((mask && mask->GetValue(i) == 0) || !isThere(i))
      {
        continue;
      }
      const double index =
        indices ? vtkMath::Norm(indices->GetTuple(i), indices->GetNumberOfComponents()) : 0.0;
      double p[3];
      data->GetPoint(i, p);
      glm::dmat4 matrix = glm::translate(glm::dmat4(1.0), glm::dvec3(p[0], p[1], p[2]));
      if (orientations)
      {
        matrix *= glm::dmat4(GetTurn(mapper->GetOrientationMode(), orientations, i));
      }
      if (mapper->GetScaling())
      {
        matrix = glm::scale(matrix, GetScale(mapper, scales, i));
      }
      const double last = static_cast<double>(sources.size() - 1);
      for (const auto& part : sources[static_cast<std::size_t>(std::clamp(index, 0.0, last))])
      {
        copies.Add(part, matrix);
      }
    }
  }
  return copies.Get();
}
}

//------------------------------------------------------------------------------
bool vtkShadowGlyphs::IsMadeBy(vtkMapper* mapper)
{
  return mapper->IsA("vtkGlyph3DMapper") || mapper->IsA("vtkPointGaussianMapper") ||
         mapper->IsA("vtkOpenGLSphereMapper") || mapper->IsA("vtkOpenGLStickMapper");
}

//------------------------------------------------------------------------------
bool vtkShadowGlyphs::IsRepresented(vtkMapper* mapper)
{
  return mapper->IsA("vtkGlyph3DMapper");
}

//------------------------------------------------------------------------------
vtkMTimeType vtkShadowGlyphs::GetShapeTime(vtkMapper* mapper)
{
  vtkMTimeType time = mapper->vtkObject::GetMTime(); // not its colours
  if (auto* glyphs = vtkGlyph3DMapper::SafeDownCast(mapper))
  {
    time = std::max(time, GetTime(glyphs->GetBlockAttributes()));
    for (const auto& parts : GetSources(glyphs))
    {
      for (vtkPolyData* part : parts)
      {
        time = std::max(time, vtkShadowMesh::GetShapeTime(part));
      }
    }
    for (vtkDataSet* data : GetShown(glyphs))
    {
      auto* points = vtkPointSet::SafeDownCast(data);
      time = std::max(time, points ? points->vtkObject::GetMTime() : data->GetMTime());
      time = std::max(time, points ? GetTime(points->GetPoints()) : 0);
      for (const auto array :
        { Glyph3D::Mask, Glyph3D::Index, Glyph3D::Orientation, Glyph3D::Scale })
      {
        time = std::max(time, GetTime((glyphs->*array)(data)));
      }
    }
    return time;
  }
  auto* input = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
  if (!input)
  {
    return time;
  }
  time = std::max(time, vtkShadowMesh::GetShapeTime(input));
  if (auto* spheres = vtkOpenGLSphereMapper::SafeDownCast(mapper))
  {
    time = std::max(time, GetTime(GetArray(input, spheres->*Spheres::Scale)));
  }
  else if (auto* sticks = vtkOpenGLStickMapper::SafeDownCast(mapper))
  {
    time = std::max(time, GetTime(GetArray(input, sticks->*Sticks::Scale)));
    time = std::max(time, GetTime(GetArray(input, sticks->*Sticks::Orientation)));
  }
  else if (auto* points = vtkPointGaussianMapper::SafeDownCast(mapper))
  {
    time = std::max(time, input->GetVerts()->GetMTime());
    time = std::max(time, GetTime(GetArray(input, points->GetScaleArray())));
    time = std::max(time, GetTime(points->GetScaleFunction()));
  }
  return time;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkShadowGlyphs::GetAlphaTime(vtkMapper* mapper)
{
  vtkMTimeType time = 0;
  if (auto* glyphs = vtkGlyph3DMapper::SafeDownCast(mapper))
  {
    for (vtkDataSet* data : GetShown(glyphs))
    {
      time = std::max(time, vtkShadowAlpha::FindColors(mapper, data).Time);
    }
  }
  else if (auto* input = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0)))
  {
    time = vtkShadowAlpha::FindColors(mapper, input).Time;
  }
  return time;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> vtkShadowGlyphs::Make(vtkMapper* mapper, double threshold)
{
  if (auto* glyphs = vtkGlyph3DMapper::SafeDownCast(mapper))
  {
    return MakeGlyphs(glyphs, threshold);
  }
  auto* input = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
  if (input && input->GetPoints())
  {
    if (auto* spheres = vtkOpenGLSphereMapper::SafeDownCast(mapper))
    {
      return MakeSphereImposters(spheres, input, threshold);
    }
    if (auto* sticks = vtkOpenGLStickMapper::SafeDownCast(mapper))
    {
      return MakeSticks(sticks, input, threshold);
    }
    if (auto* points = vtkPointGaussianMapper::SafeDownCast(mapper))
    {
      return MakeGaussians(points, input, threshold);
    }
  }
  return vtkSmartPointer<vtkPolyData>::New();
}
