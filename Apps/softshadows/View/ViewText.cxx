// SPDX-License-Identifier: BSD-3-Clause
#include "ViewText.h"

#include <cstdio>

namespace
{
using Json = nlohmann::ordered_json;

std::string DescribeRange(const Json& parameter)
{
  if (parameter.contains("choices"))
  {
    std::string text;
    for (const auto& choice : parameter["choices"])
    {
      text += (text.empty() ? "" : ", ") + choice.get<std::string>();
    }
    return text;
  }
  if (parameter["type"] == "boolean")
  {
    return "on, off";
  }
  char text[64];
  std::snprintf(text, sizeof(text), "%g to %g", parameter["minimum"].get<double>(),
    parameter["maximum"].get<double>());
  const std::string unit = parameter.value("unit", "");
  return text + (unit.empty() ? "" : " " + unit);
}

std::string DescribeError(const Json& error)
{
  const auto figures = [&error](const char* which)
  {
    const Json& one = error[which];
    return ViewText::Format(one["rmse"], 4) + " (" + ViewText::Format(one["rmseInterval"][0], 4) +
           " to " + ViewText::Format(one["rmseInterval"][1], 4) + ")";
  };
  return "error " + figures("receivers") + ", penumbrae " + figures("penumbrae");
}

/** What was made, reused and left out: the counts that are not zero. */
std::string DescribeCounts(const Json& counts)
{
  std::string text;
  for (const auto& [name, value] : counts.items())
  {
    const double number = value;
    if (number != 0.0)
    {
      std::string words;
      for (const char letter : name)
      {
        words += letter >= 'A' && letter <= 'Z' ? std::string(" ") + char(letter + 32)
                                                : std::string(1, letter);
      }
      text += (text.empty() ? "" : ", ") + words + " " + ViewText::Format(number, 0);
    }
  }
  return text;
}

/** At most so many letters a line. */
std::string Wrap(const std::string& text, std::size_t most)
{
  std::string lines;
  std::size_t length = 0;
  for (std::size_t start = 0; start < text.size();)
  {
    const std::size_t end = std::min(text.find(' ', start), text.size());
    const std::string word = text.substr(start, end - start);
    const bool fits = length == 0 || length + 1 + word.size() <= most;
    lines += length == 0 ? "" : fits ? " " : "\n  ";
    length = fits ? length + (length > 0) + word.size() : word.size() + 2;
    lines += word;
    start = end + 1;
  }
  return lines;
}
}

namespace ViewText
{
//------------------------------------------------------------------------------
std::string Format(double number, int digits)
{
  char text[64];
  std::snprintf(text, sizeof(text), "%.*f", digits, number);
  return text;
}

//------------------------------------------------------------------------------
double GetGPUMilliseconds(const Json& statistics)
{
  // The stages of a frame; what else is timed lies within them.
  double sum = 0.0;
  const Json times = statistics.value("milliseconds", Json::object());
  for (const char* stage : { "light data", "receivers", "visibility", "shading" })
  {
    sum += times.value(stage, 0.0);
  }
  return sum;
}

//------------------------------------------------------------------------------
std::string DescribeFrame(const ViewModel& model, const ViewFigures& figures)
{
  constexpr std::size_t column = 56;
  std::string text = model.GetTechnique();
  if (model.GetPass())
  {
    text += ": " + Techniques::Describe(model.GetTechnique())["title"].get<std::string>();
    text += model.GetDebugView() == "none" ? "" : "; view " + model.GetDebugView();
    text += model.IsLowered() ? " (lower quality while moving)" : "";
  }
  else
  {
    text += ": without shadows";
  }
  text += "\n" + std::to_string(figures.Size[0]) + " x " + std::to_string(figures.Size[1]) + ", " +
          std::to_string(figures.Triangles) + " triangles";
  const std::string samples = model.GetValue("samples");
  text += samples.empty() ? "" : ", " + samples + " samples";
  text +=
    "\n" + Format(figures.Rate, 1) + " frames a second, " + Format(figures.Milliseconds, 1) + " ms";
  if (model.GetPass() && figures.Statistics.contains("counts"))
  {
    text += " (GPU " + Format(GetGPUMilliseconds(figures.Statistics), 1) + " ms)";
    text += "\n" + Wrap(DescribeCounts(figures.Statistics["counts"]), column);
  }
  if (!figures.Error.is_null())
  {
    text += "\n" + DescribeError(figures.Error);
  }
  for (std::size_t i = 0; i < model.GetParameters().size(); ++i)
  {
    const Json& parameter = model.GetParameters()[i];
    const bool chosen = i == model.GetChosen();
    const std::string name = parameter["name"];
    text += (chosen ? "\n> " : "\n  ") + name + " = " + model.GetValue(name);
    text += chosen ? "  [" + DescribeRange(parameter) + "]" : "";
  }
  return text;
}
}
