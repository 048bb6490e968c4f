// SPDX-License-Identifier: BSD-3-Clause
// What a benchmark measured, as results.json (Documentation/results/results.schema.json), results.csv
// and report.html.

#ifndef BenchResults_h
#define BenchResults_h

#include "BenchPlan.h"
#include "BenchReport.h"

#include <string>
#include <utility>
#include <vector>

class BenchMeasure;

class BenchResults
{
public:
  /** `command` is the command line. */
  BenchResults(const BenchPlan& plan, const std::string& command);

  /** Add a case that was measured, and what follows from it. */
  void Add(const BenchMeasure& measure);

  /** Add what kept a case from being measured. */
  void AddFailure(const std::string& id, const std::string& reason);

  /** Not all was measured. */
  void SetIncomplete() { this->Json["complete"] = false; }

  static constexpr const char* FileNames[] = { "results.json", "results.csv", "report.html" };
  /** The files' names and texts. */
  std::vector<std::pair<std::string, std::string>> GetFiles() const;

  /** What kept a case from being measured, the first, or "". */
  std::string GetFailure() const;

  /** The last case as a table. */
  void PrintTable() const;

private:
  const BenchPlan& Plan;
  nlohmann::ordered_json Json;
  std::vector<BenchPicture> Pictures;
};

#endif
