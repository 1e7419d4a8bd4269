#include "problems/contact/two_step.h"

#include <algorithm>

#include "problems/contact/friction_lcp.h"

namespace lcp {

namespace {

Result unsupported(const Problem& problem, const char* reason) {
  Result result;
  result.claim = Claim::unsupported;
  result.message = reason;
  result.z = VectorXd::Zero(problem.size());
  return result;
}

/// Row k of the frictionless LCP is that of contact k.
Start start_from(const std::vector<Index>& basic_contacts, const FrictionBlocks& blocks) {
  Start start;
  for (const Index contact : basic_contacts) start.alpha.push_back(blocks.normal_row.at(contact));
  std::sort(start.alpha.begin(), start.alpha.end());
  return start;
}

}  // namespace

TwoStep solve_two_step(const std::function<Result(const Problem&, const Call&)>& solve,
                       const Problem& problem, const Observer& observer) {
  TwoStep steps;
  if (!has_friction(problem)) {
    steps.frictional = unsupported(problem, "two-step: the instance has no friction");
    steps.frictionless = steps.frictional;
    return steps;
  }

  steps.frictionless = solve(frictionless_part(problem), {});
  const Result& first = steps.frictionless;
  const bool solved = first.claim == Claim::solved;
  if (solved && !first.basis) {
    steps.frictional = unsupported(problem, "two-step: the solver returns no basis to start from");
  } else {
    // The empty basis, not no start at all: a method that takes none is to say so here as well.
    const Start start = solved ? start_from(*first.basis, *problem.friction) : Start{};
    steps.frictional = solve(problem, {start, observer});
  }

  Result& second = steps.frictional;
  second.work.frictionless_pivots = first.work.pivots;
  if (!solved && second.claim != Claim::unsupported) {
    ++second.work.restarts;
    second.message = "frictionless LCP: " + to_string(first.claim) + "; started cold" +
                     (second.message.empty() ? "" : "; " + second.message);
  }
  return steps;
}

}  // namespace lcp
