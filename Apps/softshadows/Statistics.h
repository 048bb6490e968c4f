// Figures that several subcommands give.

#ifndef Statistics_h
#define Statistics_h

#include <vector>

namespace Statistics
{
/** Median; NaN of nothing. */
double GetMedian(std::vector<double> values);
}

#endif
