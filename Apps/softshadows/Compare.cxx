// SPDX-License-Identifier: BSD-3-Clause
#include "Compare.h"

#include "Errors.h"
#include "Values.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <algorithm>
#include <memory>

namespace
{
//------------------------------------------------------------------------------
void Compare(const CLI::App& command, const CompareOptions& options)
{
  const auto& paths = options.Scene.Models;
  const auto pictures = std::count_if(paths.begin(), paths.end(), IsPicture);
  if (pictures == 0)
  {
    WithinMemory(options.Scene.Size, [&options] { CompareTechniques(options); });
    return;
  }
  if (pictures != 2 || paths.size() != 2)
  {
    throw WrongUsage("pictures are compared two at a time: a picture, and the one it should be.");
  }
  // They need none of what a scene needs.
  Values::RefuseOthers(command, { "MODEL", "--output", "--json" }, "two pictures.");
  ComparePictures(options);
}
}

//------------------------------------------------------------------------------
void DeclareCompare(CLI::App& app)
{
  CLI::App* command = app.add_subcommand("compare",
    "Measure the techniques on models or a scene against the ray-traced reference,\n"
    "or a picture against another: softshadows compare PICTURE REFERENCE");
  auto options = std::make_shared<CompareOptions>();
  options->Scene.Declare(*command);
  command->add_option("--techniques", options->Techniques, "Which techniques (default: all)")
    ->type_name("A,B,...")
    ->group("Technique");
  options->Parameters.Declare(*command);
  command
    ->add_option("--reference-samples", options->ReferenceSamples,
      "Rays from each pixel of the reference to the light (default 1024)")
    ->type_name("N")
    ->check(CLI::Range(1, 16384));
  command
    ->add_option("--frames", options->Frames, "Frames that a time is the median of (default 5)")
    ->type_name("N")
    ->check(CLI::Range(1, 10000));
  command
    ->add_option("-o,--output", options->Output,
      "Folder for each technique's picture and its difference; of two\n"
      "pictures, the file for their difference")
    ->type_name("PATH");
  command->add_flag("--json", options->AsJson, "Print JSON");
  command->callback([command, options] { Compare(*command, *options); });
}
