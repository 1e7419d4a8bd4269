#pragma once

#include <nlohmann/json.hpp>
#include <string>

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

/// `crossing`, `above`, ...
std::string to_string(ShareLine::Kind kind);

}  // namespace lcp
