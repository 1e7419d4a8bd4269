#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/instance.h"
#include "solvers/result.h"

namespace lcp {

/// How one solver ends on a published instance, as literature, theory or exact rational arithmetic
/// states it. What is not stated is empty.
struct ExpectedOutcome {
  std::string solver;  ///< Full spelling.
  Claim claim;
  std::optional<Index> pivots = {};  ///< The one that brings z0 in included.
  std::optional<VectorXd> z = {};
};

struct PublishedInstance {
  Instance instance;  ///< Called published/NAME; provenance holds `source` and perhaps `note`.
  std::vector<ExpectedOutcome> expected;
};

/// Every small LCP from books, papers and test suites that we know with its data: problems that
/// cycle, end on a ray although they have a solution, tie, or take exponentially many pivots.
const std::vector<PublishedInstance>& published_instances();

}  // namespace lcp
