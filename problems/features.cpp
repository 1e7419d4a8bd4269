#include "problems/features.h"

#include "problems/decompositions.h"

namespace lcp {

namespace {

Index rows_sharing_least_q(const Problem& problem, double threshold) {
  if (problem.size() == 0) return 0;
  const VectorXd scaled = problem.q.cwiseQuotient(problem.s_w);
  return (scaled.array() <= scaled.minCoeff() + threshold).count();
}

void fill_rank_and_condition(const MatrixXd& matrix, const FeatureOptions& options,
                             Features& found) {
  if (matrix.rows() > options.largest_svd) return;
  found.rank = 0;
  if (matrix.size() == 0) return;
  const VectorXd values = singular_values(matrix);
  const double largest = values(0);
  if (largest == 0) return;
  const Index rank = (values.array() > options.rank_threshold * largest).count();
  found.rank = rank;
  found.condition = largest / values(rank - 1);
}

}  // namespace

double asymmetry_of(const MatrixXd& M) {
  const double largest = M.size() > 0 ? M.cwiseAbs().maxCoeff() : 0;
  return largest > 0 ? (M - M.transpose()).cwiseAbs().maxCoeff() / largest : 0;
}

Features features(const Problem& problem, const FeatureOptions& options) {
  Features found;
  found.n = problem.size();
  found.contacts = problem.friction ? problem.friction->contacts() : 0;
  found.tied_q = rows_sharing_least_q(problem, options.tie_threshold);
  const MatrixXd& M = problem.M;
  found.asymmetry = asymmetry_of(M);
  if (M.size() > 0)
    found.density = static_cast<double>((M.array() != 0).count()) / static_cast<double>(M.size());
  fill_rank_and_condition(problem.friction ? problem.friction->W : M, options, found);
  return found;
}

}  // namespace lcp
