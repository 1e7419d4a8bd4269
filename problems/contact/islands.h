#pragma once

#include <vector>

#include "solvers/problem.h"

namespace lcp {

/// A part of an LCP that can be solved on its own.
struct Island {
  Problem problem;          ///< With the scales, covering vector and pivot limit of the whole.
  std::vector<Index> rows;  ///< Row k of `problem` is row rows[k] of the whole; ascending.
};

/// The LCP of some contacts of an LCP with friction blocks (ascending, at least one), without the
/// others: their rows and columns of M, their parts of W and vbar. The contacts left out exert no
/// force.
Island part_of_contacts(const Problem& problem, const std::vector<Index>& contacts);

/// Splits an LCP with friction blocks into sets of contacts that do not influence one another: the
/// connected components of the graph whose edges are W's 3 x 3 blocks with a non-zero entry.
/// Islands are ordered by their first contact, and each row belongs to exactly one. The solutions,
/// joined through `rows`, solve the whole.
///
/// A problem without friction blocks, or whose contacts are all connected, is one island with all
/// rows. Throws std::invalid_argument when the islands do not share out every row exactly once.
std::vector<Island> split_islands(const Problem& problem);

/// Whether that gives more than one; copies nothing.
bool has_islands(const Problem& problem);

}  // namespace lcp
