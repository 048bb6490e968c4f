// SPDX-License-Identifier: BSD-3-Clause
// What the suite "extremes" sweeps: cases, each a scene with one thing in it that goes to its limits.

#ifndef ExtremePlan_h
#define ExtremePlan_h

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

/** Where on its range a case is: a number, or a word. */
struct ExtremeValue
{
  double Number = 0.0;
  std::string Word; // empty: a number
  bool Quick = false;

  /** As tables have it: "1e-6", "3.2e4", "12", or the word. */
  std::string GetText() const;
};

struct ExtremeCase
{
  std::string Name;
  std::string About;
  std::string Scene; // see ExtremeScenes
  std::vector<ExtremeValue> Values;
  ExtremeValue Ordinary; // what the others are compared with

  ///@{
  /** What must hold, each where it is given; over the pixels that receive in both. */
  std::optional<double> Change; // RMSE against the same technique's ordinary case, pixel by pixel
  std::optional<double> Growth; // of the RMSE against the reference, over that of the ordinary case
  std::optional<double>
    Wrong; // share of pixels amid full light or umbra that are off by half or more
  std::optional<double> Bias; // growth of the mean error's magnitude
  std::optional<double>
    Motion; // RMSE of the change from the ordinary case that is not the reference's
  ///@}
};

namespace ExtremePlans
{
/** A suite's cases; `quick`: only what is marked as such. */
std::vector<ExtremeCase> Read(const nlohmann::ordered_json& suite);

/** Keep what is marked as quick. */
void KeepQuick(std::vector<ExtremeCase>& cases);

/** Keep these cases alone; WrongUsage for a name that none has. */
void Select(std::vector<ExtremeCase>& cases, const std::vector<std::string>& names);
}

#endif
