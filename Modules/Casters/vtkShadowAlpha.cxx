// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowAlpha.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkShadowAlphaMap.h"
#include "vtkTexture.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace
{
/** Maps scalars as another mapper does, and leaves that one as it is. */
class ColorMapper : public vtkMapper
{
public:
  static ColorMapper* New();
  vtkTypeMacro(ColorMapper, vtkMapper);
  void Render(vtkRenderer*, vtkActor*) override {}

  void Map(vtkMapper* mapper, vtkDataSet* data)
  {
    this->vtkMapper::ShallowCopy(mapper);
    this->SetInputDataObject(data);
    this->MapScalars(data, 1.0, this->Kind);
  }
  vtkUnsignedCharArray* GetColors() { return this->Colors; }
  bool IsOfPoints() const { return this->Kind == 0; }

private:
  int Kind = 0; // of points, cells or field data
};
vtkStandardNewMacro(ColorMapper);

float GetAlpha(vtkUnsignedCharArray* colors, vtkIdType i)
{
  const int components = colors->GetNumberOfComponents();
  return components % 2 == 0 && i < colors->GetNumberOfTuples()
           ? static_cast<float>(colors->GetTypedComponent(i, components - 1)) / 255.0f
           : 1.0f;
}

/** The cells whose number, counted from the first one's, is to be kept. */
template <typename IsKept>
vtkSmartPointer<vtkCellArray> KeepCells(vtkCellArray* cells, vtkIdType first, IsKept isKept)
{
  auto kept = vtkSmartPointer<vtkCellArray>::New();
  auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell(), ++first)
  {
    if (isKept(first))
    {
      vtkIdType size;
      const vtkIdType* ids;
      cell->GetCurrentCell(size, ids);
      kept->InsertNextCell(size, ids);
    }
  }
  return kept;
}

vtkDataArray* GetScalars(vtkImageData* image)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  return scalars ? scalars : image->GetCellData()->GetScalars();
}

/** Whether a texture's scalars are its colours, as they are. */
bool AreDirect(vtkTexture* texture, vtkDataArray* scalars)
{
  const int mode = texture->GetColorMode();
  const int type = scalars->GetDataType();
  return (mode != VTK_COLOR_MODE_MAP_SCALARS && type == VTK_UNSIGNED_CHAR) ||
         (mode == VTK_COLOR_MODE_DIRECT_SCALARS &&
           (type == VTK_UNSIGNED_SHORT || type == VTK_FLOAT));
}

/** Brings the texture's image up to date. */
bool HasAlpha(vtkTexture* texture)
{
  if (texture->GetCubeMap() || !texture->GetInputAlgorithm())
  {
    return false;
  }
  texture->GetInputAlgorithm()->UpdateWholeExtent();
  vtkDataArray* scalars = texture->GetInput() ? GetScalars(texture->GetInput()) : nullptr;
  if (!scalars || scalars->GetNumberOfTuples() == 0)
  {
    return false;
  }
  if (AreDirect(texture, scalars))
  {
    return scalars->GetNumberOfComponents() % 2 == 0;
  }
  vtkScalarsToColors* table = texture->GetLookupTable();
  if (table)
  {
    table->Build();
  }
  return table && !table->IsOpaque(scalars, texture->GetColorMode(), -1);
}

/** The textures that a mapper multiplies its colours with. */
std::set<vtkTexture*> GetTextures(vtkActor* actor, bool physical)
{
  std::set<vtkTexture*> textures;
  if (physical)
  {
    textures.insert(actor->GetProperty()->GetTexture("albedoTex"));
  }
  else
  {
    textures.insert(actor->GetTexture());
    static const std::set<std::string> special = { "albedoTex", "normalTex", "materialTex",
      "brdfTex", "emissiveTex", "anisotropyTex", "coatNormalTex" };
    for (const auto& entry : actor->GetProperty()->GetAllTextures())
    {
      if (special.count(entry.first) == 0 && entry.second && !entry.second->GetCubeMap())
      {
        textures.insert(entry.second);
      }
    }
  }
  textures.erase(nullptr);
  return textures;
}

vtkMTimeType GetTime(vtkTexture* texture)
{
  vtkMTimeType time = std::max(texture->GetMTime(), texture->GetInput()->GetMTime());
  if (texture->GetLookupTable())
  {
    time = std::max(time, texture->GetLookupTable()->GetMTime());
  }
  if (texture->GetTransform())
  {
    time = std::max(time, texture->GetTransform()->GetMTime());
  }
  return time;
}

/** The image of a texture's colours, as VTK lays it: one of its axes has one texel alone. */
void FindSize(vtkImageData* image, vtkDataArray* scalars, vtkShadowAlphaMap& map)
{
  int size[3];
  image->GetDimensions(size);
  if (image->GetNumberOfCells() == scalars->GetNumberOfTuples())
  {
    for (int& side : size)
    {
      side -= side > 1 ? 1 : 0;
    }
  }
  map.Width = size[0] == 1 ? size[1] : size[0];
  map.Height = size[0] == 1 || size[1] == 1 ? size[2] : size[1];
}

std::shared_ptr<vtkShadowAlphaMap> ReadTexture(vtkTexture* texture)
{
  auto map = std::make_shared<vtkShadowAlphaMap>();
  vtkDataArray* scalars = GetScalars(texture->GetInput());
  FindSize(texture->GetInput(), scalars, *map);
  map->Linear = texture->GetInterpolate() != 0;
  map->Wrap = texture->GetWrap();
  map->Border = static_cast<unsigned char>(
    std::lround(255.0f * std::clamp(texture->GetBorderColor()[3], 0.0f, 1.0f)));
  const vtkIdType count =
    std::min<vtkIdType>(scalars->GetNumberOfTuples(), vtkIdType(map->Width) * map->Height);
  if (AreDirect(texture, scalars) && scalars->GetNumberOfComponents() == 4)
  {
    const double most = scalars->GetDataType() == VTK_FLOAT ? 1.0 : scalars->GetDataTypeMax();
    for (vtkIdType i = 0; i < count; ++i)
    {
      const double alpha = std::clamp(scalars->GetComponent(i, 3) / most, 0.0, 1.0);
      map->Texels.push_back(static_cast<unsigned char>(std::lround(255.0 * alpha)));
    }
  }
  else
  {
    vtkSmartPointer<vtkScalarsToColors> table = texture->GetLookupTable();
    if (!table)
    {
      table = vtkSmartPointer<vtkLookupTable>::New();
    }
    auto colors = vtk::TakeSmartPointer(table->MapScalars(scalars, texture->GetColorMode(), -1));
    for (vtkIdType i = 0; i < count; ++i)
    {
      map->Texels.push_back(static_cast<unsigned char>(std::lround(255.0f * GetAlpha(colors, i))));
    }
  }
  map->Texels.resize(static_cast<std::size_t>(map->Width) * map->Height, 255);
  return map;
}

/** The image that a mapper looks colours up in: nearest, clamped to its edge. */
std::shared_ptr<vtkShadowAlphaMap> ReadColors(vtkImageData* image)
{
  auto map = std::make_shared<vtkShadowAlphaMap>();
  map->Wrap = vtkTexture::ClampToEdge;
  auto* colors = vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetScalars());
  map->Width = image->GetDimensions()[0];
  map->Height = image->GetDimensions()[1];
  for (vtkIdType i = 0; i < vtkIdType(map->Width) * map->Height; ++i)
  {
    map->Texels.push_back(static_cast<unsigned char>(std::lround(255.0f * GetAlpha(colors, i))));
  }
  return map;
}

/** Texture coordinates as the texture's transform has them. */
void SetPlaces(vtkFloatArray* places, vtkDataArray* coordinates, vtkTransform* transform)
{
  for (vtkIdType i = 0; i < coordinates->GetNumberOfTuples(); ++i)
  {
    double p[4] = { coordinates->GetComponent(i, 0), 0.0, 0.0, 1.0 };
    if (coordinates->GetNumberOfComponents() > 1)
    {
      p[1] = coordinates->GetComponent(i, 1);
    }
    if (transform)
    {
      transform->GetMatrix()->MultiplyPoint(p, p);
      p[0] /= p[3];
      p[1] /= p[3];
    }
    places->SetTypedComponent(i, 0, static_cast<float>(p[0]));
    places->SetTypedComponent(i, 1, static_cast<float>(p[1]));
  }
}
}

//------------------------------------------------------------------------------
vtkShadowAlpha vtkShadowAlpha::FindColors(vtkMapper* mapper, vtkDataSet* data)
{
  vtkShadowAlpha alpha;
  if (!mapper->GetScalarVisibility())
  {
    return alpha;
  }
  int kind;
  vtkAbstractArray* scalars = vtkAbstractMapper::GetAbstractScalars(data, mapper->GetScalarMode(),
    mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), kind);
  if (!scalars || scalars->GetNumberOfTuples() == 0)
  {
    return alpha;
  }
  auto* array = vtkDataArray::SafeDownCast(scalars);
  vtkScalarsToColors* table =
    array && array->GetLookupTable() ? array->GetLookupTable() : mapper->GetLookupTable();
  table->Build();
  auto* function = vtkColorTransferFunction::SafeDownCast(table);
  alpha.Colors = !table->IsOpaque(scalars, mapper->GetColorMode(), mapper->GetArrayComponent()) ||
                 (function && function->GetNanOpacity() < 1.0); // which it calls opaque
  if (alpha.Colors)
  {
    vtkNew<ColorMapper> colors;
    colors->vtkMapper::ShallowCopy(mapper);
    alpha.LookedUp = colors->CanUseTextureMapForColoring(data) != 0;
    alpha.MapTime = std::max(mapper->GetMTime(), table->GetMTime());
    alpha.Time = std::max(alpha.MapTime, data->GetMTime());
  }
  return alpha;
}

//------------------------------------------------------------------------------
vtkShadowAlpha vtkShadowAlpha::Find(vtkActor* actor, vtkMapper* mapper, vtkDataSet* data)
{
  vtkShadowAlpha alpha = FindColors(mapper, data);
  vtkProperty* property = actor->GetProperty();
  vtkDataArray* coordinates = data->GetPointData()->GetTCoords();
  if ((!actor->GetTexture() && property->GetNumberOfTextures() == 0) || !coordinates ||
      coordinates->GetNumberOfComponents() > 2)
  {
    return alpha;
  }
  const bool physical = property->GetInterpolation() == VTK_PBR && property->GetLighting();
  const std::set<vtkTexture*> textures = GetTextures(actor, physical);
  const bool translucent = std::any_of(textures.begin(), textures.end(), HasAlpha);
  if (physical && !textures.empty() && !alpha.LookedUp)
  {
    alpha = vtkShadowAlpha();
  }
  if (translucent && (textures.size() > 1 || alpha.LookedUp))
  {
    alpha = vtkShadowAlpha();
    alpha.Unknown = true;
  }
  else if (translucent)
  {
    alpha.Texture = *textures.begin();
    alpha.MapTime = GetTime(alpha.Texture);
    alpha.Time = std::max({ alpha.Time, data->GetMTime(), alpha.MapTime });
  }
  return alpha;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> vtkShadowAlpha::Apply(
  vtkMapper* mapper, vtkPolyData* polygons, double threshold) const
{
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(polygons->GetPoints());
  result->SetPolys(polygons->GetPolys());
  result->SetStrips(polygons->GetStrips());
  vtkNew<vtkFloatArray> places;
  places->SetName(vtkShadowAlpha::ArrayName);
  places->SetNumberOfComponents(3);
  places->SetNumberOfTuples(polygons->GetNumberOfPoints());
  places->FillComponent(0, 0.0);
  places->FillComponent(1, 0.0);
  places->FillComponent(2, 1.0);
  if (this->Colors)
  {
    vtkNew<ColorMapper> mapped;
    mapped->Map(mapper, polygons);
    if (mapped->GetColorCoordinates())
    {
      SetPlaces(places, mapped->GetColorCoordinates(), nullptr);
    }
    else if (mapped->GetColors() && mapped->IsOfPoints())
    {
      for (vtkIdType i = 0; i < polygons->GetNumberOfPoints(); ++i)
      {
        places->SetTypedComponent(i, 2, GetAlpha(mapped->GetColors(), i));
      }
    }
    else if (mapped->GetColors())
    {
      // One tuple of field data may stand for all.
      const vtkIdType single = mapper->GetScalarMode() == VTK_SCALAR_MODE_USE_FIELD_DATA
                                 ? mapper->GetFieldDataTupleId()
                                 : -1;
      const auto isKept = [&](vtkIdType cell)
      { return GetAlpha(mapped->GetColors(), single > -1 ? single : cell) >= threshold; };
      const vtkIdType first = polygons->GetNumberOfVerts() + polygons->GetNumberOfLines();
      result->SetPolys(KeepCells(polygons->GetPolys(), first, isKept));
      result->SetStrips(
        KeepCells(polygons->GetStrips(), first + polygons->GetNumberOfPolys(), isKept));
    }
  }
  if (this->Texture)
  {
    SetPlaces(places, polygons->GetPointData()->GetTCoords(), this->Texture->GetTransform());
  }
  result->GetPointData()->AddArray(places);
  return result;
}

//------------------------------------------------------------------------------
std::shared_ptr<const vtkShadowAlphaMap> vtkShadowAlpha::MakeMap(
  vtkMapper* mapper, vtkDataSet* data) const
{
  std::shared_ptr<vtkShadowAlphaMap> map;
  if (this->Texture)
  {
    map = ReadTexture(this->Texture);
  }
  else if (this->LookedUp)
  {
    vtkNew<ColorMapper> mapped;
    mapped->Map(mapper, data);
    map = mapped->GetColorTextureMap() ? ReadColors(mapped->GetColorTextureMap()) : nullptr;
  }
  if (map && map->Texels.empty())
  {
    map = nullptr;
  }
  if (map)
  {
    unsigned char least = *std::min_element(map->Texels.begin(), map->Texels.end());
    if (map->Wrap == vtkTexture::ClampToBorder)
    {
      least = std::min(least, map->Border);
    }
    map->Minimum = least / 255.0f;
  }
  return map;
}

//------------------------------------------------------------------------------
std::vector<bool> vtkShadowAlpha::FindPoints(vtkMapper* mapper, vtkDataSet* data, double threshold)
{
  std::vector<bool> points;
  if (FindColors(mapper, data).Colors)
  {
    vtkNew<ColorMapper> mapped;
    mapped->Map(mapper, data);
    for (vtkIdType i = 0; mapped->GetColors() && i < data->GetNumberOfPoints(); ++i)
    {
      points.push_back(GetAlpha(mapped->GetColors(), i) >= threshold);
    }
  }
  return points;
}
