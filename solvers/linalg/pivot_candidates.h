#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "solvers/problem.h"

namespace lcp {

/// Which pivots a search may take, and what they cost.
struct Pricing {
  double epsilon = 0;          ///< min q' may fall to -epsilon.
  double grid = 1;             ///< Costs are whole multiples of this.
  bool clean_is_free = false;  ///< A pivot with q_min above -grid/2 costs 0, and none less.
  bool as_printed = false;     ///< exp(-q_min) instead of exp(-q_min) - 1.
};

/// A row that may be pivoted on: Algorithm 2, lines 3-5.
struct PivotCandidate {
  Index row;
  double ratio;
  std::int64_t cost;  ///< In units of the grid.
};

/// The rows i whose pivot leaves min q' > -epsilon; `blocks(m_i)` says which sign of m'_i can block.
///
/// With theta_i = -q'_i / m'_i every q'_k + theta_i m'_k must stay above -epsilon. The values of
/// theta that allow this for all k form an interval, found in one pass; q_min is then computed for
/// the few rows inside: O(n) each.
///
/// Source: K. Yamane, Y. Nakamura (2008), III, Algorithm 2.
template <class Blocks>
std::vector<PivotCandidate> candidates_of(const VectorXd& q, const VectorXd& m,
                                          const Blocks& blocks, const Pricing& pricing) {
  double low = -pricing.epsilon, high = std::numeric_limits<double>::infinity();
  for (Index k = 0; k < q.size(); ++k) {
    if (m(k) == 0 && !(q(k) > -pricing.epsilon)) return {};
    if (m(k) == 0) continue;
    const double bound = -(q(k) + pricing.epsilon) / m(k);
    if (m(k) < 0) {
      high = std::min(high, bound);
    } else {
      low = std::max(low, bound);
    }
  }
  std::vector<PivotCandidate> candidates;
  for (Index i = 0; i < q.size(); ++i) {
    if (!blocks(m(i))) continue;
    const double theta = -q(i) / m(i);
    if (!(theta > low && theta < high)) continue;
    double q_min = theta;
    for (Index k = 0; k < q.size(); ++k)
      if (k != i) q_min = std::min(q_min, q(k) + theta * m(k));
    if (!(q_min > -pricing.epsilon)) continue;
    double cost = std::expm1(-q_min);
    if (pricing.clean_is_free) cost = std::max(0.0, cost);
    std::int64_t units = std::llround(cost / pricing.grid);
    if (pricing.as_printed) units += std::llround(1 / pricing.grid);
    candidates.push_back({i, theta, units});
  }
  return candidates;
}

}  // namespace lcp
