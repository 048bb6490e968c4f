// SPDX-License-Identifier: BSD-3-Clause
#include "Models.h"

#include "Errors.h"
#include "Meshes.h"
#include "ObjFile.h"
#include "ReaderGuard.h"

#include "vtkActorCollection.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetReader.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkGLTFImporter.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkSTLReader.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLStructuredGridReader.h"
#include "vtkXMLUnstructuredGridReader.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace fs = std::filesystem;

namespace
{
using Actors = std::vector<vtkSmartPointer<vtkActor>>;

std::string Quoted(const std::string& path)
{
  return "\"" + path + "\"";
}

std::string GetExtension(const std::string& path)
{
  std::string extension = fs::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return extension;
}

//------------------------------------------------------------------------------
// What can be known before a reader has a look.
void CheckFile(const std::string& path)
{
  std::error_code ignored;
  if (!fs::exists(path, ignored))
  {
    throw Failure("there is no file " + Quoted(path) + ".");
  }
  if (fs::is_directory(path, ignored))
  {
    throw Failure(Quoted(path) + " is a folder, not a model.");
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    throw Failure("cannot read " + Quoted(path) + ": " + std::strerror(errno) + ".");
  }
  if (file.peek() == std::ifstream::traits_type::eof())
  {
    throw Failure(Quoted(path) + " is empty.");
  }
}

//------------------------------------------------------------------------------
// The polygons of a data set: itself, or the outside of its cells.
vtkSmartPointer<vtkPolyData> GetSurface(vtkDataObject* data, const std::string& path)
{
  if (auto* polygons = vtkPolyData::SafeDownCast(data))
  {
    return polygons;
  }
  auto* cells = vtkPointSet::SafeDownCast(data);
  if (!cells)
  {
    const std::string kind = data ? data->GetClassName() : "nothing";
    throw Failure(Quoted(path) + " holds no polygons but " + kind + ".");
  }
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(cells))
  {
    // The filter trusts these.
    double range[2] = { 0.0, -1.0 };
    if (grid->GetCells() && grid->GetCells()->GetNumberOfConnectivityIds() > 0)
    {
      grid->GetCells()->GetConnectivityArray()->GetRange(range);
    }
    if (range[0] < 0.0 || range[1] >= static_cast<double>(grid->GetNumberOfPoints()))
    {
      throw Failure(Quoted(path) + " is damaged: cells refer to points that it does not have.");
    }
  }
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(cells);
  surface->Update();
  vtkSmartPointer<vtkPolyData> polygons = surface->GetOutput();
  return polygons;
}

//------------------------------------------------------------------------------
template <typename Reader>
vtkSmartPointer<vtkPolyData> ReadSurface(
  Reader* reader, const std::string& path, const std::string& copy = "")
{
  reader->SetFileName(copy.empty() ? path.c_str() : copy.c_str());
  reader->Update();
  Messages::Check("cannot read " + Quoted(path));
  return GetSurface(reader->GetOutputDataObject(0), path);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReadSTL(const std::string& path)
{
  vtkNew<vtkSTLReader> reader;
  reader->MergingOff(); // its locator cannot stand points that are not finite; we join them later
  return ReadSurface(reader.Get(), path);
}

//------------------------------------------------------------------------------
void AddMesh(vtkPolyData* surface, Meshes::Report& report, Actors& actors)
{
  const auto mesh = Meshes::Prepare(surface, report);
  if (mesh->GetNumberOfPolys() > 0)
  {
    actors.push_back(Models::MakeActor(mesh));
  }
}

//------------------------------------------------------------------------------
// The parts of a glTF model where its nodes place them, with their base colours. Its cameras, lights
// and what only physically based shading in an environment shows are left.
Actors ReadGLTF(const std::string& path, Meshes::Report& report)
{
  vtkNew<vtkRenderWindow> window; // never opened: the importer wants one
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  vtkNew<vtkGLTFImporter> importer;
  importer->SetFileName(path.c_str());
  importer->SetRenderWindow(window);
  importer->Update();
  Messages::Check("cannot read " + Quoted(path));

  Actors actors;
  vtkActorCollection* parts = renderer->GetActors();
  vtkCollectionSimpleIterator iterator;
  parts->InitTraversal(iterator);
  while (vtkActor* part = parts->GetNextActor(iterator))
  {
    auto* mapper = vtkPolyDataMapper::SafeDownCast(part->GetMapper());
    const std::size_t before = actors.size();
    if (mapper && mapper->GetInput())
    {
      AddMesh(mapper->GetInput(), report, actors);
    }
    const double* matrix = part->GetMatrix()->GetData();
    if (!std::all_of(matrix, matrix + 16, [](double value) { return std::isfinite(value); }))
    {
      throw Failure(Quoted(path) + ": a node's place is not finite.");
    }
    if (actors.size() > before)
    {
      vtkActor* actor = actors.back();
      actor->SetUserMatrix(part->GetMatrix());
      actor->GetProperty()->SetColor(part->GetProperty()->GetColor());
      if (vtkTexture* texture = part->GetProperty()->GetTexture("albedoTex"))
      {
        texture->UseSRGBColorSpaceOff(); // Phong shades the bytes as they are
        actor->SetTexture(texture);
        actor->SetPropertyKeys(part->GetPropertyKeys()); // the texture is upside down
      }
    }
  }
  return actors;
}

//------------------------------------------------------------------------------
Actors ReadAny(const std::string& path, Meshes::Report& report)
{
  const std::string extension = GetExtension(path);
  vtkSmartPointer<vtkPolyData> surface;
  if (extension == ".gltf" || extension == ".glb")
  {
    return ReadGLTF(path, report);
  }
  if (extension == ".obj")
  {
    const ObjFile file(path);
    surface = ReadSurface(vtkNew<vtkOBJReader>().Get(), path, file.GetPath());
  }
  else if (extension == ".ply")
  {
    surface = ReadSurface(vtkNew<vtkPLYReader>().Get(), path);
  }
  else if (extension == ".stl")
  {
    surface = ReadSTL(path);
  }
  else if (extension == ".vtp")
  {
    surface = ReadSurface(vtkNew<vtkXMLPolyDataReader>().Get(), path);
  }
  else if (extension == ".vtu")
  {
    surface = ReadSurface(vtkNew<vtkXMLUnstructuredGridReader>().Get(), path);
  }
  else if (extension == ".vts")
  {
    surface = ReadSurface(vtkNew<vtkXMLStructuredGridReader>().Get(), path);
  }
  else
  {
    surface = ReadSurface(vtkNew<vtkDataSetReader>().Get(), path);
  }
  Actors actors;
  AddMesh(surface, report, actors);
  return actors;
}

//------------------------------------------------------------------------------
void Tell(const Meshes::Report& report, const std::string& path, bool left)
{
  const auto of = [&](vtkIdType count, const char* what)
  { return Quoted(path) + ": " + std::to_string(count) + what; };
  std::string points = of(report.BadPoints, " of ");
  points += std::to_string(report.Points) + " points " + (report.BadPoints == 1 ? "is" : "are") +
            " not finite";
  if (!left)
  {
    throw Failure(
      report.BadPoints > 0 ? points + ", and no polygon without them is left."
      : report.BadPolygons > 0
        ? of(report.BadPolygons, " polygon(s) with points that are not there, and none is left.")
        : Quoted(path) + " holds no polygons.");
  }
  if (report.BadPoints > 0)
  {
    Messages::Warn(points + "; the polygons that use them are left out.");
  }
  if (report.BadPolygons > 0)
  {
    Messages::Warn(
      of(report.BadPolygons, " polygon(s) left out that have points that are not there."));
  }
}
}

namespace Models
{
//------------------------------------------------------------------------------
std::string GetExtensions()
{
  return "obj, ply, stl, vtp, vtu, vts, vtk, gltf, glb";
}

//------------------------------------------------------------------------------
std::vector<vtkSmartPointer<vtkActor>> Read(const std::string& path)
{
  const std::string extension = GetExtension(path);
  if (extension.empty() ||
      (", " + GetExtensions() + ",").find(" " + extension.substr(1) + ",") == std::string::npos)
  {
    CheckFile(path); // what is missing is called missing, whatever its name
    throw Failure(Quoted(path) + " is no model that can be read. Known: " + GetExtensions() + ".");
  }
  CheckFile(path);
  Meshes::Report report;
  Actors actors;
  {
    ReaderGuard guard(path);
    actors = ReadAny(path, report);
    Messages::Check("cannot read " + Quoted(path));
    if (!guard.GetPrinted().empty())
    {
      throw Failure("cannot read " + Quoted(path) + ": " + guard.GetPrinted() + ".");
    }
  }
  Tell(report, path, !actors.empty());
  return actors;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> MakeActor(vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(mesh);
  vtkDataArray* ofPoints = mesh->GetPointData()->GetScalars();
  vtkDataArray* ofCells = mesh->GetCellData()->GetScalars();
  vtkDataArray* colors = ofPoints ? ofPoints : ofCells;
  const bool isColor =
    vtkUnsignedCharArray::SafeDownCast(colors) &&
    (colors->GetNumberOfComponents() == 3 || colors->GetNumberOfComponents() == 4);
  mapper->SetScalarVisibility(isColor);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  vtkProperty* property = actor->GetProperty();
  property->SetColor(0.80, 0.80, 0.78);
  // The same shading as that of the built-in scenes, beside whose ground models stand.
  property->SetAmbient(0.28);
  property->SetDiffuse(0.85);
  property->SetSpecular(0.12);
  property->SetSpecularPower(24.0);
  return actor;
}
}
