#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "harness/present/figure.h"
#include "harness/studies/frontier/frontier.h"

namespace lcp {

/// A frontier and, where it was repeated with another seed, the repetition.
struct FrontierReport {
  Frontier first;
  std::optional<Frontier> second;
};

/// For a terminal: per solver the line with its band in every column, and how much of it the second
/// seed reproduces.
std::string frontier_text(const FrontierReport& report);

/// A line per cell: solver, x, y, seed, draws, solved, interval, pivots, verdicts.
std::string frontier_csv(const FrontierReport& report);

/// Everything; infinite ends of bands and missing lines are null.
nlohmann::json frontier_json(const FrontierReport& report);

/// A panel per solver: the share solved in every cell as colour and number, the 50 % line with its
/// band, and in words how many columns have none.
Figure frontier_figure(const Frontier& frontier);

}  // namespace lcp
