#pragma once

#include <vector>

#include "problems/contact/islands.h"
#include "problems/instance.h"
#include "solvers/registry.h"

namespace lcp {

/// Solves the islands (at least one) of a problem of size n apart and joins their results: the claim is that of
/// the first island that fails, else `solved`; z, w, certificate and basis are put back into the
/// problem's rows (NaN where an island returned no z or w of its size; no basis unless every island
/// has one); work is summed; z0 is the largest in size, and the covering vector is scaled so that z0 c is
/// each island's own. One island that holds every row gives exactly what the solver returned.
///
/// `call` is in the problem's rows and numbering, and so is what its observer sees, but node numbers
/// begin anew in each island.
Result solve_islands(const Solver& solver, const std::vector<Island>& islands, Index n,
                     const Call& call = {});

/// Splits an instance into its islands and solves them in this process.
Result solve_instance(const Solver& solver, const Instance& instance, const Call& call = {});

}  // namespace lcp
