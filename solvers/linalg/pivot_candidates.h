#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
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

  /// Of a pivot that leaves q_min, in units of the grid.
  std::int64_t cost(double q_min) const {
    double excess = std::expm1(-q_min);
    if (clean_is_free) excess = std::max(0.0, excess);
    return std::llround(excess / grid) + (as_printed ? std::llround(1 / grid) : 0);
  }
};

/// A row that may be pivoted on: Algorithm 2, lines 3-5.
struct PivotCandidate {
  Index row;
  double ratio;
  std::int64_t cost;  ///< In units of the grid.
};

/// The values of theta for which every q'_k + theta m'_k stays above -epsilon.
struct RatioInterval {
  double low, high;
  bool empty = false;  ///< Some q'_k <= -epsilon that m' does not move.
};

/// That interval, from -epsilon on, and `ratios` = -q' / m'. Two rows at a time, without branches: the
/// signs of m' follow no pattern.
inline RatioInterval ratio_interval(const VectorXd& q, const VectorXd& m, double epsilon,
                                    VectorXd& ratios) {
  using Pair = double __attribute__((vector_size(16)));
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Index n = q.size();
  ratios.resize(n);
  Pair low = {-epsilon, -epsilon}, high = {infinity, infinity};
  bool empty = false;
  for (Index k = 0; k < n; k += 2) {
    const std::size_t bytes = (k + 1 < n ? 2 : 1) * sizeof(double);
    Pair mk = {1, 1}, qk = {infinity, infinity};  // a row that bounds nothing, where n is odd
    if (bytes == sizeof(Pair)) {
      std::memcpy(&mk, m.data() + k, sizeof(Pair));
      std::memcpy(&qk, q.data() + k, sizeof(Pair));
    } else {
      mk[0] = m(k);
      qk[0] = q(k);
    }
    const Pair inverse = 1.0 / mk, room = qk + epsilon, bound = -room * inverse,
               ratio = -qk * inverse;
    const auto negative = mk < 0.0, positive = mk > 0.0;
    const Pair above = negative ? bound : Pair{infinity, infinity};
    const Pair below = positive ? bound : Pair{-infinity, -infinity};
    high = above < high ? above : high;
    low = below > low ? below : low;
    const auto stuck = (mk == 0.0) & ~(room > 0.0);
    empty |= (stuck[0] | stuck[1]) != 0;
    std::memcpy(ratios.data() + k, &ratio, bytes);
  }
  return {std::max(low[0], low[1]), std::min(high[0], high[1]), empty};
}

/// min over k of q'_k + theta m'_k, without row `but`.
inline double least_after(const VectorXd& q, const VectorXd& m, double theta, Index but) {
  const Index rest = q.size() - but - 1;
  double least = std::numeric_limits<double>::infinity();
  if (but > 0) least = (q.head(but) + theta * m.head(but)).minCoeff();
  if (rest > 0) least = std::min(least, (q.tail(rest) + theta * m.tail(rest)).minCoeff());
  return least;
}

/// The rows i whose pivot leaves min q' > -epsilon; `blocks(m_i)` says which sign of m'_i can block.
///
/// With theta_i = -q'_i / m'_i every q'_k + theta_i m'_k must stay above -epsilon. The values of
/// theta that allow this for all k form an interval, found in one pass; q_min is then computed for
/// the few rows inside: O(n) each. Many of them tie where contact is degenerate, and cost nothing:
/// min q' is a concave function of theta, so where it is clean at the least and the largest ratio it is
/// so between, and no more is computed.
///
/// `ratios` is room to work in, `candidates` what is found, by rows.
///
/// Source: K. Yamane, Y. Nakamura (2008), III, Algorithm 2.
template <class Blocks>
void find_candidates(const VectorXd& q, const VectorXd& m, const Blocks& blocks,
                     const Pricing& pricing, VectorXd& ratios,
                     std::vector<PivotCandidate>& candidates) {
  candidates.clear();
  const RatioInterval interval = ratio_interval(q, m, pricing.epsilon, ratios);
  if (interval.empty) return;
  double least = std::numeric_limits<double>::infinity(), largest = -least;
  for (Index i = 0; i < q.size(); ++i) {
    const double theta = ratios(i);
    if (!((theta > interval.low) & (theta < interval.high))) continue;
    if (!blocks(m(i))) continue;
    candidates.push_back({i, theta, 0});
    least = std::min(least, theta);
    largest = std::max(largest, theta);
  }
  if (candidates.empty()) return;

  const double clean = std::min(pricing.grid / 4, pricing.epsilon);
  if (candidates.size() > 2 && largest < clean &&
      (q + least * m).minCoeff() > -clean && (q + largest * m).minCoeff() > -clean) {
    for (PivotCandidate& candidate : candidates) candidate.cost = pricing.cost(0);
    return;
  }
  std::size_t kept = 0;
  for (PivotCandidate candidate : candidates) {
    const double q_min = std::min(candidate.ratio,
                                  least_after(q, m, candidate.ratio, candidate.row));
    if (!(q_min > -pricing.epsilon)) continue;
    candidate.cost = pricing.cost(q_min);
    candidates[kept++] = candidate;
  }
  candidates.resize(kept);
}

}  // namespace lcp
