// SPDX-License-Identifier: BSD-3-Clause
// Figures that several subcommands give.

#ifndef Statistics_h
#define Statistics_h

#include <vector>

namespace Statistics
{
/** The value below which a share (0 to 1) of the values lies, between neighbours interpolated; NaN of
 * nothing. */
double GetQuantile(std::vector<double> values, double share);

/** Median; NaN of nothing. */
double GetMedian(const std::vector<double>& values);
}

#endif
