#pragma once

#include <functional>
#include <vector>

#include "solvers/result.h"

namespace lcp {

/// Results of the two steps of IV-C.
struct TwoStep {
  Result frictionless;
  Result frictional;  ///< The answer; its work holds the pivots of the first step apart.
};

/// Contacts of a frictionless solution from which the LCP with friction can start: of `active`, those
/// whose rows of the normal matrix W_nn are independent (pivoted Cholesky, the largest remaining
/// diagonal first, until it is at most `tolerance` times the first). Where more normals are active
/// than the bodies have freedoms, all of them together are a singular basis that rounding in W passes
/// off as a regular one (condition 1e11), from which pivoting rules fail. Ascending.
/// Cost: O(|active|^3).
std::vector<Index> independent_contacts(const std::vector<Index>& active, const MatrixXd& W_nn,
                                        double tolerance);

/// Tolerance of independent_contacts: far above the noise of W, far below what contacts differ by.
inline constexpr double kIndependentContacts = 1e-8;

/// Two-step solve of a friction LCP (25): first the frictionless LCP of the same contacts
/// (frictionless_part), then the whole from the basis alpha = {row of a_i : a_i basic there, the
/// independent_contacts of them} and the point z with a as it is there and all else 0, both by `solve`, which is Solver::solve or does the same. `observer`
/// sees the pivots of the second step.
///
/// Where the first step returned no basis, as of iterative methods, the start is that point alone
/// (alpha is empty). Where it is not claimed solved, the second starts from the empty basis and
/// z = 0, that is cold: it counts one restart more, and its message begins with `frictionless LCP:
/// CLAIM; started cold`. A start that the solver cannot use, or a refusal of any start, stays its own
/// claim. Where no contact has friction, the answer is z = 0 with the claim `unsupported`.
///
/// work.frictionless_pivots are the pivots of the first step; no other work of it is counted.
/// Source: Yamane and Nakamura 2008, IV-C.
TwoStep solve_two_step(const std::function<Result(const Problem&, const Call&)>& solve,
                       const Problem& problem, const Observer& observer = {});

}  // namespace lcp
