#pragma once

#include <Eigen/Core>

namespace lcp {

// Eigen's decompositions, compiled once: they take longer than anything else here.

/// Singular values of a matrix in descending order, none of an empty one. O(n^3); each is right to
/// rounding of the largest, so that small ones may come out as 0.
Eigen::VectorXd singular_values(const Eigen::MatrixXd& matrix);

/// The same by Jacobi rotations, slower, but accurate for small ones too.
Eigen::VectorXd small_singular_values(const Eigen::MatrixXd& matrix);

/// Eigenvalues of a symmetric matrix, ascending, and their vectors, orthonormal, as columns. The lower
/// triangle is read.
struct SymmetricEigen {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& matrix);

/// Q of A = Q R by Householder reflections, as large as A: orthonormal columns, which span A's where those
/// are independent. At least as many rows as columns.
Eigen::MatrixXd orthonormal_basis(const Eigen::MatrixXd& A);

}  // namespace lcp
