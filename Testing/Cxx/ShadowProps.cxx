// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowProps.h"

#include "vtkAppendFilter.h"
#include "vtkAssembly.h"
#include "vtkBitArray.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkConeSource.h"
#include "vtkCubeSource.h"
#include "vtkDataSetMapper.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkFloatArray.h"
#include "vtkFollower.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageData.h"
#include "vtkImageProperty.h"
#include "vtkImageSlice.h"
#include "vtkImageSliceMapper.h"
#include "vtkLODActor.h"
#include "vtkLODProp3D.h"
#include "vtkLineSource.h"
#include "vtkMapper.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkOpenGLStickMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropAssembly.h"
#include "vtkProperty.h"
#include "vtkShadowVTKVersion.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

namespace
{
/** Three points in a row along x. */
vtkSmartPointer<vtkPolyData> MakePoints(const glm::dvec3& centre)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (int i = 0; i < 3; ++i)
  {
    const vtkIdType id = points->InsertNextPoint(centre.x + 0.4 * (i - 1), centre.y, centre.z);
    cells->InsertNextCell(1, &id);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(cells);
  return data;
}

void AddArray(vtkPolyData* data, const char* name, int components, std::vector<float> values)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  for (const float value : values)
  {
    array->InsertNextValue(value);
  }
  data->GetPointData()->AddArray(array);
}

vtkActor* AddActor(ShadowStage& stage, vtkMapper* mapper)
{
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  stage.Renderer->AddActor(actor);
  return actor;
}

vtkSmartPointer<vtkPolyData> MakeCube(const glm::dvec3& centre, const glm::dvec3& size)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetCenter(centre.x, centre.y, centre.z);
  cube->SetXLength(size.x);
  cube->SetYLength(size.y);
  cube->SetZLength(size.z);
  cube->Update();
  return cube->GetOutput();
}

vtkSmartPointer<vtkPolyDataMapper> MakeCubeMapper(const glm::dvec3& centre, const glm::dvec3& size)
{
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(MakeCube(centre, size));
  return mapper;
}

/** Glyphs of a long cone and a cube, so that turning and scaling show. */
vtkSmartPointer<vtkGlyph3DMapper> MakeGlyphs(vtkPolyData* points)
{
  vtkNew<vtkConeSource> cone; // along x
  cone->SetHeight(0.5);
  cone->SetRadius(0.12);
  cone->SetResolution(9);
  auto mapper = vtkSmartPointer<vtkGlyph3DMapper>::New();
  mapper->SetInputData(points);
  mapper->SetSourceConnection(0, cone->GetOutputPort());
  mapper->OrientOff();
  mapper->ScalingOff();
  return mapper;
}

void AddTurnedGlyphs(
  ShadowStage& stage, const glm::dvec3& centre, int mode, int components, std::vector<float> turns)
{
  auto points = MakePoints(centre);
  AddArray(points, "turn", components, std::move(turns));
  auto mapper = MakeGlyphs(points);
  mapper->OrientOn();
  mapper->SetOrientationArray("turn");
  mapper->SetOrientationMode(mode);
  AddActor(stage, mapper);
}

void AddScaledGlyphs(ShadowStage& stage, const glm::dvec3& centre, int mode, bool clamps)
{
  auto points = MakePoints(centre);
  AddArray(points, "scale", 3, { 0.5f, 1.0f, 1.5f, 1.0f, 2.0f, 0.3f, 0.8f, 0.0f, 1.5f });
  auto mapper = MakeGlyphs(points);
  mapper->ScalingOn();
  mapper->SetScaleArray("scale");
  mapper->SetScaleMode(mode);
  mapper->SetScaleFactor(clamps ? 1.4 : 0.9);
  mapper->SetClamping(clamps);
  mapper->SetRange(0.2, 1.9);
  AddActor(stage, mapper);
}

/** By number, one of two sources; the third point is masked. */
void AddChosenGlyphs(ShadowStage& stage, const glm::dvec3& centre, bool tree)
{
  auto points = MakePoints(centre);
  AddArray(points, "which", 1, { 1.0f, 0.0f, 1.0f });
  vtkNew<vtkBitArray> mask;
  mask->SetName("mask");
  for (int i = 0; i < 3; ++i)
  {
    mask->InsertNextValue(i < 2);
  }
  points->GetPointData()->AddArray(mask);
  auto mapper = MakeGlyphs(points);
  const auto cube = MakeCube({ 0.0, 0.0, 0.2 }, { 0.2, 0.3, 0.4 });
  if (tree)
  {
    vtkNew<vtkMultiBlockDataSet> table;
    vtkNew<vtkMultiBlockDataSet> both;
    both->SetBlock(0, cube);
    both->SetBlock(1, MakeCube({ 0.0, 0.0, -0.3 }, { 0.3, 0.1, 0.1 }));
    table->SetBlock(0, MakeCube({ 0.0, 0.0, 0.0 }, { 0.1, 0.5, 0.1 }));
    table->SetBlock(1, both);
    mapper->SetSourceTableTree(table);
    mapper->UseSourceTableTreeOn();
  }
  else
  {
    mapper->SetSourceData(1, cube);
  }
  mapper->SourceIndexingOn();
  mapper->SetSourceIndexArray("which");
  mapper->MaskingOn();
  mapper->SetMaskArray("mask");
  AddActor(stage, mapper);
}

vtkSmartPointer<vtkPlane> MakePlane(const glm::dvec3& origin, const glm::dvec3& normal)
{
  auto plane = vtkSmartPointer<vtkPlane>::New();
  plane->SetOrigin(origin.x, origin.y, origin.z);
  plane->SetNormal(normal.x, normal.y, normal.z);
  return plane;
}

vtkSmartPointer<vtkImageData> MakeImage(const glm::dvec3& centre, int depth)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(9, 7, depth);
  image->SetSpacing(0.1, 0.1, 0.1);
  image->SetOrigin(centre.x - 0.4, centre.y - 0.3, centre.z - 0.05 * (depth - 1));
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* values = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < 9 * 7 * depth; ++i)
  {
    values[i] = static_cast<unsigned char>(100 + i % 100);
  }
  return image;
}

/** Blocks in the order of the tree: a shown one, a hidden one, a branch of one that is shown again. */
void AddBlocks(ShadowStage& stage, const glm::dvec3& centre)
{
  vtkNew<vtkMultiBlockDataSet> branch;
  branch->SetBlock(0, MakeCube(centre + glm::dvec3(0.4, 0.0, 0.3), glm::dvec3(0.2)));
  branch->SetBlock(1, MakeCube(centre + glm::dvec3(0.4, 0.0, -0.3), glm::dvec3(0.3)));
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, MakeCube(centre - glm::dvec3(0.4, 0.0, 0.0), glm::dvec3(0.3, 0.5, 0.2)));
  blocks->SetBlock(1, MakeCube(centre, glm::dvec3(0.25, 0.3, 0.9)));
  blocks->SetBlock(2, branch);
  vtkNew<vtkShadowCompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  attributes->SetBlockVisibility(blocks->GetBlock(1), false);
  attributes->SetBlockVisibility(branch, false);
  attributes->SetBlockVisibility(branch->GetBlock(0), true);
  mapper->SetCompositeDataDisplayAttributes(attributes);
  AddActor(stage, mapper);
}

void AddAssembly(ShadowStage& stage, const glm::dvec3& centre)
{
  vtkNew<vtkActor> part;
  part->SetMapper(MakeCubeMapper(glm::dvec3(0.0), { 0.2, 0.4, 0.6 }));
  part->SetPosition(0.3, 0.0, 0.0);
  vtkNew<vtkAssembly> inner;
  inner->AddPart(part);
  inner->RotateZ(30.0);
  inner->SetScale(1.0, 0.5, 1.0);
  vtkNew<vtkAssembly> outer;
  outer->AddPart(inner);
  outer->RotateX(40.0);
  outer->SetPosition(centre.x, centre.y, centre.z);
  stage.Renderer->AddViewProp(outer);
}

void AddGaussians(ShadowStage& stage, const glm::dvec3& centre, bool emissive)
{
  auto points = MakePoints(centre);
  AddArray(points, "size", 1, { 0.2f, 0.3f, 0.25f });
  vtkNew<vtkPointGaussianMapper> mapper;
  mapper->SetInputData(points);
  mapper->SetScaleArray("size");
  mapper->SetScaleFactor(0.8);
  mapper->SetEmissive(emissive);
  if (!emissive)
  {
    mapper->SetSplatShaderCode("//VTK::Color::Impl\n"
                               "float fromCentre = dot(offsetVCVSOutput, offsetVCVSOutput);\n"
                               "if (fromCentre > 1.0) { discard; }\n");
  }
  AddActor(stage, mapper);
}

void AddVolume(ShadowStage& stage, const glm::dvec3& centre)
{
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  mapper->SetSampleDistance(0.05f);
  mapper->SetInputData(MakeImage(centre, 6));
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.9);
  opacity->AddPoint(255.0, 1.0);
  volume->GetProperty()->SetScalarOpacity(opacity);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 1.0, 0.2, 0.1);
  color->AddRGBPoint(255.0, 0.2, 1.0, 0.1);
  volume->GetProperty()->SetColor(color);
  stage.Renderer->AddVolume(volume);
}
}

//------------------------------------------------------------------------------
const std::vector<ShadowProp>& GetShadowProps()
{
  using Stage = ShadowStage&;
  using Place = const glm::dvec3&;
  static const std::vector<ShadowProp> props = {
    { "glyphs, turned by angles", true,
      [](Stage stage, Place at)
      {
        AddTurnedGlyphs(
          stage, at, vtkGlyph3DMapper::ROTATION, 3, { 20, 70, 40, 0, 0, 120, 80, -30, 10 });
      } },
    { "glyphs, turned to a direction", true,
      [](Stage stage, Place at)
      {
        AddTurnedGlyphs(
          stage, at, vtkGlyph3DMapper::DIRECTION, 3, { 0.2f, 1, 3, -2, 0, 0, 1, -1, -0.5f });
      } },
    { "glyphs, turned by quaternions", true,
      [](Stage stage, Place at)
      {
        AddTurnedGlyphs(stage, at, vtkGlyph3DMapper::QUATERNION, 4,
          { 0.9f, 0.1f, 0.3f, 0.2f, 0.5f, 0.5f, -0.5f, 0.5f, 1, 0, 0, 1 });
      } },
    { "glyphs, scaled by magnitude", true,
      [](Stage stage, Place at)
      { AddScaledGlyphs(stage, at, vtkGlyph3DMapper::SCALE_BY_MAGNITUDE, false); } },
    { "glyphs, scaled by components and clamped", true,
      [](Stage stage, Place at)
      { AddScaledGlyphs(stage, at, vtkGlyph3DMapper::SCALE_BY_COMPONENTS, true); } },
    { "glyphs, masked and of several sources", true,
      [](Stage stage, Place at) { AddChosenGlyphs(stage, at, false); } },
    { "glyphs of composite sources", true,
      [](Stage stage, Place at) { AddChosenGlyphs(stage, at, true); } },
    { "sphere imposters", true,
      [](Stage stage, Place at)
      {
        auto points = MakePoints(at);
        AddArray(points, "size", 1, { 0.2f, 0.3f, 0.15f });
        vtkNew<vtkOpenGLSphereMapper> mapper;
        mapper->SetInputData(points);
        mapper->SetScaleArray("size");
        AddActor(stage, mapper);
      } },
    { "sphere imposters of one size", true,
      [](Stage stage, Place at)
      {
        vtkNew<vtkOpenGLSphereMapper> mapper;
        mapper->SetInputData(MakePoints(at));
        mapper->SetRadius(0.25f);
        AddActor(stage, mapper);
      } },
    { "stick imposters", true,
      [](Stage stage, Place at)
      {
        auto points = MakePoints(at);
        AddArray(points, "along", 3, { 0, 0, 1, 0.6f, 0.8f, 0, 0.6f, 0, 0.8f });
        AddArray(points, "size", 3, { 0.6f, 0.1f, 0, 0.7f, 0.15f, 0, 0.5f, 0.08f, 0 });
        AddArray(points, "color", 1, { 0.1f, 0.5f, 0.9f });
        points->GetPointData()->SetActiveScalars("color");
        vtkNew<vtkOpenGLStickMapper> mapper;
        mapper->SetInputData(points);
        mapper->SetOrientationArray("along");
        mapper->SetScaleArray("size");
        AddActor(stage, mapper);
        mapper->ScalarVisibilityOn(); // without colours VTK draws none
      } },
    { "Gaussian points that do not glow", true,
      [](Stage stage, Place at) { AddGaussians(stage, at, false); } },
    { "Gaussian points that glow", false,
      [](Stage stage, Place at) { AddGaussians(stage, at, true); } },
    { "blocks, some hidden", true, AddBlocks },
    { "clipped", true,
      [](Stage stage, Place at)
      {
        auto mapper = MakeCubeMapper(at, glm::dvec3(0.7));
        mapper->AddClippingPlane(MakePlane(at, { 1.0, 0.4, 0.0 }));
        mapper->AddClippingPlane(MakePlane(at + glm::dvec3(0, 0.1, 0.1), { 0.0, -1.0, -0.2 }));
        AddActor(stage, mapper);
      } },
    { "clipped, moved and turned", true,
      [](Stage stage, Place at)
      {
        auto mapper = MakeCubeMapper(glm::dvec3(0.0), glm::dvec3(0.4));
        mapper->AddClippingPlane(MakePlane(at, { 1.0, 0.4, 0.0 }));
        vtkActor* actor = AddActor(stage, mapper);
        actor->SetPosition(at.x, at.y, at.z);
        actor->SetScale(1.2, 2.0, 0.9);
        actor->RotateX(30.0);
        actor->RotateZ(20.0);
      } },
    { "image slice", true,
      [](Stage stage, Place at)
      {
        vtkNew<vtkImageSliceMapper> mapper;
        mapper->SetInputData(MakeImage(at, 1));
        mapper->BorderOn();
        vtkNew<vtkImageSlice> slice;
        slice->SetMapper(mapper);
        stage.Renderer->AddViewProp(slice);
      } },
    { "translucent image slice", false,
      [](Stage stage, Place at)
      {
        vtkNew<vtkImageSliceMapper> mapper;
        mapper->SetInputData(MakeImage(at, 1));
        vtkNew<vtkImageSlice> slice;
        slice->SetMapper(mapper);
        slice->GetProperty()->SetOpacity(0.4);
        stage.Renderer->AddViewProp(slice);
      } },
    { "skin of a grid", true,
      [](Stage stage, Place at)
      {
        vtkNew<vtkAppendFilter> grid;
        grid->AddInputData(MakeImage(at, 5));
        grid->Update();
        vtkNew<vtkDataSetMapper> mapper;
        mapper->SetInputData(grid->GetOutput());
        AddActor(stage, mapper);
      } },
    { "level-of-detail prop in a prop assembly", true,
      [](Stage stage, Place at)
      {
        vtkNew<vtkLODProp3D> prop;
        prop->AddLOD(MakeCubeMapper(glm::dvec3(0.0), { 0.4, 0.3, 0.5 }), 0.0);
        prop->SetPosition(at.x, at.y, at.z);
        vtkNew<vtkPropAssembly> assembly;
        assembly->AddPart(prop);
        stage.Renderer->AddViewProp(assembly);
      } },
    { "level-of-detail actor", true,
      [](Stage stage, Place at)
      {
        vtkNew<vtkLODActor> actor;
        actor->SetMapper(MakeCubeMapper(at, { 0.5, 0.3, 0.7 }));
        stage.Renderer->AddActor(actor);
      } },
    { "level-of-detail prop", true,
      [](Stage stage, Place at)
      {
        vtkNew<vtkLODProp3D> prop;
        prop->AddLOD(MakeCubeMapper(glm::dvec3(0.0), { 0.5, 0.3, 0.7 }), 0.0);
        prop->SetPosition(at.x, at.y, at.z);
        stage.Renderer->AddViewProp(prop);
      } },
    { "assembly within an assembly", true, AddAssembly },
    { "prop assembly", true,
      [](Stage stage, Place at)
      {
        vtkNew<vtkActor> part;
        part->SetMapper(MakeCubeMapper(glm::dvec3(0.0), { 0.3, 0.4, 0.6 }));
        part->SetPosition(at.x, at.y, at.z);
        vtkNew<vtkPropAssembly> assembly;
        assembly->AddPart(part);
        stage.Renderer->AddViewProp(assembly);
      } },
    { "physically based with backface", true,
      [](Stage stage, Place at)
      {
        vtkActor* actor = stage.AddBox(at, { 0.5, 0.3, 0.7 });
        actor->GetProperty()->SetInterpolationToPBR();
        actor->GetProperty()->SetMetallic(0.3);
      } },
    { "wide line", false,
      [](Stage stage, Place at)
      {
        vtkNew<vtkLineSource> line;
        line->SetPoint1(at.x - 0.5, at.y, at.z);
        line->SetPoint2(at.x + 0.5, at.y, at.z);
        line->Update();
        vtkProperty* property = stage.Add(line->GetOutput())->GetProperty();
        property->SetLineWidth(6.0);
        property->RenderLinesAsTubesOn();
      } },
    { "points as spheres", false,
      [](Stage stage, Place at)
      {
        vtkProperty* property = stage.Add(MakePoints(at))->GetProperty();
        property->SetPointSize(10.0);
        property->RenderPointsAsSpheresOn();
      } },
    { "wireframe", false,
      [](Stage stage, Place at)
      { stage.AddBox(at, glm::dvec3(0.7))->GetProperty()->SetRepresentationToWireframe(); } },
    { "volume", false, AddVolume },
  };
  return props;
}
