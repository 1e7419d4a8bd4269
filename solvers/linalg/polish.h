#pragma once

#include "solvers/linalg/basis.h"
#include "solvers/result.h"

namespace lcp {

/// Solves once more on the basis alpha of `result`, at which `basis` stands without z0:
/// M_alpha,alpha z_alpha = -q_alpha, factorised afresh, with one step of iterative refinement, negative
/// z set to 0, w = M z + q recomputed. The new z is kept if its natural residual is at rounding level,
/// or smaller than before. The basis is not changed; factorisations are added to the result's work.
void polish(const Problem& problem, const ScaledProblem& scaled, Basis& basis, Result& result);

}  // namespace lcp
