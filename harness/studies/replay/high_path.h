#pragma once

#include <atomic>
#include <functional>

#include "harness/studies/replay/high_rule.h"

namespace lcp {

/// Limits of a run in 113 bits, and its observer.
struct HighLimits {
  double zero = 10;          ///< As in HighDictionary: in units of the estimated error.
  Index most_pivots = 1000;  ///< Pivots followed, or nodes checked.
  std::function<void(Index)> progress = [](Index) {};  ///< Pivots so far.
  const std::atomic<bool>* interrupted = nullptr;
};

/// A pivot taken in 113 bits.
struct HighPivot {
  Variable entering;
  Variable leaving;
  HighChoice choice;
};

/// The complementary path of a rule in 113 bits.
struct HighPath {
  std::vector<HighPivot> pivots;
  Claim claim = Claim::singular;
  bool cut_short = false;  ///< Stopped by most_pivots, interrupted or undecided: claims `limit`.
  bool undecided = false;  ///< 113 bits do not decide the next pivot.
  VectorXd z;              ///< n, of the last dictionary, in the problem's own units.
};

/// Follows the path from the dictionary of `alpha` as follow_complementary_path does
/// (solvers/linalg/complementary_path.h), each dictionary computed afresh from M and q.
HighPath follow_high_path(const Problem& problem, const PathRule& rule,
                          const std::vector<Index>& alpha, const HighLimits& limits);

/// z of a dictionary in the problem's own units, rounded to doubles.
VectorXd point_of(const HighDictionary& dictionary, const Problem& problem, bool scale);

/// The natural residual of the basic solution of alpha, where z_alpha and the other w are computed in
/// 113 bits and not rounded after: max_i max(0, -z_i / s_z,i, -w_i / s_w,i). Empty where
/// M_alpha,alpha is singular to 113 bits.
std::optional<double> basis_residual(const Problem& problem, const std::vector<Index>& alpha,
                                     double zero);

}  // namespace lcp
