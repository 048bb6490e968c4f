// SPDX-License-Identifier: BSD-3-Clause
// What a pass costs where there is little to do: many actors under a light that stays, and no light
// that casts.
//
//   softshadowsPassBenchmark [size=700 [frames=41]]
//
// Medians of interleaved frames for which the camera moves, each ended by glFinish.

#include "Contestant.h"

#include "vtkActor.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShadowTechniques.h"
#include "vtkSphereSource.h"

#include <cstdio>
#include <cstdlib>
#include <memory>

namespace
{
/** 200 balls, each an actor and a mapper, over a floor. */
void BuildActors(vtkRenderer* renderer)
{
  const auto add = [renderer](vtkAlgorithm* source)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    renderer->AddActor(actor);
    return actor.Get();
  };
  for (int i = 0; i < 200; ++i)
  {
    vtkNew<vtkSphereSource> ball;
    ball->SetRadius(0.3);
    ball->SetThetaResolution(16);
    ball->SetPhiResolution(12);
    vtkActor* actor = add(ball);
    actor->SetPosition(i % 20 - 9.5, i / 20 - 4.5, 0.5 + 0.1 * (i % 7));
    actor->GetProperty()->SetColor(
      0.3 + 0.035 * (i % 20), 0.6, 0.9 - 0.06 * static_cast<int>(i / 20));
  }
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-12.0, -8.0, 0.0);
  floor->SetPoint1(12.0, -8.0, 0.0);
  floor->SetPoint2(-12.0, 8.0, 0.0);
  add(floor);
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->PositionalOn();
  light->SetConeAngle(40.0);
  light->SetPosition(-6.0, -8.0, 20.0);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  renderer->AutomaticLightCreationOff();
  renderer->AddLight(light);
  renderer->GetActiveCamera()->SetPosition(5.0, -18.0, 12.0);
  renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 0.0);
  renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange();
}

void Measure(const std::vector<std::unique_ptr<Contestant>>& contestants, int frames)
{
  for (int i = -4; i < frames; ++i)
  {
    for (const auto& contestant : contestants)
    {
      const double milliseconds = contestant->MoveCamera(i);
      if (i >= 0)
      {
        contestant->Camera.push_back(milliseconds);
      }
    }
  }
}

void RunActors(int size, int frames)
{
  const auto vtkPass = MakeVTKShadowPass(1024);
  const auto ourPass = MakePass("map-hard", { { "resolution", "1024" } });
  std::vector<std::unique_ptr<Contestant>> all;
  all.push_back(std::make_unique<Contestant>("no shadows", BuildActors, size, nullptr));
  all.push_back(std::make_unique<Contestant>("vtkShadowMapPass", BuildActors, size, vtkPass));
  all.push_back(std::make_unique<Contestant>("map-hard", BuildActors, size, ourPass));
  Measure(all, frames);
  const double base = Median(all[0]->Camera);
  std::printf("201 actors, %d x %d, map 1024, still light, moving camera\n", size, size);
  for (const auto& contestant : all)
  {
    std::printf("  %-18s %7.2f ms, added %6.2f\n", contestant->Name.c_str(),
      Median(contestant->Camera), Median(contestant->Camera) - base);
  }
  std::printf("  map-hard adds %.2f of VTK's\n",
    (Median(all[2]->Camera) - base) / (Median(all[1]->Camera) - base));
}

void RunWithoutLight(
  const char* name, const std::function<void(vtkRenderer*)>& build, int size, int frames)
{
  std::vector<std::unique_ptr<Contestant>> all;
  std::vector<vtkSmartPointer<vtkShadowPass>> passes;
  all.push_back(std::make_unique<Contestant>("no pass", build, size, nullptr));
  for (int i = 0; i < vtkShadowTechniques::GetNumberOfTechniques(); ++i)
  {
    const std::string technique = vtkShadowTechniques::GetName(i);
    passes.push_back(MakePass(technique, {}));
    all.push_back(std::make_unique<Contestant>(technique, build, size, passes.back()));
  }
  for (auto& contestant : all)
  {
    vtkShadowPass::SetLightCasting(contestant->Light, false);
  }
  Measure(all, frames);
  const double base = Median(all[0]->Camera);
  std::printf(
    "%s, %d x %d, no light that casts: frame without a pass %.2f ms\n", name, size, size, base);
  for (std::size_t i = 1; i < all.size(); ++i)
  {
    std::printf("  %-18s %7.2f ms, %+.1f %%\n", all[i]->Name.c_str(), Median(all[i]->Camera),
      100.0 * (Median(all[i]->Camera) / base - 1.0));
  }
}
}

int main(int argc, char* argv[])
{
  const int size = argc > 1 ? std::atoi(argv[1]) : 700;
  const int frames = argc > 2 ? std::atoi(argv[2]) : 41;
  if (size < 16 || frames < 3)
  {
    std::fprintf(stderr, "usage: softshadowsPassBenchmark [size >= 16 [frames >= 3]]\n");
    return 2;
  }
  RunActors(size, frames);
  RunWithoutLight("201 actors", BuildActors, size, frames);
  RunWithoutLight(
    "basic", [](vtkRenderer* renderer) { vtkShadowScenes::Build("basic", renderer); }, size,
    frames);
  return 0;
}
