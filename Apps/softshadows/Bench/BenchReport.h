// SPDX-License-Identifier: BSD-3-Clause
// The page that shows the results of softshadows bench.

#ifndef BenchReport_h
#define BenchReport_h

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

/** What an entry of a case draws, and its signed difference from the reference; either may miss. */
struct BenchPicture
{
  std::string Case;
  std::string Entry;
  vtkSmartPointer<vtkImageData> Picture;
  vtkSmartPointer<vtkImageData> Difference;
};

/**
 * An HTML page that needs no other file. Results that miss figures give a page that misses them.
 * Failure where charts cannot be drawn.
 */
std::string MakeBenchReport(
  const nlohmann::ordered_json& results, const std::vector<BenchPicture>& pictures);

#endif
