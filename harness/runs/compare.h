#pragma once

#include <string>
#include <vector>

#include "harness/record.h"

namespace lcp {

/// From where on a change counts.
struct CompareOptions {
  double pivot_growth = 0.05;  ///< Share by which pivots may grow.
  double time_ratio =
      1.25;  ///< Median over median; the ranges of the samples must be disjoint too.
};

/// A pair that got worse from one run to the next.
struct Regression {
  enum class Kind {
    lost,    ///< It was solved and is not.
    pivots,  ///< Solved in both, with more pivots.
    time,    ///< Solved in both, and slower.
  };

  Kind kind;
  PairKey pair;
  double ratio = 0;  ///< New over old; 0 for `lost`.
  std::string before;
  std::string after;
};

struct Comparison {
  std::vector<Regression> regressions;  ///< Worst first: lost, then pivots, then time by ratio.
  std::size_t compared = 0;             ///< Pairs in both runs.
  std::size_t gained = 0;               ///< Solved in the new run only.
  std::size_t only_old = 0;             ///< Pairs without a row in the new run.
  std::size_t only_new = 0;
};

const char* to_string(Regression::Kind kind);

/// Compares the pairs that two runs have in common, by instance, content, solver and start. A pair
/// may appear once for each thing that got worse. Throws std::invalid_argument when the rows were
/// judged at different tolerances.
Comparison compare(const std::vector<Record>& before, const std::vector<Record>& after,
                   const CompareOptions& options = {});

}  // namespace lcp
