#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "harness/present/columns.h"
#include "solvers/linalg/scaled_problem.h"

namespace lcp {

/// Name of a variable of a problem of size n, as printed: w_3, z_3 (rows count from 1), z0.
std::string variable_name(int variable, Index n);

/// Writes down the pivots of one solve.
class Trace {
 public:
  struct Options {
    Index largest_condition = 200;  ///< Rows above which no condition is computed: it costs n^3.
    /// Only steps first ... last - 1, counted from 0, have a condition.
    std::size_t first = 0, last = std::numeric_limits<std::size_t>::max();
  };
  struct Step {
    PivotEvent event;  ///< Its `basic` is gone.
    /// Largest over smallest singular value of the basis after the pivot, of the problem scaled by
    /// s_z and s_w, so that it has no units; infinite for a singular one.
    std::optional<double> condition;
  };

  explicit Trace(const Problem& problem) : Trace(problem, Options()) {}
  Trace(const Problem& problem, const Options& options);

  /// For Call::observer; valid as long as this object.
  Observer observer();

  const std::vector<Step>& steps() const { return steps_; }

  /// What is told of a step; valid as long as this object.
  std::vector<Column<Step>> columns() const;
  /// A line per pivot; with nodes and their parents where a search went back.
  std::string text() const;
  nlohmann::ordered_json json() const;

 private:
  double condition(const std::vector<int>& basic) const;

  ScaledProblem scaled_;
  Options options_;
  std::vector<Step> steps_;
};

}  // namespace lcp
