// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowSurfaces.h"

#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkCellArray.h"
#include "vtkClipPolyData.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeRange.h"
#include "vtkDataSet.h"
#include "vtkDataSetSurfaceFilter.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageData.h"
#include "vtkImageMapper3D.h"
#include "vtkImageProperty.h"
#include "vtkImageSlice.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkShadowAlpha.h"
#include "vtkShadowAlphaMap.h"
#include "vtkShadowGlyphs.h"
#include "vtkShadowMesh.h"
#include "vtkShadowVTKVersion.h"
#include "vtkTexture.h"

#include <array>
#include <utility>

namespace
{
using Function = std::function<void(const vtkShadowSurface&)>;
using Maker = std::function<vtkSmartPointer<vtkPolyData>(double threshold)>;

/** The mapper's clipping planes in model coordinates. */
std::vector<double> GetPlanes(vtkAbstractMapper3D* mapper, vtkMatrix4x4* matrix)
{
  std::vector<double> planes(4 * mapper->GetNumberOfClippingPlanes());
  for (int i = 0; i < mapper->GetNumberOfClippingPlanes(); ++i)
  {
    mapper->GetClippingPlaneInDataCoords(matrix, i, &planes[4 * i]);
  }
  return planes;
}

vtkSmartPointer<vtkPolyData> Clip(
  vtkSmartPointer<vtkPolyData> polygons, const std::vector<double>& planes)
{
  if (polygons->GetPoints())
  {
    polygons = vtkShadowMesh::Triangulate(polygons); // what is clipped is what is drawn
  }
  for (std::size_t i = 0; i < planes.size(); i += 4)
  {
    const double* p = &planes[i];
    const double length2 = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
    vtkNew<vtkPlane> plane;
    plane->SetNormal(p[0], p[1], p[2]);
    plane->SetOrigin(-p[3] * p[0] / length2, -p[3] * p[1] / length2, -p[3] * p[2] / length2);
    vtkNew<vtkPolyData> shape; // without other data that would be interpolated
    shape->SetPoints(polygons->GetPoints());
    shape->SetPolys(polygons->GetPolys());
    shape->SetStrips(polygons->GetStrips());
    if (vtkDataArray* alpha = polygons->GetPointData()->GetArray(vtkShadowAlpha::ArrayName))
    {
      shape->GetPointData()->AddArray(alpha);
    }
    vtkNew<vtkClipPolyData> clip;
    clip->SetInputData(shape);
    clip->SetClipFunction(plane);
    clip->Update();
    polygons = clip->GetOutput();
  }
  return polygons;
}

/** Whether an actor is translucent by its property, or made so. */
bool IsTranslucent(vtkActor* actor)
{
  return actor->GetForceTranslucent() ||
         (!actor->GetForceOpaque() && actor->GetProperty()->GetOpacity() < 1.0);
}

/** Give the surface of data the alpha that its actor and mapper draw it with. */
Maker AddAlpha(vtkShadowSurface& surface, vtkActor* actor, vtkDataSet* data,
  std::function<vtkSmartPointer<vtkPolyData>()> make)
{
  vtkMapper* mapper = actor->GetMapper();
  const vtkShadowAlpha alpha = vtkShadowAlpha::Find(actor, mapper, data);
  surface.AlphaTime = alpha.Time;
  surface.AlphaUnknown = alpha.Unknown;
  surface.Translucent =
    surface.Translucent || (alpha.Unknown && actor->HasTranslucentPolygonalGeometry());
  surface.From.Mapper = alpha.Colors ? mapper : nullptr;
  surface.From.Texture = alpha.Texture;
  surface.Map = alpha.LookedUp ? static_cast<const void*>(mapper) : alpha.Texture;
  surface.MapTime = alpha.MapTime;
  if (surface.Map)
  {
    surface.MakeMap = [alpha, mapper, data] { return alpha.MakeMap(mapper, data); };
  }
  if (alpha.Time == 0)
  {
    return [make = std::move(make)](double) { return make(); };
  }
  return [alpha, mapper, make = std::move(make)](double threshold)
  { return alpha.Apply(mapper, make(), threshold); };
}

/** Give the surface its clipping planes, and hand it on. */
void HandOn(vtkShadowSurface& surface, vtkMapper* mapper, vtkMatrix4x4* matrix, Maker make,
  const Function& function)
{
  surface.From.Details = GetPlanes(mapper, matrix);
  if (surface.From.Details.empty())
  {
    surface.MakePolygons = std::move(make);
  }
  else
  {
    surface.MakePolygons = [planes = surface.From.Details, make = std::move(make)](double threshold)
    { return Clip(make(threshold), planes); };
  }
  function(surface);
}

/** Blocks take visibility and opacity from those they lie in, as the composite mapper has it. */
void ForEachBlock(vtkDataObject* block, vtkCompositeDataDisplayAttributes* attributes, bool visible,
  double opacity, const std::function<void(vtkPolyData*, double)>& function)
{
  if (attributes && attributes->HasBlockVisibility(block))
  {
    visible = attributes->GetBlockVisibility(block);
  }
  if (attributes && attributes->HasBlockOpacity(block))
  {
    opacity = attributes->GetBlockOpacity(block);
  }
  if (auto* tree = vtkDataObjectTree::SafeDownCast(block))
  {
    for (vtkDataObject* child : vtk::Range(tree, vtk::DataObjectTreeOptions::None))
    {
      if (child)
      {
        ForEachBlock(child, attributes, visible, opacity, function);
      }
    }
  }
  else if (auto* polygons = vtkPolyData::SafeDownCast(block))
  {
    if (visible)
    {
      function(polygons, opacity);
    }
  }
}

void ForEachSurfaceOfActor(vtkActor* actor, vtkMatrix4x4* matrix, const Function& function)
{
  vtkMapper* mapper = actor->GetMapper();
  if (!mapper || mapper->GetNumberOfInputConnections(0) == 0)
  {
    return;
  }
  const bool surfaces = actor->GetProperty()->GetRepresentation() == VTK_SURFACE;
  if (!mapper->GetStatic()) // or it draws what data there are
  {
    mapper->GetInputAlgorithm()->Update();
  }
  vtkDataObject* input = mapper->GetInputDataObject(0, 0);
  vtkShadowSurface surface;
  surface.Translucent = IsTranslucent(actor);
  surface.Opacity = actor->GetProperty()->GetOpacity();
  if (vtkShadowGlyphs::IsMadeBy(mapper))
  {
    // VTK does not draw what has no bounds, such as points without cells.
    const bool drawn = vtkMath::AreBoundsInitialized(mapper->GetBounds());
    if (input && drawn && (surfaces || !vtkShadowGlyphs::IsRepresented(mapper)))
    {
      surface.From.Input = input;
      surface.From.Mapper = mapper;
      surface.Time = vtkShadowGlyphs::GetShapeTime(mapper);
      surface.AlphaTime = vtkShadowGlyphs::GetAlphaTime(mapper);
      surface.AlphaUnknown = actor->GetTexture() && actor->GetTexture()->IsTranslucent();
      HandOn(
        surface, mapper, matrix,
        [mapper](double threshold) { return vtkShadowGlyphs::Make(mapper, threshold); }, function);
    }
    return;
  }
  if (surfaces && mapper->IsA("vtkDataSetMapper") && !vtkPolyData::SafeDownCast(input))
  {
    if (auto* data = vtkDataSet::SafeDownCast(input))
    {
      surface.From.Input = data;
      surface.Time = data->GetMTime();
      HandOn(surface, mapper, matrix,
        AddAlpha(surface, actor, data,
          [data]
          {
            vtkNew<vtkDataSetSurfaceFilter> skin;
            skin->SetInputData(data);
            skin->Update();
            return vtkSmartPointer<vtkPolyData>(skin->GetOutput());
          }),
        function);
    }
    return;
  }
  if (!surfaces || !(mapper->IsA("vtkPolyDataMapper") || mapper->IsA("vtkDataSetMapper") ||
                     mapper->IsA("vtkCompositePolyDataMapper")))
  {
    return;
  }
  auto* composite = vtkShadowCompositeMapper::SafeDownCast(mapper);
  auto* attributes = composite ? composite->GetCompositeDataDisplayAttributes() : nullptr;
  ForEachBlock(input, attributes, true, surface.Opacity,
    [&](vtkPolyData* polygons, double opacity)
    {
      surface.From.Input = polygons;
      surface.Time = vtkShadowMesh::GetShapeTime(polygons);
      surface.Opacity = opacity;
      surface.Translucent = opacity < 1.0 || actor->GetForceTranslucent();
      HandOn(surface, mapper, matrix,
        AddAlpha(
          surface, actor, polygons, [polygons] { return vtkSmartPointer<vtkPolyData>(polygons); }),
        function);
    });
}

void ForEachSurfaceOfSlice(vtkImageSlice* slice, const Function& function)
{
  vtkImageMapper3D* mapper = slice->GetMapper();
  if (!mapper || !mapper->IsA("vtkImageSliceMapper") || mapper->GetNumberOfInputConnections(0) == 0)
  {
    return;
  }
  mapper->GetInputAlgorithm()->Update();
  const double* bounds = mapper->GetBounds();
  int flat = -1;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (bounds[2 * axis] == bounds[2 * axis + 1])
    {
      flat = flat < 0 ? axis : 3; // flat in two directions: a line
    }
    else if (!(bounds[2 * axis] < bounds[2 * axis + 1]))
    {
      flat = 3;
    }
  }
  if (flat < 0 || flat > 2)
  {
    return;
  }
  const std::array<double, 6> box = { bounds[0], bounds[1], bounds[2], bounds[3], bounds[4],
    bounds[5] };
  vtkShadowSurface surface;
  auto* image = vtkImageData::SafeDownCast(mapper->GetInputDataObject(0, 0));
  vtkDataArray* scalars = image ? image->GetPointData()->GetScalars() : nullptr;
  vtkScalarsToColors* table = slice->GetProperty()->GetLookupTable();
  surface.AlphaUnknown =
    scalars && (scalars->GetNumberOfComponents() % 2 == 0 || (table && !table->IsOpaque()));
  surface.From.Input = image;
  surface.From.Mapper = mapper;
  surface.From.Details.assign(box.begin(), box.end()); // which is all that counts
  surface.Opacity = slice->GetProperty()->GetOpacity();
  surface.Translucent = surface.Opacity < 1.0 || slice->HasTranslucentPolygonalGeometry() != 0;
  surface.MakePolygons = [box, flat](double)
  {
    double corners[3][3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool first = axis == (flat + 1) % 3;
      const bool second = axis == (flat + 2) % 3;
      corners[0][axis] = box[2 * axis];
      corners[1][axis] = box[2 * axis + (first ? 1 : 0)];
      corners[2][axis] = box[2 * axis + (second ? 1 : 0)];
    }
    vtkNew<vtkPlaneSource> rectangle;
    rectangle->SetOrigin(corners[0]);
    rectangle->SetPoint1(corners[1]);
    rectangle->SetPoint2(corners[2]);
    rectangle->Update();
    return vtkSmartPointer<vtkPolyData>(rectangle->GetOutput());
  };
  function(surface);
}
}

//------------------------------------------------------------------------------
void vtkForEachShadowSurface(vtkProp* prop, vtkMatrix4x4* matrix, const Function& function)
{
  if (auto* actor = vtkActor::SafeDownCast(prop))
  {
    ForEachSurfaceOfActor(actor, matrix, function);
  }
  else if (auto* slice = vtkImageSlice::SafeDownCast(prop))
  {
    ForEachSurfaceOfSlice(slice, function);
  }
}
