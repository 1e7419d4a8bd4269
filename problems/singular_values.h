#pragma once

#include "solvers/problem.h"

namespace lcp {

/// Singular values of a matrix in descending order, O(n^3); none of an empty one.
VectorXd singular_values(const MatrixXd& matrix);

}  // namespace lcp
