#pragma once

#include "solvers/problem.h"

namespace lcp {

/// Singular values of a matrix in descending order, none of an empty one. O(n^3); each is right to
/// rounding of the largest, so that small ones may come out as 0.
VectorXd singular_values(const MatrixXd& matrix);

/// The same by Jacobi rotations, slower, which tell the small ones apart too.
VectorXd small_singular_values(const MatrixXd& matrix);

}  // namespace lcp
