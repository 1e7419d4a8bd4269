#pragma once

#include <string>
#include <vector>

#include "harness/studies/sheet/chart_panels.h"

namespace lcp {

/// What gnuplot draws a chart from.
struct ChartFiles {
  std::string script;
  std::string data;  ///< Three data sets per panel: a line per setting, the ladders, the stairs.
};

/// Lays the chart of draw_chart out; the script reads its data from NAME.dat.
ChartFiles chart_files(const std::vector<ChartPanel>& panels, const Sheet& sheet,
                       const std::string& name);

}  // namespace lcp
