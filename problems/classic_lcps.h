#pragma once

#include <string>

#include "solvers/problem.h"

namespace lcp {

/// LCPs of any size n that literature gives in closed form, with the solution that it states. M, q
/// and the solution are exact in double unless a function says otherwise.
struct ClassicLcp {
  MatrixXd M;
  VectorXd q;
  VectorXd solution;
  Index pivot_limit = 0;  ///< 2^(n+1) where pivots double with every row, else 0.
  std::string source;
};

/// Unit lower triangular with 2 below the diagonal.
MatrixXd unit_lower_with_twos(Index n);

/// M = unit_lower_with_twos, q_i = -(2^(n-i+1) + ... + 2^n), solution 2^n e_1: a P-matrix on which
/// Lemke takes exactly 2^n pivots and meets no tie. n in [1, 50].
ClassicLcp murty_exponential(Index n);

/// M = LL' (variant 1), LL' + 4 (2), LL' - 4 outside the first column (3) with L =
/// unit_lower_with_twos; q = -1, solution e_1 / M_11 (rounded in variant 2). Nearly every ratio test
/// is tied: the lexicographic rule takes 2^n pivots where the first index takes 2. n in [1, 50].
ClassicLcp fathi(int variant, Index n);

/// An M-matrix, 1 on and -1 below the diagonal, whose handicap grows exponentially, which slows
/// interior points down; solution 1, 0, 1 ...
ClassicLcp csizmadia(Index n);

/// A P-matrix with q = 1 on which the Newton-min method cycles from -e_1; z = 0 solves it. Circulant,
/// with 2 (n odd) or 4/3 and 1/2 (n even, 4/3 rounded) below the diagonal. n >= 3.
ClassicLcp ben_gharbia_gilbert(Index n);

}  // namespace lcp
