#include "problems/contact/two_step.h"

#include <algorithm>
#include <numeric>

#include "problems/contact/friction_lcp.h"

namespace lcp {

namespace {

Result without_friction(const Problem& problem) {
  Result result;
  result.claim = Claim::unsupported;
  result.message = "two-step: the instance has no friction";
  result.z = VectorXd::Zero(problem.size());
  return result;
}

/// Row k of the frictionless LCP, whose matrix is W_nn, is that of contact k.
Start start_from(const Result& frictionless, const MatrixXd& W_nn, const FrictionBlocks& blocks,
                 Index n) {
  Start start{.alpha = {}, .z = VectorXd::Zero(n)};
  if (frictionless.z.size() == blocks.contacts())
    start.z(blocks.normal_row) = frictionless.z;
  if (!frictionless.basis) return start;
  for (const Index contact : independent_contacts(*frictionless.basis, W_nn, kIndependentContacts))
    start.alpha.push_back(blocks.normal_row.at(contact));
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
    steps.frictional = without_friction(problem);
    steps.frictionless = steps.frictional;
    return steps;
  }

  const Problem frictionless = frictionless_part(problem);
  steps.frictionless = solve(frictionless, {});
  const Result& first = steps.frictionless;
  const bool solved = first.claim == Claim::solved;
  // The empty basis, not no start at all: a method that takes none is to say so here as well.
  const Start start =
      solved ? start_from(first, frictionless.M, *problem.friction, problem.size())
             : Start{.alpha = {}, .z = VectorXd::Zero(problem.size())};
  steps.frictional = solve(problem, {start, observer});

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
