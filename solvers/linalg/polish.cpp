#include "solvers/linalg/polish.h"

#include <limits>

#include "solvers/linalg/natural_residual.h"

namespace lcp {

namespace {

/// A natural residual that is not compared with the one before, which would cost another product.
constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();

}  // namespace

void polish(const Problem& problem, const ScaledProblem& scaled, Basis& basis, Result& result) {
  if (result.basis->empty()) return;
  const Index before = basis.factorisations();
  const bool refined = basis.refine();
  result.work.factorisations += basis.factorisations() - before;
  if (!refined) return;

  const Labels& labels = basis.labels();
  VectorXd z = VectorXd::Zero(problem.size()), w;
  for (const Index i : *result.basis)
    z(i) = std::max(0.0, basis.q()(labels.row_of(labels.z(i)))) * scaled.column_scale(i);
  const double residual = natural_residual(problem, z, w);
  VectorXd old_w;
  if (residual <= kRounding || residual < natural_residual(problem, result.z, old_w)) {
    result.z.swap(z);
    result.w.swap(w);
  }
}

}  // namespace lcp
