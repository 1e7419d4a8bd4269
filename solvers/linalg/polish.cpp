#include "solvers/linalg/polish.h"

#include "solvers/linalg/natural_residual.h"
#include "solvers/linalg/start.h"

namespace lcp {

Index polish(const Problem& problem, const ScaledProblem& scaled, Result& result) {
  const std::vector<Index>& alpha = *result.basis;
  if (alpha.empty()) return 0;
  const MatrixXd kernel = scaled.M()(alpha, alpha);
  const VectorXd q_alpha = scaled.q()(alpha);
  const Eigen::PartialPivLU<MatrixXd> lu(kernel);
  if (!(smallest_pivot(lu.matrixLU()) > 0)) return 1;
  VectorXd z_alpha = -lu.solve(q_alpha);
  z_alpha -= lu.solve(kernel * z_alpha + q_alpha);

  VectorXd z = VectorXd::Zero(problem.size()), w = z, covering = z;
  z(alpha) = z_alpha.cwiseMax(0.0);
  scaled.unscale(z, w, covering);
  VectorXd old_w;
  const double old_residual = natural_residual(problem, result.z, old_w);
  if (natural_residual(problem, z, w) < old_residual) {
    result.z = z;
    result.w = w;
  }
  return 1;
}

}  // namespace lcp
