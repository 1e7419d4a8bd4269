#include "solvers/linalg/start.h"

#include <algorithm>
#include <limits>

#include "solvers/errors.h"

namespace lcp {

std::vector<Index> complement_of(const std::vector<Index>& alpha, Index n) {
  std::vector<bool> in_alpha(n, false);
  for (const Index i : alpha) in_alpha[i] = true;
  std::vector<Index> rest;
  rest.reserve(n - alpha.size());
  for (Index i = 0; i < n; ++i)
    if (!in_alpha[i]) rest.push_back(i);
  return rest;
}

VectorXd covering_of(const ScaledProblem& problem, const std::vector<Index>& alpha) {
  if (alpha.empty()) return problem.c();
  VectorXd sum = VectorXd::Zero(problem.size());
  for (const Index j : alpha) sum += problem.M().col(j);
  VectorXd covering = VectorXd::Ones(problem.size()) - sum;
  for (const Index i : alpha) covering(i) = -sum(i);
  return covering;
}

std::vector<Index> checked_alpha(const std::vector<Index>& alpha, Index n) {
  std::vector<Index> sorted = alpha;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    if (sorted[k] < 0 || sorted[k] >= n)
      throw InvalidArgument("starting basis holds row {}, expected 0 ... {}", sorted[k], n - 1);
    if (k > 0 && sorted[k] == sorted[k - 1])
      throw InvalidArgument("starting basis holds row {} twice", sorted[k]);
  }
  return sorted;
}

double smallest_pivot(const Eigen::Ref<const MatrixXd>& factors) {
  double smallest = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < factors.rows(); ++i) {
    if (!factors.col(i).allFinite()) return std::numeric_limits<double>::quiet_NaN();
    smallest = std::min(smallest, std::abs(factors(i, i)));
  }
  return smallest;
}

}  // namespace lcp
