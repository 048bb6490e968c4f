// SPDX-License-Identifier: BSD-3-Clause
// One case of the suite "extremes": each technique at each value of its range.

#ifndef ExtremeMeasure_h
#define ExtremeMeasure_h

#include "BenchPlan.h"
#include "ExtremePlan.h"

#include <memory>

class ExtremeMeasure
{
public:
  /** Opens a window to draw in. Failure where there is none. */
  explicit ExtremeMeasure(const BenchPlan& plan);
  ~ExtremeMeasure();

  /**
   * The case as results.json has it: for each technique a list of what was found at each value, its
   * worst, and whether all hold. Stops where the user interrupts.
   */
  nlohmann::ordered_json Run(const ExtremeCase& one);

private:
  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
