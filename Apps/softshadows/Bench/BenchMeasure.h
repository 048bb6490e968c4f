// SPDX-License-Identifier: BSD-3-Clause
// One case of a benchmark: each entry's error once, then the times of all in turns.

#ifndef BenchMeasure_h
#define BenchMeasure_h

#include "BenchPlan.h"
#include "BenchReport.h"

#include <memory>
#include <string>
#include <vector>

class BenchMeasure
{
public:
  /** Builds the scene in a window of its own. Failure for what cannot be. */
  BenchMeasure(const BenchPlan& plan, const BenchCase& one);
  ~BenchMeasure();

  /**
   * Measure for about that many seconds, or until all medians have the frames that the plan wants, or
   * an interruption. `title` stands before the time that is left, of this and, `later` seconds, of
   * others.
   */
  void Run(double seconds, double later, const std::string& title);

  /** Whether each entry that can be measured was timed. */
  bool IsComplete() const;

  /** The case, as results.json has it, without what follows from it (BenchAnalysis). */
  nlohmann::ordered_json GetJSON() const;

  /** Of each technique, the picture with the least error. */
  std::vector<BenchPicture> GetPictures() const;

  /** Vendor, renderer and version of the OpenGL that draws. */
  nlohmann::ordered_json GetGL() const;

private:
  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
