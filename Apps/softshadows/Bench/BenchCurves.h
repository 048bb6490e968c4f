// SPDX-License-Identifier: BSD-3-Clause
// What the report's charts show.

#ifndef BenchCurves_h
#define BenchCurves_h

#include "BenchCharts.h"
#include "BenchFigures.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

/**
 * A look for each technique and each peer of the results, the same in all charts: techniques in
 * colours that colour-blind people can tell apart, and by markers; peers grey and dashed.
 */
class CurveStyles
{
public:
  using Json = BenchFigures::Json;
  /** Whether it is a peer, and the technique. */
  using Key = std::pair<bool, std::string>;

  explicit CurveStyles(const Json& results);

  static Key GetKey(const Json& entry);
  const CurveStyle& Get(const Key& key) const;

  /** For the page's template: name, colour and symbols of some techniques, in their order. */
  Json GetLegend(const std::vector<Key>& keys) const;

  static CurveStyle GetFront();

private:
  std::map<Key, CurveStyle> Styles;
  std::vector<Key> Order;
};

/** A chart and what has to be said of it. */
struct CurveChart
{
  Chart Content;
  std::vector<CurveStyles::Key> Shown;
  std::vector<std::string> LeftOut; // names of what no logarithmic axis can show
};

namespace BenchCurves
{
/** Error against added time: a curve for each technique, the front and the reference's noise. */
CurveChart MakeErrorChart(const BenchFigures::Json& oneCase, const std::string& pixels,
  const std::string& time, const CurveStyles& styles);

/** Added time against what an axis of the suite changes. */
CurveChart MakeScalingChart(const BenchFigures::Json& scaling, const std::string& axis,
  const std::string& time, const CurveStyles& styles);
}

#endif
