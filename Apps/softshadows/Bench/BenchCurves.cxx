// SPDX-License-Identifier: BSD-3-Clause
#include "BenchCurves.h"

#include <algorithm>
#include <cstdio>

using BenchFigures::Json;

namespace
{
using Points = std::vector<std::array<double, 2>>;

// Of Okabe and Ito, without yellow, which is too faint on white, and with a dark violet.
constexpr std::array<std::array<unsigned char, 3>, 7> colours = { { { 0, 114, 178 }, { 213, 94, 0 },
  { 0, 158, 115 }, { 204, 121, 167 }, { 86, 180, 233 }, { 230, 159, 0 }, { 68, 34, 136 } } };
constexpr std::array<unsigned char, 3> greys = { 70, 130, 100 };

// Filled and hollow; VTK's crosses are too thin. With seven colours and six markers 42 techniques
// differ, neighbours in both.
constexpr std::array<int, 3> markers = { vtkPlotPoints::CIRCLE, vtkPlotPoints::SQUARE,
  vtkPlotPoints::DIAMOND };

//------------------------------------------------------------------------------
CurveStyle MakeStyle(bool isPeer, std::size_t index)
{
  CurveStyle style;
  style.Marker = markers[index % markers.size()];
  style.IsHollow = index % (2 * markers.size()) >= markers.size();
  if (isPeer)
  {
    style.Colour.fill(greys[index % greys.size()]);
    style.Line = vtkPen::DASH_LINE;
  }
  else
  {
    style.Colour = colours[index % colours.size()];
  }
  return style;
}

//------------------------------------------------------------------------------
std::string GetSymbol(const CurveStyle& style)
{
  switch (style.Marker)
  {
    case vtkPlotPoints::CIRCLE:
      return style.IsHollow ? "\u25cb" : "\u25cf";
    case vtkPlotPoints::SQUARE:
      return style.IsHollow ? "\u25a1" : "\u25a0";
    default:
      return style.IsHollow ? "\u25c7" : "\u25c6";
  }
}

//------------------------------------------------------------------------------
bool CanShow(const BenchFigures::Number& x, const BenchFigures::Number& y)
{
  return x && y && *x > 0.0 && *y > 0.0;
}

//------------------------------------------------------------------------------
// Those of the points, by x, that none before beats in y.
Points GetFront(const Points& sorted)
{
  Points front;
  for (const auto& point : sorted)
  {
    if (front.empty() || point[1] < front.back()[1])
    {
      front.push_back(point);
    }
  }
  return front;
}

//------------------------------------------------------------------------------
// Markers at all points, and a line through all of them; or, since settings of several parameters have no
// order, through those of a technique that none of its others beats in both.
void AddCurves(const std::map<CurveStyles::Key, Points>& found, const CurveStyles& styles,
  bool throughFront, CurveChart& chart)
{
  for (const auto& [key, points] : found)
  {
    ChartCurve curve = { styles.Get(key), points };
    std::sort(curve.Points.begin(), curve.Points.end());
    if (throughFront)
    {
      ChartCurve line = { curve.Style, GetFront(curve.Points) };
      line.Style.Marker = vtkPlotPoints::NONE;
      if (line.Points.size() > 1)
      {
        chart.Content.Curves.push_back(line);
      }
      curve.Style.Line = vtkPen::NO_PEN;
    }
    chart.Content.Curves.push_back(curve);
    chart.Shown.push_back(key);
  }
}
}

//------------------------------------------------------------------------------
CurveStyles::CurveStyles(const Json& results)
{
  std::size_t known[2] = { 0, 0 };
  const auto add = [this, &known](const Key& key)
  {
    if (this->Styles.emplace(key, MakeStyle(key.first, known[key.first])).second)
    {
      ++known[key.first];
      this->Order.push_back(key);
    }
  };
  for (const Json& oneCase : BenchFigures::FindList(results, { "cases" }))
  {
    for (const Json& entry : BenchFigures::FindList(oneCase, { "entries" }))
    {
      if (BenchFigures::IsTechnique(entry) || BenchFigures::IsPeer(entry))
      {
        add(GetKey(entry));
      }
    }
  }
}

//------------------------------------------------------------------------------
CurveStyles::Key CurveStyles::GetKey(const Json& entry)
{
  return { BenchFigures::IsPeer(entry), BenchFigures::FindText(entry, { "technique" }) };
}

//------------------------------------------------------------------------------
const CurveStyle& CurveStyles::Get(const Key& key) const
{
  static const CurveStyle unknown;
  const auto found = this->Styles.find(key);
  return found != this->Styles.end() ? found->second : unknown;
}

//------------------------------------------------------------------------------
Json CurveStyles::GetLegend(const std::vector<Key>& keys) const
{
  Json legend = Json::array();
  for (const Key& key : this->Order)
  {
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
    {
      continue;
    }
    const CurveStyle& style = this->Get(key);
    char colour[8];
    std::snprintf(
      colour, sizeof(colour), "#%02x%02x%02x", style.Colour[0], style.Colour[1], style.Colour[2]);
    legend.push_back({ { "name", key.second }, { "peer", key.first }, { "colour", colour },
      { "symbol", GetSymbol(style) } });
  }
  return legend;
}

//------------------------------------------------------------------------------
CurveStyle CurveStyles::GetFront()
{
  CurveStyle style;
  style.Opacity = 50;
  style.Width = 7.0f;
  return style;
}

namespace BenchCurves
{
//------------------------------------------------------------------------------
CurveChart MakeErrorChart(const Json& oneCase, const std::string& pixels, const std::string& time,
  const CurveStyles& styles)
{
  CurveChart chart;
  chart.Content.XTitle = "added time, ms";
  chart.Content.YTitle = pixels == "penumbra" ? "RMSE in the penumbra" : "RMSE";
  std::map<CurveStyles::Key, Points> found;
  for (const Json& entry : BenchFigures::FindList(oneCase, { "entries" }))
  {
    const auto x = BenchFigures::GetAdded(entry, time);
    const auto y = BenchFigures::GetError(entry, pixels);
    const bool isWanted = BenchFigures::IsTechnique(entry) || BenchFigures::IsPeer(entry);
    if (isWanted && CanShow(x, y))
    {
      found[CurveStyles::GetKey(entry)].push_back({ *x, *y });
    }
    else if (isWanted && x && y)
    {
      chart.LeftOut.push_back(BenchFigures::GetName(entry));
    }
  }

  ChartCurve front;
  front.Style = CurveStyles::GetFront();
  for (const Json& id : BenchFigures::FindList(oneCase, { "fronts", pixels, time }))
  {
    const Json& entry =
      BenchFigures::FindEntry(oneCase, id.is_string() ? id.get<std::string>() : "");
    const auto x = BenchFigures::GetAdded(entry, time);
    const auto y = BenchFigures::GetError(entry, pixels);
    if (CanShow(x, y))
    {
      front.Points.push_back({ *x, *y });
    }
  }
  if (!found.empty() && front.Points.size() > 1)
  {
    chart.Content.Curves.push_back(front); // below the others
  }
  chart.Content.Floor = std::max(0.0, BenchFigures::GetNoise(oneCase, pixels).value_or(0.0));
  AddCurves(found, styles, true, chart);
  return chart;
}

//------------------------------------------------------------------------------
CurveChart MakeScalingChart(
  const Json& scaling, const std::string& axis, const std::string& time, const CurveStyles& styles)
{
  CurveChart chart;
  chart.Content.XTitle = axis;
  chart.Content.YTitle = "added time, ms";
  std::map<CurveStyles::Key, Points> found;
  for (const Json& line : scaling)
  {
    if (BenchFigures::FindText(line, { "axis" }) != axis ||
        BenchFigures::FindText(line, { "time" }) != time)
    {
      continue;
    }
    // A peer that bears a technique's name is not among these lines unless it is the only one.
    CurveStyles::Key key = { false, BenchFigures::FindText(line, { "technique" }) };
    if (styles.Get(key).Marker == vtkPlotPoints::NONE)
    {
      key.first = true;
    }
    bool isComplete = true;
    for (const Json& point : BenchFigures::FindList(line, { "points" }))
    {
      const bool isPair =
        point.is_array() && point.size() == 2 && point[0].is_number() && point[1].is_number();
      if (isPair && CanShow(point[0].get<double>(), point[1].get<double>()))
      {
        found[key].push_back({ point[0].get<double>(), point[1].get<double>() });
      }
      else
      {
        isComplete = false;
      }
    }
    if (!isComplete)
    {
      chart.LeftOut.push_back(BenchFigures::FindText(line, { "entry" }));
    }
  }
  AddCurves(found, styles, false, chart);
  return chart;
}
}
