#include "solvers/linalg/natural_residual.h"

#include <limits>

namespace lcp {

double natural_residual(const Problem& problem, const VectorXd& z, VectorXd& w) {
  w = problem.q;
  for (Index j = 0; j < z.size(); ++j)
    if (z(j) != 0) w += z(j) * problem.M.col(j);
  if (!z.allFinite() || !w.allFinite()) return std::numeric_limits<double>::infinity();
  if (z.size() == 0) return 0;
  return z.cwiseQuotient(problem.s_z).cwiseMin(w.cwiseQuotient(problem.s_w)).cwiseAbs().maxCoeff();
}

}  // namespace lcp
