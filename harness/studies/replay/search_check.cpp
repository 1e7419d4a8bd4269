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
  Departure departure{.why = Why::singular_basis,
                      .pivot = 0,
                      .entering = event.entering,
                      .row = event.row,
                      .size = {},
                      .ratio = {},
                      .rule = {}};
  if (!dictionary.usable()) return departure;
  const Estimates m = dictionary.column(event.entering);
  departure.size = m[event.row];
  departure.why = Why::zero_pivot;
  if (departure.size.doubt > rule.pivot) return std::nullopt;  // 113 bits do not tell
  if (departure.size.value == 0) return departure;
  departure.ratio = ratio_of(dictionary.q()[event.row], departure.size);
  departure.why = Why::no_pivot;
  const bool step0 = event.entering == labels.z0();
  const bool blocks = step0
                          ? departure.size.value > 0
                          : surely_less(departure.size, {-static_cast<Quad>(rule.pivot), 0}, zero);
  if (!blocks) return departure;
  const Estimate least = least_after(dictionary.q(), m, event.row, departure.ratio);
  departure.why = Why::infeasible;
  departure.q_min = least.value;
  if (surely_less(least, {-static_cast<Quad>(rule.epsilon), 0}, zero)) return departure;
  return std::nullopt;
}

}  // namespace

std::optional<SearchRule> search_rule(const NamedSolver& solver) {
  static const std::vector<std::string> rows = {"best-first", "best-first-lexicographic",
                                                "best-first-tableau", "best-first-uniform"};
  if (std::find(rows.begin(), rows.end(), solver.info.name) == rows.end()) return std::nullopt;
  std::map<std::string, std::string> set;
  for (const Option& option : solver.solver->options()) set[option.name] = option.get();
  return SearchRule{.epsilon = std::stod(set.at("epsilon")),
                    .pivot = std::stod(set.at("pivot")),
                    .scale = set.at("scale") == "on"};
}

std::vector<Labels> labels_before(const std::vector<Trace::Step>& steps, Index n,
                                  const std::vector<Index>& alpha, std::size_t most) {
  const Labels first(n, alpha);
  std::vector<Labels> before;
  std::map<Index, Labels> after;  // by number; attempts of a search count anew
  for (std::size_t k = 0; k < std::min(most, steps.size()); ++k) {
    const PivotEvent& event = steps[k].event;
    before.push_back(event.parent == 0 ? first : after.at(event.parent));
    Labels labels = before.back();
    labels.exchange({event.row, event.entering});
    after.insert_or_assign(event.node, std::move(labels));
  }
  return before;
}

std::optional<Departure> check_search(const Problem& problem, const SearchRule& rule,
                                      const std::vector<Index>& alpha,
                                      const std::vector<Trace::Step>& steps,
                                      const std::vector<Labels>& before, const HighLimits& limits,
                                      std::size_t& checked) {
  const HighProblem high(problem, rule.scale, alpha);
  for (checked = 0; checked < before.size(); ++checked) {
    if (limits.interrupted != nullptr && *limits.interrupted) break;
    limits.progress(static_cast<Index>(checked));
    std::optional<Departure> departure =
        check_pivot(high, rule, steps[checked].event, before[checked], limits.zero);
    if (!departure) continue;
    departure->pivot = static_cast<Index>(++checked);
    return departure;
  }
  return std::nullopt;
}

}  // namespace lcp
