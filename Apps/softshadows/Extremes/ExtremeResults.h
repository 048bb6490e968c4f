// SPDX-License-Identifier: BSD-3-Clause
// What the suite "extremes" found: results.json, results.csv and tables on the terminal.

#ifndef ExtremeResults_h
#define ExtremeResults_h

#include "BenchPlan.h"
#include "ExtremePlan.h"

#include <string>
#include <utility>
#include <vector>

class ExtremeResults
{
public:
  /** `command` is the command line. */
  ExtremeResults(const BenchPlan& plan, const std::string& command);

  /** Add what ExtremeMeasure::Run gives, and print its table. */
  void Add(const ExtremeCase& one, const nlohmann::ordered_json& techniques);
  void AddFailure(const std::string& name, const std::string& reason);
  void SetIncomplete() { this->Json["complete"] = false; }

  std::vector<std::pair<std::string, std::string>> GetFiles() const;

  /** What does not hold, in a sentence, or "". */
  std::string GetFailure() const;

private:
  nlohmann::ordered_json Json;
};

#endif
