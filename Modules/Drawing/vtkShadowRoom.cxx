// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowRoom.h"

#include <algorithm>

namespace
{
constexpr double Rounding = 1e-6;

/** What is divided has this share of its extent between its sides. */
constexpr double LeastRoom = 0.25;
}

//------------------------------------------------------------------------------
vtkShadowRoom vtkShadowRoom::Find(const std::vector<Rectangle>& rectangles, double least)
{
  vtkShadowRoom found;
  std::vector<std::pair<double, double>> ranges(rectangles.size());
  for (int axis = 0; axis < 2 && !ranges.empty(); ++axis)
  {
    std::transform(rectangles.begin(), rectangles.end(), ranges.begin(),
      [axis](const Rectangle& r) { return std::make_pair(r.first[axis], r.second[axis]); });
    std::sort(ranges.begin(), ranges.end());
    double high = ranges.front().second;
    double widest = 0.0;
    double end = 0.0;
    for (const auto& range : ranges)
    {
      if (range.first - high > (1.0 + Rounding) * widest)
      {
        widest = range.first - high;
        end = range.first;
      }
      high = std::max(high, range.second);
    }
    const double share = widest / (high - ranges.front().first);
    if (widest >= least && share > LeastRoom - Rounding && share > found.Share + Rounding)
    {
      found = { share, axis, end };
    }
  }
  return found;
}
