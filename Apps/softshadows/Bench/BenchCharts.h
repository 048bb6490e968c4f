// SPDX-License-Identifier: BSD-3-Clause
// The plots of the report, drawn by VTK's charts.

#ifndef BenchCharts_h
#define BenchCharts_h

#include "OffscreenWindow.h"

#include "vtkPen.h"
#include "vtkPlotPoints.h"

#include <array>
#include <string>
#include <vector>

/** How a curve looks. */
struct CurveStyle
{
  std::array<unsigned char, 3> Colour = { 0, 0, 0 };
  unsigned char Opacity = 255;
  int Marker = vtkPlotPoints::NONE;
  bool IsHollow = false; // the marker
  int Line = vtkPen::SOLID_LINE;
  float Width = 2.0f; // pixels
};

struct ChartCurve
{
  CurveStyle Style;
  std::vector<std::array<double, 2>> Points; // > 0
};

/** Curves over two logarithmic axes. Later ones lie above earlier ones. */
struct Chart
{
  std::string XTitle;
  std::string YTitle;
  std::vector<ChartCurve> Curves;
  double Floor = 0.0; // a thin line at this height, unless 0
};

/** Draws charts, all in one window. */
class ChartPainter
{
public:
  /** Failure where there is no display to draw with. */
  ChartPainter();

  /** A PNG file in base64. The chart needs a point. Failure if it cannot be drawn. */
  std::string Draw(const Chart& chart);

  /** Pixels of the page; the file has twice as many, for dense screens and paper. */
  static constexpr int Width = 560;
  static constexpr int Height = 380;

private:
  OffscreenWindow Window;
};

#endif
