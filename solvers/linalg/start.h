#pragma once

#include <vector>

#include "solvers/linalg/scaled_problem.h"

namespace lcp {

/// The rows 0 ... n-1 that are not in `alpha`.
std::vector<Index> complement_of(const std::vector<Index>& alpha, Index n);

/// The covering vector in original rows whose column in the dictionary of `alpha` is 1:
/// c_alpha = -M_alpha,alpha 1, c_rest = 1 - M_rest,alpha 1; the problem's own where alpha is empty.
VectorXd covering_of(const ScaledProblem& problem, const std::vector<Index>& alpha);

/// Sorted alpha of a starting basis; throws std::invalid_argument on an index out of range or
/// repeated.
std::vector<Index> checked_alpha(const std::vector<Index>& alpha, Index n);

/// Smallest |u_ii| of the factors of an LU decomposition; infinity for a 0 x 0 matrix, NaN if any
/// factor is not finite.
double smallest_pivot(const Eigen::Ref<const MatrixXd>& factors);

}  // namespace lcp
