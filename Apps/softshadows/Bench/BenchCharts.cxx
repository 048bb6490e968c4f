// SPDX-License-Identifier: BSD-3-Clause
#include "BenchCharts.h"

#include "BenchPictures.h"

#include "vtkAxis.h"
#include "vtkChartXY.h"
#include "vtkContextActor.h"
#include "vtkContextScene.h"
#include "vtkDoubleArray.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
constexpr int Scale = 2;
const int windowSize[2] = { Scale * ChartPainter::Width, Scale* ChartPainter::Height };

/** From the least to the largest value of the points, with a margin. */
std::array<double, 2> FindRange(const Chart& chart, int component)
{
  double low = std::numeric_limits<double>::max();
  double high = 0.0;
  for (const ChartCurve& curve : chart.Curves)
  {
    for (const auto& point : curve.Points)
    {
      low = std::min(low, point[component]);
      high = std::max(high, point[component]);
    }
  }
  if (component == 1 && chart.Floor > 0.0)
  {
    low = std::min(low, chart.Floor);
    high = std::max(high, chart.Floor);
  }
  // At least a decade: VTK finds no round ticks within less.
  const double middle = std::sqrt(low) * std::sqrt(high);
  return { std::min(low * 0.8, middle * 0.3), std::max(high * 1.25, middle * 3.5) };
}

//------------------------------------------------------------------------------
void SetUpAxis(vtkAxis* axis, const std::string& title, const std::array<double, 2>& range)
{
  axis->SetTitle(title);
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetUnscaledRange(range[0], range[1]);
  axis->SetLogScale(true);
  axis->GetTitleProperties()->SetFontSize(13 * Scale);
  axis->GetTitleProperties()->BoldOff();
  axis->SetNotation(vtkAxis::PRINTF_NOTATION);
  axis->SetLabelFormat("%.10g"); // no exponents
  axis->GetLabelProperties()->SetFontSize(12 * Scale);
  axis->SetTickLength(5.0f * Scale);
  axis->SetLabelOffset(8.0f * Scale);
  axis->GetGridPen()->SetColor(225, 225, 225, 255);
  axis->GetGridPen()->SetWidth(Scale);
  axis->GetPen()->SetWidth(Scale);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTable> MakeTable(const std::vector<std::array<double, 2>>& points)
{
  auto table = vtkSmartPointer<vtkTable>::New();
  for (int component = 0; component < 2; ++component)
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(component == 0 ? "x" : "y");
    for (const auto& point : points)
    {
      column->InsertNextValue(point[component]);
    }
    table->AddColumn(column);
  }
  return table;
}

//------------------------------------------------------------------------------
void AddCurve(
  vtkChartXY* chart, const CurveStyle& style, const std::vector<std::array<double, 2>>& points)
{
  const auto table = MakeTable(points);
  const auto add = [chart, &table, &style](int kind, float markerSize)
  {
    auto* plot = vtkPlotPoints::SafeDownCast(chart->AddPlot(kind));
    plot->SetInputData(table, 0, 1);
    plot->SetMarkerStyle(style.Marker);
    plot->SetMarkerSize(markerSize * Scale);
    return plot;
  };
  // VTK draws no line through one point.
  auto* plot = add(points.size() > 1 ? vtkChart::LINE : vtkChart::POINTS, 10.0f);
  plot->SetColor(style.Colour[0], style.Colour[1], style.Colour[2], style.Opacity);
  plot->SetWidth(Scale * style.Width);
  plot->GetPen()->SetLineType(style.Line);
  if (style.IsHollow)
  {
    add(vtkChart::POINTS, 5.5f)->SetColor(255, 255, 255, 255);
  }
}
}

//------------------------------------------------------------------------------
ChartPainter::ChartPainter()
  : Window(windowSize, 8)
{
  this->Window.GetRenderer()->SetBackground(1.0, 1.0, 1.0);
}

//------------------------------------------------------------------------------
std::string ChartPainter::Draw(const Chart& chart)
{
  vtkNew<vtkChartXY> plots;
  const auto x = FindRange(chart, 0);
  const auto y = FindRange(chart, 1);
  // An empty line between labels and title: VTK leaves too little room for labels of that size.
  SetUpAxis(plots->GetAxis(vtkAxis::BOTTOM), "\n" + chart.XTitle, x);
  SetUpAxis(plots->GetAxis(vtkAxis::LEFT), chart.YTitle + "\n", y);
  if (chart.Floor > 0.0)
  {
    CurveStyle thin;
    thin.Line = vtkPen::DOT_LINE;
    thin.Width = 1.0f;
    AddCurve(plots, thin, { { x[0], chart.Floor }, { x[1], chart.Floor } });
  }
  for (const ChartCurve& curve : chart.Curves)
  {
    AddCurve(plots, curve.Style, curve.Points);
  }

  vtkNew<vtkContextActor> actor;
  actor->GetScene()->AddItem(plots);
  actor->GetScene()->SetRenderer(this->Window.GetRenderer());
  this->Window.GetRenderer()->AddActor(actor);
  this->Window.Render();
  const auto picture = this->Window.Grab();
  this->Window.GetRenderer()->RemoveActor(actor);
  return BenchPictures::EncodePNG(picture);
}
