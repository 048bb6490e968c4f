// SPDX-License-Identifier: BSD-3-Clause
// Holes by alpha: where a texture or colours are clear, a surface casts nothing, elsewhere all.

#include "ShadowStage.h"
#include "ShadowTest.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSetMapper.h"
#include "vtkDiscretizableColorTransferFunction.h"
#include "vtkFloatArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkImageSlice.h"
#include "vtkImageSliceMapper.h"
#include "vtkLookupTable.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShadowVTKVersion.h"
#include "vtkTexture.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double Step = 0.5; // of the sheet's cells
constexpr int Cells = 4;     // a side

/** A place of the sheet: it is there, or not, or the edge is too near to say. */
enum Part
{
  Hole,
  Solid,
  Edge
};
using Expected = std::function<Part(double x, double y)>;

/** The sheet that a signed distance, or what bounds it, is positive on. */
Part Decide(double distance)
{
  return std::abs(distance) < 0.06 ? Edge : (distance > 0.0 ? Solid : Hole);
}

/**
 * A sheet of -1 to 1 along x and y, in four cells a side, lit from straight above; beneath it the
 * eye, and the floor, which shows its shadow at the same x and y.
 */
class Sheet : public ShadowStage
{
public:
  static constexpr double Seen = 1.3; // along x and y

  Sheet()
  {
    this->AddFloor();
    vtkNew<vtkPlaneSource> source;
    source->SetOrigin(-1.0, -1.0, 2.0);
    source->SetPoint1(1.0, -1.0, 2.0);
    source->SetPoint2(-1.0, 1.0, 2.0);
    source->SetResolution(Cells, Cells);
    source->Update();
    this->Actor = this->Add(source->GetOutput());
    this->Light = this->AddPlainLight(false, { 0.0, 0.0, 5.0 });
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, 0.0, 1.5);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->SetViewAngle(2.0 * vtkMath::DegreesFromRadians(std::atan(Seen / 1.5)));
    camera->SetClippingRange(0.1, 5.0);
  }
  vtkMapper* GetMapper() { return this->Actor->GetMapper(); }
  vtkPolyData* GetMesh()
  {
    return vtkPolyData::SafeDownCast(this->GetMapper()->GetInputDataObject(0, 0));
  }
  vtkTexture* SetTexture(vtkImageData* image)
  {
    vtkNew<vtkTexture> texture;
    texture->SetInputData(image);
    this->Actor->SetTexture(texture);
    return texture;
  }
  /** RGBA of points or cells, all opaque; for the actor's mapper to show. */
  vtkUnsignedCharArray* AddColors(vtkDataSetAttributes* attributes, vtkIdType count)
  {
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(4);
    colors->SetNumberOfTuples(count);
    colors->FillValue(255);
    attributes->SetScalars(colors);
    this->GetMapper()->ScalarVisibilityOn();
    return colors;
  }
  /** 0, 1, 2… of points or cells. */
  vtkFloatArray* AddScalars(vtkDataSetAttributes* attributes, vtkIdType count)
  {
    vtkNew<vtkFloatArray> scalars;
    for (vtkIdType i = 0; i < count; ++i)
    {
      scalars->InsertNextValue(static_cast<float>(i));
    }
    attributes->SetScalars(scalars);
    this->GetMapper()->ScalarVisibilityOn();
    this->GetMapper()->SetScalarRange(0.0, static_cast<double>(count));
    return scalars;
  }
  void SetMapper(vtkMapper* mapper)
  {
    this->Actor->SetMapper(mapper);
    mapper->ScalarVisibilityOn();
  }
  void Start(const std::string& technique, Parameters parameters = {})
  {
    parameters.emplace("resolution", "1024");
    parameters.emplace("samples", "4");
    this->SetPass(technique, parameters);
    this->Render();
  }
  /** The share of pixels whose V is not as expected: 1 in holes, this one elsewhere. */
  double GetWrong(const Expected& expected, double solid = 0.0)
  {
    const Visibility v = this->GetVisibility();
    int wrong = 0;
    int used = 0;
    for (int j = 0; j < v.Height; ++j)
    {
      for (int i = 0; i < v.Width; ++i)
      {
        const double x = Seen * ((2.0 * i + 1.0) / v.Width - 1.0);
        const double y = Seen * ((2.0 * j + 1.0) / v.Height - 1.0);
        const double beyond = std::max(std::abs(x), std::abs(y)) - 1.0;
        const Part place = std::abs(beyond) < 0.06 ? Edge : (beyond > 0.0 ? Hole : expected(x, y));
        if (place != Edge)
        {
          ++used;
          // Not of NaN either.
          wrong += std::abs(v(i, j) - (place == Solid ? solid : 1.0)) <= 0.01 ? 0 : 1;
        }
      }
    }
    return used > 5000 ? static_cast<double>(wrong) / used : 1.0;
  }
  vtkActor* Actor;
  vtkLight* Light;
};

vtkSmartPointer<vtkImageData> MakeImage(
  int components, const std::function<int(double s, double t)>& getAlpha)
{
  constexpr int size = 64;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size, size, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  for (int i = 0; i < size * size; ++i)
  {
    auto* texel = static_cast<unsigned char*>(image->GetScalarPointer(i % size, i / size, 0));
    std::fill(texel, texel + components, static_cast<unsigned char>(200));
    texel[components - 1] = static_cast<unsigned char>(
      getAlpha((i % size + 0.5) / size, (static_cast<int>(i / size) + 0.5) / size));
  }
  return image;
}

/** A disc around the middle, of radius 0.35 of the sheet's side. */
vtkSmartPointer<vtkImageData> MakeDisc(int components = 4)
{
  return MakeImage(
    components, [](double s, double t) { return std::hypot(s - 0.5, t - 0.5) < 0.35 ? 255 : 0; });
}

Part IsDisc(double x, double y)
{
  return Decide(0.7 - std::hypot(x, y));
}

/** All but the cell whose middle is at 0.25, 0.25, the eleventh. */
constexpr vtkIdType ClearCell = 10;
Part IsNotTheCell(double x, double y)
{
  return Decide(std::max(std::abs(x - 0.25), std::abs(y - 0.25)) - 0.25);
}

/** All but the middle point's share of more than a half: between a diamond and a square. */
constexpr vtkIdType ClearPoint = 12;
Part IsNotThePoint(double x, double y)
{
  const Part diamond = Decide(std::abs(x) + std::abs(y) - 0.5 * Step);
  const Part square = Decide(std::max(std::abs(x), std::abs(y)) - 0.5 * Step);
  return diamond == square ? diamond : Edge;
}

/** The same for all of its share. */
Part IsNotAroundThePoint(double x, double y)
{
  const Part diamond = Decide(std::abs(x) + std::abs(y) - Step);
  const Part square = Decide(std::max(std::abs(x), std::abs(y)) - Step);
  return diamond == square ? diamond : Edge;
}

Part IsWhole(double, double)
{
  return Solid;
}

vtkSmartPointer<vtkLookupTable> MakeTable()
{
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNanColor(0.0, 0.0, 0.0, 0.0);
  return table;
}

struct Source
{
  const char* Name;
  bool WholeCells; // what is clear is whole triangles: volumes know it too
  Expected IsThere;
  std::function<void(Sheet&)> Apply;
};

const std::vector<Source>& GetSources()
{
  static const std::vector<Source> sources = {
    { "texture", false, IsDisc, [](Sheet& sheet) { sheet.SetTexture(MakeDisc()); } },
    { "interpolated texture", false, IsDisc,
      [](Sheet& sheet) { sheet.SetTexture(MakeDisc())->InterpolateOn(); } },
    { "texture of luminance and alpha", false, IsDisc,
      [](Sheet& sheet) { sheet.SetTexture(MakeDisc(2)); } },
    { "texture through a table", false, IsDisc,
      [](Sheet& sheet)
      {
        vtkNew<vtkLookupTable> table;
        table->SetRange(0.0, 255.0);
        table->SetAlphaRange(0.0, 1.0);
        vtkTexture* texture = sheet.SetTexture(MakeDisc(1));
        texture->SetColorModeToMapScalars();
        texture->SetLookupTable(table);
      } },
    { "texture, repeated by a transform", false,
      [](double x, double y)
      { return Decide(0.35 - std::hypot(x - (x < 0.0 ? -0.5 : 0.5), y - (y < 0.0 ? -0.5 : 0.5))); },
      [](Sheet& sheet)
      {
        vtkNew<vtkTransform> twice;
        twice->Scale(2.0, 2.0, 1.0);
        sheet.SetTexture(MakeDisc())->SetTransform(twice);
      } },
    { "texture, clamped to its clear border", false,
      [](double x, double y) { return Decide(0.5 - std::max(std::abs(x), std::abs(y))); },
      [](Sheet& sheet)
      {
        vtkNew<vtkTransform> twice;
        twice->Translate(-0.5, -0.5, 0.0);
        twice->Scale(2.0, 2.0, 1.0);
        vtkTexture* texture = sheet.SetTexture(MakeImage(4, [](double, double) { return 255; }));
        texture->SetWrap(vtkTexture::ClampToBorder);
        texture->SetBorderColor(0.0f, 0.0f, 0.0f, 0.0f);
        texture->SetTransform(twice);
      } },
    { "albedo texture", false, IsDisc,
      [](Sheet& sheet)
      {
        vtkNew<vtkTexture> texture;
        texture->SetInputData(MakeDisc());
        texture->UseSRGBColorSpaceOn();
        sheet.Actor->GetProperty()->SetInterpolationToPBR();
        sheet.Actor->GetProperty()->SetBaseColorTexture(texture);
      } },
    { "texture over colours", false,
      [](double x, double y)
      {
        const Part disc = IsDisc(x, y);
        const Part cell = IsNotTheCell(x, y);
        return disc == Hole || cell == Hole ? Hole : (disc == Edge ? disc : cell);
      },
      [](Sheet& sheet)
      {
        sheet.SetTexture(MakeDisc());
        sheet.AddColors(sheet.GetMesh()->GetCellData(), Cells * Cells)
          ->SetTypedComponent(ClearCell, 3, 0);
      } },
    { "clipped texture", false,
      [](double x, double y)
      {
        const Part left = Decide(0.2 - x);
        return left == Solid ? IsDisc(x, y) : left;
      },
      [](Sheet& sheet)
      {
        vtkNew<vtkPlane> plane;
        plane->SetOrigin(0.2, 0.0, 0.0);
        plane->SetNormal(-1.0, 0.0, 0.0);
        sheet.GetMapper()->AddClippingPlane(plane);
        sheet.SetTexture(MakeDisc());
      } },
    { "colours of points", false, IsNotThePoint,
      [](Sheet& sheet)
      {
        sheet.AddColors(sheet.GetMesh()->GetPointData(), sheet.GetMesh()->GetNumberOfPoints())
          ->SetTypedComponent(ClearPoint, 3, 0);
      } },
    { "colours of cells", true, IsNotTheCell,
      [](Sheet& sheet)
      {
        sheet.AddColors(sheet.GetMesh()->GetCellData(), Cells * Cells)
          ->SetTypedComponent(ClearCell, 3, 0);
      } },
    { "NaN in a cell", true, IsNotTheCell,
      [](Sheet& sheet)
      {
        sheet.AddScalars(sheet.GetMesh()->GetCellData(), Cells * Cells)
          ->SetValue(ClearCell, std::nanf(""));
        sheet.GetMapper()->SetLookupTable(MakeTable());
      } },
    { "NaN in a cell, discrete transfer function", true, IsNotTheCell,
      [](Sheet& sheet)
      {
        sheet.AddScalars(sheet.GetMesh()->GetCellData(), Cells * Cells)
          ->SetValue(ClearCell, std::nanf(""));
        vtkNew<vtkDiscretizableColorTransferFunction> function;
        function->DiscretizeOn();
        function->AddRGBPoint(0.0, 1.0, 0.0, 0.0);
        function->AddRGBPoint(16.0, 0.0, 0.0, 1.0);
        function->SetNanOpacity(0.0);
        sheet.GetMapper()->SetLookupTable(function);
      } },
    { "NaN at a point", false, IsNotThePoint,
      [](Sheet& sheet)
      {
        sheet.AddScalars(sheet.GetMesh()->GetPointData(), sheet.GetMesh()->GetNumberOfPoints())
          ->SetValue(ClearPoint, std::nanf(""));
        sheet.GetMapper()->SetLookupTable(MakeTable());
      } },
    { "NaN at a point, interpolated before mapping", false, IsNotAroundThePoint,
      [](Sheet& sheet)
      {
        sheet.AddScalars(sheet.GetMesh()->GetPointData(), sheet.GetMesh()->GetNumberOfPoints())
          ->SetValue(ClearPoint, std::nanf(""));
        sheet.GetMapper()->SetLookupTable(MakeTable());
        sheet.GetMapper()->InterpolateScalarsBeforeMappingOn();
      } },
    { "NaN at a cell's points, interpolated before mapping", true,
      [](double x, double y)
      {
        // And what of the cells around, which volumes do not know: not asked.
        const Part cell = IsNotTheCell(x, y);
        const Part around = Decide(std::max(std::abs(x - 0.25), std::abs(y - 0.25)) - 0.75);
        return cell == Solid && around != Solid ? Edge : cell;
      },
      [](Sheet& sheet)
      {
        vtkFloatArray* scalars =
          sheet.AddScalars(sheet.GetMesh()->GetPointData(), sheet.GetMesh()->GetNumberOfPoints());
        for (const vtkIdType i : { 12, 13, 17, 18 })
        {
          scalars->SetValue(i, std::nanf(""));
        }
        sheet.GetMapper()->SetLookupTable(MakeTable());
        sheet.GetMapper()->InterpolateScalarsBeforeMappingOn();
      } },
    { "colour above the range", true, IsNotTheCell,
      [](Sheet& sheet)
      {
        sheet.AddScalars(sheet.GetMesh()->GetCellData(), Cells * Cells)->SetValue(ClearCell, 99.0f);
        vtkNew<vtkLookupTable> table;
        table->UseAboveRangeColorOn();
        table->SetAboveRangeColor(0.0, 0.0, 0.0, 0.0);
        sheet.GetMapper()->SetLookupTable(table);
      } },
    { "cell of a grid", true, IsNotTheCell,
      [](Sheet& sheet)
      {
        sheet.AddColors(sheet.GetMesh()->GetCellData(), Cells * Cells)
          ->SetTypedComponent(ClearCell, 3, 0);
        vtkPolyData* mesh = sheet.GetMesh();
        vtkNew<vtkUnstructuredGrid> grid;
        grid->SetPoints(mesh->GetPoints());
        grid->SetCells(VTK_QUAD, mesh->GetPolys());
        grid->GetCellData()->SetScalars(mesh->GetCellData()->GetScalars());
        vtkNew<vtkDataSetMapper> mapper;
        mapper->SetInputData(grid);
        sheet.SetMapper(mapper);
      } },
    { "cell of a block", true, IsNotTheCell,
      [](Sheet& sheet)
      {
        sheet.AddColors(sheet.GetMesh()->GetCellData(), Cells * Cells)
          ->SetTypedComponent(ClearCell, 3, 0);
        vtkNew<vtkMultiBlockDataSet> blocks;
        blocks->SetBlock(0, sheet.GetMesh());
        vtkNew<vtkShadowCompositeMapper> mapper;
        mapper->SetInputDataObject(blocks);
        sheet.SetMapper(mapper);
      } },
    { "glyph", true, IsNotTheCell,
      [](Sheet& sheet)
      {
        vtkNew<vtkPlaneSource> middles;
        middles->SetOrigin(-0.75, -0.75, 2.0);
        middles->SetPoint1(0.75, -0.75, 2.0);
        middles->SetPoint2(-0.75, 0.75, 2.0);
        middles->SetResolution(Cells - 1, Cells - 1);
        middles->Update();
        sheet.AddColors(middles->GetOutput()->GetPointData(), Cells * Cells)
          ->SetTypedComponent(ClearCell, 3, 0);
        vtkNew<vtkPlaneSource> cell;
        cell->SetOrigin(-0.5 * Step, -0.5 * Step, 0.0);
        cell->SetPoint1(0.5 * Step, -0.5 * Step, 0.0);
        cell->SetPoint2(-0.5 * Step, 0.5 * Step, 0.0);
        vtkNew<vtkGlyph3DMapper> mapper;
        mapper->SetInputData(middles->GetOutput());
        mapper->SetSourceConnection(cell->GetOutputPort());
        mapper->ScalingOff();
        mapper->OrientOff();
        sheet.SetMapper(mapper);
      } },
  };
  return sources;
}

bool IsVolume(const std::string& technique)
{
  return technique.rfind("volume", 0) == 0 || technique == "wedges";
}

/** What a technique makes of a source; volumes may fill holes within triangles. */
void CheckHoles(Sheet& sheet, const Source& source, const std::string& technique,
  const std::string& what, double solid = 0.0)
{
  const bool filled = IsVolume(technique) && !source.WholeCells;
  const auto expected = [&](double x, double y)
  {
    const Part part = source.IsThere(x, y);
    return filled && part == Hole ? Edge : part;
  };
  ShadowTest::CheckAtMost(sheet.GetWrong(expected, solid), 0.002, what + ": share of wrong pixels");
}
}

//------------------------------------------------------------------------------
SHADOW_TEST(Alpha, HolesAreWhereItIsClear, Each)
{
  for (const Source& source : GetSources())
  {
    Sheet sheet;
    source.Apply(sheet);
    sheet.Start(technique);
    const bool cells = sheet.Count("castersWithHoles") == 0.0;
    if (IsVolume(technique) && !cells)
    {
      ShadowTest::CheckOneMessage(
        ShadowTest::Message::Warning, { "holes by alpha", "silhouettes" }, source.Name);
    }
    ShadowTest::CheckNoMessage(source.Name);
    ShadowTest::Check(source.WholeCells || !cells, std::string(source.Name) + ": no holes");
    CheckHoles(sheet, source, technique, source.Name);
  }
}

//------------------------------------------------------------------------------
// A cell that is clear is as if it were cut out, with a light of some size too: by its colour bit by
// bit, and by a texture but for its edge.
SHADOW_TEST(Alpha, ClearIsAsCutOut, Each)
{
  Visibility visibilities[3];
  for (int i = 0; i < 3; ++i)
  {
    Sheet sheet;
    sheet.Renderer->RemoveLight(sheet.Light);
    const bool soft = ShadowStage::Supports(technique, LightKind::Rectangle);
    sheet.AddLight(
      soft ? LightKind::Rectangle : LightKind::Point, { 0.3, 0.2, 6.0 }, { 0.0, 0.0, 0.0 });
    if (i == 0)
    {
      vtkNew<vtkCellArray> others;
      for (vtkIdType cell = 0; cell < Cells * Cells; ++cell)
      {
        if (cell != ClearCell)
        {
          vtkNew<vtkIdList> points;
          sheet.GetMesh()->GetCellPoints(cell, points);
          others->InsertNextCell(points);
        }
      }
      sheet.GetMesh()->SetPolys(others);
    }
    else if (i == 1)
    {
      sheet.AddColors(sheet.GetMesh()->GetCellData(), Cells * Cells)
        ->SetTypedComponent(ClearCell, 3, 0);
    }
    else
    {
      sheet.SetTexture(MakeImage(4,
        [](double s, double t) { return s > 0.5 && s < 0.75 && t > 0.5 && t < 0.75 ? 0 : 255; }));
    }
    // Slices as if independent of each other are nowhere quite dark.
    sheet.Start(technique, { { "combine", "bits" }, { "double-projection", "on" } });
    ShadowTest::TakeMessages(); // of volumes
    visibilities[i] = sheet.GetVisibility();
  }
  ShadowTest::CheckAtMost(GetRange(visibilities[0]).first, 0.01, "darkest V");
  ShadowTest::Check(Same(visibilities[0], visibilities[1]), "the colour: V differs");
  ShadowTest::CheckAtMost(
    Compare(visibilities[0], visibilities[2]).Share, 0.01, "the texture: pixels that differ");
}

//------------------------------------------------------------------------------
// The rule is about the property's opacity; holes are holes under each.
SHADOW_TEST(Alpha, Rules, Each)
{
  for (const Source& source : GetSources())
  {
    const std::string name = source.Name;
    if (name != "interpolated texture" && name != "colours of cells")
    {
      continue;
    }
    for (const double opacity : { 1.0, 0.5 })
    {
      for (const char* rule : { "off", "opaque", "weighted" })
      {
        const bool half = opacity < 1.0 && std::string(rule) == "weighted";
        const bool none = opacity < 1.0 && std::string(rule) == "off";
        Sheet sheet;
        source.Apply(sheet);
        sheet.Actor->GetProperty()->SetOpacity(opacity);
        sheet.Start(technique, { { "translucent-casters", rule } });
        ShadowTest::TakeMessages(); // of volumes
        CheckHoles(sheet, source, technique,
          name + ", " + rule + ", opacity " + std::to_string(opacity),
          none ? 1.0 : (half ? 0.5 : 0.0));
      }
    }
  }
}

//------------------------------------------------------------------------------
// Four bands, of alpha 0, 100, 180 and 255 of 255, by texture and by cells. What is as high as the
// threshold is there.
SHADOW_TEST(Alpha, Threshold, Each)
{
  constexpr int bands[] = { 0, 100, 180, 255 };
  const std::pair<std::string, int> thresholds[] = { { "0", 0 }, { "0.3", 1 }, { "0.5", 2 },
    { "0.70588", 2 }, { "0.71", 3 }, { "1", 3 } };
  for (const bool texture : { true, false })
  {
    Sheet sheet;
    if (texture)
    {
      sheet.SetTexture(
        MakeImage(4, [&](double s, double) { return bands[static_cast<int>(4.0 * s)]; }));
    }
    else
    {
      auto* colors = sheet.AddColors(sheet.GetMesh()->GetCellData(), Cells * Cells);
      for (int i = 0; i < Cells * Cells; ++i)
      {
        colors->SetTypedComponent(i, 3, static_cast<unsigned char>(bands[i % Cells]));
      }
    }
    sheet.Start(technique);
    for (const auto& threshold : thresholds)
    {
      ShadowTest::Check(
        sheet.Pass->SetParameter("alpha-threshold", threshold.first), "not a threshold");
      sheet.Render();
      ShadowTest::TakeMessages(); // of volumes
      // Volumes too drop triangles that are clear all over.
      const auto expected = [&](double x, double)
      { return Decide(x - (-1.0 + Step * threshold.second)); };
      ShadowTest::CheckAtMost(sheet.GetWrong(expected), 0.002,
        std::string(texture ? "texture, " : "cells, ") + threshold.first +
          ": share of wrong pixels");
    }
    for (const char* refused : { "-0.1", "1.1", "half" })
    {
      ShadowTest::Check(!sheet.Pass->SetParameter("alpha-threshold", refused), refused);
    }
    ShadowTest::TakeMessages();
  }
}

//------------------------------------------------------------------------------
// What changes alpha is followed at once; other colours rebuild nothing.
SHADOW_TEST(Alpha, OnlyAlphaCounts, Each)
{
  struct Edit
  {
    const char* Name;
    bool Rebuilds;
    std::function<void(Sheet&)> Apply;
  };
  const auto getColors = [](Sheet& sheet)
  { return vtkUnsignedCharArray::SafeDownCast(sheet.GetMesh()->GetCellData()->GetScalars()); };
  const std::vector<Edit> edits = {
    { "nothing", false, [](Sheet&) {} },
    { "another texture", true,
      [](Sheet& sheet)
      { sheet.SetTexture(MakeImage(4, [](double s, double) { return s < 0.5 ? 255 : 0; })); } },
    { "the image in place", true,
      [](Sheet& sheet)
      {
        vtkImageData* image = sheet.Actor->GetTexture()->GetInput();
        auto* alpha = vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetScalars());
        alpha->FillComponent(3, 255.0);
        image->Modified();
      } },
    { "the image's colours", false,
      [](Sheet& sheet)
      {
        vtkImageData* image = sheet.Actor->GetTexture()->GetInput();
        auto* colors = vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetScalars());
        colors->FillComponent(0, 255.0);
        image->Modified();
      } },
    { "the texture's transform", true,
      [](Sheet& sheet)
      {
        vtkNew<vtkTransform> moved;
        moved->Translate(0.2, 0.0, 0.0);
        sheet.Actor->GetTexture()->SetTransform(moved);
      } },
    { "no texture", true,
      [](Sheet& sheet)
      {
        sheet.Actor->SetTexture(nullptr);
        sheet.GetMapper()->Modified(); // VTK's shader would still ask for it
      } },
    { "a cell's alpha", true,
      [&](Sheet& sheet)
      {
        getColors(sheet)->SetTypedComponent(5, 3, 0);
        getColors(sheet)->Modified();
      } },
    { "a cell's colour", false,
      [&](Sheet& sheet)
      {
        getColors(sheet)->SetTypedComponent(5, 0, 0);
        getColors(sheet)->Modified();
      } },
    { "no colours", true, [](Sheet& sheet) { sheet.GetMapper()->ScalarVisibilityOff(); } },
    { "the threshold", true,
      [](Sheet& sheet) { sheet.Pass->SetParameter("alpha-threshold", "0"); } },
    { "the threshold, between the same", true, // it is in the mesh, for what is looked up
      [](Sheet& sheet) { sheet.Pass->SetParameter("alpha-threshold", "0.6"); } },
  };
  for (const Edit& edit : edits)
  {
    const auto build = [](Sheet& sheet)
    {
      sheet.SetTexture(MakeDisc());
      sheet.AddColors(sheet.GetMesh()->GetCellData(), Cells * Cells)
        ->SetTypedComponent(ClearCell, 3, 0);
    };
    Sheet stage;
    build(stage);
    stage.Start(technique);
    stage.Render();
    ShadowTest::CheckEqual(stage.Count("castersRebuilt"), 0.0, "castersRebuilt, unchanged");
    edit.Apply(stage);
    stage.Render();
    ShadowTest::CheckEqual(stage.Count("castersRebuilt"), edit.Rebuilds ? 1.0 : 0.0,
      std::string(edit.Name) + ": castersRebuilt");
    const Visibility after = stage.GetVisibility();
    stage.Render();
    ShadowTest::CheckEqual(stage.Count("castersRebuilt"), 0.0, "castersRebuilt, a frame later");

    Sheet fresh;
    build(fresh);
    fresh.Start(technique);
    edit.Apply(fresh);
    fresh.Start(technique, { { "alpha-threshold", stage.Pass->GetParameter("alpha-threshold") } });
    ShadowTest::Check(Same(after, fresh.GetVisibility()), std::string(edit.Name) + ": V is stale");
    ShadowTest::TakeMessages(); // of volumes
  }
}

//------------------------------------------------------------------------------
// Colours that are opaque cost nothing: no rebuild when they change, no holes, the same bytes.
SHADOW_TEST(Alpha, OpaqueColoursCostNothing, Each)
{
  Sheet sheet;
  sheet.Start(technique);
  const auto bytes = sheet.GetBytes();
  vtkUnsignedCharArray* colors = sheet.AddColors(sheet.GetMesh()->GetCellData(), Cells * Cells);
  sheet.SetTexture(MakeImage(4, [](double, double) { return 255; }));
  sheet.Render();
  ShadowTest::CheckEqual(
    static_cast<double>(sheet.GetBytes()), static_cast<double>(bytes), "bytes");
  ShadowTest::CheckEqual(sheet.Count("castersWithHoles"), 0.0, "castersWithHoles");
  colors->FillComponent(0, 10.0);
  colors->Modified();
  sheet.Render();
  ShadowTest::CheckEqual(sheet.Count("castersRebuilt"), 0.0, "castersRebuilt");
}

//------------------------------------------------------------------------------
// Textures that come and go hold no more than the first, and the pass takes all with it.
SHADOW_TEST(Alpha, MemoryIsFreed, Each)
{
  Sheet sheet;
  vtkTexture* texture = sheet.SetTexture(MakeDisc());
  sheet.Render();
  const int plain = sheet.CountGLObjects();
  sheet.Start(technique);
  sheet.GetVisibility();
  double bytes = 0.0;
  int objects = 0;
  for (int i = 0; i < 12; ++i)
  {
    texture->SetInputData(
      MakeImage(4, [&](double s, double t) { return s + t < 0.5 + 0.1 * (i % 3) ? 255 : 0; }));
    sheet.Render();
    sheet.GetVisibility();
    if (i == 2)
    {
      bytes = static_cast<double>(sheet.GetBytes());
      objects = sheet.CountGLObjects();
    }
  }
  ShadowTest::TakeMessages(); // of volumes
  ShadowTest::CheckEqual(static_cast<double>(sheet.GetBytes()), bytes, "bytes");
  ShadowTest::CheckEqual(sheet.CountGLObjects(), objects, "objects");
  sheet.Renderer->SetPass(nullptr);
  ShadowTest::CheckEqual(static_cast<double>(sheet.GetBytes()), 0.0, "bytes, without the pass");
  ShadowTest::CheckEqual(sheet.CountGLObjects(), plain, "objects, without the pass");
}

//------------------------------------------------------------------------------
// Alpha that is not known is said, once, and makes no holes.
SHADOW_TEST(Alpha, UnknownIsSaid, Each)
{
  {
    Sheet sheet;
    sheet.SetTexture(MakeDisc());
    vtkNew<vtkTexture> second;
    second->SetInputData(MakeDisc());
    sheet.Actor->GetProperty()->SetTexture("second", second);
    sheet.Start(technique);
    ShadowTest::CheckOneMessage(
      ShadowTest::Message::Warning, { "1 props", "several textures" }, "two textures");
    sheet.Render();
    ShadowTest::CheckNoMessage("the next frame");
    ShadowTest::CheckAtMost(sheet.GetWrong(IsWhole), 0.002, "two textures: share of wrong pixels");
  }
  Sheet sheet;
  sheet.Actor->VisibilityOff();
  auto image = MakeDisc();
  image->SetOrigin(-1.0, -1.0, 2.0);
  image->SetSpacing(2.0 / 63.0, 2.0 / 63.0, 1.0);
  vtkNew<vtkImageSliceMapper> mapper;
  mapper->SetInputData(image);
  vtkNew<vtkImageSlice> slice;
  slice->SetMapper(mapper);
  sheet.Renderer->AddViewProp(slice);
  sheet.Start(technique);
  ShadowTest::CheckOneMessage(ShadowTest::Message::Warning, { "image slice" }, "an image slice");
  ShadowTest::CheckAtMost(sheet.GetWrong(IsWhole), 0.002, "a slice: share of wrong pixels");
}
