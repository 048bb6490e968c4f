// SPDX-License-Identifier: BSD-3-Clause
// A cone and a sphere over a plane, lit by an area light: soft_shadows picture.png

#include <vtkActor.h>
#include <vtkAreaLight.h>
#include <vtkCamera.h>
#include <vtkConeSource.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkShadowPass.h>
#include <vtkShadowTechniques.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>
#include <vtkWindowToImageFilter.h>

#include <cstdlib>
#include <initializer_list>
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "usage: " << argv[0] << " picture.png\n";
    return EXIT_FAILURE;
  }

  vtkNew<vtkConeSource> cone;
  cone->SetCenter(-0.7, 0.0, 0.6);
  cone->SetHeight(1.2);
  cone->SetDirection(0.0, 0.0, 1.0);
  cone->SetResolution(60);

  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(0.7, 0.0, 0.9);
  sphere->SetThetaResolution(60);
  sphere->SetPhiResolution(60);

  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-4.0, -4.0, 0.0);
  plane->SetPoint1(4.0, -4.0, 0.0);
  plane->SetPoint2(-4.0, 4.0, 0.0);

  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.85, 0.87, 0.90);
  for (vtkPolyDataAlgorithm* source :
    std::initializer_list<vtkPolyDataAlgorithm*>{ cone, sphere, plane })
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    renderer->AddActor(actor);
  }

  vtkNew<vtkAreaLight> light;
  light->SetPosition(-4.0, -2.0, 5.0);
  light->SetRadius(0.5);
  light->SetShadowAttenuation(0.8f); // not quite black
  renderer->AddLight(light);

  auto shadows = vtkSmartPointer<vtkShadowPass>::Take(vtkShadowTechniques::Create("map-pcss"));
  renderer->SetPass(shadows);

  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.0, -7.0, 5.0);
  camera->SetFocalPoint(0.0, 0.0, 0.5);
  camera->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange();

  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetSize(600, 400);
  window->AddRenderer(renderer);
  window->Render();

  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  writer->SetFileName(argv[1]);
  writer->Write();
  return writer->GetErrorCode() == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
