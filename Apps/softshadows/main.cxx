// SPDX-License-Identifier: BSD-3-Clause
// The command softshadows: exit code 0 when done, 1 for a failure it names, 2 for wrong usage,
// 130 when the user ended it.

#include "Bench.h"
#include "Compare.h"
#include "Errors.h"
#include "List.h"
#include "Render.h"
#include "StandardOutput.h"
#include "Values.h"
#include "View.h"

#include "vtkShadowPass.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

namespace
{
int Fail(const std::string& text, int code)
{
  Messages::PrintError(text);
  return code;
}

// What is given is given: nothing stands for "not given".
void RefuseEmptyValues(CLI::App& app)
{
  const auto check = [](const std::string& value)
  { return value.empty() ? std::string("its value is empty") : std::string(); };
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; }))
  {
    for (CLI::Option* option : command->get_options())
    {
      if (option->get_items_expected_max() > 0)
      {
        option->check(check, "", "not empty");
      }
    }
  }
}

int Run(int argc, char* argv[])
{
  vtkShadowPass::SetAdvice(false); // what is compared and measured is as it is meant
  CLI::App app(
    "Soft shadows for VTK: draw models and scenes, and measure the techniques.", "softshadows");
  app.set_version_flag("--version", "softshadows " SOFTSHADOWS_VERSION);
  app.require_subcommand(0, 1); // that there must be one is said below
  app.get_formatter()->column_width(30);
  DeclareList(app);
  DeclareRender(app);
  DeclareCompare(app);
  DeclareBench(app, "softshadows " + Values::Join({ argv + 1, argv + argc }));
  DeclareView(app);
  RefuseEmptyValues(app);

  try
  {
    app.parse(argc, argv); // runs the subcommand
    if (app.get_subcommands().empty())
    {
      throw CLI::RequiredError("a subcommand (list, render, compare, bench, view)");
    }
    Messages::Check();
    Messages::ShowWarnings();
  }
  catch (const CLI::Success& success) // --help, --version
  {
    return app.exit(success);
  }
  catch (const CLI::ParseError& wrong)
  {
    const auto used = app.get_subcommands();
    Fail(wrong.what(), 2);
    std::fprintf(stderr, "See: softshadows %s%s--help\n",
      used.empty() ? "" : used.front()->get_name().c_str(), used.empty() ? "" : " ");
    return 2;
  }
  catch (const WrongUsage& wrong)
  {
    return Fail(wrong.what(), 2);
  }
  catch (const Interrupted& interrupted)
  {
    return Fail(interrupted.what(), 130);
  }
  catch (const Failure& failure)
  {
    return Fail(failure.what(), 1);
  }
  catch (const std::bad_alloc&)
  {
    return Fail("out of memory.", 1);
  }
  catch (const std::exception& exception)
  {
    return Fail(exception.what(), 1);
  }
  return 0;
}
}

int main(int argc, char* argv[])
{
  StandardOutput::Reserve();
  std::signal(SIGXFSZ, SIG_IGN); // a file that becomes too large is an error like a full disk
  Messages::Install();
  const int code = Run(argc, argv);
  const std::string lost = StandardOutput::Finish();
  return code != 0 || lost.empty() ? code : Fail("cannot write to standard output: " + lost, 1);
}
