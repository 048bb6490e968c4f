#include "Bench.h"

#include "BenchMeasure.h"
#include "BenchPlan.h"
#include "BenchResults.h"
#include "Errors.h"
#include "Interruption.h"
#include "Outputs.h"
#include "Values.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>

namespace
{
struct BenchOptions
{
  SceneOptions Scene;
  std::string Suites; // separated by commas; "all"
  std::string Techniques;
  std::vector<std::string> Sweeps;
  std::string Lights;
  std::optional<double> Budget;
  std::optional<int> Frames;
  std::optional<int> ReferenceSamples;
  std::string Output;
};

//------------------------------------------------------------------------------
std::vector<double> ParseLights(const std::string& text)
{
  std::vector<double> scales;
  for (const std::string& word : Values::Split(text))
  {
    char* end = nullptr;
    const double scale = std::strtod(word.c_str(), &end);
    if (word.empty() || *end != '\0' || !std::isfinite(scale) || scale < 0.0)
    {
      throw WrongUsage("--lights: \"" + word + "\" is no size: a number, 0 or more.");
    }
    scales.push_back(scale);
  }
  return scales;
}

//------------------------------------------------------------------------------
// The user's scene in the place of a suite's: a case for each size of the light.
void UseScene(BenchPlan& plan, const BenchOptions& options, const CLI::App& command)
{
  BenchCase one = plan.Default;
  const auto size = one.Scene.Size;
  one.Scene = options.Scene;
  if (command.get_option("--size")->count() == 0)
  {
    one.Scene.Size = size;
  }
  one.Id = options.Scene.Builtin;
  for (const std::string& model : options.Scene.Models)
  {
    one.Id += (one.Id.empty() ? "" : " ") + model;
  }
  plan.Cases.clear();
  const auto scales =
    options.Lights.empty() ? std::vector<double>{ 1.0 } : ParseLights(options.Lights);
  for (std::size_t i = 0; i < scales.size(); ++i)
  {
    plan.Cases.push_back(one);
    plan.Cases.back().LightScale = scales[i];
    plan.Cases.back().Budget = one.Budget / static_cast<double>(scales.size());
    if (!options.Lights.empty())
    {
      plan.Cases.back().Id += ", light x " + Values::Split(options.Lights)[i];
    }
  }
}

//------------------------------------------------------------------------------
void Override(BenchPlan& plan, const BenchOptions& options)
{
  if (!options.Techniques.empty())
  {
    BenchPlans::Select(plan, Values::Split(options.Techniques));
  }
  BenchPlans::Sweep(plan, options.Sweeps);
  const double share = options.Budget ? *options.Budget / plan.GetBudget() : 1.0;
  for (BenchCase& one : plan.Cases)
  {
    one.Budget *= share;
    one.ReferenceSamples = options.ReferenceSamples.value_or(one.ReferenceSamples);
  }
  plan.Frames = options.Frames.value_or(plan.Frames);
  BenchPlans::Check(plan);
}

//------------------------------------------------------------------------------
// A suite has its own scenes; an option that would do nothing is refused.
void CheckSuiteOptions(const CLI::App& command)
{
  static const char* const used[] = { "--suite", "--techniques", "--sweep", "--budget", "--frames",
    "--reference-samples", "--output" };
  for (const CLI::Option* option : command.get_options())
  {
    if (option->count() > 0 && std::none_of(std::begin(used), std::end(used),
                                 [&](const char* name) { return option->check_name(name); }))
    {
      throw WrongUsage(
        option->get_name() + " has no meaning for a suite, which has its own scenes.");
    }
  }
}

//------------------------------------------------------------------------------
std::vector<BenchPlan> MakePlans(const BenchOptions& options, const CLI::App& command)
{
  std::vector<BenchPlan> plans;
  if (options.Suites.empty())
  {
    options.Scene.Check();
    plans.push_back(BenchPlans::Load("quick"));
    UseScene(plans.back(), options, command);
  }
  else
  {
    CheckSuiteOptions(command);
    const bool all = options.Suites == "all";
    for (const std::string& name : all ? BenchPlans::GetSuites() : Values::Split(options.Suites))
    {
      plans.push_back(BenchPlans::Load(name));
      if (plans.back().Cases.empty() && all)
      {
        plans.pop_back();
      }
      else if (plans.back().Cases.empty())
      {
        throw WrongUsage("suite " + name + " has no scene: give a model or --scene instead.");
      }
    }
  }
  for (BenchPlan& plan : plans)
  {
    Override(plan, options);
  }
  return plans;
}

//------------------------------------------------------------------------------
// A suite is handed over when it is done, or as far as it came.
void Run(const BenchPlan& plan, const std::string& folder, const std::string& commandLine)
{
  BenchResults results(plan, commandLine);
  {
    const Interruption interruption;
    double left = plan.GetBudget();
    double wanted = left;
    for (std::size_t i = 0; i < plan.Cases.size() && !Interruption::IsAsked(); ++i)
    {
      const BenchCase& one = plan.Cases[i];
      const auto start = std::chrono::steady_clock::now();
      BenchMeasure measure(plan, one);
      Messages::ShowWarnings();
      // What earlier cases left over is spread over the rest.
      measure.Run(left * one.Budget / wanted, plan.Name + " " + std::to_string(i + 1) + " of " +
                                                std::to_string(plan.Cases.size()) + ", " + one.Id);
      left -= std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      wanted -= one.Budget;
      results.Add(measure);
      results.PrintTable();
    }
    if (Interruption::IsAsked())
    {
      results.SetIncomplete();
    }
  }
  if (!folder.empty())
  {
    Outputs outputs;
    results.Stage(outputs, folder);
    outputs.Commit();
  }
}

//------------------------------------------------------------------------------
void Bench(const CLI::App& command, const BenchOptions& options, const std::string& commandLine)
{
  const auto plans = MakePlans(options, command);
  if (!options.Output.empty())
  {
    Outputs().PlanFolder(options.Output);
  }
  for (const BenchPlan& plan : plans)
  {
    const bool several = plans.size() > 1 && !options.Output.empty();
    Run(plan, several ? options.Output + "/" + plan.Name : options.Output, commandLine);
    if (Interruption::IsAsked())
    {
      throw Interrupted(several || !options.Output.empty()
                          ? "interrupted; what was measured is in \"" + options.Output + "\"."
                          : "interrupted.");
    }
  }
}
}

//------------------------------------------------------------------------------
void DeclareBench(CLI::App& app, const std::string& commandLine)
{
  CLI::App* command = app.add_subcommand("bench",
    "Measure what each technique at each setting costs on models or a scene, and how wrong\n"
    "it is: a table, and results.json, results.csv and report.html in the output folder");
  auto options = std::make_shared<BenchOptions>();
  options->Scene.Declare(*command);
  std::string suites;
  for (const std::string& name : BenchPlans::GetSuites())
  {
    suites += name + ", ";
  }
  command
    ->add_option("--suite", options->Suites,
      "Suites instead of a scene, separated by commas: " + suites + "files, or all")
    ->type_name("A,B,...")
    ->group("Scene");
  command
    ->add_option("--lights", options->Lights,
      "Sizes of the light to measure with, times the size that it has (default 1)")
    ->type_name("X,Y,...")
    ->group("Light");
  command
    ->add_option("--techniques", options->Techniques,
      "Which techniques; vtkShadowMapPass is VTK's own (default: all)")
    ->type_name("A,B,...")
    ->group("Technique");
  command
    ->add_option("--sweep", options->Sweeps,
      "Values of a parameter to measure with instead of the default's; may be given again.\n"
      "TECHNIQUE:NAME=... for that technique alone")
    ->type_name("NAME=V,W,...")
    ->allow_extra_args(false)
    ->group("Technique");
  command
    ->add_option("--budget", options->Budget,
      "Seconds that all of it shall take, of each suite (default 100, or the suite's)")
    ->type_name("SECONDS")
    ->check(CLI::Range(1.0, 1e6));
  command->add_option("--frames", options->Frames, "Frames that a median wants (default 15)")
    ->type_name("N")
    ->check(CLI::Range(1, 10000));
  command
    ->add_option("--reference-samples", options->ReferenceSamples,
      "Rays from each pixel of each of the two references (default 1024); 0: no errors")
    ->type_name("N")
    ->check(CLI::Range(0, 16384));
  command
    ->add_option("-o,--output", options->Output,
      "Folder for results.json, results.csv and report.html; of several suites a folder each in it")
    ->type_name("DIR");
  command->callback([command, options, commandLine] { Bench(*command, *options, commandLine); });
}
