#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/present/curve.h"
#include "harness/present/tag_placement.h"
#include "harness/studies/sheet/sheet.h"

namespace lcp {

/// One setting in a panel of the chart.
struct ChartPoint {
  int number = 0;  ///< Of the setting, from 1: its tag.
  int row = 0;     ///< Of the registry row, from 0: its colour and marker.
  std::string label;
  Mass mass;
  std::optional<Spread> cost, residual;
  bool front = false;
  bool listed = true;  ///< In colour, with a tag and a line in the list.
};

/// A line on a panel: settings of a ladder, or the stairs of the front.
struct ChartLine {
  int row = 0;
  bool listed = true;            ///< One of its settings is.
  std::vector<Pixels> vertices;  ///< Cost, residual: in data coordinates.
};

struct ChartPanel {
  std::string title;
  std::vector<ChartPoint> points;
  std::vector<ChartLine> ladders;  ///< Those with a listed setting.
  std::vector<Pixels> stairs;      ///< Of the front among the settings that solve the most.
  LogRange cost, residual;

  std::size_t lines() const;  ///< In the list beside it.
  Index counted() const;      ///< Most of any setting.
  double height() const;
  /// What is not listed, summed up; empty where all are.
  Mass others() const;
};

/// Width of the plot in pixels, and of a line in the list; heights follow from the number of lines.
inline constexpr double chart_width = 500, chart_line_height = 18;

/// A panel per drawn group. Costs and residuals of 0 stand at `cost_floor` and `residual_floor`.
std::vector<ChartPanel> chart_panels(const Sheet& sheet);

/// Where 0 stands on an axis of costs.
double cost_floor(Measure measure);

double shown_residual(double residual);
double shown_cost(double cost, Measure measure);

/// Where the tags of a panel's listed points stand, in data coordinates; NaN for the others.
std::vector<Pixels> tag_positions(const ChartPanel& panel, Measure measure);

}  // namespace lcp
