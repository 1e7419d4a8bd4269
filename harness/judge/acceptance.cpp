#include "harness/judge/acceptance.h"

#include <cmath>

namespace lcp {

std::string to_string(Standing standing) {
  constexpr const char* names[] = {"success", "trivial",     "no_solution", "cycle",
                                   "error",   "unsupported", "not_run"};
  return names[static_cast<int>(standing)];
}

Standing Judged::standing() const {
  switch (verdict) {
    case Verdict::solved:
      return trivial ? Standing::trivial : Standing::success;
    case Verdict::ray:
    case Verdict::exhausted:
    case Verdict::infeasible:
    case Verdict::false_infeasible:
      return Standing::no_solution;
    case Verdict::cycle:
    case Verdict::limit:
    case Verdict::timeout:
      return Standing::cycle;
    case Verdict::wrong:
    case Verdict::inaccurate:
    case Verdict::singular:
    case Verdict::crash:
    case Verdict::memory:
      return Standing::error;
    case Verdict::unsupported:
      return Standing::unsupported;
    case Verdict::not_run:
      return Standing::not_run;
  }
  throw std::logic_error("verdict without a column");
}

bool Judged::failure() const {
  const Standing column = standing();
  return column == Standing::no_solution || column == Standing::cycle || column == Standing::error;
}

Judged judged(Claim claim, Verdict otherwise, const std::optional<Accuracy>& accuracy,
              const Acceptance& acceptance, double own_tolerance) {
  Judged judged{otherwise};
  if (!accuracy) return judged;
  const bool by_residual = acceptance.criterion == Acceptance::Criterion::residual;
  const double error = error_of(*accuracy, acceptance.criterion);
  const bool passes = error <= acceptance.tolerance;
  if (claim == Claim::solved)
    judged.verdict = passes                                  ? Verdict::solved
                     : by_residual && error <= own_tolerance ? Verdict::inaccurate
                                                             : Verdict::wrong;
  if (!by_residual) return judged;
  judged.unclaimed = passes && claim != Claim::solved && otherwise != Verdict::unsupported;
  judged.trivial = accuracy->zero_residual <= acceptance.tolerance;
  return judged;
}

Judged judged(const Record& record, const std::optional<Acceptance>& acceptance) {
  const Judged stored{record.verdict, record.unclaimed, record.trivial};
  if (!acceptance) return stored;
  if (!record.accuracy && acceptance->criterion == Acceptance::Criterion::residual) return stored;
  return judged(record.claim, record.verdict, record.accuracy, *acceptance, record.tolerance);
}

double error_of(const Accuracy& accuracy, Acceptance::Criterion criterion) {
  if (criterion == Acceptance::Criterion::residual) return accuracy.residual;
  return std::isnan(accuracy.paper_error) ? accuracy.residual_unscaled : accuracy.paper_error;
}

}  // namespace lcp
