#pragma once

#include <utility>

#include "solvers/linalg/pivoting_options.h"
#include "solvers/linalg/ratio_test.h"
#include "solvers/linalg/scaled_problem.h"
#include "solvers/linalg/visited.h"
#include "solvers/result.h"

namespace lcp {

/// The answer that a dictionary stands for, in the problem's own units: the basic variables are q',
/// the others 0. `covering` is empty where z0 is nonbasic. Numbers that are not finite give z = 0 and
/// the claim `singular` instead.
Result basic_result(const ScaledProblem& problem, const Labels& labels, const VectorXd& q,
                    const VectorXd& covering, Claim claim, std::string message);

/// The same with the work done so far, to which the dictionary adds its own.
template <class Dictionary>
Result basic_result(const ScaledProblem& problem, const Dictionary& dictionary, const Work& work,
                    Claim claim, std::string message) {
  const Labels& labels = dictionary.labels();
  Result result = basic_result(problem, labels, dictionary.q(),
                               labels.is_basic(labels.z0()) ? dictionary.covering() : VectorXd(),
                               claim, std::move(message));
  result.work = work;
  result.work.factorisations += dictionary.factorisations();
  result.work.replayed += dictionary.replayed();
  return result;
}

/// The starting basis of a call, checked and sorted; empty for a cold start.
std::vector<Index> starting_alpha(const Problem& problem, const Call& call);

/// Follows one complementary path of Lemke's algorithm (II-A) from the dictionary of `alpha`, with
/// Step 0 and Step 1 as `rule` decides them:
///   rule.step0(q', c') -> row r whose variable z0 replaces,
///   rule.step1(dictionary, m', first) -> Blocking; `first` holds the first basic variables,
///   rule.accepted_infeasibility() -> a starting basis with min q' >= minus this is the solution.
template <class Dictionary, class Rule>
Result follow_complementary_path(const Problem& problem, const PivotingOptions& options,
                                 const Call& call, const Rule& rule) {
  const ScaledProblem scaled(problem, options.scale);
  const std::vector<Index> alpha = starting_alpha(problem, call);
  Dictionary dictionary(scaled, alpha, options);
  Work work;
  work.start_pivots = static_cast<Index>(alpha.size());
  const auto finish = [&](Claim claim, std::string message) {
    return basic_result(scaled, dictionary, work, claim, std::move(message));
  };

  if (!dictionary.usable()) {
    if (options.restart == Restart::none) return finish(Claim::singular, "start not usable");
    Result cold =
        follow_complementary_path<Dictionary>(problem, options, {{}, call.observer}, rule);
    cold.work.factorisations += dictionary.factorisations();
    cold.work.restarts = 1;
    return cold;
  }
  const Labels& labels = dictionary.labels();
  const std::vector<Variable> first = labels.basic();
  const double accepted = alpha.empty() ? 0 : rule.accepted_infeasibility();
  if (labels.size() == 0 || dictionary.q().minCoeff() >= -accepted)
    return finish(Claim::solved, "");

  const Index max_pivots = pivot_limit(options, problem);
  VectorXd m;
  Variable driving = labels.z0();
  dictionary.column(driving, m);
  Blocking blocking{rule.step0(dictionary.q(), m), 0, 1};  // Step 0
  blocking.ratio = -dictionary.q()(blocking.row) / m(blocking.row);
  Visited visited;
  BasisKey key(labels, -1);
  while (true) {
    if (work.pivots == max_pivots)
      return finish(Claim::limit, "max_pivots=" + std::to_string(max_pivots) + " reached");
    const double pivot_size = m(blocking.row);
    const Variable leaving = dictionary.pivot({blocking.row, driving}, m);  // Step 2
    ++work.pivots;
    ++work.path;
    if (call.observer)
      call.observer({work.pivots, work.pivots - 1, blocking.row, driving, leaving, blocking.ratio,
                     pivot_size, blocking.tied, &labels.basic()});
    if (!dictionary.usable()) return finish(Claim::singular, "basis singular to working precision");
    if (!dictionary.q().allFinite()) return finish(Claim::singular, "q' is not finite");
    if (leaving == labels.z0()) return finish(Claim::solved, "");

    const Variable entered = std::exchange(driving, labels.complement(leaving));
    key.follow(labels, entered, leaving, driving);
    if (!visited.insert(key))
      return finish(Claim::cycle, "basis and driving variable of an earlier pivot came back");
    dictionary.column(driving, m);
    blocking = rule.step1(dictionary, m, first);  // Step 1
    if (blocking.row < 0) return finish(Claim::ray, "nothing blocks the driving variable");
  }
}

}  // namespace lcp
