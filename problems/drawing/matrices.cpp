#include "problems/drawing/matrices.h"

#include "problems/decompositions.h"

namespace lcp {

MatrixXd uniform_matrix(Index rows, Index columns, Random& random) {
  MatrixXd A(rows, columns);
  for (Index j = 0; j < columns; ++j)
    for (Index i = 0; i < rows; ++i) A(i, j) = random.between(-1, 1);
  return A;
}

MatrixXd orthonormal_columns(Index rows, Index columns, Random& random) {
  return orthonormal_basis(uniform_matrix(rows, columns, random));
}

VectorXd spread_spectrum(Index size, double condition, Random& random) {
  VectorXd values = VectorXd::Ones(size);
  if (size > 1) values(1) = 1 / condition;
  for (Index i = 2; i < size; ++i) values(i) = std::pow(condition, -random.between(0, 1));
  return values;
}

MatrixXd gram_matrix(const MatrixXd& A) {
  MatrixXd S = MatrixXd::Zero(A.rows(), A.rows());
  S.selfadjointView<Eigen::Lower>().rankUpdate(A);
  S.triangularView<Eigen::StrictlyUpper>() = S.transpose();
  return S;
}

MatrixXd skew_matrix(Index n, Random& random) {
  const MatrixXd Q = orthonormal_columns(n, n, random);
  MatrixXd rotated = MatrixXd::Zero(n, n);  // Q times the block diagonal.
  for (Index k = 0; k + 1 < n; k += 2) {
    const double sigma = k == 0 ? 1 : random.between(0, 1);
    rotated.col(k) = -sigma * Q.col(k + 1);
    rotated.col(k + 1) = sigma * Q.col(k);
  }
  const MatrixXd K = rotated * Q.transpose();
  return (K - K.transpose()) / 2;
}

}  // namespace lcp
