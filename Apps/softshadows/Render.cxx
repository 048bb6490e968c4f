// SPDX-License-Identifier: BSD-3-Clause
#include "Render.h"

#include "Errors.h"
#include "Models.h"
#include "OffscreenWindow.h"
#include "Outputs.h"
#include "SceneOptions.h"
#include "StandardOutput.h"
#include "Statistics.h"
#include "Techniques.h"

#include "vtkAreaLight.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkPropCollection.h"
#include "vtkShadowScenes.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <cstdio>
#include <memory>

namespace
{
using Json = nlohmann::ordered_json;

struct RenderOptions
{
  SceneOptions Scene;
  TechniqueOptions Parameters;
  std::string Technique;
  std::string DebugView;
  std::string Picture;
  std::string Visibility;
  std::string Statistics;
  int Frames = 1;
  bool ShadowCatcher = false;
  bool Error = false;
  bool AsJson = false;
};

//------------------------------------------------------------------------------
// The technique with all that was asked of it; none for the plain picture.
vtkSmartPointer<vtkShadowPass> MakePass(const RenderOptions& options)
{
  if (options.Technique == "none")
  {
    const char* pointless = !options.Visibility.empty()            ? "--visibility"
                            : !options.DebugView.empty()           ? "--debug-view"
                            : !options.Parameters.Settings.empty() ? "--set"
                            : !options.Parameters.Quality.empty()  ? "--quality"
                            : options.ShadowCatcher                ? "--shadow-catcher"
                            : options.Error                        ? "--error"
                                                                   : nullptr;
    if (pointless)
    {
      throw WrongUsage(std::string(pointless) + " needs a technique other than none.");
    }
    return nullptr;
  }
  auto pass = options.Parameters.Create(options.Technique, true);
  options.Parameters.CheckSettings({ options.Technique });
  if (!options.DebugView.empty())
  {
    pass->SetDebugView(options.DebugView);
    Messages::Check();
  }
  return pass;
}

//------------------------------------------------------------------------------
// Of the grounds, which the scenes mark, only the shadow is to show.
void MakeCatcher(OffscreenWindow& window)
{
  bool found = false;
  vtkPropCollection* props = window.GetRenderer()->GetViewProps();
  vtkCollectionSimpleIterator iterator;
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    vtkInformation* keys = prop->GetPropertyKeys();
    if (keys && keys->Has(vtkShadowScenes::GROUND()))
    {
      vtkShadowPass::SetShadowCatcher(prop, true);
      found = true;
    }
  }
  if (!found)
  {
    throw WrongUsage("--shadow-catcher: there is no ground; put one there with --ground.");
  }
  window.MakeTransparent();
}

//------------------------------------------------------------------------------
// Milliseconds of a frame. The first one sets everything up and stands for itself if it is the only
// one asked for; else it is left out. Frames that add up count as one.
double Draw(OffscreenWindow& window, vtkShadowPass* pass, int frames)
{
  double time = window.Render();
  while (pass && !pass->IsFinished())
  {
    time += window.Render();
  }
  if (frames > 1)
  {
    std::vector<double> times(frames);
    for (double& one : times)
    {
      one = window.Render();
    }
    time = Statistics::GetMedian(times);
  }
  return time;
}

//------------------------------------------------------------------------------
void Render(const RenderOptions& options)
{
  vtkShadowPass::SetAdvice(true);
  const auto pass = JudgeUsage(
    [&options]
    {
      options.Scene.Check();
      return MakePass(options);
    });
  Outputs outputs(Models::GetFiles(options.Scene.Models));
  outputs.PlanPicture(options.Picture, options.ShadowCatcher ? 4 : 3);
  if (!options.Visibility.empty())
  {
    outputs.PlanPicture(options.Visibility, 1);
  }
  if (!options.Statistics.empty())
  {
    outputs.PlanText(options.Statistics);
  }

  OffscreenWindow window(options.Scene.Size.data(), options.Scene.SamplesPerPixel);
  SceneOptions shown = options.Scene;
  shown.ShownSamples = Techniques::GetLightSamples(pass);
  const Scene scene = shown.Build(window.GetRenderer());
  if (options.ShadowCatcher)
  {
    MakeCatcher(window);
  }
  if (pass && !pass->IsSupported(window.GetOpenWindow()))
  {
    throw Failure(options.Technique + " cannot run here: " + pass->GetUnsupportedReason() + ".");
  }
  window.GetRenderer()->SetPass(pass);
  const double time = Draw(window, pass, options.Frames);
  outputs.StagePicture(options.Picture, window.Grab());
  if (!options.Visibility.empty())
  {
    vtkImageData* visibility = pass->GetVisibility(scene.Light);
    Messages::Check();
    outputs.StagePicture(options.Visibility, visibility);
  }

  Json error;
  if (options.Error)
  {
    const std::string text = pass->GetErrorEstimate(scene.Light);
    Messages::Check();
    error = Json::parse(text);
  }

  Json statistics = { { "technique", options.Technique },
    { "parameters", pass ? Techniques::GetParameters(pass) : Json() }, { "scene", scene.GetJSON() },
    { "size", options.Scene.Size }, { "frames", options.Frames },
    { "includes_setup", options.Frames == 1 }, { "frame_milliseconds", time },
    { "picture", options.Picture } };
  statistics["pass"] = pass ? Json::parse(pass->GetStatistics()) : Json();
  statistics["camera"] = DescribeCamera(window.GetRenderer()->GetActiveCamera());
  for (std::size_t i = 1; i < scene.Lights.size(); ++i)
  {
    statistics["scene"]["further_lights"].push_back(DescribeLight(scene.Lights[i]));
  }
  if (!options.Statistics.empty())
  {
    outputs.StageText(options.Statistics, StandardOutput::GetText(statistics));
  }
  Messages::Check();
  outputs.Commit();

  Messages::ShowWarnings();
  if (options.AsJson)
  {
    StandardOutput::Print(statistics);
    return;
  }
  const std::string how = options.Frames == 1
                            ? "first frame, with set-up"
                            : "median of " + std::to_string(options.Frames) + " frames";
  std::printf("%s: %lld triangles, %dx%d, %.1f ms (%s), written to %s\n", options.Technique.c_str(),
    static_cast<long long>(scene.Triangles), options.Scene.Size[0], options.Scene.Size[1], time,
    how.c_str(), Messages::GetPrintable(options.Picture).c_str());
  for (const char* which : { "receivers", "penumbrae" })
  {
    if (options.Error)
    {
      const Json& figures = error[which];
      std::printf(
        "error of visibility, %s: RMSE %.4f (%.4f to %.4f), bias %+.4f (%+.4f to %+.4f)\n", which,
        figures["rmse"].get<double>(), figures["rmseInterval"][0].get<double>(),
        figures["rmseInterval"][1].get<double>(), figures["bias"].get<double>(),
        figures["biasInterval"][0].get<double>(), figures["biasInterval"][1].get<double>());
    }
  }
}
}

//------------------------------------------------------------------------------
void DeclareRender(CLI::App& app)
{
  CLI::App* command =
    app.add_subcommand("render", "Draw models or a built-in scene with one technique");
  auto options = std::make_shared<RenderOptions>();
  command->add_option("-o,--output", options->Picture, "The picture: png, exr, tif, bmp and others")
    ->type_name("FILE")
    ->required();
  options->Scene.Studio = true;
  options->Scene.SamplesPerPixel = 8;
  options->Scene.Declare(*command);
  command
    ->add_option("--technique", options->Technique,
      "Which technique (default map-pcss, and map-soft in the studio's light, which stands still;\n"
      "see \"softshadows list\"), or none: no shadows")
    ->type_name("NAME")
    ->group("Technique");
  options->Parameters.Declare(*command);
  command
    ->add_flag("--shadow-catcher", options->ShadowCatcher,
      "Show of the ground only the shadow on it, in a picture with alpha (png, exr, tif)")
    ->group("Picture");
  command
    ->add_option("--debug-view", options->DebugView,
      "Show visibility, penumbra, cost, or what the technique adds")
    ->type_name("VIEW")
    ->group("Technique");
  command
    ->add_option("--visibility", options->Visibility, "Write the light's visibility (exr, tif)")
    ->type_name("FILE");
  command->add_flag("--error", options->Error,
    "Estimate the error of the light's visibility, by rays from some two thousand pixels");
  command->add_option("--stats", options->Statistics, "Write the figures of the frame as JSON")
    ->type_name("FILE");
  command
    ->add_option("--frames", options->Frames,
      "Draw once (default), or give the median time of N frames after a first one")
    ->type_name("N")
    ->check(CLI::Range(1, 10000));
  command->add_flag("--json", options->AsJson, "Print the figures as JSON");
  command->callback(
    [options]
    {
      if (options->Technique.empty())
      {
        options->Technique = options->Parameters.TakeDefault(options->Scene.UsesStudio());
      }
      WithinMemory(options->Scene.Size, [options] { Render(*options); });
    });
}
