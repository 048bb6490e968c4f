// SPDX-License-Identifier: BSD-3-Clause
// Values on the command line that are more than one number. Text of another form is wrong usage.

#ifndef Values_h
#define Values_h

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class App;
class Option;
}

namespace Values
{
/** An option of three numbers, "1,2.5,-3". */
CLI::Option* AddTriple(CLI::App& command, const std::string& name,
  std::optional<std::array<double, 3>>& value, const std::string& form, const std::string& meaning);

/** An option of a finite number from the range's first to its second. */
CLI::Option* AddNumber(CLI::App& command, const std::string& name, std::optional<double>& value,
  const std::array<double, 2>& range, const std::string& meaning);

/** An option of a size, "900x700". */
CLI::Option* AddSize(CLI::App& command, const std::string& name, std::array<int, 2>& value,
  const std::string& meaning);

/** A finite number that is the whole text; else false. */
bool ParseNumber(const std::string& text, double& value);

/** Three finite numbers, "1,2.5,-3"; else nothing. */
std::optional<std::array<double, 3>> ParseTriple(const std::string& text);

/** WrongUsage for an option that is given and would do nothing: "OPTION has no meaning for WHAT". */
void RefuseOthers(
  const CLI::App& command, const std::vector<std::string>& used, const std::string& what);

/** Words as a line for the shell, quoted where they need it. */
std::string Join(const std::vector<std::string>& words);

/** The words between commas. */
std::vector<std::string> Split(const std::string& text, char separator = ',');
}

#endif
