#include "harness/judge/acceptance.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace lcp {

double error_of(const Accuracy& accuracy, Acceptance::Criterion criterion) {
  if (criterion == Acceptance::Criterion::residual) return accuracy.residual;
  return std::isnan(accuracy.paper_error) ? accuracy.residual_unscaled : accuracy.paper_error;
}

std::string to_string(Acceptance::Criterion criterion) {
  return criterion == Acceptance::Criterion::paper ? "paper" : "residual";
}

Acceptance::Criterion criterion_from_string(const std::string& name) {
  for (const auto criterion : {Acceptance::Criterion::residual, Acceptance::Criterion::paper})
    if (to_string(criterion) == name) return criterion;
  throw std::invalid_argument(
      fmt::format("unknown criterion '{}', expected residual or paper", name));
}

}  // namespace lcp
