// A file of its own: Eigen's decompositions take long to compile.

#include "tests/problems/families/independent.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

namespace lcp::independent {

VectorXd eigenvalues(const MatrixXd& symmetric) {
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
}

VectorXd singular_values(const MatrixXd& M) {
  return Eigen::JacobiSVD<MatrixXd>(M).singularValues();
}

}  // namespace lcp::independent
