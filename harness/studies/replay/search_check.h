#pragma once

#include "harness/studies/replay/replay.h"

namespace lcp {

/// What a search may take: a row with m'_i < -pivot (any that c covers, in Step 0) whose pivot leaves
/// min q' > -epsilon (Yamane and Nakamura 2008, Algorithm 2).
struct SearchRule {
  double epsilon = 0;
  double pivot = 0;
  bool scale = false;
};

/// The rule of a row that searches, with the options it is set to; empty for other rows.
std::optional<SearchRule> search_rule(const NamedSolver& solver);

/// Whether a pivot is one by itself, whatever the rule: `size` and `ratio` of it are filled in, and the
/// answer is zero_pivot or no_pivot where its m'_s is 0 or not below minus `pivot` (of z0: not above 0).
/// `m` is the column of the driving variable.
std::optional<Departure::Why> fault_of_pivot(const HighDictionary& dictionary, const Estimates& m,
                                             const PivotEvent& event, double pivot, double zero,
                                             Departure& departure);

/// The first of the run's pivots that the rule does not allow in 113 bits, each from the basis that the
/// search stood at: of its parent after the parent's own pivot, of the first that of `alpha`. Looks at
/// no more than HighLimits::most_pivots; `checked` is how many they were. Whether an allowed one was
/// the best choice is not asked.
std::optional<Departure> check_search(const Problem& problem, const SearchRule& rule,
                                      const std::vector<Index>& alpha,
                                      const std::vector<Trace::Step>& steps,
                                      const HighLimits& limits, std::size_t& checked);

}  // namespace lcp
