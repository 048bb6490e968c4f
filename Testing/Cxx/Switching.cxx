// SPDX-License-Identifier: BSD-3-Clause
// A pass can change from any technique to any other.

#include "ShadowStage.h"
#include "ShadowTest.h"

#include "vtkShadowPass.h"
#include "vtkShadowTechniques.h"

#include <string>
#include <utility>
#include <vector>

using ShadowTest::Message;

//------------------------------------------------------------------------------
// One pass through all techniques, in a window that runs: what a new one shows, with nothing gathered
// anew, and nothing kept of the others.
SHADOW_TEST(Switching, AllTechniques, Once)
{
  ShadowStage stage;
  stage.AddThings();
  stage.AddLight(LightKind::Sphere);
  const auto pass = vtkSmartPointer<vtkShadowPass>::New();
  stage.Pass = pass;
  stage.Renderer->SetPass(pass);
  stage.Render();
  std::vector<std::string> names;
  for (int i = 0; i < vtkShadowTechniques::GetNumberOfTechniques(); ++i)
  {
    const std::string name = vtkShadowTechniques::GetName(i);
    if (name.find("test-") != 0 && name.find("probe") == std::string::npos)
    {
      names.push_back(name);
    }
  }
  const auto set = [](vtkShadowPass* target, const std::string& name)
  {
    ShadowTest::Check(target->SetTechnique(name), name + " was not taken");
    for (const auto& value : { std::pair("samples", "8"), { "resolution", "256" } })
    {
      if (ShadowStage::HasParameter(name, value.first))
      {
        target->SetParameter(value.first, value.second);
      }
    }
  };
  for (int round = 0; round < 2; ++round)
  {
    for (const auto& name : names)
    {
      set(pass, name);
      stage.Render();
      ShadowTest::CheckEqual(stage.Count("castersRebuilt"), 0.0, name + ": casters gathered anew");
      const Visibility visibility = stage.GetVisibility();
      const std::size_t bytes = stage.GetBytes();
      const int objects = stage.CountGLObjects();
      ShadowTest::CheckNoMessage(name);
      if (round == 1)
      {
        continue;
      }
      ShadowStage alone;
      alone.AddThings();
      alone.AddLight(LightKind::Sphere);
      alone.Pass = vtkSmartPointer<vtkShadowPass>::New();
      set(alone.Pass, name);
      alone.Renderer->SetPass(alone.Pass);
      alone.Render();
      ShadowTest::Check(Same(visibility, alone.GetVisibility()), name + ": another V than alone");
      ShadowTest::CheckEqual(static_cast<double>(bytes), static_cast<double>(alone.GetBytes()),
        name + ": bytes on the GPU, and alone");
      ShadowTest::CheckAtMost(objects, alone.CountGLObjects(), name + ": GL objects, and alone");
    }
  }
  ShadowTest::Check(!pass->SetTechnique("map-nothing"), "an unknown technique was taken");
  ShadowTest::CheckOneMessage(Message::Error, { "map-nothing", names.front() }, "an unknown one");
  ShadowTest::Check(pass->GetTechnique() == names.back(), "the technique is no more what it was");
}
