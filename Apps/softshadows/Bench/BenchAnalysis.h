// SPDX-License-Identifier: BSD-3-Clause
// What follows from a benchmark's figures: fronts, times beside rays of the same error, advice,
// exponents. From results.json's own form to results.json's own form.

#ifndef BenchAnalysis_h
#define BenchAnalysis_h

#include "BenchPlan.h"

#include <nlohmann/json.hpp>

namespace BenchAnalysis
{
/** Add "fronts", "against_rays", "advice" to a case, and to its entries what a paper says of them. */
void AddToCase(nlohmann::ordered_json& one, const BenchPlan& plan);

/** Exponents of added time against the cases' values, an axis, entry and kind of time each. */
nlohmann::ordered_json GetScaling(const nlohmann::ordered_json& cases);
}

#endif
