// SPDX-License-Identifier: BSD-3-Clause
#include "View.h"

#include "Errors.h"
#include "ViewKeys.h"
#include "Viewer.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <memory>

namespace
{
void View(const ViewOptions& options)
{
  vtkShadowPass::SetAdvice(true);
  const auto viewer = JudgeUsage(
    [&options]
    {
      options.Scene.Check();
      return std::make_unique<Viewer>(options);
    });
  viewer->Run();
}
}

//------------------------------------------------------------------------------
void DeclareView(CLI::App& app)
{
  CLI::App* command =
    app.add_subcommand("view", "Look at models or a built-in scene in a window, and play with it");
  auto options = std::make_shared<ViewOptions>();
  options->Scene.Studio = true;
  options->Scene.SamplesPerPixel = 8;
  options->Scene.Declare(*command);
  command
    ->add_option("--technique", options->Technique,
      "Which technique to begin with (default as of render), or none: no shadows")
    ->type_name("NAME")
    ->group("Technique");
  options->Parameters.Declare(*command);
  command->add_option("--debug-view", options->DebugView, "Which debug view to begin with")
    ->type_name("VIEW")
    ->group("Technique");
  command
    ->add_option("--least-rate", options->LeastRate,
      "Frames a second below which quality falls while the mouse drags (default 15; 0: never)")
    ->type_name("X")
    ->check(CLI::Range(0.0, 1e9))
    ->group("Window");
  command->add_option("--record", options->Record, "Write what the user does to a file")
    ->type_name("FILE")
    ->group("Window");
  command->add_option("--play", options->Play, "Do what was recorded in a file, then end")
    ->type_name("FILE")
    ->group("Window");
  command->add_option("--screenshot", options->Screenshot, "Write the window's picture at the end")
    ->type_name("FILE")
    ->group("Window");
  command->footer("Keys and mouse:\n\n" + ViewKeys::GetHelp());
  command->callback(
    [options]
    {
      if (options->Technique.empty())
      {
        options->Technique = options->Parameters.TakeDefault(options->Scene.UsesStudio());
      }
      WithinMemory(options->Scene.Size, [options] { View(*options); });
    });
}
