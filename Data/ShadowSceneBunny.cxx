// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowSceneBunny.h"

#include "ShadowSceneBuilders.h"
#include "ShadowSceneStage.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkFlyingEdges3D.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkLoopSubdivisionFilter.h"
#include "vtkNew.h"
#include "vtkPLYReader.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataNormals.h"
#include "vtkQuadricDecimation.h"
#include "vtkRenderer.h"
#include "vtkShadowVTKVersion.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLPolyDataWriter.h"

#include <dlfcn.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <vector>

namespace fs = std::filesystem;
namespace stage = ShadowSceneStage;

namespace
{
std::string Note;

//------------------------------------------------------------------------------
// The folder of the library that this is in, or of the program where it is linked into that.
fs::path GetLibraryDirectory()
{
  Dl_info info = {};
  std::error_code error;
  fs::path library = dladdr(&Note, &info) ? fs::canonical(info.dli_fname, error) : fs::path();
  if (library.empty()) // such as a program that was found by PATH
  {
    library = fs::read_symlink("/proc/self/exe", error);
  }
  return library.parent_path();
}

//------------------------------------------------------------------------------
// The directory that holds bunny.ply, or an empty path and a note.
fs::path FindModelDirectory()
{
  const char* environment = std::getenv("SOFTSHADOWS_DATA");
  std::vector<fs::path> places;
  if (environment && *environment)
  {
    places.emplace_back(environment);
  }
  // As installed; then as built, or beside a program.
  const fs::path library = GetLibraryDirectory();
  places.push_back((library / SOFTSHADOWS_DATA_FROM_LIBRARY).lexically_normal());
  places.push_back(library.parent_path() / "share" / "softshadows" / "models");
  std::string looked;
  for (const fs::path& place : places)
  {
    std::error_code error;
    if (fs::is_regular_file(place / "bunny.ply", error))
    {
      return place;
    }
    looked += (looked.empty() ? "" : ", ") + place.string();
  }
  Note = "bunny.ply not found (looked in " + looked + "); a procedural model stands in";
  return fs::path();
}

//------------------------------------------------------------------------------
// Remove the lowest triangles, where nobody sees them. A closed mesh has an even number of
// triangles, so that an odd number costs it one: a hole in the underside, as the scanned bunny has.
void DropLowestTriangles(vtkPolyData* mesh, vtkIdType count)
{
  std::vector<std::pair<double, vtkIdType>> heights;
  vtkNew<vtkIdList> corners;
  for (vtkIdType cell = 0; cell < mesh->GetPolys()->GetNumberOfCells(); ++cell)
  {
    mesh->GetPolys()->GetCellAtId(cell, corners);
    double height = 0.0;
    for (vtkIdType k = 0; k < corners->GetNumberOfIds(); ++k)
    {
      height += mesh->GetPoint(corners->GetId(k))[2];
    }
    heights.emplace_back(height, cell);
  }
  std::sort(heights.begin(), heights.end());
  std::vector<bool> drop(heights.size(), false);
  for (vtkIdType k = 0; k < count; ++k)
  {
    drop[heights[k].second] = true;
  }
  vtkNew<vtkCellArray> kept;
  for (vtkIdType cell = 0; cell < mesh->GetPolys()->GetNumberOfCells(); ++cell)
  {
    if (!drop[cell])
    {
      mesh->GetPolys()->GetCellAtId(cell, corners);
      kept->InsertNextCell(corners);
    }
  }
  mesh->SetPolys(kept);
  mesh->DeleteCells();
}

//------------------------------------------------------------------------------
// Decimate to exactly so many triangles. The filter stops where its last collapse leads it, so the
// goal is moved until it lands on the number or at most two above.
vtkSmartPointer<vtkPolyData> Decimate(vtkPolyData* mesh, vtkIdType triangles)
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  const auto before = static_cast<double>(mesh->GetNumberOfPolys());
  vtkIdType goal = triangles + triangles % 2;
  for (int attempt = 0; attempt < 8; ++attempt)
  {
    vtkNew<vtkQuadricDecimation> decimation;
    decimation->SetInputData(mesh);
    decimation->SetTargetReduction(1.0 - (static_cast<double>(goal) + 0.5) / before);
    decimation->Update();
    result->ShallowCopy(decimation->GetOutput());
    const vtkIdType excess = result->GetNumberOfPolys() - triangles;
    if (excess >= 0 && excess <= 2)
    {
      break;
    }
    goal -= excess < 0 ? excess - 1 : excess;
  }
  DropLowestTriangles(result, std::max<vtkIdType>(0, result->GetNumberOfPolys() - triangles));
  return result;
}

//------------------------------------------------------------------------------
// Move and scale: height 1, standing on z = 0, centred in x and y.
void StandUpright(vtkPolyData* mesh)
{
  double bounds[6];
  mesh->ComputeBounds();
  mesh->GetBounds(bounds);
  const double scale = 1.0 / (bounds[5] - bounds[4]);
  vtkNew<vtkPoints> points;
  points->SetNumberOfPoints(mesh->GetNumberOfPoints());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    points->SetPoint(i, scale * (p[0] - 0.5 * (bounds[0] + bounds[1])),
      scale * (p[1] - 0.5 * (bounds[2] + bounds[3])), scale * (p[2] - bounds[4]));
  }
  mesh->SetPoints(points);
}

//------------------------------------------------------------------------------
// The stand-in: a contour of blobs that flow into each other, of as many triangles as the bunny.
vtkSmartPointer<vtkPolyData> ModelBunny()
{
  struct Blob
  {
    vtkVector3d Center, Radii;
    double Lean; // of its upper part along x, per unit of height
  };
  std::vector<Blob> blobs = {
    { { 0.08, 0.00, 0.32 }, { 0.40, 0.28, 0.31 }, 0.0 },  // body
    { { -0.15, 0.00, 0.38 }, { 0.22, 0.23, 0.26 }, 0.0 }, // chest
    { { -0.34, 0.00, 0.68 }, { 0.20, 0.16, 0.17 }, 0.0 }, // head
    { { -0.48, 0.00, 0.64 }, { 0.10, 0.09, 0.08 }, 0.0 }, // snout
    { { 0.50, 0.00, 0.22 }, { 0.10, 0.10, 0.10 }, 0.0 },  // tail
  };
  for (const double side : { -1.0, 1.0 })
  {
    blobs.push_back({ { -0.22, 0.09 * side, 0.98 }, { 0.065, 0.05, 0.22 }, 0.45 }); // ears
    blobs.push_back({ { -0.22, 0.11 * side, 0.18 }, { 0.08, 0.07, 0.16 }, 0.0 });   // forelegs
    blobs.push_back({ { -0.29, 0.11 * side, 0.06 }, { 0.13, 0.07, 0.06 }, 0.0 });   // forepaws
    blobs.push_back({ { 0.18, 0.22 * side, 0.20 }, { 0.25, 0.12, 0.20 }, 0.0 });    // thighs
    blobs.push_back({ { 0.05, 0.24 * side, 0.06 }, { 0.22, 0.08, 0.06 }, 0.0 });    // hind paws
  }
  constexpr int cells = 110;
  constexpr double spacing = 1.5 / cells;
  vtkNew<vtkImageData> field;
  field->SetDimensions(cells, cells, cells);
  field->SetOrigin(-0.75, -0.75, -0.15);
  field->SetSpacing(spacing, spacing, spacing);
  field->AllocateScalars(VTK_FLOAT, 1);
  auto* value = static_cast<float*>(field->GetScalarPointer());
  for (vtkIdType id = 0; id < field->GetNumberOfPoints(); ++id)
  {
    const vtkVector3d point(field->GetPoint(id));
    double sum = 0.0;
    for (const Blob& blob : blobs)
    {
      vtkVector3d arm = point - blob.Center;
      arm[0] -= blob.Lean * arm[2];
      arm.Set(arm[0] / blob.Radii[0], arm[1] / blob.Radii[1], arm[2] / blob.Radii[2]);
      sum += std::exp(-4.0 * (arm.SquaredNorm() - 1.0));
    }
    value[id] = static_cast<float>(sum);
  }
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(field);
  contour->SetValue(0, 1.00037);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  contour->Update();
  auto mesh = Decimate(contour->GetOutput(), ShadowSceneBunny::OriginalTriangles);
  StandUpright(mesh);
  return mesh;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReadBunny(const fs::path& directory)
{
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName((directory / "bunny.ply").string().c_str());
  reader->Update();
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->ShallowCopy(reader->GetOutput());
  return mesh;
}

//------------------------------------------------------------------------------
void ComputeNormals(vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(mesh);
  normals->SplittingOff();
  normals->ConsistencyOff();
  normals->Update();
  mesh->ShallowCopy(normals->GetOutput());
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> Subdivide(vtkPolyData* bunny)
{
  vtkNew<vtkLoopSubdivisionFilter> subdivision;
  subdivision->SetInputData(bunny);
  subdivision->SetNumberOfSubdivisions(3);
  subdivision->Update();
  auto mesh = Decimate(subdivision->GetOutput(), ShadowSceneBunny::SubdividedTriangles);
  StandUpright(mesh);
  ComputeNormals(mesh);
  return mesh;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReadCache(const fs::path& cache, const fs::path& origin)
{
  std::error_code error;
  const auto written = fs::last_write_time(cache, error);
  if (error || written < fs::last_write_time(origin, error))
  {
    return nullptr;
  }
  vtkNew<vtkXMLPolyDataReader> reader;
  if (!reader->CanReadFile(cache.string().c_str()))
  {
    return nullptr;
  }
  reader->SetFileName(cache.string().c_str());
  reader->Update();
  vtkPolyData* mesh = reader->GetOutput();
  if (mesh->GetNumberOfPolys() != ShadowSceneBunny::SubdividedTriangles ||
      !mesh->GetPointData()->GetNormals())
  {
    return nullptr;
  }
  return mesh;
}

//------------------------------------------------------------------------------
// Written aside and renamed, so that nobody reads half a file. Failure is no matter.
void WriteCache(vtkPolyData* mesh, const fs::path& cache)
{
  fs::path part = cache;
  part += "." + std::to_string(std::random_device()()) + ".part";
  if (!std::ofstream(part))
  {
    return;
  }
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(mesh);
  writer->SetFileName(part.string().c_str());
  std::error_code error;
  if (writer->Write())
  {
    fs::rename(part, cache, error);
  }
  fs::remove(part, error);
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ShadowSceneBunny::GetBunny(int triangles)
{
  const fs::path directory = FindModelDirectory();
  const fs::path cache = directory / "bunny-16301.vtp";
  const bool subdivided = triangles == SubdividedTriangles;
  if (subdivided && !directory.empty())
  {
    if (auto kept = ReadCache(cache, directory / "bunny.ply"))
    {
      return kept;
    }
  }
  vtkSmartPointer<vtkPolyData> bunny;
  if (!directory.empty())
  {
    bunny = ReadBunny(directory);
    if (bunny->GetNumberOfPolys() != OriginalTriangles)
    {
      Note = (directory / "bunny.ply").string() + " does not hold the " +
             std::to_string(OriginalTriangles) +
             " triangles expected; a procedural model stands in";
      bunny = nullptr;
    }
  }
  const bool found = bunny != nullptr;
  if (!found)
  {
    bunny = ModelBunny();
  }
  if (!subdivided)
  {
    ComputeNormals(bunny);
    return bunny;
  }
  bunny = Subdivide(bunny);
  if (found)
  {
    WriteCache(bunny, cache);
  }
  return bunny;
}

//------------------------------------------------------------------------------
std::string ShadowSceneBunny::GetNote()
{
  return Note;
}

//------------------------------------------------------------------------------
void ShadowSceneBunny::ClearNote()
{
  Note.clear();
}

//------------------------------------------------------------------------------
void ShadowSceneBuilders::Bunny(vtkRenderer* renderer, int)
{
  stage::AddFloor(renderer, 3.0);
  stage::AddActor(
    renderer, ShadowSceneBunny::GetBunny(ShadowSceneBunny::OriginalTriangles), stage::Bone);
  stage::AddSphereLight(renderer, vtkVector3d(-1.5, -1.0, 2.4), vtkVector3d(0.0, 0.0, 0.5), 0.12);
  stage::SetCamera(renderer, vtkVector3d(1.4, -3.6, 2.1), vtkVector3d(0.15, 0.0, 0.43));
}

//------------------------------------------------------------------------------
void ShadowSceneBuilders::Huge(vtkRenderer* renderer, int)
{
  struct Placement
  {
    vtkVector3d Position;
    double Scale;
    double Turn[3]; // degrees about x, then y, then z
    stage::Color Color;
  };
  const Placement placements[] = {
    { { 0.0, 0.3, 0.0 }, 1.8, { 0.0, 0.0, 10.0 }, stage::Bone },
    { { -1.7, -0.5, 0.0 }, 1.0, { 0.0, 0.0, 75.0 }, stage::Clay },
    { { 1.6, -0.6, 0.0 }, 1.2, { 0.0, 0.0, -55.0 }, stage::Sage },
    { { -0.3, -1.7, 0.0 }, 0.7, { 0.0, 0.0, 150.0 }, stage::Ochre },
    { { 1.9, 1.5, 0.0 }, 1.4, { 0.0, 0.0, 200.0 }, stage::Sky },
    { { -1.6, 1.4, 1.3 }, 0.9, { 20.0, -25.0, 30.0 }, stage::Plum },
    { { 1.1, -1.2, 1.7 }, 0.5, { -30.0, 20.0, -20.0 }, stage::Rose },
  };
  stage::AddFloor(renderer, 7.0);
  const auto bunny = ShadowSceneBunny::GetBunny(ShadowSceneBunny::SubdividedTriangles);
  for (const Placement& placement : placements)
  {
    vtkActor* actor = stage::AddActor(renderer, bunny, placement.Color);
    actor->SetPosition(placement.Position[0], placement.Position[1], placement.Position[2]);
    actor->SetScale(placement.Scale);
    actor->RotateX(placement.Turn[0]);
    actor->RotateY(placement.Turn[1]);
    actor->RotateZ(placement.Turn[2]);
  }
  stage::AddSphereLight(renderer, vtkVector3d(-4.5, -3.0, 7.0), vtkVector3d(0.0, 0.0, 0.5), 0.5);
  stage::SetCamera(renderer, vtkVector3d(3.6, -8.6, 5.6), vtkVector3d(0.1, 0.0, 0.7));
}
