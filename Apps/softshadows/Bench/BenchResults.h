// What a benchmark measured, as results.json (Documentation/results/results.schema.json), results.csv
// and report.html.

#ifndef BenchResults_h
#define BenchResults_h

#include "BenchPlan.h"
#include "BenchReport.h"

#include <string>
#include <vector>

class BenchMeasure;
class Outputs;

class BenchResults
{
public:
  /** `command` is the command line. */
  BenchResults(const BenchPlan& plan, const std::string& command);

  /** Add a case that was measured, and what follows from it. */
  void Add(const BenchMeasure& measure);

  /** Not all was measured. */
  void SetIncomplete() { this->Json["complete"] = false; }

  /** The three files into a folder. */
  void Stage(Outputs& outputs, const std::string& folder);

  /** The last case as a table. */
  void PrintTable() const;

private:
  std::string GetCSV() const;

  const BenchPlan& Plan;
  nlohmann::ordered_json Json;
  std::vector<BenchPicture> Pictures;
};

#endif
