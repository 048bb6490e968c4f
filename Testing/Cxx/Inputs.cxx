// SPDX-License-Identifier: BSD-3-Clause
// What pipelines hand over: mappers whose upstream is not to run, and emission textures of any image.

#include "ShadowStage.h"
#include "ShadowTest.h"

#include "vtkAppendFilter.h"
#include "vtkCubeSource.h"
#include "vtkDataSetMapper.h"
#include "vtkDoubleArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkShadowVTKVersion.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"

#include <limits>

namespace
{
/** An image of so many components, of a pattern that has no symmetry; and changes of it. */
vtkSmartPointer<vtkImageData> MakeEmission(
  int components, const std::function<double(int index, double value)>& change = {})
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(8, 4, 1);
  image->AllocateScalars(VTK_DOUBLE, components);
  auto* texels = static_cast<double*>(image->GetScalarPointer());
  for (int i = 0; i < 32 * components; ++i)
  {
    texels[i] = (i * 7 % 11) / 10.0;
    texels[i] = change ? change(i, texels[i]) : texels[i];
  }
  return image;
}

Visibility ShowWith(const std::string& technique, vtkTexture* texture)
{
  return RenderVisibility(technique, { { "samples", "16" } },
    [&](ShadowStage& stage)
    {
      stage.AddThings();
      stage.AddLight(LightKind::Rectangle)->SetTexture(texture);
    });
}

Visibility ShowWith(const std::string& technique, vtkImageData* emission)
{
  vtkNew<vtkTexture> texture;
  texture->SetInputData(emission);
  return ShowWith(technique, texture);
}

bool TakesTextures(const std::string& technique)
{
  const auto& description = ShadowStage::Describe(technique);
  return !description.Traits.Hard &&
         description.LightShapes[5] != vtkShadowShapeSupport::Unsupported;
}
}

//------------------------------------------------------------------------------
// StaticOn: what draws must not update what lies before the mapper, and no more must the pass. The
// shadow is that of the data that are there.
SHADOW_TEST(Inputs, StaticMappersAreNotUpdated, Each)
{
  vtkNew<vtkPolyDataMapper> polygons;
  vtkNew<vtkDataSetMapper> grid;
  vtkNew<vtkShadowCompositeMapper> composite;
  vtkNew<vtkGlyph3DMapper> glyphs;
  vtkNew<vtkCubeSource> cube;
  glyphs->SetSourceConnection(cube->GetOutputPort());
  cube->Update();
  glyphs->ScalingOff();
  const struct
  {
    const char* What;
    vtkMapper* Mapper;
  } kinds[] = { { "polygons", polygons }, { "a grid", grid }, { "composite data", composite },
    { "glyphs", glyphs } };
  for (const auto& kind : kinds)
  {
    ShadowStage stage;
    stage.AddFloor();
    vtkNew<vtkSphereSource> sphere;
    sphere->SetCenter(0.0, 0.0, 1.6);
    sphere->SetRadius(0.6);
    vtkNew<vtkAppendFilter> unstructured; // of tetrahedra there are none: the cells are polygons
    unstructured->SetInputConnection(sphere->GetOutputPort());
    kind.Mapper->SetInputConnection(
      kind.Mapper == grid ? unstructured->GetOutputPort() : sphere->GetOutputPort());
    unstructured->Update();
    kind.Mapper->StaticOn();
    vtkNew<vtkActor> actor;
    actor->SetMapper(kind.Mapper);
    stage.Renderer->AddActor(actor);
    stage.AddLight(LightKind::Point);
    stage.LookAt({ 3.5, -6.5, 4.5 }, { 0.2, 0.2, 0.3 });
    stage.SetPass(technique);
    stage.Render();
    const Visibility before = stage.GetVisibility();
    const vtkMTimeType time = sphere->GetOutput()->GetMTime();
    sphere->SetRadius(1.2);
    stage.Render();
    const std::string what = kind.What;
    ShadowTest::CheckAtMost(GetRange(before).first, 0.5, what + ": V in the shadow");
    ShadowTest::Check(Same(stage.GetVisibility(), before), what + ": the shadow is another");
    ShadowTest::Check(sphere->GetOutput()->GetMTime() == time, what + ": the source has run");
    kind.Mapper->StaticOff();
    stage.Render();
    ShadowTest::Check(
      !Same(stage.GetVisibility(), before), what + ": no other shadow of what is no longer static");
  }
}

//------------------------------------------------------------------------------
// Where an image's extent begins changes nothing: such as of a part that was cut out of another.
SHADOW_TEST(Inputs, EmissionExtent, Each)
{
  if (!TakesTextures(technique))
  {
    return;
  }
  for (const int components : { 1, 2, 3, 4 })
  {
    const auto image = MakeEmission(components);
    const Visibility expected = ShowWith(technique, image);
    image->SetExtent(10, 17, -5, -2, 3, 3);
    ShadowTest::Check(Same(ShowWith(technique, image), expected),
      std::to_string(components) + " components: another V where the extent begins elsewhere");
  }
}

//------------------------------------------------------------------------------
// Texels below 0, and what is no number, shine as little as black ones.
SHADOW_TEST(Inputs, EmissionThatIsNoLight, Each)
{
  if (!TakesTextures(technique))
  {
    return;
  }
  const auto black = MakeEmission(3, [](int i, double value) { return i % 5 == 0 ? 0.0 : value; });
  const Visibility expected = ShowWith(technique, black);
  for (const double value : { -3.0, std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() })
  {
    const auto image =
      MakeEmission(3, [value](int i, double other) { return i % 5 == 0 ? value : other; });
    ShadowTest::Check(Same(ShowWith(technique, image), expected),
      std::to_string(value) + " is not as dark as black");
  }
  // All of it: then every place counts alike, as in a channel that is black.
  const Visibility none = ShowWith(technique, MakeEmission(3, [](int, double) { return -1.0; }));
  const Visibility dark = ShowWith(technique, MakeEmission(3, [](int, double) { return 0.0; }));
  ShadowTest::Check(Same(none, dark), "all below 0 is not as black");
  ShadowTest::CheckAtMost(GetRange(none).second, 1.0 + 1e-5, "V at most");
}

//------------------------------------------------------------------------------
// Textures without texels are none: the light is evenly bright, and nothing is said.
SHADOW_TEST(Inputs, EmissionWithoutTexels, Each)
{
  if (!TakesTextures(technique))
  {
    return;
  }
  const Visibility expected = ShowWith(technique, static_cast<vtkTexture*>(nullptr));
  vtkNew<vtkTexture> unconnected;
  ShadowTest::Check(Same(ShowWith(technique, unconnected), expected), "no input");
  vtkNew<vtkImageData> empty;
  ShadowTest::Check(Same(ShowWith(technique, empty), expected), "an empty image");
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(4, 4, 1);
  ShadowTest::Check(Same(ShowWith(technique, bare), expected), "an image without scalars");
  vtkNew<vtkImageData> few;
  few->SetDimensions(4, 4, 1);
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetNumberOfTuples(3);
  scalars->Fill(1.0);
  few->GetPointData()->SetScalars(scalars);
  ShadowTest::Check(Same(ShowWith(technique, few), expected), "an image of too few scalars");
}
