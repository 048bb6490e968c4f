// SPDX-License-Identifier: BSD-3-Clause
#include "Models.h"

#include "Errors.h"
#include "Inputs.h"
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

#include <nlohmann/json.hpp>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <new>

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
// What readers take over from the file as it is, and everything after them trusts.
void CheckOffsets(vtkCellArray* cells, const std::string& path)
{
  if (cells && !cells->IsValid())
  {
    throw Failure(Quoted(path) + " is damaged: its cells are no ranges of its list of corners.");
  }
}

void CheckCells(vtkCellArray* cells, vtkIdType points, const std::string& path)
{
  CheckOffsets(cells, path);
  double range[2] = { 0.0, -1.0 };
  if (cells && cells->GetNumberOfConnectivityIds() > 0)
  {
    cells->GetConnectivityArray()->GetRange(range);
  }
  if (range[0] < 0.0 || range[1] >= static_cast<double>(points))
  {
    throw Failure(Quoted(path) + " is damaged: cells refer to points that it does not have.");
  }
}

//------------------------------------------------------------------------------
// The polygons of a data set: itself, or the outside of its cells.
vtkSmartPointer<vtkPolyData> GetSurface(vtkDataObject* data, const std::string& path)
{
  if (auto* polygons = vtkPolyData::SafeDownCast(data))
  {
    for (vtkCellArray* each : { polygons->GetPolys(), polygons->GetStrips() })
    {
      CheckOffsets(each, path);
    }
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
    CheckCells(grid->GetCells(), grid->GetNumberOfPoints(), path);
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
// The reader takes what is there of a binary file, however many triangles it says that it has. A count
// that is too small, or of another sign, is ignored as the reader does: such files are common.
void CheckLengthOfSTL(const std::string& path)
{
  using vtksys::SystemTools;
  if (SystemTools::DetectFileType(path.c_str()) == SystemTools::FileTypeText)
  {
    return; // its form tells
  }
  constexpr std::size_t headerSize = 80;
  constexpr std::size_t triangleSize = 50;
  unsigned char header[headerSize + 4] = {};
  std::ifstream(path, std::ios::binary).read(reinterpret_cast<char*>(header), sizeof(header));
  const unsigned char* bytes = header + headerSize;
  const auto count = static_cast<std::int32_t>(
    bytes[0] | bytes[1] << 8 | bytes[2] << 16 | static_cast<std::uint32_t>(bytes[3]) << 24);
  const auto size = static_cast<std::size_t>(fs::file_size(path));
  const std::size_t there = size < sizeof(header) ? 0 : (size - sizeof(header)) / triangleSize;
  if (count > 0 && static_cast<std::size_t>(count) > there)
  {
    throw Failure("cannot read " + Quoted(path) + ": it is cut short, with " +
                  std::to_string(there) + " of its " + std::to_string(count) + " triangles.");
  }
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> ReadSTL(const std::string& path)
{
  CheckLengthOfSTL(path);
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

//------------------------------------------------------------------------------
// Whatever the file does to its reader becomes a Failure that names it.
Actors ReadGuarded(const std::string& path, Meshes::Report& report)
{
  const std::string cannot = "cannot read " + Quoted(path) + ": ";
  try
  {
    ReaderGuard guard(path);
    const Messages::About about(Quoted(path));
    const Actors actors = ReadAny(path, report);
    Messages::Check("cannot read " + Quoted(path));
    if (!guard.GetPrinted().empty())
    {
      throw Failure(cannot + guard.GetPrinted() + ".");
    }
    return actors;
  }
  catch (const Failure&)
  {
    throw;
  }
  catch (const std::bad_alloc&)
  {
    throw Failure(
      cannot + "it is damaged, or too large: its reader wants more memory than there is.");
  }
  catch (const std::length_error&)
  {
    throw Failure(cannot + "it is damaged: it gives a size that nothing can have.");
  }
  catch (const std::exception& exception)
  {
    throw Failure(cannot + "it is damaged: " + exception.what());
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
  Inputs::Check(path);
  const std::string extension = GetExtension(path);
  if (extension.empty() ||
      (", " + GetExtensions() + ",").find(" " + extension.substr(1) + ",") == std::string::npos)
  {
    throw Failure(Quoted(path) + " is no model that can be read. Known: " + GetExtensions() + ".");
  }
  Meshes::Report report;
  const Actors actors = ReadGuarded(path, report);
  Tell(report, path, !actors.empty());
  return actors;
}

//------------------------------------------------------------------------------
std::vector<std::string> GetFiles(const std::vector<std::string>& paths)
{
  constexpr std::uintmax_t largest = 64 << 20; // a model that refers to its data is small
  std::vector<std::string> files = paths;
  for (const std::string& path : paths)
  {
    std::error_code failed;
    if (GetExtension(path) != ".gltf" || !fs::is_regular_file(path, failed) ||
        fs::file_size(path, failed) > largest || failed)
    {
      continue;
    }
    std::ifstream file(path, std::ios::binary);
    const auto model = nlohmann::json::parse(file, nullptr, false);
    for (const char* kind : { "buffers", "images" })
    {
      const auto parts = model.is_object() ? model.value(kind, nlohmann::json()) : nlohmann::json();
      for (const auto& part : parts)
      {
        if (part.is_object() && part.contains("uri") && part["uri"].is_string())
        {
          files.push_back((fs::path(path).parent_path() / part["uri"].get<std::string>()).string());
        }
      }
    }
  }
  return files;
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
