#pragma once

#include "solvers/problem.h"

namespace lcp {

/// max_i |min(z_i / s_z,i, w_i / s_w,i)| with w = M z + q, which is handed back, in double: the natural
/// residual as far as a method can see it itself. Infinite if anything is not finite. Costs n for each
/// z_j that is not 0.
double natural_residual(const Problem& problem, const VectorXd& z, VectorXd& w);

}  // namespace lcp
