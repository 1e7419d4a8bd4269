#include "solvers/linalg/scaled_problem.h"

namespace lcp {

ScaledProblem::ScaledProblem(const Problem& problem, bool scale)
    : problem_(problem), scaled_(scale), row_scales_(VectorXd::Ones(problem.size())), q_(problem.q) {
  const bool own_covering = problem.c.size() > 0;
  c_ = own_covering ? problem.c : VectorXd::Ones(size());
  if (!scaled_) return;
  row_scales_ = problem.s_w.cwiseInverse();
  q_ = q_.cwiseQuotient(problem.s_w);
  if (own_covering) {
    c_ = c_.cwiseQuotient(problem.s_w);
    c_ /= c_.maxCoeff();
  }
}

const MatrixXd& ScaledProblem::M() const {
  if (!scaled_) return problem_.M;
  if (M_.rows() < size()) {
    M_.resize(size(), size());
    for (Index j = 0; j < size(); ++j)
      M_.col(j) = problem_.M.col(j).cwiseQuotient(problem_.s_w) * problem_.s_z(j);
  }
  return M_;
}

void ScaledProblem::unscale(VectorXd& z, VectorXd& w, VectorXd& covering) const {
  if (!scaled_) return;
  z = z.cwiseProduct(problem_.s_z);
  w = w.cwiseProduct(problem_.s_w);
  if (covering.size() > 0) covering = covering.cwiseProduct(problem_.s_w);
}

}  // namespace lcp
