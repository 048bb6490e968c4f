// SPDX-License-Identifier: BSD-3-Clause
// Casters: touching, thin, many, one within another, and meshes of every kind.

#include "ExtremeScenes.h"

#include "vtkActor.h"
#include "vtkAppendPolyData.h"
#include "vtkAreaLight.h"
#include "vtkCellArray.h"
#include "vtkCubeSource.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkReverseSense.h"
#include "vtkShadowPass.h"
#include "vtkSphereSource.h"
#include "vtkStripper.h"
#include "vtkTriangleFilter.h"

#include <cmath>
#include <limits>

namespace
{
using Shape = ExtremeScene::Shape;

vtkSmartPointer<vtkPolyData> MakeBox(const glm::dvec3& centre, const glm::dvec3& size)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  cube->SetCenter(centre.x, centre.y, centre.z);
  cube->SetXLength(size.x);
  cube->SetYLength(size.y);
  cube->SetZLength(size.z);
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputConnection(cube->GetOutputPort());
  triangles->Update();
  vtkSmartPointer<vtkPolyData> box = triangles->GetOutput();
  return box;
}

vtkSmartPointer<vtkPolyData> MakePolygon(const std::vector<glm::dvec3>& corners, bool strip = false)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(static_cast<int>(corners.size()));
  for (const glm::dvec3& p : corners)
  {
    cells->InsertCellPoint(points->InsertNextPoint(&p.x));
  }
  auto polygon = vtkSmartPointer<vtkPolyData>::New();
  polygon->SetPoints(points);
  strip ? polygon->SetStrips(cells) : polygon->SetPolys(cells);
  return polygon;
}

vtkSmartPointer<vtkPolyData> Append(const std::vector<vtkSmartPointer<vtkPolyData>>& parts)
{
  vtkNew<vtkAppendPolyData> append;
  append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  for (const auto& part : parts)
  {
    append->AddInputData(part);
  }
  append->Update();
  vtkSmartPointer<vtkPolyData> all = append->GetOutput();
  return all;
}

// With cells of some triangles changed: left out, turned over, or taken twice.
vtkSmartPointer<vtkPolyData> Change(vtkPolyData* from, bool leaveOut, bool turn, bool twice)
{
  auto changed = vtkSmartPointer<vtkPolyData>::New();
  changed->SetPoints(from->GetPoints());
  vtkNew<vtkCellArray> cells;
  for (vtkIdType i = 0; i < from->GetNumberOfPolys(); ++i)
  {
    vtkNew<vtkIdList> corners;
    from->GetCellPoints(i, corners);
    const bool picked = i % 3 == 0;
    if (picked && leaveOut)
    {
      continue;
    }
    for (int k = 0; k < (picked && twice ? 2 : 1); ++k)
    {
      const vtkIdType second = corners->GetId(picked && turn ? 2 : 1);
      const vtkIdType third = corners->GetId(picked && turn ? 1 : 2);
      cells->InsertNextCell({ corners->GetId(0), second, third });
    }
  }
  changed->SetPolys(cells);
  return changed;
}

//------------------------------------------------------------------------------
void Contact(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.AddFloor();
  scene.AddBox({ 0.0, 0.0, 0.5 + at.Number }, { 1.0, 1.0, 1.0 });
  scene.AddLight(Shape::Sphere)->SetRadius(0.3);
  scene.LookAt({ 2.2, 1.6, 1.5 }, { 0.5, 0.3, 0.0 }, 50.0);
}

void Wire(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.AddFloor();
  for (int i = 0; i < 5; ++i)
  {
    scene.AddBox({ -1.2 + 0.6 * i, 0.0, 0.4 + 0.3 * i }, { at.Number, 3.0, at.Number });
  }
  scene.AddLight(Shape::Disk)->SetRadius(0.1);
  scene.LookAt({ 3.5, -6.5, 4.5 }, { 0.2, 0.2, 0.3 });
}

// A body that is ever thinner, and in the end a sheet.
void Sheet(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.AddFloor();
  scene.AddBox({ 0.0, 0.0, 1.0 }, { 2.0, 1.4, at.Number });
  scene.AddLight(Shape::Rectangle);
  scene.LookAt({ 3.5, -6.5, 4.5 }, { 0.2, 0.2, 0.3 });
}

void Nested(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.AddFloor();
  const int count = static_cast<int>(at.Number);
  for (int i = 0; i < count; ++i)
  {
    scene.AddSphere({ 0.0, 0.0, 1.2 }, 0.9 * (count - i) / count, 16);
  }
  scene.AddLight(Shape::Rectangle);
  scene.LookAt({ 3.5, -6.5, 4.5 }, { 0.2, 0.2, 0.3 });
}

// Bars along x in one layer and along y in the next, over a floor that receives.
void Stacked(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.AddFloor();
  const int count = static_cast<int>(at.Number);
  for (int layer = 0; layer < count; ++layer)
  {
    const double height = 0.5 + 2.0 * layer / std::max(count - 1, 1);
    std::vector<vtkSmartPointer<vtkPolyData>> bars;
    for (int i = 0; i < 6; ++i)
    {
      const double place = -1.25 + 0.5 * i + 0.01 * layer;
      bars.push_back(layer % 2 == 0
                       ? MakePolygon({ { -1.5, place, height }, { 1.5, place, height },
                           { 1.5, place + 0.25, height }, { -1.5, place + 0.25, height } })
                       : MakePolygon({ { place, -1.5, height }, { place + 0.25, -1.5, height },
                           { place + 0.25, 1.5, height }, { place, 1.5, height } }));
    }
    vtkShadowPass::SetReceiving(scene.Add(Append(bars)), false);
  }
  scene.AddLight(Shape::Rectangle);
  scene.LookAt({ 4.5, -6.5, 5.5 }, { 0.2, 0.2, 0.3 });
}

//------------------------------------------------------------------------------
void Mesh(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.AddFloor();
  scene.AddSphere({ 1.5, -0.5, 0.8 }, 0.5);
  const std::string& kind = at.Word;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto box = MakeBox({ -0.5, 0.0, 1.0 }, { 1.2, 1.2, 1.2 });
  vtkNew<vtkPolyData> empty;
  const std::vector<glm::dvec3> bent = { { -1.1, -0.6, 1.0 }, { 0.1, -0.6, 1.6 }, { 0.1, 0.6, 1.0 },
    { -1.1, 0.6, 1.6 } };
  if (kind == "open")
  {
    scene.Add(Change(box, true, false, false));
  }
  else if (kind == "inconsistent")
  {
    scene.Add(Change(box, false, true, false));
  }
  else if (kind == "duplicate")
  {
    scene.Add(Change(box, false, false, true));
  }
  else if (kind == "inside-out")
  {
    vtkNew<vtkReverseSense> turned;
    turned->SetInputData(box);
    turned->Update();
    scene.Add(turned->GetOutput());
  }
  else if (kind == "non-manifold") // a fin along one of its edges
  {
    scene.Add(
      Append({ box, MakePolygon({ { 0.1, -0.6, 1.6 }, { 0.1, 0.6, 1.6 }, { 0.6, 0.0, 2.2 } }) }));
  }
  else if (kind == "degenerate")
  {
    scene.Add(
      Append({ box, MakePolygon({ { 1e3, 0.0, 2.0 }, { 1e3, 0.0, 2.0 }, { 1e3, 0.0, 2.0 } }),
        MakePolygon({ { -1e3, 0.0, 2.0 }, { 0.0, 0.0, 2.0 }, { 1e3, 0.0, 2.0 } }) }));
  }
  else if (kind == "degenerate-alone")
  {
    scene.Add(box);
    scene.Add(MakePolygon({ { 1e6, 0.0, 2.0 }, { 1e6, 0.0, 2.0 }, { 1e6, 0.0, 2.0 } }));
    scene.Add(MakePolygon({ { 0.0, 0.0, 2.0 }, { 0.5, 0.0, 2.0 }, { 1.0, 0.0, 2.0 } }));
  }
  else if (kind == "nan")
  {
    scene.Add(
      Append({ box, MakePolygon({ { nan, 0.0, 2.0 }, { 0.0, nan, 2.0 }, { 1.0, 0.0, 2.0 } }) }));
  }
  else if (kind == "empty")
  {
    scene.Add(box);
    scene.Add(empty);
  }
  else if (kind == "triangle")
  {
    scene.Add(MakePolygon({ { -1.1, -0.6, 1.0 }, { 0.1, -0.6, 1.0 }, { 0.1, 0.6, 1.4 } }));
  }
  else if (kind == "strip")
  {
    scene.Add(MakePolygon({ { -1.1, -0.6, 1.0 }, { -1.1, 0.6, 1.0 }, { -0.5, -0.6, 1.3 },
                            { -0.5, 0.6, 1.3 }, { 0.1, -0.6, 1.0 }, { 0.1, 0.6, 1.0 } },
      true));
  }
  else if (kind == "quad")
  {
    scene.Add(MakePolygon(
      { { -1.1, -0.6, 1.0 }, { 0.1, -0.6, 1.0 }, { 0.1, 0.6, 1.0 }, { -1.1, 0.6, 1.0 } }));
  }
  else if (kind == "bent-quad")
  {
    scene.Add(MakePolygon(bent));
  }
  else if (kind == "n-gon")
  {
    std::vector<glm::dvec3> corners;
    for (int i = 0; i < 11; ++i)
    {
      corners.emplace_back(-0.5 + 0.7 * std::cos(0.5712 * i), 0.7 * std::sin(0.5712 * i), 1.2);
    }
    scene.Add(MakePolygon(corners));
  }
  else if (kind == "concave")
  {
    scene.Add(MakePolygon({ { -1.1, -0.6, 1.0 }, { 0.1, -0.6, 1.0 }, { -0.7, 0.0, 1.0 },
      { 0.1, 0.6, 1.0 }, { -1.1, 0.6, 1.0 } }));
  }
  else
  {
    scene.Add(box);
  }
  scene.AddLight(Shape::Rectangle);
  scene.LookAt({ 3.5, -6.5, 4.5 }, { 0.2, 0.2, 0.3 });
}

//------------------------------------------------------------------------------
void Props(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.AddThings();
  const int count = static_cast<int>(at.Number);
  const int side = std::max(1, static_cast<int>(std::ceil(std::sqrt(count))));
  for (int i = 0; i < count; ++i)
  {
    scene.AddBox({ -3.5 + 7.0 * (i % side) / side, 2.5 + 1.2 * (i / side) / side, 0.05 },
      glm::dvec3(2.0 / side, 0.5 / side, 0.1));
  }
  scene.AddLight(Shape::Rectangle);
}

void Triangles(ExtremeScene& scene, const ExtremeValue& at)
{
  scene.AddThings();
  scene.AddSphere(
    { -2.0, -1.0, 1.0 }, 0.5, std::max(6, static_cast<int>(std::sqrt(0.5 * at.Number))));
  scene.AddLight(Shape::Rectangle);
}
}

//------------------------------------------------------------------------------
void ExtremeScenes::AddCasters(ExtremeBuilders& builders)
{
  builders["contact"] = Contact;
  builders["wire"] = Wire;
  builders["sheet"] = Sheet;
  builders["nested"] = Nested;
  builders["stacked"] = Stacked;
  builders["mesh"] = Mesh;
  builders["props"] = Props;
  builders["triangles"] = Triangles;
}
