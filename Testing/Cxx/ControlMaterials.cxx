// SPDX-License-Identifier: BSD-3-Clause
// All that VTK can draw goes on being drawn as VTK draws it, times the shadow.

#include "ShadowOracle.h"
#include "ShadowTest.h"

#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLineSource.h"
#include "vtkMapper.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPBRLUTTexture.h"
#include "vtkPBRPrefilterTexture.h"
#include "vtkPlane.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"
#include "vtkVertexGlyphFilter.h"

#include <algorithm>

namespace
{
struct Material
{
  const char* Name;
  std::function<void(ShadowStage&, vtkActor*)> Apply; // to the floor
};

vtkSmartPointer<vtkImageData> MakeCheckers(int size = 8)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(size, size, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int i = 0; i < size * size; ++i)
  {
    auto* texel = static_cast<unsigned char*>(image->GetScalarPointer(i % size, i / size, 0));
    const bool even = (i % size + i / size) % 2 == 0;
    texel[0] = even ? 220 : 90;
    texel[1] = 180;
    texel[2] = even ? 60 : 200;
  }
  return image;
}

void AddTextureCoordinates(vtkActor* floor)
{
  auto* polygons = vtkPolyData::SafeDownCast(floor->GetMapper()->GetInputDataObject(0, 0));
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  for (const auto& uv : { std::pair<float, float>(0, 0), { 1, 0 }, { 1, 1 }, { 0, 1 } })
  {
    coordinates->InsertNextTuple2(uv.first, uv.second);
  }
  polygons->GetPointData()->SetTCoords(coordinates);
}

const std::vector<Material>& GetMaterials()
{
  static const std::vector<Material> materials = {
    { "plain", [](ShadowStage&, vtkActor*) {} },
    { "shiny",
      [](ShadowStage&, vtkActor* floor)
      {
        floor->GetProperty()->SetSpecular(0.6);
        floor->GetProperty()->SetSpecularPower(10.0);
      } },
    { "textured",
      [](ShadowStage&, vtkActor* floor)
      {
        AddTextureCoordinates(floor);
        vtkNew<vtkTexture> texture;
        texture->SetInputData(MakeCheckers());
        floor->SetTexture(texture);
      } },
    { "scalar colours",
      [](ShadowStage&, vtkActor* floor)
      {
        auto* polygons = vtkPolyData::SafeDownCast(floor->GetMapper()->GetInputDataObject(0, 0));
        vtkNew<vtkFloatArray> scalars;
        for (int i = 0; i < 4; ++i)
        {
          scalars->InsertNextValue(0.3f * static_cast<float>(i));
        }
        polygons->GetPointData()->SetScalars(scalars);
        floor->GetMapper()->ScalarVisibilityOn();
      } },
    { "PBR",
      [](ShadowStage&, vtkActor* floor)
      {
        floor->GetProperty()->SetInterpolationToPBR();
        floor->GetProperty()->SetRoughness(0.5);
        floor->GetProperty()->SetMetallic(0.1);
      } },
    { "PBR with image-based light",
      [](ShadowStage& stage, vtkActor* floor)
      {
        floor->GetProperty()->SetInterpolationToPBR();
        floor->GetProperty()->SetRoughness(0.3);
        vtkNew<vtkTexture> environment;
        environment->SetInputData(MakeCheckers(128));
        environment->MipmapOn();
        environment->InterpolateOn();
        environment->SetColorModeToDirectScalars();
        stage.Renderer->SetEnvironmentTexture(environment);
        stage.Renderer->UseImageBasedLightingOn();
        // Small, or a software rasterizer makes them for seconds.
        auto* renderer = vtkOpenGLRenderer::SafeDownCast(stage.Renderer);
        renderer->GetEnvMapLookupTable()->SetLUTSize(32);
        renderer->GetEnvMapPrefiltered()->SetPrefilterMaxSamples(16);
      } },
    { "moved by a shader of the user's",
      [](ShadowStage&, vtkActor* floor)
      {
        floor->GetShaderProperty()->AddVertexShaderReplacement("//VTK::PositionVC::Impl", true,
          "//VTK::PositionVC::Impl\n"
          "  vec4 movedMC = vertexMC + vec4(0.0, 0.0, 0.2, 0.0);\n"
          "  vertexVCVSOutput = MCVCMatrix * movedMC;\n"
          "  gl_Position = MCDCMatrix * movedMC;\n",
          false);
      } },
    { "coloured by a shader of the user's",
      [](ShadowStage&, vtkActor* floor)
      {
        floor->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Color::Impl", true,
          "//VTK::Color::Impl\n  diffuseColor = fract(0.01 * vec3(gl_FragCoord.xyx));\n", false);
      } },
    { "flat",
      [](ShadowStage&, vtkActor* floor) { floor->GetProperty()->SetInterpolationToFlat(); } },
    { "edges visible",
      [](ShadowStage&, vtkActor* floor) { floor->GetProperty()->EdgeVisibilityOn(); } },
    { "two-sided",
      [](ShadowStage&, vtkActor* floor)
      {
        vtkNew<vtkProperty> back;
        back->SetColor(1.0, 0.0, 0.0);
        floor->SetBackfaceProperty(back);
      } },
    { "clipped",
      [](ShadowStage&, vtkActor* floor)
      {
        vtkNew<vtkPlane> plane;
        plane->SetOrigin(-2.5, 0.0, 0.0);
        plane->SetNormal(1.0, 0.0, 0.0);
        floor->GetMapper()->AddClippingPlane(plane);
      } },
    { "with lines beside it",
      [](ShadowStage& stage, vtkActor*)
      {
        vtkNew<vtkLineSource> line;
        line->SetPoint1(-1.8, -2.0, 0.1);
        line->SetPoint2(2.0, -2.5, 0.1);
        line->Update();
        stage.Add(line->GetOutput())->GetProperty()->SetLineWidth(3.0);
      } },
    { "with points beside it",
      [](ShadowStage& stage, vtkActor*)
      {
        vtkNew<vtkLineSource> line;
        line->SetPoint1(-1.8, -2.0, 0.1);
        line->SetPoint2(2.0, -2.5, 0.1);
        line->SetResolution(10);
        vtkNew<vtkVertexGlyphFilter> points;
        points->SetInputConnection(line->GetOutputPort());
        points->Update();
        stage.Add(points->GetOutput())->GetProperty()->SetPointSize(4.0);
      } },
    { "with a wireframe beside it",
      [](ShadowStage& stage, vtkActor*)
      {
        stage.AddBox({ -2.0, -1.5, 0.5 }, { 0.5, 0.5, 1.0 })
          ->GetProperty()
          ->SetRepresentationToWireframe();
      } },
    { "with something unlit beside it",
      [](ShadowStage& stage, vtkActor*) {
        stage.AddBox({ -2.0, -1.5, 0.5 }, { 0.5, 0.5, 1.0 })->GetProperty()->LightingOff();
      } },
  };
  return materials;
}
}

//------------------------------------------------------------------------------
// Where V is 1 the picture is VTK's without a pass, and where it is 0 it is VTK's with that light
// all but out: both to 1/255 at every pixel. (A light that is quite out would change VTK's shading.)
SHADOW_TEST(Control, Materials, Each)
{
  for (const Material& material : GetMaterials())
  {
    ShadowStage stage;
    stage.AddFloor();
    auto* floor = vtkActor::SafeDownCast(stage.Renderer->GetViewProps()->GetItemAsObject(0));
    stage.AddBox({ -0.8, 0.3, 0.6 }, { 1.0, 1.0, 1.2 });
    stage.AddSphere({ 0.9, -0.5, 1.3 }, 0.6);
    vtkAreaLight* light = stage.AddLight(LightKind::Point);
    stage.LookAt({ 3.5, -6.5, 4.5 }, { 0.2, 0.2, 0.3 });
    material.Apply(stage, floor);
    const std::string what = material.Name;

    stage.Render();
    const Picture plain = stage.GetPicture();
    light->SetIntensity(1e-6);
    stage.Render();
    const Picture out = stage.GetPicture();
    light->SetIntensity(1.0);
    ShadowTest::CheckNoMessage(what + ", without a pass");
    stage.SetPass(technique);
    stage.Render();
    const Picture picture = stage.GetPicture();
    ShadowTest::CheckNoMessage(what + ", with a pass");
    const Visibility visibility = stage.GetVisibility();
    ShadowTest::CheckNoMessage(what + ", visibility");

    int worstLit = 0;
    int worstDark = 0;
    std::size_t lit = 0;
    std::size_t dark = 0;
    for (std::size_t i = 0; i < visibility.V.size(); ++i)
    {
      if (!visibility.Mask[i] || visibility.V[i] == 1.0f)
      {
        ++lit;
        worstLit = std::max(worstLit, picture.Difference(plain, i));
      }
      else if (visibility.V[i] == 0.0f)
      {
        ++dark;
        worstDark = std::max(worstDark, picture.Difference(out, i));
      }
    }
    ShadowTest::CheckAtLeast(static_cast<double>(lit), 5000.0, what + ", lit pixels");
    ShadowTest::CheckAtLeast(static_cast<double>(dark), 500.0, what + ", dark pixels");
    ShadowTest::CheckAtMost(worstLit, 1.0, what + ", lit: difference, of 255");
    ShadowTest::CheckAtMost(worstDark, 1.0, what + ", dark: difference, of 255");
  }
}

//------------------------------------------------------------------------------
// What is unlit casts, and is no receiver.
SHADOW_TEST(Control, UnlitProps, Each)
{
  ShadowStage stage;
  vtkActor* box = stage.AddThings();
  stage.AddLight(LightKind::Point);
  stage.SetPass(technique);
  stage.Render();
  const Visibility lit = stage.GetVisibility();
  box->GetProperty()->LightingOff();
  stage.Render();
  const Visibility unlit = stage.GetVisibility();
  const ShadowOracle oracle(stage);
  const auto mask = oracle.GetMask(box);
  const auto inner = oracle.GetInner(1);
  std::size_t receivers = 0;
  std::vector<unsigned char> others;
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    receivers += inner[i] && mask[i] && unlit.Mask[i];
    others.push_back(inner[i] && !mask[i]);
  }
  ShadowTest::CheckEqual(static_cast<double>(receivers), 0.0, "receivers of the unlit box");
  ShadowTest::CheckEqual(
    Compare(lit, unlit, 0.1, others).Maximum, 0.0, "difference of the others' V");
}
