#include "problems/contact/two_step.h"

#include <algorithm>
#include <numeric>

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

std::vector<Index> independent_contacts(const std::vector<Index>& active, const MatrixXd& W_nn,
                                        double tolerance) {
  std::vector<Index> left = active, kept;
  MatrixXd rest = W_nn(active, active);  // Schur complement of what is kept
  double largest = 0;
  while (!left.empty()) {
    Index place;
    const double pivot = rest.diagonal().maxCoeff(&place);
    largest = std::max(largest, pivot);
    if (!(pivot > tolerance * largest)) break;
    kept.push_back(left[place]);
    const VectorXd column = rest.col(place), row = rest.row(place);
    rest -= column * row.transpose() / pivot;
    left.erase(left.begin() + place);
    std::vector<Index> others(left.size() + 1);
    std::iota(others.begin(), others.end(), Index{0});
    others.erase(others.begin() + place);
    rest = rest(others, others).eval();
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

TwoStep solve_two_step(const std::function<Result(const Problem&, const Call&)>& solve,
                       const Problem& problem, const Observer& observer) {
  TwoStep steps;
  if (!has_friction(problem)) {
    steps.frictional = unsupported(problem, "two-step: the instance has no friction");
    steps.frictionless = steps.frictional;
    return steps;
  }

  const Problem frictionless = frictionless_part(problem);
  steps.frictionless = solve(frictionless, {});
  const Result& first = steps.frictionless;
  const bool solved = first.claim == Claim::solved;
  if (solved && !first.basis) {
    steps.frictional = unsupported(problem, "two-step: the solver returns no basis to start from");
  } else {
    // The empty basis, not no start at all: a method that takes none is to say so here as well.
    const Start start =
        solved
            ? start_from(independent_contacts(*first.basis, frictionless.M, kIndependentContacts),
                         *problem.friction)
            : Start{};
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
