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

/** The command's own messages and those of VTK, in one form. */
namespace Messages
{
/** From now on VTK's messages are collected here instead of being printed. */
void Install();

/** Print "softshadows: error: ..." on stderr. */
void PrintError(const std::string& text);

/** Keep "softshadows: warning: ..." or "softshadows: note: ..." for ShowWarnings, once each. */
void Warn(const std::string& text);
void Note(const std::string& text);

/** Print what was kept. A command that fails does not: it prints its one error. */
void ShowWarnings();

/** The first error that VTK has reported since the last call, or "". Forgets all errors. */
std::string TakeError();

/** Throw Failure if VTK has reported an error; before its text stands the context, if any. */
void Check(const std::string& context = "");
}

#endif
