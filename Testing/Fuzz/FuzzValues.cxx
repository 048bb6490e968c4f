// SPDX-License-Identifier: BSD-3-Clause
// Values of the command line: numbers are finite, lists are what was put in, and nothing that a
// terminal obeys gets through.

#include "Errors.h"
#include "Techniques.h"
#include "Values.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string text(reinterpret_cast<const char*>(data), size);
  double value = 0.0;
  bool right = !Values::ParseNumber(text, value) || std::isfinite(value);
  std::string joined;
  for (const std::string& word : Values::Split(text))
  {
    joined += word + ",";
  }
  right = right && joined == text + ",";
  if (const auto setting = TechniqueSetting::Parse(text))
  {
    right = right && text == (setting->Technique.empty() ? "" : setting->Technique + ":") +
                               setting->Name + "=" + setting->Value;
  }
  for (const char c : Messages::GetPrintable(text))
  {
    right = right && static_cast<unsigned char>(c) >= 0x20 && c != 0x7f;
  }
  if (!right)
  {
    std::abort();
  }
  return 0;
}
