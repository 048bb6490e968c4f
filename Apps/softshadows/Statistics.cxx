#include "Statistics.h"

#include <algorithm>
#include <limits>

namespace Statistics
{
//------------------------------------------------------------------------------
double GetMedian(std::vector<double> values)
{
  if (values.empty())
  {
    return std::numeric_limits<double>::quiet_NaN();
  }
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}
}
