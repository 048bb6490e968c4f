// SPDX-License-Identifier: BSD-3-Clause
// A whole technique in one file, to copy: the shadows of the balls around what casts. technique picture.png

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>
#include <vtkShadowCasters.h>
#include <vtkShadowDeclaration.h>
#include <vtkShadowFrame.h>
#include <vtkShadowPass.h>
#include <vtkShadowStudio.h>
#include <vtkShadowTechnique.h>
#include <vtkSphereSource.h>
#include <vtkWindowToImageFilter.h>

#include <glm/vec4.hpp>

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

namespace
{
constexpr int Most = 16;

class BallTechnique : public vtkShadowTechnique
{
public:
  using vtkShadowTechnique::
    vtkShadowTechnique; // with the settings: this->Settings.GetReal("swelling")

  // Light data: here but a list of balls. Others keep theirs, and let vtkShadowChanges tell what changed.
  bool UpdateLightData(vtkShadowFrame& frame) override
  {
    this->BallsVC.clear();
    const glm::dmat4 SWCToVC = frame.GetSWCToVC();
    for (const auto& caster : frame.Casters->Get())
    {
      if (this->BallsVC.size() < Most)
      {
        const glm::dvec4 middleVC = SWCToVC * glm::dvec4(caster.GetMiddle(), 1.0);
        this->BallsVC.emplace_back(
          glm::vec3(middleVC), caster.GetRadius() * this->Settings.GetReal("swelling"));
      }
    }
    frame.Counts["balls"] = static_cast<double>(this->BallsVC.size());
    return true;
  }

  // One function, run in each prop's shader or once a pixel. It can use what vtkShadowLightsFS.glsl
  // declares; in a module it lies in a file of its own, glsl/*.glsl.
  std::string GetVisibilityGLSL() override
  {
    return R"(
uniform vec4 exampleBallsVC[16]; // middle, radius
uniform int exampleBallCount;

SHADOW_VISIBILITY shadowVisibility(int light, vec3 positionVC, vec3 normalVC)
{
  vec4 placeVC = shadowLightPlaceVC[light];
  vec3 toLightVC = placeVC.xyz - placeVC.w * positionVC;
  float distanceToLight = length(toLightVC);
  float visibility = 1.0;
  for (int i = 0; i < exampleBallCount; ++i)
  {
    vec3 toBallVC = exampleBallsVC[i].xyz - positionVC;
    float radius = exampleBallsVC[i].w;
    float along = dot(toBallVC, toLightVC) / distanceToLight;
    if (along > 0.0 && length(toBallVC) > radius) // it is not the receiver's own
    {
      float miss = length(toBallVC - along * toLightVC / distanceToLight);
      float penumbra = max(length(shadowLightUVC[light].xyz) * along / distanceToLight, 1e-3 * radius);
      visibility = min(visibility, smoothstep(radius - penumbra, radius + penumbra, miss));
    }
  }
  shadowCost += float(exampleBallCount); // for the debug view "cost"
  return SHADOW_VISIBILITY(visibility);
}
)";
  }
  void SetVisibilityParameters(vtkShaderProgram* program) override
  {
    program->SetUniformi("exampleBallCount", static_cast<int>(this->BallsVC.size()));
    program->SetUniform4fv("exampleBallsVC", static_cast<int>(this->BallsVC.size()),
      reinterpret_cast<const float(*)[4]>(this->BallsVC.data()));
  }
  double GetMaximumCost() override { return Most; }
  void Release(vtkOpenGLRenderWindow*) override { this->BallsVC.clear(); } // nothing on the GPU

private:
  std::vector<glm::vec4> BallsVC;
};

vtkShadowDeclaration Balls()
{
  vtkShadowDeclaration t;
  t.Name = "balls";
  t.Title = "Shadows of balls";
  t.SetClasses<BallTechnique, vtkShadowPass>("vtkShadowPass"); // it needs no pass of its own
  t.Traits.Forward = true;                                     // its GLSL can run in props' shaders
  t.Traits.CameraDependent = true; // its light data is in view coordinates
  t.LightShapes.fill(vtkShadowShapeSupport::Approximate);
  t.Parameters = { vtkShadowParameter::Real(
    "swelling", 0.8, 0.1, 2.0, "Radius of a ball, as a share of its caster's") };
  t.Limits = {
    "A caster casts as a ball, and none on itself; those after the sixteenth do not cast."
  };
  return t;
}

// While the program is loaded. The pass, Python, the command and the documentation read it.
const vtkShadowTechniqueRegistration registration(Balls());
}

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "usage: " << argv[0] << " picture.png\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.9, 0.9, 0.9);
  for (int i = 0; i < 3; ++i)
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetCenter(1.3 * i, 0.0, 0.5 + 0.3 * i);
    ball->SetThetaResolution(48);
    ball->SetPhiResolution(48);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(ball->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    renderer->AddActor(actor);
  }
  vtkNew<vtkShadowStudio> studio;
  studio->SetUpVector(0.0, 0.0, 1.0);
  studio->PutOn(renderer);
  vtkNew<vtkShadowPass> shadows;
  if (!shadows->SetTechnique("balls"))
  {
    return EXIT_FAILURE;
  }
  shadows->PutOn(renderer);

  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(true);
  window->SetSize(600, 400);
  window->AddRenderer(renderer);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(1.0, -6.0, 4.0);
  camera->SetFocalPoint(1.3, 0.0, 0.5);
  camera->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange();
  window->Render();

  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(picture->GetOutputPort());
  writer->SetFileName(argv[1]);
  writer->Write();

  // Something is in shadow.
  vtkImageData* visibility = shadows->GetVisibility(0);
  double range[2] = { 1.0, 1.0 };
  if (visibility)
  {
    visibility->GetPointData()->GetArray("Visibility")->GetRange(range);
  }
  return range[0] < 0.1 ? EXIT_SUCCESS : EXIT_FAILURE;
}
