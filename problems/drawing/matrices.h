#pragma once

#include "problems/drawing/random.h"

namespace lcp {

/// Entries uniform in [-1, 1), drawn column by column.
MatrixXd uniform_matrix(Index rows, Index columns, Random& random);

/// rows x columns with orthonormal columns: Q of a uniform matrix. columns <= rows.
MatrixXd orthonormal_columns(Index rows, Index columns, Random& random);

/// 1, 1 / condition, and the others in between, uniform on a logarithmic scale; 1 alone where size
/// is 1. condition >= 1.
VectorXd spread_spectrum(Index size, double condition, Random& random);

/// A A', symmetric to the bit.
MatrixXd gram_matrix(const MatrixXd& A);

/// Skew-symmetric to the bit, of spectral norm 1: pairs of eigenvalues +-i sigma, the largest sigma
/// 1 and the others uniform in [0, 1). 0 where n is 1.
MatrixXd skew_matrix(Index n, Random& random);

}  // namespace lcp
