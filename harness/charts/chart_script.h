#pragma once

#include <string>
#include <vector>

#include "harness/charts/chart.h"

namespace lcp {

/// What gnuplot draws a chart from.
struct ChartFiles {
  std::string script;
  std::string data;  ///< A data set per corpus, a line per solver.
};

/// Lays the chart of draw_chart out; the script reads its data from NAME.dat. Throws
/// std::invalid_argument when no corpus has a counted run.
ChartFiles chart_files(const std::vector<ChartPoint>& points, double tolerance,
                       const std::string& name);

}  // namespace lcp
