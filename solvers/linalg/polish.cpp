#include "solvers/linalg/polish.h"

#include <limits>

#include "solvers/linalg/start.h"

namespace lcp {

double natural_residual(const Problem& problem, const VectorXd& z, VectorXd& w) {
  w = problem.q;
  for (Index j = 0; j < z.size(); ++j)
    if (z(j) != 0) w += z(j) * problem.M.col(j);
  if (!z.allFinite() || !w.allFinite()) return std::numeric_limits<double>::infinity();
  if (z.size() == 0) return 0;
  return z.cwiseQuotient(problem.s_z).cwiseMin(w.cwiseQuotient(problem.s_w)).cwiseAbs().maxCoeff();
}

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
