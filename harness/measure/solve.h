#pragma once

#include <string>
#include <vector>

#include "problems/contact/islands.h"
#include "problems/instance.h"
#include "solvers/registry.h"

namespace lcp {

/// The basis or point from which an instance is solved.
enum class StartKind {
  cold,      ///< None.
  two_step,  ///< That of each island's frictionless LCP (problems/contact/two_step.h).
  previous,  ///< The solution of the frame before (Instance::previous).
};

/// Solves the islands (at least one) of a problem of size n apart and joins their results: the claim
/// is that of the first island that fails, else `solved`; z, w, certificate and basis are put back
/// into the problem's rows (NaN where an island returned no z or w of its size; no basis unless every
/// island has one); work is summed; z0 is the largest in size, and the covering vector is scaled so
/// that z0 c is each island's own. One island that holds every row gives exactly what the solver
/// returned.
///
/// `call` is in the problem's rows and numbering, and so is what its observer sees, but node numbers
/// begin anew in each island.
///
/// With StartKind::two_step each island is solved in two steps by itself, but one whose contacts have
/// no friction, beside others that have some, is its own frictionless LCP and solved once, cold.
/// With StartKind::previous each island starts from its rows of `previous`. Where there is none, it
/// starts from the empty basis and z = 0, that is cold: it counts one restart more, and the message
/// begins with `no previous solution; started cold`; a refusal of any start stays `unsupported`.
/// Both throw std::invalid_argument when `call` holds a start too.
Result solve_islands(const Solver& solver, const std::vector<Island>& islands, Index n,
                     const Call& call = {}, StartKind start = StartKind::cold,
                     const std::optional<Start>& previous = {});

/// Splits an instance into its islands and solves them in this process.
Result solve_instance(const Solver& solver, const Instance& instance, const Call& call = {},
                      StartKind start = StartKind::cold);

}  // namespace lcp
