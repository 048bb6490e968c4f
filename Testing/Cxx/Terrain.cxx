// SPDX-License-Identifier: BSD-3-Clause
// Surfaces of cells that are not flat: terrain, structured grids, skins of finite elements. What casts
// is what VTK draws, cut along the same diagonals; a map's bias does not light what lies in shadow.

#include "ShadowStage.h"
#include "ShadowTest.h"

#include "vtkCellArray.h"
#include "vtkDataSetMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkShadowTechniques.h"
#include "vtkShadowVTKVersion.h"
#include "vtkStructuredGrid.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace
{
/** A square of so many quads a side, 8 wide: hills, and a noise as steep at any number of quads. */
vtkSmartPointer<vtkPoints> MakeHills(int side)
{
  std::mt19937 random(1);
  vtkNew<vtkPoints> points;
  for (int j = 0; j <= side; ++j)
  {
    for (int i = 0; i <= side; ++i)
    {
      const double x = 8.0 * i / side - 4.0;
      const double y = 8.0 * j / side - 4.0;
      // The sum of four evenly spread numbers, of variance 1/3.
      double noise = -2.0;
      for (int k = 0; k < 4; ++k)
      {
        noise += static_cast<double>(random()) / 4294967296.0;
      }
      points->InsertNextPoint(x, y,
        0.4 * std::sin(1.5 * x) * std::cos(1.2 * y) +
          0.1 * std::sin(5.0 * x + 1.0) * std::sin(4.0 * y) + 8.0 / side * noise);
    }
  }
  return points;
}

std::vector<std::vector<vtkIdType>> MakeQuads(int side)
{
  std::vector<std::vector<vtkIdType>> cells;
  for (vtkIdType j = 0; j < side; ++j)
  {
    for (vtkIdType i = 0; i < side; ++i)
    {
      const vtkIdType first = i + j * (side + 1);
      cells.push_back({ first, first + 1, first + side + 2, first + side + 1 });
    }
  }
  return cells;
}

vtkSmartPointer<vtkPolyData> MakePolygons(
  vtkPoints* points, const std::vector<std::vector<vtkIdType>>& cells)
{
  vtkNew<vtkCellArray> array;
  for (const auto& cell : cells)
  {
    array->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
  }
  vtkNew<vtkPolyData> polygons;
  polygons->SetPoints(points);
  polygons->SetPolys(array);
  return polygons;
}

/** Fans, as VTK's mappers draw cells of up to four corners, and all to 9.6. */
std::vector<std::vector<vtkIdType>> Fan(const std::vector<std::vector<vtkIdType>>& cells)
{
  std::vector<std::vector<vtkIdType>> triangles;
  for (const auto& cell : cells)
  {
    for (std::size_t k = 2; k < cell.size(); ++k)
    {
      triangles.push_back({ cell[0], cell[k - 1], cell[k] });
    }
  }
  return triangles;
}

enum class Kind
{
  Polygons,
  Grid
};

/** Hills under a sun of this elevation in degrees. */
Visibility ShowHills(const std::string& technique, int side, double sun, Kind kind)
{
  ShadowStage stage(240, 180);
  vtkNew<vtkActor> actor;
  if (kind == Kind::Grid)
  {
    vtkNew<vtkStructuredGrid> grid;
    grid->SetDimensions(side + 1, side + 1, 1);
    grid->SetPoints(MakeHills(side));
    vtkNew<vtkDataSetMapper> mapper;
    mapper->SetInputData(grid);
    actor->SetMapper(mapper);
  }
  else
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(MakePolygons(MakeHills(side), MakeQuads(side)));
    actor->SetMapper(mapper);
  }
  stage.Renderer->AddActor(actor);
  const double elevation = glm::radians(sun);
  vtkLight* light = stage.AddLight(LightKind::Directional,
    { 8.0 * std::cos(elevation), 5.0 * std::cos(elevation), 9.43 * std::sin(elevation) },
    glm::dvec3(0.0));
  vtkAreaLight::SafeDownCast(light)->SetAngularDiameter(0.0);
  stage.LookAt({ 0.0, -9.0, 6.5 }, glm::dvec3(0.0), 40.0);
  // As a user has it: no parameter is set.
  stage.Pass = vtkSmartPointer<vtkShadowPass>::Take(vtkShadowTechniques::Create(technique));
  stage.Renderer->SetPass(stage.Pass);
  stage.Render();
  return stage.GetVisibility();
}

bool IsVolumeOrRay(const std::string& technique)
{
  return !ShadowStage::HasParameter(technique, "resolution");
}
}

//------------------------------------------------------------------------------
// A quad of which two opposite corners are raised, under a light above it: nothing hides any of it,
// whichever of its corners comes first.
SHADOW_TEST(Terrain, BentQuadHidesNothing, Each)
{
  for (const std::vector<vtkIdType>& cell :
    { std::vector<vtkIdType>{ 0, 1, 2, 3 }, std::vector<vtkIdType>{ 1, 2, 3, 0 } })
  {
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(-1.0, -1.0, 0.6);
    points->InsertNextPoint(1.0, -1.0, 0.0);
    points->InsertNextPoint(1.0, 1.0, 0.6);
    points->InsertNextPoint(-1.0, 1.0, 0.0);
    const Visibility visibility = RenderVisibility(technique, {},
      [&](ShadowStage& stage)
      {
        stage.Add(MakePolygons(points, { cell }));
        stage.AddLight(LightKind::Point, { 0.0, 0.0, 20.0 }, glm::dvec3(0.0));
        stage.LookAt({ 0.0, -4.0, 4.0 }, glm::dvec3(0.0));
      });
    if (ShadowStage::Describe(technique).Traits.PlanarReceivers)
    {
      ShadowTest::TakeMessages(); // nothing is flat
    }
    ShadowTest::CheckAtLeast(
      static_cast<double>(visibility.GetNumberOfReceivers()), 1000.0, "receivers");
    // But at the fold and the border, where a pixel's derivatives are of two triangles.
    double sum = 0.0;
    for (std::size_t i = 0; i < visibility.Mask.size(); ++i)
    {
      sum += visibility.Mask[i] != 0 ? 1.0 - visibility.V[i] : 0.0;
    }
    ShadowTest::CheckAtMost(
      sum / static_cast<double>(visibility.GetNumberOfReceivers()), 0.02, "mean share of dark");
  }
}

//------------------------------------------------------------------------------
// Cells of four, five and eight corners, one of them concave, cast and receive just as the triangles
// that VTK draws of them.
SHADOW_TEST(Terrain, CellsAreTheTrianglesThatAreDrawn, Each)
{
  constexpr int side = 12;
  const vtkSmartPointer<vtkPoints> points = MakeHills(side);
  std::vector<std::vector<vtkIdType>> cells = MakeQuads(side);
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 7, 0) // fans throughout; later, ears
  const auto add = [&](const std::vector<glm::dvec3>& corners)
  {
    cells.emplace_back();
    for (const glm::dvec3& p : corners)
    {
      cells.back().push_back(points->InsertNextPoint(p.x, p.y, p.z));
    }
  };
  add({ { -1.0, -1.0, 2.0 }, { 0.0, -1.5, 2.4 }, { 1.0, -1.0, 2.0 }, { 0.6, 0.5, 1.8 },
    { -0.6, 0.5, 2.2 } });
  add({ { 1.4, 0.0, 2.0 }, { 2.6, 0.2, 2.0 }, { 1.9, 0.5, 2.0 }, { 2.6, 1.6, 2.0 },
    { 1.6, 1.4, 2.1 } });
  add({ { -2.5, 1.0, 1.8 }, { -2.0, 0.7, 2.0 }, { -1.5, 0.8, 1.9 }, { -1.2, 1.2, 2.1 },
    { -1.2, 1.7, 1.8 }, { -1.6, 2.0, 2.0 }, { -2.2, 2.1, 1.9 }, { -2.6, 1.6, 2.2 } });
#endif
  const auto show = [&](const std::vector<std::vector<vtkIdType>>& shown)
  {
    return RenderVisibility(technique, {},
      [&](ShadowStage& stage)
      {
        stage.AddFloor(4.0, -1.0);
        stage.Add(MakePolygons(points, shown));
        stage.AddLight(ShadowStage::Supports(technique, LightKind::Sphere) ? LightKind::Sphere
                                                                           : LightKind::Point,
          { -3.0, -2.0, 6.0 }, glm::dvec3(0.0));
        stage.LookAt({ 1.0, -8.0, 7.0 }, glm::dvec3(0.0), 45.0);
      });
  };
  const Visibility expected = show(Fan(cells));
  ShadowTest::CheckAtMost(GetRange(expected).first, 0.01, "there is a shadow");
  ShadowTest::Check(Same(show(cells), expected), "cells are as their triangles, bit by bit");
}

//------------------------------------------------------------------------------
// Against rays on the same triangles. Maps have about four texels along a quad's side by default, and
// tell details of that size to a texel at their edges. Volumes are exact.
SHADOW_TEST(Terrain, HillsAgainstRays, Each)
{
  if (!vtkShadowTechniqueRegistration::Find("ray-traced") ||
      ShadowStage::Describe(technique).Traits.PlanarReceivers)
  {
    return;
  }
  for (const int side : { 81, 201 })
  {
    for (const double sun : { 60.0, 25.0 })
    {
      const Visibility rays = ShowHills("ray-traced", side, sun, Kind::Polygons);
      for (const Kind kind : { Kind::Polygons, Kind::Grid })
      {
        const Visibility visibility = ShowHills(technique, side, sun, kind);
        double receivers = 0.0;
        double dark = 0.0;
        double lit = 0.0;
        for (std::size_t i = 0; i < rays.V.size(); ++i)
        {
          const bool use = rays.Mask[i] != 0 && visibility.Mask[i] != 0;
          receivers += use ? 1.0 : 0.0;
          dark += use && rays.V[i] > 0.5f && visibility.V[i] < 0.5f ? 1.0 : 0.0;
          lit += use && rays.V[i] < 0.5f && visibility.V[i] > 0.5f ? 1.0 : 0.0;
        }
        const std::string what = std::to_string(side) + (kind == Kind::Grid ? " grid" : " quads") +
                                 ", sun at " + std::to_string(static_cast<int>(sun)) + ": falsely ";
        ShadowTest::CheckAtLeast(receivers, 10000.0, what + "receivers");
        // Texels that the picture's pixels choose are larger than the mesh's cells.
        const bool byPixels = ShadowStage::Describe(technique).Traits.NeedsReceivers;
        ShadowTest::CheckAtMost(dark / receivers, byPixels ? 0.015 : 0.01, what + "dark");
        ShadowTest::CheckAtMost(lit / receivers,
          IsVolumeOrRay(technique) ? 0.003 : (byPixels ? 0.04 : 0.02), what + "lit");
      }
    }
  }
}
