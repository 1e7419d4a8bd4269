#include "harness/studies/replay/high_path.h"

#include <algorithm>
#include <utility>

#include "solvers/linalg/visited.h"

namespace lcp {

namespace {

/// One walk along the path, and the dictionary it stands at.
class Walk {
 public:
  Walk(const Problem& problem, const PathRule& rule, const std::vector<Index>& alpha,
       const HighLimits& limits)
      : problem_(problem),
        rule_(rule),
        limits_(limits),
        high_(problem, rule.scale, alpha),
        labels_(problem.size(), alpha),
        dictionary_(high_, labels_, limits.zero),
        first_(labels_.basic()),
        accepted_(alpha.empty() ? 0 : rule.z0) {}

  HighPath run() {
    path_.claim = claim_at_the_end();
    if (dictionary_.usable()) path_.z = point_of(dictionary_, problem_, rule_.scale);
    return std::move(path_);
  }

 private:
  Claim claim_at_the_end() {
    if (!dictionary_.usable()) return Claim::singular;
    if (is_solved()) return Claim::solved;
    const Index max_pivots = rule_.max_pivots > 0 ? rule_.max_pivots : problem_.max_pivots();
    Variable driving = labels_.z0();
    HighChoice choice = high_step0(dictionary_, rule_, limits_.zero);
    Visited visited;
    BasisKey key(labels_, -1);
    while (true) {
      path_.undecided = path_.cut_short = choice.undecided;
      if (choice.undecided) return Claim::limit;
      if (choice.row < 0) return Claim::ray;
      const Index pivots = static_cast<Index>(path_.pivots.size());
      if (pivots == max_pivots) return Claim::limit;
      path_.cut_short =
          pivots == limits_.most_pivots || (limits_.interrupted != nullptr && *limits_.interrupted);
      if (path_.cut_short) return Claim::limit;
      limits_.progress(pivots);

      const Variable leaving = labels_.exchange({choice.row, driving});
      path_.pivots.push_back({driving, leaving, choice});
      dictionary_ = HighDictionary(high_, labels_, limits_.zero);
      if (!dictionary_.usable()) return Claim::singular;
      if (leaving == labels_.z0()) return Claim::solved;
      const Variable entered = std::exchange(driving, labels_.complement(leaving));
      key.follow(labels_, entered, leaving, driving);
      if (!visited.insert(key)) return Claim::cycle;
      choice = high_step1(dictionary_, driving, first_, rule_, limits_.zero);
    }
  }

  bool is_solved() const {
    return std::all_of(dictionary_.q().begin(), dictionary_.q().end(),
                       [this](const Estimate& x) { return x.value >= -accepted_; });
  }

  const Problem& problem_;
  const PathRule& rule_;
  const HighLimits& limits_;
  const HighProblem high_;
  Labels labels_;
  HighDictionary dictionary_;
  const std::vector<Variable> first_;
  const double accepted_;  ///< A starting basis with min q' above minus this is the solution.
  HighPath path_;
};

}  // namespace

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
  return Walk(problem, rule, alpha, limits).run();
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
