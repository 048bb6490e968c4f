// SPDX-License-Identifier: BSD-3-Clause
#include "SceneOptions.h"

#include "Errors.h"
#include "Meshes.h"
#include "Models.h"
#include "Turntable.h"
#include "Values.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkAreaLightActor.h"
#include "vtkBoundingBox.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkShadowPass.h"
#include "vtkShadowScenes.h"
#include "vtkShadowStudio.h"
#include "vtkShadowTags.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <algorithm>
#include <cmath>

namespace
{
vtkIdType CountTriangles(vtkRenderer* renderer)
{
  vtkIdType count = 0;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    vtkShadowTags::ForEachPart(prop,
      [&count](vtkProp* part, vtkMatrix4x4*)
      {
        auto* actor = vtkActor::SafeDownCast(part);
        vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
        if (mapper)
        {
          mapper->Update();
          auto* surface = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
          count += surface ? Meshes::CountTriangles(surface) : 0;
        }
      });
  }
  return count;
}

// Failure for an unknown scene, or a number of triangles that it cannot have; 0 is its default.
void CheckTriangles(const std::string& scene, int triangles)
{
  const std::string text = vtkShadowScenes::Describe(scene);
  Messages::Check();
  if (triangles == 0)
  {
    return;
  }
  const nlohmann::json description = nlohmann::json::parse(text);
  for (const auto& parameter : description["parameters"])
  {
    if (parameter["name"] == "triangles")
    {
      const int least = parameter["min"];
      const int most = parameter["max"];
      if (triangles < least || triangles > most)
      {
        throw Failure("--triangles of scene " + scene + " is from " + std::to_string(least) +
                      " to " + std::to_string(most) + ", not " + std::to_string(triangles) + ".");
      }
      return;
    }
  }
  throw Failure("scene " + scene + " cannot be told its number of triangles.");
}

vtkAreaLight* FindLight(vtkRenderer* renderer)
{
  vtkLightCollection* lights = renderer->GetLights();
  vtkCollectionSimpleIterator iterator;
  lights->InitTraversal(iterator);
  while (vtkLight* light = lights->GetNextLight(iterator))
  {
    if (auto* area = vtkAreaLight::SafeDownCast(light))
    {
      return area;
    }
  }
  return nullptr;
}
}

//------------------------------------------------------------------------------
void PlaceBeside(vtkAreaLight* light, vtkRenderer* renderer)
{
  const vtkBoundingBox bounds(renderer->ComputeVisiblePropBounds());
  double middle[3];
  double way[3];
  bounds.GetCenter(middle);
  vtkMath::Subtract(light->GetPosition(), light->GetFocalPoint(), way);
  vtkMath::Normalize(way);
  vtkMath::MultiplyScalar(way, bounds.GetDiagonalLength());
  light->SetFocalPoint(middle);
  light->SetPosition(middle[0] + way[0], middle[1] + way[1], middle[2] + way[2]);
}

//------------------------------------------------------------------------------
nlohmann::ordered_json Scene::GetJSON() const
{
  return { { "name", this->Name }, { "triangles", this->Triangles },
    { "light", DescribeLight(this->Light) } };
}

//------------------------------------------------------------------------------
void SceneOptions::Declare(CLI::App& command)
{
  command
    .add_option("MODEL", this->Models, "Polygon files, drawn together: " + Models::GetExtensions())
    ->type_name("");
  command
    .add_option(
      "--scene", this->Builtin, "A built-in scene instead of models (see \"softshadows list\")")
    ->type_name("NAME")
    ->group("Scene");
  command
    .add_option("--triangles", this->Triangles, "How many triangles the scene \"plant\" shall have")
    ->type_name("N")
    ->group("Scene");
  command.add_flag("--ground", this->Ground, "Put a ground under what is drawn")->group("Scene");
  command
    .add_option(
      "--up", this->Up, "Axis that points up: x, y or z (default y for models, z for scenes)")
    ->type_name("AXIS")
    ->group("Scene");
  command
    .add_option("--turn", this->Turn,
      "Degrees to turn what stands on the ground about the axis that points up")
    ->type_name("X")
    ->group("Scene");
  this->Camera.Declare(command);
  this->Light.Declare(command);
  LightOptions::DeclareMany(command, this->Lights);
  command
    .add_flag("--show-lights", this->ShowLights,
      "Draw each light as its shape, with the samples that techniques take of it")
    ->group("Light");
  if (this->Studio)
  {
    Values::AddTriple(command, "--studio-key", this->StudioKey, "X,Y,Z",
      "The way to the studio's key light (default: high on the left of the camera that\n"
      "shows all)")
      ->group("Light");
    Values::AddNumber(command, "--studio-softness", this->StudioSoftness, { 0.0, 3.0 },
      "Its size as a share of the scene (default a third)")
      ->type_name("X")
      ->group("Light");
  }
  Values::AddSize(command, "--size", this->Size,
    "Width and height of the picture (default " + std::to_string(this->Size[0]) + "x" +
      std::to_string(this->Size[1]) + ")")
    ->group("Picture");
  Values::AddTriple(command, "--background", this->Background, "R,G,B", "Background, each 0 to 1")
    ->group("Picture");
  command
    .add_option("--samples-per-pixel", this->SamplesPerPixel,
      "Smooth edges: 0 to 8 (default " + std::to_string(this->SamplesPerPixel) + ")")
    ->type_name("N")
    ->group("Picture");
}

//------------------------------------------------------------------------------
void SceneOptions::Check() const
{
  if (this->Models.empty() == this->Builtin.empty())
  {
    throw WrongUsage(this->Models.empty() ? "nothing to draw: give model files, or --scene NAME."
                                          : "model files and --scene exclude each other.");
  }
  if (!this->Builtin.empty())
  {
    CheckTriangles(this->Builtin, this->Triangles);
  }
  else if (this->Triangles != 0)
  {
    throw WrongUsage("--triangles goes with --scene plant.");
  }
  if (!this->Up.empty() && this->Up != "x" && this->Up != "y" && this->Up != "z")
  {
    throw Failure("unknown axis '" + this->Up + "' for --up. Known: x, y, z.");
  }
  if (!std::isfinite(this->Turn))
  {
    throw Failure("--turn takes a finite number of degrees.");
  }
  if (this->Background && std::any_of(this->Background->begin(), this->Background->end(),
                            [](double value) { return value < 0.0 || value > 1.0; }))
  {
    throw Failure("--background takes three numbers from 0 to 1.");
  }
  if (this->SamplesPerPixel < 0 || this->SamplesPerPixel > 8)
  {
    throw Failure(
      "--samples-per-pixel is from 0 to 8, not " + std::to_string(this->SamplesPerPixel) + ".");
  }
  constexpr int largest = 16384;
  for (const int side : this->Size)
  {
    if (side < 1 || side > largest)
    {
      throw Failure("--size " + std::to_string(this->Size[0]) + "x" +
                    std::to_string(this->Size[1]) + ": a side is from 1 to " +
                    std::to_string(largest) + " pixels.");
    }
  }
  this->Light.Check();
  if (!this->Lights.empty() && this->Light.IsAny())
  {
    throw WrongUsage("--light and --light-... exclude each other: say all of a light in --light.");
  }
  for (const LightOptions& light : this->Lights)
  {
    light.Check();
  }
  if ((this->StudioKey || this->StudioSoftness) && !this->UsesStudio())
  {
    throw WrongUsage("--studio-key and --studio-softness go with models that no option of a light "
                     "is given for.");
  }
}

//------------------------------------------------------------------------------
bool SceneOptions::UsesStudio() const
{
  return this->Studio && this->Builtin.empty() && !this->Light.IsAny() && this->Lights.empty();
}

//------------------------------------------------------------------------------
int SceneOptions::GetUpAxis() const
{
  const std::string axis = !this->Up.empty() ? this->Up : (this->Builtin.empty() ? "y" : "z");
  return axis[0] - 'x';
}

//------------------------------------------------------------------------------
void SceneOptions::PlaceLights(vtkRenderer* renderer, std::vector<vtkAreaLight*>& lights) const
{
  for (std::size_t i = 1; i < this->Lights.size(); ++i)
  {
    vtkNew<vtkAreaLight> light;
    light->DeepCopy(lights.front());
    renderer->AddLight(light);
    lights.push_back(light);
  }
  for (std::size_t i = 0; i < lights.size(); ++i)
  {
    (this->Lights.empty() ? this->Light : this->Lights[i]).Apply(lights[i]);
  }
}

//------------------------------------------------------------------------------
Scene SceneOptions::Build(vtkRenderer* renderer) const
{
  Scene scene;
  const int up = this->GetUpAxis();
  const bool studio = this->UsesStudio();
  const auto tell = [this](const std::string& what, std::size_t number, std::size_t count)
  {
    if (this->Progress)
    {
      this->Progress(what, number, count);
    }
  };
  if (!this->Builtin.empty())
  {
    scene.Name = this->Builtin;
    tell(this->Builtin, 1, 1);
    vtkShadowScenes::Build(this->Builtin, renderer, this->Triangles);
    Messages::Check();
    if (!vtkShadowScenes::GetModelNote().empty())
    {
      Messages::Note(vtkShadowScenes::GetModelNote());
    }
  }
  else
  {
    std::size_t number = 0;
    for (const std::string& path : this->Models)
    {
      tell(path, ++number, this->Models.size());
      for (const auto& actor : Models::Read(path))
      {
        renderer->AddActor(actor);
      }
      scene.Name += (scene.Name.empty() ? "" : " ") + path;
    }
    renderer->AutomaticLightCreationOff();
    renderer->SetBackground(0.87, 0.88, 0.90);
    if (studio)
    {
      vtkShadowScenes::ResetCameraWithShadow(renderer, up);
      vtkNew<vtkShadowStudio> light;
      light->SetUpVector(up == 0, up == 1, up == 2);
      light->SetGround(this->Ground ? vtkShadowStudio::None : vtkShadowStudio::Catcher);
      light->SetSoftness(this->StudioSoftness.value_or(light->GetSoftness()));
      light->PutOn(renderer);
      light->AimNow(); // by the camera that shows all
      scene.Light = light->GetKeyLight();
      if (this->StudioKey)
      {
        scene.Light->SetPosition(this->StudioKey->data());
      }
    }
    else
    {
      vtkShadowScenes::AddLight(renderer, up);
      vtkShadowScenes::ResetCamera(renderer, up);
    }
  }
  if (this->Ground)
  {
    vtkShadowScenes::AddGround(renderer, up);
  }
  Messages::Check();
  scene.Light = scene.Light ? scene.Light : FindLight(renderer);
  if (!scene.Light)
  {
    throw Failure("scene '" + scene.Name + "' has no light.");
  }
  scene.Lights = { scene.Light };
  if (!studio)
  {
    this->PlaceLights(renderer, scene.Lights);
  }
  this->Camera.Apply(renderer->GetActiveCamera());
  if (this->Background)
  {
    renderer->GradientBackgroundOff();
    renderer->SetBackground(this->Background->data());
  }
  scene.Triangles = CountTriangles(renderer);
  if (this->Turn != 0.0)
  {
    Turntable(renderer, up).SetAngle(this->Turn);
  }
  if (this->ShowLights)
  {
    for (vtkAreaLight* light : scene.Lights)
    {
      if (studio)
      {
        PlaceBeside(light, renderer);
      }
      vtkNew<vtkAreaLightActor> shown;
      shown->SetLight(light);
      shown->SetSamples(this->ShownSamples);
      renderer->AddViewProp(shown);
    }
  }
  renderer->ResetCameraClippingRange();
  return scene;
}
