#pragma once

#include "solvers/problem.h"

namespace lcp {

/// The 97.5 % quantile of the normal distribution: intervals hold 95 %.
inline constexpr double normal_quantile = 1.959963984540054;
/// The 99.95 % quantile: intervals hold 99.9 %.
inline constexpr double confirming_quantile = 3.2905267314919255;

struct Interval {
  double low = 0;
  double high = 1;
};

/// Wilson's interval of a share of which `count` in `trials` were seen, 0 <= count <= trials; [0, 1] of
/// no trial. Source: E. B. Wilson (1927), J. Amer. Statist. Assoc. 22, 209-212; R. G. Newcombe (1998),
/// Statistics in Medicine 17, 857-872 (method 3).
Interval wilson_interval(Index count, Index trials, double quantile = normal_quantile);

}  // namespace lcp
