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

/// Labels before each of the first `most` pivots of a search (and before those of a path): those of its
/// parent after its own pivot. `alpha` is the starting basis.
std::vector<Labels> labels_before(const std::vector<Trace::Step>& steps, Index n,
                                  const std::vector<Index>& alpha, std::size_t most);

/// The first of these pivots that the rule does not allow in 113 bits, each from the basis that the
/// search stood at. Whether an allowed one was the best choice is not asked. `checked` is how many were
/// looked at.
std::optional<Departure> check_search(const Problem& problem, const SearchRule& rule,
                                      const std::vector<Index>& alpha,
                                      const std::vector<Trace::Step>& steps,
                                      const std::vector<Labels>& before, const HighLimits& limits,
                                      std::size_t& checked);

}  // namespace lcp
