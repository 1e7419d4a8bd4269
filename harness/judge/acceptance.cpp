#include "harness/judge/acceptance.h"

#include <cmath>

namespace lcp {

double error_of(const Accuracy& accuracy, Acceptance::Criterion criterion) {
  if (criterion == Acceptance::Criterion::residual) return accuracy.residual;
  return std::isnan(accuracy.paper_error) ? accuracy.residual_unscaled : accuracy.paper_error;
}

}  // namespace lcp
