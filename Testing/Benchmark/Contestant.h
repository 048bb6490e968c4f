// SPDX-License-Identifier: BSD-3-Clause
// What the benchmarks share: scenes in windows of their own, drawn in different ways, to be timed in
// turns.

#ifndef Contestant_h
#define Contestant_h

#include "VTKShadowPass.h"

#include "vtkAreaLight.h"
#include "vtkCamera.h"
#include "vtkLightCollection.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkShadowPass.h"
#include "vtkShadowScenes.h"
#include "vtkShadowTechniques.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <map>
#include <string>
#include <vector>

/** A scene in its own window, drawn in one way. */
struct Contestant
{
  std::string Name;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  vtkSmartPointer<vtkLight> Light; // the scene's own
  std::vector<double> Camera;      // milliseconds of frames for which the camera moved
  std::vector<double> Moving;      // for which the light moved

  Contestant(const std::string& name, const std::string& scene, int size, vtkRenderPass* pass)
    : Contestant(
        name, [&scene](vtkRenderer* renderer) { vtkShadowScenes::Build(scene, renderer); }, size,
        pass)
  {
  }

  Contestant(const std::string& name, const std::function<void(vtkRenderer*)>& build, int size,
    vtkRenderPass* pass)
    : Name(name)
  {
    build(this->Renderer);
    this->Light = vtkLight::SafeDownCast(this->Renderer->GetLights()->GetItemAsObject(0));
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(size, size);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->SetPass(pass);
  }

  /** In the place of the light, a spot of VTK's own. */
  void UseSpot(double coneAngle)
  {
    vtkNew<vtkLight> spot;
    spot->SetPosition(this->Light->GetPosition());
    spot->SetFocalPoint(this->Light->GetFocalPoint());
    spot->PositionalOn();
    spot->SetConeAngle(coneAngle);
    this->Renderer->RemoveAllLights();
    this->Renderer->AddLight(spot);
    this->Light = spot;
  }

  double Frame()
  {
    const auto start = std::chrono::steady_clock::now();
    this->Window->Render();
    this->Window->WaitForCompletion();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
  }

  /** A frame for which the camera moved a little, one way and back. */
  double MoveCamera(int frame)
  {
    this->Renderer->GetActiveCamera()->Azimuth(frame % 2 ? 1.0 : -1.0);
    this->Renderer->ResetCameraClippingRange();
    return this->Frame();
  }

  double MoveLight(int frame)
  {
    double position[3];
    this->Light->GetPosition(position);
    this->Light->SetPosition(position[0] + (frame % 2 ? 0.01 : -0.01), position[1], position[2]);
    return this->Frame();
  }

  std::vector<unsigned char> Picture()
  {
    vtkNew<vtkUnsignedCharArray> pixels;
    const int* size = this->Window->GetSize();
    this->Window->Render();
    this->Window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
    return { pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues() };
  }
};

inline vtkSmartPointer<vtkShadowPass> MakePass(
  const std::string& technique, const std::map<std::string, std::string>& parameters)
{
  auto pass = vtk::TakeSmartPointer(vtkShadowTechniques::Create(technique));
  for (const auto& parameter : parameters)
  {
    pass->SetParameter(parameter.first, parameter.second);
  }
  return pass;
}

inline double Median(std::vector<double> values)
{
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

#endif
