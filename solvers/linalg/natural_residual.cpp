#include "solvers/linalg/natural_residual.h"

#include <limits>

#include "solvers/linalg/columns.h"

namespace lcp {

double natural_residual(const Problem& problem, const VectorXd& z, VectorXd& w) {
  std::vector<Index> columns;
  std::vector<double> coefficients;
  const Index positive = (z.array() != 0).count();
  columns.reserve(positive);
  coefficients.reserve(positive);
  for (Index j = 0; j < z.size(); ++j) {
    if (z(j) == 0) continue;
    columns.push_back(j);
    coefficients.push_back(z(j));
  }
  w = problem.q;
  add_columns(problem.M, columns, coefficients.data(), w);
  if (!z.allFinite() || !w.allFinite()) return std::numeric_limits<double>::infinity();
  if (z.size() == 0) return 0;
  return z.cwiseQuotient(problem.s_z).cwiseMin(w.cwiseQuotient(problem.s_w)).cwiseAbs().maxCoeff();
}

}  // namespace lcp
