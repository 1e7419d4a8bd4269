#pragma once

#include "solvers/linalg/scaled_problem.h"
#include "solvers/result.h"

namespace lcp {

/// Solves once more on the basis alpha of `result`: M_alpha,alpha z_alpha = -q_alpha with one step
/// of iterative refinement, negative z set to 0, w = M z + q recomputed. The new z is kept if its
/// natural residual is smaller. The basis is not changed. Returns the factorisations done (0 or 1).
Index polish(const Problem& problem, const ScaledProblem& scaled, Result& result);

/// max_i |min(z_i / s_z,i, w_i / s_w,i)| with w = M z + q in double: the natural residual as far as
/// double precision shows it. Infinite if anything is not finite.
double natural_residual(const Problem& problem, const VectorXd& z, VectorXd& w);

}  // namespace lcp
