#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/runs/record.h"

namespace lcp {

/// Quartiles and median over the instances that a solver solved.
struct Spread {
  double low = 0;
  double median = 0;
  double high = 0;
};

/// One solver setting on one corpus, as a point of the chart of time against accuracy.
struct ChartPoint {
  std::string corpus;
  /// Registry row, with ` [START]` where rows start differently: points of one row share a colour and
  /// are joined.
  std::string row;
  std::string label;  ///< As in the table.
  Index counted = 0;  ///< success + failure of the table.
  Index failed = 0;
  std::optional<Spread> time_ms;   ///< Of one solve; empty when nothing was solved.
  std::optional<Spread> residual;  ///< Natural residual, scaled; exact zeros stay 0.
};

/// By corpus, then by solver, each in order of first appearance.
std::vector<ChartPoint> chart_points(const std::vector<Record>& records);

/// Smallest residual that the chart tells from zero; what is below is drawn there.
constexpr double residual_floor = 1e-18;

/// Draws `points` with gnuplot: a panel per corpus, median time against median residual on log axes,
/// quartiles as bars, and beside it the failures of every solver. Writes `svg`, and the script and
/// the data it is made from beside it (.gp, .dat), so that it can be restyled:
/// `gnuplot chart.gp > chart.svg`. Throws UnwritableOutput where they cannot be written or gnuplot
/// is missing or fails, and std::invalid_argument when no corpus has a counted run.
void draw_chart(const std::vector<ChartPoint>& points, double tolerance,
                const std::filesystem::path& svg);

}  // namespace lcp
