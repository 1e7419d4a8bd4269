#include "solvers/linalg/complementary_path.h"

#include <algorithm>
#include <cmath>

#include "solvers/linalg/start.h"

namespace lcp {

Result basic_result(const ScaledProblem& problem, const Labels& labels, const VectorXd& q,
                    const VectorXd& covering, Claim claim, std::string message) {
  const Index n = problem.size();
  Result result;
  result.claim = claim;
  result.message = std::move(message);
  result.z = VectorXd::Zero(n);
  result.w = VectorXd::Zero(n);
  result.covering = covering;
  std::vector<Index> basis;
  basis.reserve(n);
  for (Index row = 0; row < n; ++row) {
    const Variable v = labels.basic(row);
    if (labels.is_w(v)) {
      result.w(v) = q(row);
    } else if (v == labels.z0()) {
      result.z0 = q(row);
    } else {
      result.z(labels.index(v)) = q(row);
      basis.push_back(labels.index(v));
    }
  }
  problem.unscale(result.z, result.w, result.covering);
  if (result.z.allFinite() && result.w.allFinite() && std::isfinite(result.z0)) {
    std::sort(basis.begin(), basis.end());
    result.basis = std::move(basis);
    return result;
  }
  result.claim = Claim::singular;
  result.message = "numbers are no longer finite; z = 0 is returned";
  result.z = VectorXd::Zero(n);
  result.w = VectorXd();
  result.z0 = 0;
  return result;
}

std::vector<Index> starting_alpha(const Problem& problem, const Call& call) {
  if (!call.start) return {};
  return checked_alpha(call.start->alpha, problem.size());
}

}  // namespace lcp
