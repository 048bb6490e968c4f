// SPDX-License-Identifier: BSD-3-Clause
#include "ViewKeys.h"

#include "Viewer.h"

#include <algorithm>
#include <cctype>

namespace ViewKeys
{
//------------------------------------------------------------------------------
const std::vector<ViewKey>& GetAll()
{
  using Shift = ViewKey::Shift;
  static const std::vector<ViewKey> keys = {
    { "Left drag", "turn; on the line between two sides, move it", {} },
    { "Middle drag", "move the light, its height kept", {} },
    { "Right button", "menu of techniques and debug views", {} },
    { "Wheel", "zoom", {} },
    { "Page Up, Page Down", "raise, lower the light", { "prior" }, &Viewer::RaiseLight, 1 },
    { "", "", { "next" }, &Viewer::RaiseLight, -1 },
    { "+, -", "zoom in, out", { "plus", "equal", "kp_add" }, &Viewer::Zoom, 1 },
    { "", "", { "minus", "underscore", "kp_subtract" }, &Viewer::Zoom, -1 },
    { "Space", "next technique; with Shift the previous one", { "space" }, &Viewer::StepTechnique,
      1, Shift::Without },
    { "", "", { "space" }, &Viewer::StepTechnique, -1, Shift::With },
    { "Return", "spin the camera; with Shift the casters", { "return", "kp_enter" }, &Viewer::Spin,
      0, Shift::Without },
    { "", "", { "return", "kp_enter" }, &Viewer::Spin, 1, Shift::With },
    { "1 to 5", "quality: preview, low, medium, high, reference", { "1" }, &Viewer::SetQuality, 0 },
    { "", "", { "2" }, &Viewer::SetQuality, 1 },
    { "", "", { "3" }, &Viewer::SetQuality, 2 },
    { "", "", { "4" }, &Viewer::SetQuality, 3 },
    { "", "", { "5" }, &Viewer::SetQuality, 4 },
    { "Up, Down", "choose a parameter", { "up" }, &Viewer::Choose, -1 },
    { "", "", { "down" }, &Viewer::Choose, 1 },
    { "Left, Right", "change it", { "left" }, &Viewer::Change, -1 },
    { "", "", { "right" }, &Viewer::Change, 1 },
    { "m", "midpoint maps, on and off", { "m" }, &Viewer::SwitchMidpoint },
    { "n", "64 or 100 samples", { "n" }, &Viewer::SwitchSamples },
    { "[, ]", "smaller, larger light", { "bracketleft" }, &Viewer::ScaleLight, -1 },
    { "", "", { "bracketright" }, &Viewer::ScaleLight, 1 },
    { "d", "next debug view; with Shift the previous one", { "d" }, &Viewer::StepDebugView, 1,
      Shift::Without },
    { "", "", { "d" }, &Viewer::StepDebugView, -1, Shift::With },
    { "v", "split the window: the reference on the right", { "v" }, &Viewer::SplitReference },
    { "b", "split the window: the next technique on the right", { "b" }, &Viewer::SplitTechnique },
    { "comma, period", "move the line between them", { "comma" }, &Viewer::MoveDivider, -1 },
    { "", "", { "period" }, &Viewer::MoveDivider, 1 },
    { "e", "error of visibility at rest: red too light, blue too dark", { "e" },
      &Viewer::SwitchErrors },
    { "l", "light and its samples, on and off", { "l" }, &Viewer::SwitchLights },
    { "i", "text, on and off", { "i" }, &Viewer::SwitchText },
    { "s", "snapshot: picture, visibility and settings, as new files", { "s" },
      &Viewer::TakeSnapshot },
    { "c", "print the options that reproduce the view", { "c" }, &Viewer::PrintOptions },
    { "r", "camera as at the start", { "r" }, &Viewer::ResetCamera },
    { "?", "this help", { "question" }, &Viewer::SwitchHelp },
    { "Esc", "end", { "escape" }, &Viewer::End },
  };
  return keys;
}

//------------------------------------------------------------------------------
const ViewKey* Find(const std::string& key, bool shift)
{
  std::string small = key;
  std::transform(small.begin(), small.end(), small.begin(),
    [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  for (const ViewKey& one : GetAll())
  {
    const bool fits =
      one.WithShift == ViewKey::Shift::Any || (one.WithShift == ViewKey::Shift::With) == shift;
    if (fits && std::find(one.Keys.begin(), one.Keys.end(), small) != one.Keys.end())
    {
      return &one;
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
std::string GetHelp()
{
  constexpr std::size_t column = 20;
  std::string text;
  for (const ViewKey& one : GetAll())
  {
    if (*one.Meaning)
    {
      std::string shown = one.Shown;
      shown.resize(std::max(column, shown.size() + 1), ' ');
      text += (text.empty() ? "" : "\n") + shown + one.Meaning;
    }
  }
  return text;
}
}
