// SPDX-License-Identifier: BSD-3-Clause
#include "VTKShadows.h"

#include "OffscreenWindow.h"
#include "References.h"
#include "VTKShadowPass.h"

#include "vtkAreaLight.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace
{
// Half the angle, in degrees, of the cone from the light about its axis that holds the bounds.
double GetConeAngle(vtkAreaLight* light, const double bounds[6])
{
  double axis[3];
  vtkMath::Subtract(light->GetFocalPoint(), light->GetPosition(), axis);
  double widest = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double way[3];
    for (int i = 0; i < 3; ++i)
    {
      way[i] = bounds[2 * i + ((corner >> i) & 1)] - light->GetPosition()[i];
    }
    widest = std::max(widest, vtkMath::AngleBetweenVectors(axis, way));
  }
  // VTK makes no map of a cone of 90 degrees or more, and a poor one of nearly that.
  return std::clamp(vtkMath::DegreesFromRadians(widest), 1.0, 80.0);
}

int Sum(const unsigned char* pixel)
{
  return pixel[0] + pixel[1] + pixel[2];
}

const unsigned char* GetPixels(vtkImageData* picture)
{
  return static_cast<const unsigned char*>(picture->GetScalarPointer());
}
}

//------------------------------------------------------------------------------
VTKShadows::VTKShadows(int resolution)
  : Pass(MakeVTKShadowPass(resolution))
{
}

//------------------------------------------------------------------------------
std::string VTKShadows::FindUnsupported(vtkAreaLight* light)
{
  return light->LightTypeIsSceneLight() ? "" : "VTK's pass takes lights of the scene alone";
}

//------------------------------------------------------------------------------
void VTKShadows::Enter(vtkRenderer* renderer, const std::vector<vtkAreaLight*>& lights)
{
  this->Lights.assign(lights.begin(), lights.end());
  renderer->ComputeVisiblePropBounds(this->Bounds);
  for (vtkAreaLight* light : lights)
  {
    vtkNew<vtkLight> standIn;
    standIn->SetLightTypeToSceneLight();
    standIn->SetPositional(light->GetPositional());
    standIn->SetDiffuseColor(light->GetDiffuseColor());
    standIn->SetSpecularColor(light->GetSpecularColor());
    standIn->SetIntensity(light->GetIntensity());
    standIn->SetExponent(0.0); // as bright everywhere in the cone
    this->StandIns.push_back(standIn.Get());
    renderer->RemoveLight(light);
    renderer->AddLight(standIn);
  }
  this->Follow();
  renderer->SetPass(this->Pass);
}

//------------------------------------------------------------------------------
void VTKShadows::Follow()
{
  for (std::size_t i = 0; i < this->StandIns.size(); ++i)
  {
    this->StandIns[i]->SetPosition(this->Lights[i]->GetPosition());
    this->StandIns[i]->SetFocalPoint(this->Lights[i]->GetFocalPoint());
    this->StandIns[i]->SetConeAngle(GetConeAngle(this->Lights[i], this->Bounds));
  }
}

//------------------------------------------------------------------------------
void VTKShadows::Leave(vtkRenderer* renderer)
{
  renderer->SetPass(nullptr);
  this->Pass->ReleaseGraphicsResources(renderer->GetRenderWindow());
  for (std::size_t i = 0; i < this->StandIns.size(); ++i)
  {
    renderer->RemoveLight(this->StandIns[i]);
    renderer->AddLight(this->Lights[i]);
  }
  this->StandIns.clear();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> VTKShadows::GetVisibility(
  OffscreenWindow& window, vtkImageData* right)
{
  const auto draw = [&window](vtkRenderPass* pass)
  {
    window.GetRenderer()->SetPass(pass);
    window.Render();
    vtkSmartPointer<vtkImageData> picture = References::Copy(window.Grab());
    return picture;
  };
  // Its light alone.
  std::vector<double> intensities;
  for (vtkLight* other : this->StandIns)
  {
    intensities.push_back(other->GetIntensity());
    if (other != this->StandIns.front())
    {
      other->SetIntensity(0.0);
    }
  }
  const auto shadowed = draw(this->Pass);
  const auto unshadowed = draw(nullptr);
  vtkLight* light = this->StandIns.front();
  light->SetIntensity(0.0); // not switched off: without a light VTK draws everything bright
  const auto dark = draw(nullptr);
  for (std::size_t i = 0; i < intensities.size(); ++i)
  {
    this->StandIns[i]->SetIntensity(intensities[i]);
  }
  window.GetRenderer()->SetPass(this->Pass);

  auto visibility = References::Copy(right);
  auto* values = vtkFloatArray::SafeDownCast(visibility->GetPointData()->GetArray("Visibility"));
  const int components = values->GetNumberOfComponents();
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    // Of 3 x 255. The three roundings of a sum are off by 0.5 together: 1/100 of this.
    constexpr int least = 64;
    const int without = Sum(GetPixels(dark) + 3 * i);
    const int added = Sum(GetPixels(unshadowed) + 3 * i) - without;
    const bool clipped =
      *std::max_element(GetPixels(unshadowed) + 3 * i, GetPixels(unshadowed) + 3 * i + 3) == 255;
    if (added >= least && !clipped)
    {
      const double part = static_cast<double>(Sum(GetPixels(shadowed) + 3 * i) - without) / added;
      for (int c = 0; c < components; ++c)
      {
        values->SetTypedComponent(i, c, static_cast<float>(std::clamp(part, 0.0, 1.0)));
      }
    }
  }
  return visibility;
}
