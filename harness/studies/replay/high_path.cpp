#include "harness/studies/replay/high_path.h"

#include <algorithm>
#include <utility>

#include "solvers/linalg/visited.h"

namespace lcp {

VectorXd point_of(const HighDictionary& dictionary, const Problem& problem, bool scale) {
  const Labels& labels = dictionary.labels();
  VectorXd z = VectorXd::Zero(labels.size());
  for (Index row = 0; row < labels.size(); ++row) {
    const Variable v = labels.basic(row);
    if (labels.is_w(v) || v == labels.z0()) continue;
    const Index j = labels.index(v);
    const Quad value = dictionary.q()[row].value;
    z(j) = static_cast<double>(scale ? value * problem.s_z(j) : value);
  }
  return z;
}

HighPath follow_high_path(const Problem& problem, const PathRule& rule,
                          const std::vector<Index>& alpha, const HighLimits& limits) {
  const HighProblem high(problem, rule.scale, alpha);
  Labels labels(problem.size(), alpha);
  HighDictionary dictionary(high, labels, limits.zero);
  const std::vector<Variable> first = labels.basic();
  HighPath path;

  const auto claim_at_the_end = [&] {
    if (!dictionary.usable()) return Claim::singular;
    // A starting basis with min q' above minus this is the solution.
    const double accepted = alpha.empty() ? 0 : rule.z0;
    if (std::all_of(dictionary.q().begin(), dictionary.q().end(),
                    [=](const Estimate& x) { return x.value >= -accepted; }))
      return Claim::solved;
    const Index max_pivots = rule.max_pivots > 0 ? rule.max_pivots : problem.max_pivots();
    Variable driving = labels.z0();
    HighChoice choice = high_step0(dictionary, rule, limits.zero);
    Visited visited;
    BasisKey key(labels, -1);
    while (true) {
      path.undecided = path.cut_short = choice.undecided;
      if (choice.undecided) return Claim::limit;
      if (choice.row < 0) return Claim::ray;
      const Index pivots = static_cast<Index>(path.pivots.size());
      if (pivots == max_pivots) return Claim::limit;
      path.cut_short =
          pivots == limits.most_pivots || (limits.interrupted != nullptr && *limits.interrupted);
      if (path.cut_short) return Claim::limit;
      limits.progress(pivots);

      const Variable leaving = labels.exchange({choice.row, driving});
      path.pivots.push_back({driving, leaving, choice});
      dictionary = HighDictionary(high, labels, limits.zero);
      if (!dictionary.usable()) return Claim::singular;
      if (leaving == labels.z0()) return Claim::solved;
      const Variable entered = std::exchange(driving, labels.complement(leaving));
      key.follow(labels, entered, leaving, driving);
      if (!visited.insert(key)) return Claim::cycle;
      choice = high_step1(dictionary, driving, first, rule, limits.zero);
    }
  };
  path.claim = claim_at_the_end();
  if (dictionary.usable()) path.z = point_of(dictionary, problem, rule.scale);
  return path;
}

std::optional<double> basis_residual(const Problem& problem, const std::vector<Index>& alpha,
                                     double zero) {
  const HighProblem high(problem, false);
  const HighDictionary dictionary(high, Labels(problem.size(), alpha), zero);
  if (!dictionary.usable()) return std::nullopt;
  Quad largest = 0;
  for (Index i = 0; i < problem.size(); ++i) {
    const Variable v = dictionary.labels().basic(i);
    const double scale = dictionary.labels().is_w(v) ? problem.s_w(i) : problem.s_z(i);
    largest = std::max(largest, -dictionary.q()[i].value / scale);
  }
  return static_cast<double>(largest);
}

}  // namespace lcp
