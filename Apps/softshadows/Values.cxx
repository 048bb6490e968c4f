// SPDX-License-Identifier: BSD-3-Clause
#include "Values.h"

#include "Errors.h"

#include "vtkShadowNumber.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <limits>
#include <sstream>

namespace Values
{
//------------------------------------------------------------------------------
bool ParseNumber(const std::string& text, double& value)
{
  const auto number = vtkShadowNumber::Parse(text);
  value = number.value_or(0.0);
  return number.has_value();
}

//------------------------------------------------------------------------------
std::optional<std::array<double, 3>> ParseTriple(const std::string& text)
{
  const auto words = Split(text);
  std::array<double, 3> numbers{};
  bool valid = words.size() == numbers.size();
  for (std::size_t i = 0; valid && i < numbers.size(); ++i)
  {
    valid = ParseNumber(words[i], numbers[i]);
  }
  return valid ? std::optional(numbers) : std::nullopt;
}

//------------------------------------------------------------------------------
void RefuseOthers(
  const CLI::App& command, const std::vector<std::string>& used, const std::string& what)
{
  for (const CLI::Option* option : command.get_options())
  {
    if (option->count() > 0 && std::none_of(used.begin(), used.end(),
                                 [&](const std::string& name) { return option->check_name(name); }))
    {
      throw WrongUsage(option->get_name() + " has no meaning for " + what);
    }
  }
}

//------------------------------------------------------------------------------
std::vector<std::string> Split(const std::string& text, char separator)
{
  std::vector<std::string> words;
  std::istringstream stream(text + separator);
  for (std::string word; std::getline(stream, word, separator);)
  {
    words.push_back(word);
  }
  return words;
}

//------------------------------------------------------------------------------
std::string Join(const std::vector<std::string>& words)
{
  std::string line;
  for (const std::string& word : words)
  {
    const bool plain = !word.empty() && std::all_of(word.begin(), word.end(),
                                          [](unsigned char c) {
                                            return std::isalnum(c) || std::strchr("-_./,:=+%@", c);
                                          });
    std::string quoted;
    for (const char c : word)
    {
      quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    line += (line.empty() ? "" : " ") + (plain ? word : "'" + quoted + "'");
  }
  return line;
}

//------------------------------------------------------------------------------
CLI::Option* AddTriple(CLI::App& command, const std::string& name,
  std::optional<std::array<double, 3>>& value, const std::string& form, const std::string& meaning)
{
  const auto parse = [name, &value](const std::string& text)
  {
    value = ParseTriple(text);
    if (!value)
    {
      throw CLI::ValidationError(name, "\"" + text + "\" is not three numbers such as 1,2.5,-3");
    }
  };
  return command.add_option_function<std::string>(name, parse, meaning)->type_name(form);
}

//------------------------------------------------------------------------------
CLI::Option* AddNumber(CLI::App& command, const std::string& name, std::optional<double>& value,
  const std::array<double, 2>& range, const std::string& meaning)
{
  const auto parse = [name, range, &value](const std::string& text)
  {
    double number = 0.0;
    if (!ParseNumber(text, number) || number < range[0] || number > range[1])
    {
      throw CLI::ValidationError(name, "\"" + text + "\" is no number from " +
                                         vtkShadowNumber::Print(range[0]) + " to " +
                                         vtkShadowNumber::Print(range[1]));
    }
    value = number;
  };
  return command.add_option_function<std::string>(name, parse, meaning);
}

//------------------------------------------------------------------------------
CLI::Option* AddSize(
  CLI::App& command, const std::string& name, std::array<int, 2>& value, const std::string& meaning)
{
  const auto parse = [name, &value](const std::string& text)
  {
    const auto words = Split(text, 'x');
    std::array<int, 2> sides{};
    bool valid = words.size() == sides.size();
    for (std::size_t i = 0; valid && i < sides.size(); ++i)
    {
      double number = 0.0;
      valid = ParseNumber(words[i], number) && number == std::floor(number) &&
              std::abs(number) <= std::numeric_limits<int>::max();
      sides[i] = valid ? static_cast<int>(number) : 0;
    }
    if (!valid)
    {
      throw CLI::ValidationError(name, "\"" + text + "\" is not a size such as 900x700");
    }
    value = sides;
  };
  return command.add_option_function<std::string>(name, parse, meaning)->type_name("WxH");
}
}
