// SPDX-License-Identifier: BSD-3-Clause
// What goes wrong, and how the command says so: each failure is one line on stderr and an exit code.

#ifndef Errors_h
#define Errors_h

#include <stdexcept>
#include <string>

/** A failure that the command names: exit code 1. */
class Failure : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/** A command line that cannot be understood: exit code 2. */
class WrongUsage : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/** The user has ended it, after what was done was kept: exit code 130, as the shell has it. */
class Interrupted : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/** Do what the command line alone decides: a Failure there is wrong usage. */
template <typename Function>
auto JudgeUsage(Function function) -> decltype(function())
{
  try
  {
    return function();
  }
  catch (const Failure& failure)
  {
    throw WrongUsage(failure.what());
  }
}

/** The command's own messages and those of VTK, in one form. */
namespace Messages
{
/** Text of whatever origin, fit for a terminal: control characters are written as "\\x1b". */
std::string GetPrintable(const std::string& text);

/** From now on VTK's messages are collected here instead of being printed. */
void Install();

/** Print "softshadows: error: ..." on stderr. */
void PrintError(const std::string& text);

/** Keep "softshadows: warning: ..." or "softshadows: note: ..." for ShowWarnings, once each. */
void Warn(const std::string& text);
void Note(const std::string& text);

/**
 * Print what was kept, of a flood the first and the number of the others. A command that fails does
 * not: it prints its one error.
 */
void ShowWarnings();

/** What was kept, as one text, or "". Forgets it: the same is told again when it comes again. */
std::string TakeWarnings();

/** The first error that VTK has reported since the last call, or "". Forgets all errors. */
std::string TakeError();

/** While it lives, what VTK warns of is said to be about this. */
class About
{
public:
  explicit About(const std::string& what);
  ~About();
  About(const About&) = delete;
  void operator=(const About&) = delete;
};

/** Throw Failure if VTK has reported an error; before its text stands the context, if any. */
void Check(const std::string& context = "");
}

#endif
