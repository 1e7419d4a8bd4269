// A file of its own: Eigen's decomposition takes longer to compile than anything else here.

#include "problems/singular_values.h"

#include <Eigen/SVD>

namespace lcp {

VectorXd singular_values(const MatrixXd& matrix) {
  if (matrix.size() == 0) return VectorXd();
  return Eigen::BDCSVD<MatrixXd>(matrix).singularValues();
}

VectorXd small_singular_values(const MatrixXd& matrix) {
  if (matrix.size() == 0) return VectorXd();
  return Eigen::JacobiSVD<MatrixXd>(matrix).singularValues();
}

}  // namespace lcp
