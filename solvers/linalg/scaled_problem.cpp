#include "solvers/linalg/scaled_problem.h"

namespace lcp {

ScaledProblem::ScaledProblem(const Problem& problem, bool scale)
    : problem_(problem), scaled_(scale), q_(problem.q) {
  const bool own_covering = problem.c.size() > 0;
  c_ = own_covering ? problem.c : VectorXd::Ones(size());
  if (!scaled_) return;
  M_.resize(size(), size());
  for (Index j = 0; j < size(); ++j)
    M_.col(j) = problem.M.col(j).cwiseQuotient(problem.s_w) * problem.s_z(j);
  q_ = q_.cwiseQuotient(problem.s_w);
  if (own_covering) {
    c_ = c_.cwiseQuotient(problem.s_w);
    c_ /= c_.maxCoeff();
  }
}

void ScaledProblem::unscale(VectorXd& z, VectorXd& w, VectorXd& covering) const {
  if (!scaled_) return;
  z = z.cwiseProduct(problem_.s_z);
  w = w.cwiseProduct(problem_.s_w);
  covering = covering.cwiseProduct(problem_.s_w);
}

}  // namespace lcp
