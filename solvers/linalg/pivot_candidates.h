#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "solvers/problem.h"

namespace lcp {

/// |x| below which exp(-x) - 1 = -x + x^2 / 2 to a relative 2e-17.
constexpr double kShortSeries = 1e-8;

/// Two rows at a time, as every x86-64 can.
using Pair = double __attribute__((vector_size(16)));

inline Pair pair_at(const double* from) {
  Pair pair;
  std::memcpy(&pair, from, sizeof(Pair));
  return pair;
}

inline Pair both(double x) { return Pair{x, x}; }

/// Which pivots a search may take, and what they cost.
struct Pricing {
  double epsilon = 0;          ///< min q' may fall to -epsilon.
  double grid = 1;             ///< Costs are whole multiples of this.
  bool clean_is_free = false;  ///< A pivot with q_min above -grid/2 costs 0, never less.
  bool as_printed = false;     ///< exp(-q_min) instead of exp(-q_min) - 1.

  /// Of a pivot that leaves q_min, in units of the grid.
  std::int64_t cost(double q_min) const {
    // Where the series ends with its second term in doubles, most of the time, it is taken.
    double excess = std::abs(q_min) < kShortSeries ? q_min * (0.5 * q_min - 1) : std::expm1(-q_min);
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

/// That interval, from -epsilon on, and `ratios` = -q' / m'. Without branches, since the signs of m'
/// follow no pattern, and four rows at a time, since each minimum waits for the one before.
inline RatioInterval ratio_interval(const VectorXd& q, const VectorXd& m, double epsilon,
                                    VectorXd& ratios) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  struct Bounds {
    Pair low, high;
    decltype(both(0) < both(0)) stuck;
    double epsilon;

    /// Returns -q' / m' of the two rows.
    Pair add(Pair qk, Pair mk) {
      const Pair inverse = 1.0 / mk, room = qk + epsilon, bound = -room * inverse;
      const Pair above = mk < 0.0 ? bound : both(infinity);
      const Pair below = mk > 0.0 ? bound : both(-infinity);
      high = above < high ? above : high;
      low = below > low ? below : low;
      stuck |= (mk == 0.0) & ~(room > 0.0);
      return -qk * inverse;
    }
  };
  const Index n = q.size();
  ratios.resize(n);
  const Bounds none{both(-epsilon), both(infinity), both(0) < both(0), epsilon};
  Bounds even = none, odd = none;
  Index k = 0;
  for (; k + 4 <= n; k += 4) {
    const Pair first = even.add(pair_at(q.data() + k), pair_at(m.data() + k));
    const Pair second = odd.add(pair_at(q.data() + k + 2), pair_at(m.data() + k + 2));
    std::memcpy(ratios.data() + k, &first, sizeof(Pair));
    std::memcpy(ratios.data() + k + 2, &second, sizeof(Pair));
  }
  for (; k < n; ++k)  // next to a row that bounds nothing
    ratios(k) = even.add(Pair{q(k), infinity}, Pair{m(k), 1})[0];
  const auto stuck = even.stuck | odd.stuck;
  const Pair low = even.low > odd.low ? even.low : odd.low;
  const Pair high = even.high < odd.high ? even.high : odd.high;
  return {std::max(low[0], low[1]), std::min(high[0], high[1]), (stuck[0] | stuck[1]) != 0};
}

/// min over k of q'_k + theta m'_k, without row `but`.
inline double least_after(const VectorXd& q, const VectorXd& m, double theta, Index but) {
  Pair even = both(std::numeric_limits<double>::infinity()), odd = even;
  const auto over = [&](Index k, Index end) {
    for (; k + 4 <= end; k += 4) {
      const Pair first = pair_at(q.data() + k) + theta * pair_at(m.data() + k);
      const Pair second = pair_at(q.data() + k + 2) + theta * pair_at(m.data() + k + 2);
      even = first < even ? first : even;
      odd = second < odd ? second : odd;
    }
    for (; k < end; ++k) even[0] = std::min(even[0], q(k) + theta * m(k));
  };
  over(0, but);
  over(but + 1, q.size());
  return std::min({even[0], even[1], odd[0], odd[1]});
}

/// Appends the rows whose ratio lies strictly within the interval.
template <class Append>
void rows_within(const VectorXd& ratios, const RatioInterval& interval, const Append& append) {
  const Pair low = both(interval.low), high = both(interval.high);
  const auto add = [&](Index i) {
    if ((ratios(i) > interval.low) & (ratios(i) < interval.high)) append(i);
  };
  const Index n = ratios.size();
  Index i = 0;
  for (; i + 4 <= n; i += 4) {
    const Pair first = pair_at(ratios.data() + i), second = pair_at(ratios.data() + i + 2);
    const auto inside = ((first > low) & (first < high)) | ((second > low) & (second < high));
    if ((inside[0] | inside[1]) == 0) continue;
    for (Index k = i; k < i + 4; ++k) add(k);
  }
  for (; i < n; ++i) add(i);
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
  rows_within(ratios, interval, [&](Index i) {
    if (!blocks(m(i))) return;
    candidates.push_back({i, ratios(i), 0});
    least = std::min(least, ratios(i));
    largest = std::max(largest, ratios(i));
  });
  if (candidates.empty()) return;

  const double clean = std::min(pricing.grid / 4, pricing.epsilon);
  if (candidates.size() > 2 && largest < clean && (q + least * m).minCoeff() > -clean &&
      (q + largest * m).minCoeff() > -clean) {
    const std::int64_t nothing = pricing.cost(0);
    for (PivotCandidate& candidate : candidates) candidate.cost = nothing;
    return;
  }
  std::size_t kept = 0;
  for (PivotCandidate candidate : candidates) {
    const double q_min =
        std::min(candidate.ratio, least_after(q, m, candidate.ratio, candidate.row));
    if (!(q_min > -pricing.epsilon)) continue;
    candidate.cost = pricing.cost(q_min);
    candidates[kept++] = candidate;
  }
  candidates.resize(kept);
}

}  // namespace lcp
