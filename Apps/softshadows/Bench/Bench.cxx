// SPDX-License-Identifier: BSD-3-Clause
#include "Bench.h"

#include "BenchMeasure.h"
#include "BenchPlan.h"
#include "BenchResults.h"
#include "Errors.h"
#include "ExtremeMeasure.h"
#include "ExtremeResults.h"
#include "Interruption.h"
#include "Models.h"
#include "Outputs.h"
#include "Values.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>

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
  std::string Cases;
  bool Quick = false;
  std::string Output;
};

//------------------------------------------------------------------------------
std::vector<double> ParseLights(const std::string& text)
{
  std::vector<double> scales;
  for (const std::string& word : Values::Split(text))
  {
    double scale = 0.0;
    if (!Values::ParseNumber(word, scale) || scale < 0.0)
    {
      throw WrongUsage("--lights: \"" + word + "\" is no size: a number, 0 or more.");
    }
    if (std::find(scales.begin(), scales.end(), scale) != scales.end())
    {
      throw WrongUsage("--lights: " + word + " is given twice.");
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
  plan.CasesFromSuite = false;
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
// What each suite takes by itself, for the help.
std::string GetBudgets()
{
  std::string text = "Seconds that suites take: ";
  for (const std::string& name : BenchPlans::GetSuites())
  {
    const BenchPlan plan = BenchPlans::Load(name);
    const double seconds =
      plan.Cases.empty() && plan.Extremes.empty() ? BenchCase().Budget : plan.GetBudget();
    text += name + " " + std::to_string(static_cast<int>(std::lround(seconds))) + ", ";
  }
  return text.substr(0, text.size() - 2) + ".";
}

//------------------------------------------------------------------------------
// Said before it begins: a budget that is a fraction of what the suite takes leaves entries out.
void CheckBudget(const BenchPlan& plan, double given)
{
  if (given < 0.5 * plan.GetBudget())
  {
    Messages::Note("--budget " + std::to_string(static_cast<int>(given)) + " holds " +
                   std::to_string(static_cast<int>(100.0 * given / plan.GetBudget())) +
                   " % of what suite " + plan.Name + " takes, " +
                   std::to_string(static_cast<int>(std::lround(plan.GetBudget()))) +
                   " seconds: medians will be of fewer frames, and entries may be missing.");
  }
}

//------------------------------------------------------------------------------
void SelectCases(BenchPlan& plan, const std::vector<std::string>& names)
{
  if (!plan.Extremes.empty())
  {
    ExtremePlans::Select(plan.Extremes, names);
    return;
  }
  std::vector<BenchCase> selected;
  for (const std::string& name : names)
  {
    const auto found = std::find_if(plan.Cases.begin(), plan.Cases.end(),
      [&name](const BenchCase& one) { return one.Id == name; });
    if (found == plan.Cases.end())
    {
      throw WrongUsage("--cases: suite " + plan.Name + " has no case \"" + name + "\".");
    }
    selected.push_back(*found);
  }
  plan.Cases = selected;
}

//------------------------------------------------------------------------------
void Override(BenchPlan& plan, const BenchOptions& options)
{
  if (!options.Techniques.empty())
  {
    BenchPlans::Select(plan, Values::Split(options.Techniques));
  }
  BenchPlans::Sweep(plan, options.Sweeps);
  if (options.Budget)
  {
    CheckBudget(plan, *options.Budget);
  }
  if (options.Quick)
  {
    ExtremePlans::KeepQuick(plan.Extremes);
  }
  if (!options.Cases.empty())
  {
    SelectCases(plan, Values::Split(options.Cases));
  }
  plan.Default.ReferenceSamples = options.ReferenceSamples.value_or(plan.Default.ReferenceSamples);
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
std::vector<BenchPlan> MakePlans(const BenchOptions& options, const CLI::App& command)
{
  std::vector<BenchPlan> plans;
  const bool all = options.Suites == "all";
  const bool own = !options.Scene.Models.empty() || !options.Scene.Builtin.empty();
  for (const std::string& name : options.Suites.empty() ? std::vector<std::string>{ "quick" }
                                 : all                  ? BenchPlans::GetSuites()
                                                        : Values::Split(options.Suites))
  {
    BenchPlan plan = BenchPlans::Load(name);
    const bool needsScene = plan.Cases.empty() && plan.Extremes.empty();
    if (needsScene && all)
    {
      continue; // there is none to measure it with
    }
    if (needsScene && !own && !options.Suites.empty())
    {
      throw WrongUsage("suite " + name + " has no scene of its own: give a model or --scene, too.");
    }
    if (needsScene)
    {
      JudgeUsage([&options] { options.Scene.Check(); });
      UseScene(plan, options, command);
    }
    else
    {
      Values::RefuseOthers(command,
        { "--suite", "--techniques", "--sweep", "--budget", "--frames", "--reference-samples",
          "--cases", "--quick", "--output" },
        "a suite, which has its own scenes.");
    }
    plans.push_back(plan);
  }
  std::set<std::string> names;
  for (BenchPlan& plan : plans)
  {
    if (!names.insert(plan.Name).second)
    {
      throw WrongUsage("--suite: two suites are named " + plan.Name + ".");
    }
    JudgeUsage([&] { Override(plan, options); });
  }
  return plans;
}

//------------------------------------------------------------------------------
// Measure a case. What keeps it from being measured is noted: the others are worth having all the same.
void Measure(
  BenchResults& results, const BenchPlan& plan, std::size_t i, double seconds, double later)
{
  const BenchCase& one = plan.Cases[i];
  try
  {
    WithinMemory(one.Scene.Size,
      [&]
      {
        BenchMeasure measure(plan, one);
        Messages::ShowWarnings();
        measure.Run(seconds, later,
          plan.Name + " " + std::to_string(i + 1) + " of " + std::to_string(plan.Cases.size()) +
            ", " + one.Id);
        results.Add(measure);
        results.PrintTable();
      });
  }
  catch (const Failure& failure)
  {
    results.AddFailure(one.Id, failure.what());
  }
  catch (const WrongUsage& wrong)
  {
    if (!plan.CasesFromSuite)
    {
      throw;
    }
    results.AddFailure(one.Id, wrong.what());
  }
  Messages::TakeError(); // what else was said of this case is none of the next one's
}

//------------------------------------------------------------------------------
void Write(const std::string& folder, const std::vector<std::string>& inputs,
  const std::vector<std::pair<std::string, std::string>>& files)
{
  if (folder.empty())
  {
    return;
  }
  Outputs outputs(inputs);
  for (const auto& file : files)
  {
    outputs.StageText(folder + "/" + file.first, file.second);
  }
  outputs.Commit();
}

//------------------------------------------------------------------------------
// The same for a suite that sweeps cases to their limits: what does not hold is a failure, too.
std::string RunExtremes(const BenchPlan& plan, const std::string& folder,
  const std::vector<std::string>& inputs, const std::string& commandLine)
{
  const Interruption interruption;
  ExtremeResults results(plan, commandLine);
  const auto start = std::chrono::steady_clock::now();
  for (const ExtremeCase& one : plan.Extremes)
  {
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    if (taken.count() > plan.GetBudget())
    {
      results.AddFailure(one.Name, "the time was over before it was measured");
      continue;
    }
    try
    {
      ExtremeMeasure measure(plan); // VTK keeps each shader until its window goes
      results.Add(one, measure.Run(one));
    }
    catch (const Failure& failure)
    {
      results.AddFailure(one.Name, failure.what());
    }
    if (Interruption::IsAsked())
    {
      results.SetIncomplete();
      break;
    }
  }
  Write(folder, inputs, results.GetFiles());
  return results.GetFailure();
}

//------------------------------------------------------------------------------
// A suite is handed over when it is done, or as far as it came. Gives what kept a case from being
// measured, or "".
std::string Run(const BenchPlan& plan, const std::string& folder,
  const std::vector<std::string>& inputs, const std::string& commandLine)
{
  const Interruption interruption;
  BenchResults results(plan, commandLine);
  double left = plan.GetBudget();
  double wanted = left;
  for (std::size_t i = 0; i < plan.Cases.size() && !Interruption::IsAsked(); ++i)
  {
    if (left <= 0.0)
    {
      results.AddFailure(plan.Cases[i].Id, "the time was over before it was measured");
      continue;
    }
    // What earlier cases left over is spread over the rest.
    const double seconds = left * plan.Cases[i].Budget / wanted;
    const auto start = std::chrono::steady_clock::now();
    Measure(results, plan, i, seconds, left - seconds);
    left -= std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    wanted -= plan.Cases[i].Budget;
  }
  if (Interruption::IsAsked())
  {
    results.SetIncomplete();
  }
  Write(folder, inputs, results.GetFiles());
  return results.GetFailure();
}

//------------------------------------------------------------------------------
// Find out now what would keep the files from being written.
void PlanOutputs(const std::string& output, const std::vector<std::string>& folders,
  const std::vector<std::string>& inputs)
{
  if (output.empty())
  {
    return;
  }
  Outputs outputs(inputs);
  outputs.PlanFolder(output);
  for (const std::string& folder : folders)
  {
    std::error_code ignored;
    if (!std::filesystem::exists(folder, ignored))
    {
      continue;
    }
    outputs.PlanFolder(folder);
    for (const char* name : BenchResults::FileNames)
    {
      outputs.PlanText(folder + "/" + name);
    }
  }
}

//------------------------------------------------------------------------------
void Bench(const CLI::App& command, const BenchOptions& options, const std::string& commandLine)
{
  const auto plans = MakePlans(options, command);
  std::vector<std::string> folders;
  for (const BenchPlan& plan : plans)
  {
    const bool several = plans.size() > 1 && !options.Output.empty();
    folders.push_back(several ? options.Output + "/" + plan.Name : options.Output);
  }
  std::vector<std::string> inputs = Models::GetFiles(options.Scene.Models);
  for (const std::string& suite : Values::Split(options.Suites))
  {
    inputs.push_back(suite); // or its name, which no file has
  }
  PlanOutputs(options.Output, folders, inputs);
  std::string failure;
  for (std::size_t i = 0; i < plans.size(); ++i)
  {
    const auto run = plans[i].Extremes.empty() ? Run : RunExtremes;
    const std::string reason = run(plans[i], folders[i], inputs, commandLine);
    failure = failure.empty() ? reason : failure;
    if (Interruption::IsAsked())
    {
      throw Interrupted(options.Output.empty()
                          ? "interrupted."
                          : "interrupted; what was measured is in \"" + options.Output + "\".");
    }
  }
  if (!failure.empty())
  {
    throw Failure(failure);
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
  options->Scene.Size = { 500, 500 }; // that of the suite quick
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
  command->add_option("--cases", options->Cases, "Of the suite, these cases alone, by their names")
    ->type_name("A,B,...")
    ->group("Scene");
  command
    ->add_flag("--quick", options->Quick,
      "Of a suite that sweeps cases to their limits, the values that take seconds instead of hours")
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
      "Values of a parameter to measure with instead of the suite's settings of the technique;\n"
      "may be given again. TECHNIQUE:NAME=... for that technique alone")
    ->type_name("NAME=V,W,...")
    ->allow_extra_args(false)
    ->group("Technique");
  Values::AddNumber(*command, "--budget", options->Budget, { 1.0, 1e6 },
    "Seconds that all of it shall take, of each suite (default 100, or the suite's)")
    ->type_name("SECONDS");
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
  command->footer(GetBudgets); // read only where the help is asked for
  command->callback([command, options, commandLine] { Bench(*command, *options, commandLine); });
}
