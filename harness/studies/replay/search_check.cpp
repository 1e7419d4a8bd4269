#include "harness/studies/replay/search_check.h"

#include <algorithm>
#include <map>

namespace lcp {

namespace {

/// q' after a pivot in `row`, its least entry: q'_k + theta m'_k, and theta in the row itself.
Estimate least_after(const Estimates& q, const Estimates& m, Index row, const Estimate& ratio) {
  Estimate least = ratio;
  for (std::size_t k = 0; k < q.size(); ++k) {
    if (static_cast<Index>(k) == row) continue;
    const Quad value = q[k].value + ratio.value * m[k].value;
    const double error = q[k].error + ratio.error * static_cast<double>(magnitude(m[k].value)) +
                         m[k].error * static_cast<double>(magnitude(ratio.value));
    if (value < least.value) least = {value, error};
  }
  return least;
}

std::optional<Departure> check_pivot(const HighProblem& high, const SearchRule& rule,
                                     const PivotEvent& event, const Labels& labels, double zero) {
  using Why = Departure::Why;
  const HighDictionary dictionary(high, labels, zero);
  Departure departure{.why = Why::singular_basis, .entering = event.entering, .row = event.row};
  if (!dictionary.usable()) return departure;
  const Estimates m = dictionary.column(event.entering);
  if (m[event.row].doubt > rule.pivot) return std::nullopt;  // 113 bits do not tell
  if (const auto fault = fault_of_pivot(dictionary, m, event, rule.pivot, zero, departure)) {
    departure.why = *fault;
    return departure;
  }
  const Estimate least = least_after(dictionary.q(), m, event.row, departure.ratio);
  departure.why = Why::infeasible;
  departure.q_min = least.value;
  if (may_be_pivot(least, rule.epsilon, zero)) return departure;
  return std::nullopt;
}

}  // namespace

std::optional<SearchRule> search_rule(const NamedSolver& solver) {
  static const std::vector<std::string> rows = {"best-first", "best-first-lexicographic",
                                                "best-first-tableau", "best-first-uniform"};
  if (std::find(rows.begin(), rows.end(), solver.info.name) == rows.end()) return std::nullopt;
  const std::map<std::string, std::string> set = settings_of(solver);
  return SearchRule{.epsilon = std::stod(set.at("epsilon")),
                    .pivot = std::stod(set.at("pivot")),
                    .scale = set.at("scale") == "on"};
}

std::optional<Departure::Why> fault_of_pivot(const HighDictionary& dictionary, const Estimates& m,
                                             const PivotEvent& event, double pivot, double zero,
                                             Departure& departure) {
  departure.size = m[event.row];
  if (departure.size.value == 0) return Departure::Why::zero_pivot;
  departure.ratio = ratio_of(dictionary.q()[event.row], departure.size);
  const bool blocks = event.entering == dictionary.labels().z0()
                          ? departure.size.value > 0
                          : may_be_pivot(departure.size, pivot, zero);
  return blocks ? std::nullopt : std::optional(Departure::Why::no_pivot);
}

std::optional<Departure> check_search(const Problem& problem, const SearchRule& rule,
                                      const std::vector<Index>& alpha,
                                      const std::vector<Trace::Step>& steps,
                                      const HighLimits& limits, std::size_t& checked) {
  const HighProblem high(problem, rule.scale, alpha);
  const std::size_t most = static_cast<std::size_t>(limits.most_pivots);
  std::map<Index, Labels> after;  // by number; attempts of a search count anew
  for (checked = 0; checked < std::min(most, steps.size()); ++checked) {
    if (limits.interrupted != nullptr && *limits.interrupted) break;
    limits.progress(static_cast<Index>(checked));
    const PivotEvent& event = steps[checked].event;
    Labels labels = event.parent == 0 ? Labels(problem.size(), alpha) : after.at(event.parent);
    std::optional<Departure> departure = check_pivot(high, rule, event, labels, limits.zero);
    labels.exchange({event.row, event.entering});
    after.insert_or_assign(event.node, std::move(labels));
    if (!departure) continue;
    departure->pivot = static_cast<Index>(++checked);
    return departure;
  }
  return std::nullopt;
}

}  // namespace lcp
