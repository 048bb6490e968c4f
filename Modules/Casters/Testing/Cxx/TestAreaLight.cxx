// SPDX-License-Identifier: BSD-3-Clause
// vtkAreaLight: defaults, shape names, clamps, copies, modification time, PrintSelf.

#include "ShadowTesting.h"

#include "vtkAreaLight.h"
#include "vtkCallbackCommand.h"
#include "vtkInformation.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkShadowTags.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"

#include <sstream>
#include <string>

namespace
{
//------------------------------------------------------------------------------
void TestDefaults()
{
  vtkNew<vtkAreaLight> light;
  CHECK(light->GetPositional());
  CHECK(!light->LightTypeIsHeadlight());
  CHECK_EQUAL(light->GetConeAngle(), 90.0);
  CHECK_EQUAL(light->GetShape(), vtkAreaLight::Sphere);
  CHECK_EQUAL(light->GetRadius(), 0.5);
  CHECK_EQUAL(light->GetWidth(), 1.0);
  CHECK_EQUAL(light->GetHeight(), 1.0);
  CHECK_EQUAL(light->GetUpVector()[1], 1.0);
  CHECK_EQUAL(light->GetAngularDiameter(), 0.0);
  CHECK(light->GetTexture() == nullptr);
}

//------------------------------------------------------------------------------
void TestShapes()
{
  vtkNew<vtkAreaLight> light;
  light->SetShapeToPoint();
  CHECK_EQUAL(std::string(light->GetShapeAsString()), "point");
  light->SetShapeToSphere();
  CHECK_EQUAL(std::string(light->GetShapeAsString()), "sphere");
  light->SetShapeToDisk();
  CHECK_EQUAL(std::string(light->GetShapeAsString()), "disk");
  light->SetShapeToRectangle();
  CHECK_EQUAL(std::string(light->GetShapeAsString()), "rectangle");
}

//------------------------------------------------------------------------------
void TestClamps()
{
  vtkNew<vtkAreaLight> light;
  light->SetShape(-1);
  CHECK_EQUAL(light->GetShape(), vtkAreaLight::Point);
  light->SetShape(99);
  CHECK_EQUAL(light->GetShape(), vtkAreaLight::Rectangle);
  // What is no size is refused, with an error each.
  int errors = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&errors);
  count->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  light->AddObserver(vtkCommand::ErrorEvent, count);
  light->SetRadius(-1.0);
  CHECK_EQUAL(light->GetRadius(), 0.5);
  light->SetWidth(-1.0);
  CHECK_EQUAL(light->GetWidth(), 1.0);
  light->SetHeight(-1.0);
  CHECK_EQUAL(light->GetHeight(), 1.0);
  light->SetAngularDiameter(-1.0);
  CHECK_EQUAL(light->GetAngularDiameter(), 0.0);
  CHECK_EQUAL(errors, 4);
  CHECK(!light->GetPlaced());
  light->SetAngularDiameter(180.0);
  CHECK(light->GetPlaced());
  CHECK_EQUAL(light->GetAngularDiameter(), 90.0);
}

//------------------------------------------------------------------------------
// Every member differs from its default, so that a forgotten one shows.
void Fill(vtkAreaLight* light, vtkTexture* texture)
{
  light->SetPosition(1.0, 2.0, 3.0);
  light->SetFocalPoint(4.0, 5.0, 6.0);
  light->SetDiffuseColor(0.25, 0.5, 0.75);
  light->SetIntensity(0.5);
  light->SetConeAngle(45.0);
  light->SetShadowAttenuation(0.75);
  light->SetShapeToDisk();
  light->SetRadius(2.0);
  light->SetWidth(3.0);
  light->SetHeight(4.0);
  light->SetUpVector(0.0, 0.0, 1.0);
  light->SetAngularDiameter(0.5);
  light->SetTexture(texture);
}

void CheckFilled(vtkAreaLight* light, vtkTexture* texture)
{
  CHECK_EQUAL(light->GetPosition()[2], 3.0);
  CHECK_EQUAL(light->GetFocalPoint()[0], 4.0);
  CHECK_EQUAL(light->GetDiffuseColor()[2], 0.75);
  CHECK_EQUAL(light->GetIntensity(), 0.5);
  CHECK_EQUAL(light->GetConeAngle(), 45.0);
  CHECK_EQUAL(light->GetShadowAttenuation(), 0.75f);
  CHECK_EQUAL(light->GetShape(), vtkAreaLight::Disk);
  CHECK_EQUAL(light->GetRadius(), 2.0);
  CHECK_EQUAL(light->GetWidth(), 3.0);
  CHECK_EQUAL(light->GetHeight(), 4.0);
  CHECK_EQUAL(light->GetUpVector()[1], 0.0);
  CHECK_EQUAL(light->GetUpVector()[2], 1.0);
  CHECK_EQUAL(light->GetAngularDiameter(), 0.5);
  CHECK(light->GetTexture() == texture);
}

//------------------------------------------------------------------------------
void TestCopies()
{
  vtkNew<vtkTexture> texture;
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(0, 3, 7.0);
  vtkNew<vtkAreaLight> light;
  Fill(light, texture);
  light->SetTransformMatrix(matrix);
  vtkShadowTags::SetLightCasting(light, false);

  // VTK clones lights through the base class.
  vtkLight* base = light;
  auto clone = vtkSmartPointer<vtkLight>::Take(base->ShallowClone());
  auto* area = vtkAreaLight::SafeDownCast(clone);
  CHECK(area != nullptr);
  if (area)
  {
    CheckFilled(area, texture);
    CHECK(area->GetTransformMatrix() == matrix);
    CHECK(!vtkShadowTags::GetLightCasting(area));
  }

  vtkNew<vtkAreaLight> copy;
  copy->DeepCopy(light);
  CheckFilled(copy, texture);

  // A plain light has no area to copy: the rest is copied, the area stays.
  vtkNew<vtkLight> plain;
  plain->SetIntensity(0.125);
  copy->DeepCopy(plain);
  CHECK_EQUAL(copy->GetIntensity(), 0.125);
  CHECK_EQUAL(copy->GetShape(), vtkAreaLight::Disk);
  CHECK_EQUAL(copy->GetRadius(), 2.0);
  CHECK(copy->GetTexture() == texture);
}

//------------------------------------------------------------------------------
void TestModifiedTime()
{
  vtkNew<vtkAreaLight> light;
  vtkMTimeType time = light->GetMTime();
  light->SetRadius(light->GetRadius());
  CHECK_EQUAL(light->GetMTime(), time);
  light->SetRadius(3.0);
  CHECK(light->GetMTime() > time);

  vtkNew<vtkTexture> texture;
  light->SetTexture(texture);
  time = light->GetMTime();
  texture->Modified();
  CHECK(light->GetMTime() > time);
}

//------------------------------------------------------------------------------
void TestPrint()
{
  vtkNew<vtkTexture> texture;
  vtkNew<vtkAreaLight> light;
  Fill(light, texture);
  std::ostringstream out;
  light->Print(out);
  const std::string text = out.str();
  for (const char* part : { "vtkAreaLight", "Shape: disk\n", "Radius: 2\n", "Width: 3\n",
         "Height: 4\n", "UpVector: 0, 0, 1\n", "AngularDiameter: 0.5\n", "Texture: " })
  {
    if (text.find(part) == std::string::npos)
    {
      std::cout << "PrintSelf does not print " << part << "\n";
      CHECK(false);
    }
  }
}
}

//------------------------------------------------------------------------------
int TestAreaLight(int, char*[])
{
  TestDefaults();
  TestShapes();
  TestClamps();
  TestCopies();
  TestModifiedTime();
  TestPrint();
  return ShadowTesting::Result();
}
