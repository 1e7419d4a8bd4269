#include "problems/decompositions.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <Eigen/SVD>

namespace lcp {

using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd singular_values(const MatrixXd& matrix) {
  if (matrix.size() == 0) return VectorXd();
  return Eigen::BDCSVD<MatrixXd>(matrix).singularValues();
}

VectorXd small_singular_values(const MatrixXd& matrix) {
  if (matrix.size() == 0) return VectorXd();
  return Eigen::JacobiSVD<MatrixXd>(matrix).singularValues();
}

SymmetricEigen symmetric_eigen(const MatrixXd& matrix) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> found(matrix);
  return {found.eigenvalues(), found.eigenvectors()};
}

MatrixXd orthonormal_basis(const MatrixXd& A) {
  return Eigen::HouseholderQR<MatrixXd>(A).householderQ() * MatrixXd::Identity(A.rows(), A.cols());
}

}  // namespace lcp
