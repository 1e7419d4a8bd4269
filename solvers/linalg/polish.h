#pragma once

#include "solvers/linalg/scaled_problem.h"
#include "solvers/result.h"

namespace lcp {

/// Solves once more on the basis alpha of `result`: M_alpha,alpha z_alpha = -q_alpha with one step
/// of iterative refinement, negative z set to 0, w = M z + q recomputed. The new z is kept if its
/// natural residual is smaller. The basis is not changed. Returns the factorisations done (0 or 1).
Index polish(const Problem& problem, const ScaledProblem& scaled, Result& result);

}  // namespace lcp
