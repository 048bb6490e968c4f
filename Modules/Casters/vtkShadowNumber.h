// SPDX-License-Identifier: BSD-3-Clause
// Numbers as text, the same in every locale: where the user's language has a decimal comma, any Qt
// program makes strtod, printf and the streams read and write one.

#ifndef vtkShadowNumber_h
#define vtkShadowNumber_h

#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace vtkShadowNumber
{
/** The finite number that a text is, and nothing besides: "64", "+0.16", "-1e-3". */
inline std::optional<double> Parse(std::string_view text)
{
  if (text.size() > 1 && text[0] == '+' && text[1] != '-')
  {
    text.remove_prefix(1);
  }
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(number))
  {
    return std::nullopt;
  }
  return number;
}

/** The shortest text that reads as a number again; whole numbers without an exponent. */
inline std::string Print(double number)
{
  char text[32];
  const bool whole = std::abs(number) < 1e15 && number == std::trunc(number);
  const auto result = whole
                        ? std::to_chars(text, text + sizeof(text), static_cast<long long>(number))
                        : std::to_chars(text, text + sizeof(text), number);
  return std::string(text, result.ptr);
}
}

#endif
