#pragma once

#include <optional>

#include "harness/present/described.h"
#include "harness/studies/frontier/frontier.h"

namespace lcp {

/// A frontier and, where it was repeated with another seed, the repetition.
struct FrontierReport {
  Frontier first;
  std::optional<Frontier> second;
};

/// Text: per solver the line with its band in every column, and how much of it the second seed
/// reproduces. CSV: a line per cell: solver, seed, x, y, draws, solved, interval, pivots, verdicts.
/// JSON: everything; infinite ends of bands and missing lines are null. Figure: frontier_figure.
Described described(const FrontierReport& report);

/// A panel per solver: the share solved in every cell as colour and number, the 50 % line with its
/// band, and in words how many columns have none.
Figure frontier_figure(const Frontier& frontier);

}  // namespace lcp
