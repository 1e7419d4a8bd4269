#include "harness/studies/replay/high_rule.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace lcp {

namespace {

/// The rows whose rule this is. A new row of the family is entered here.
const std::map<std::string, bool>& lexicographic_by_row() {
  static const std::map<std::string, bool> rows = {{"lemke", false},
                                                   {"lemke-revised", false},
                                                   {"lexicographic", true},
                                                   {"lexicographic-pivot", true},
                                                   {"lexicographic-revised", true}};
  return rows;
}

Estimate plus(const Estimate& a, double b) { return {a.value + b, a.error}; }

/// Place of the least value.
std::size_t least_of(const Estimates& numbers) {
  return std::min_element(numbers.begin(), numbers.end(),
                          [](const Estimate& a, const Estimate& b) { return a.value < b.value; }) -
         numbers.begin();
}

/// Entries of column w_j of the basis inverse (of the identity at the start: `first`) in the tied rows,
/// over -m'_i; empty where the column is a unit vector that no tied row meets.
Estimates lexicographic_entries(const HighDictionary& dictionary, const Estimates& m,
                                Variable first, const std::vector<Index>& tied) {
  Estimates entries;
  const Index unit_row = dictionary.labels().row_of(first);
  if (unit_row >= 0) {
    if (std::find(tied.begin(), tied.end(), unit_row) == tied.end()) return {};
    for (const Index row : tied) entries.push_back({row == unit_row ? Quad(1) : Quad(0), 0});
  } else {
    entries = dictionary.entries(first, tied);  // minus those of the basis inverse
    for (Estimate& entry : entries) entry.value = -entry.value;
  }
  for (std::size_t t = 0; t < tied.size(); ++t) entries[t] = ratio_of(entries[t], m[tied[t]]);
  return entries;
}

/// Whether some number in doubt could change the choice: an m' that may be a pivot after all, or the q'
/// of a row that blocks.
bool in_doubt(const Estimates& q, const Estimates& m, const std::vector<Index>& blocking,
              double pivot) {
  return std::any_of(m.begin(), m.end(), [=](const Estimate& x) { return x.doubt > pivot; }) ||
         std::any_of(blocking.begin(), blocking.end(), [&](Index i) { return q[i].doubt > 0; });
}

Index lexicographically_least(const HighDictionary& dictionary, const Estimates& m,
                              const std::vector<Variable>& first, const PathRule& rule, double zero,
                              std::vector<Index> tied) {
  for (std::size_t j = 0; j < first.size() && tied.size() > 1; ++j) {
    const Estimates entries = lexicographic_entries(dictionary, m, first[j], tied);
    if (entries.empty()) continue;
    const bool last = j + 1 == first.size();
    const Estimate threshold = plus(entries[least_of(entries)], last ? 0 : rule.delta);
    std::vector<Index> kept;
    for (std::size_t t = 0; t < tied.size(); ++t)
      if (!surely_less(threshold, entries[t], zero)) kept.push_back(tied[t]);
    tied = kept;
  }
  return tied.front();
}

}  // namespace

std::optional<PathRule> path_rule(const NamedSolver& solver) {
  const auto row = lexicographic_by_row().find(solver.info.name);
  if (row == lexicographic_by_row().end()) return std::nullopt;
  std::map<std::string, std::string> set;
  for (const Option& option : solver.solver->options()) set[option.name] = option.get();
  const auto number = [&](const char* name) { return std::stod(set.at(name)); };
  PathRule rule;
  rule.lexicographic = row->second;
  if (rule.lexicographic) {
    rule.delta = number("delta");
    rule.z0 = set.at("z0") == "delta" ? rule.delta : number("z0");
  }
  rule.pivot = number("pivot");
  rule.scale = set.at("scale") == "on";
  rule.max_pivots = set.at("max_pivots") == "auto" ? 0 : std::stoll(set.at("max_pivots"));
  return rule;
}

bool surely_less(const Estimate& a, const Estimate& b, double zero) {
  return a.value < b.value && b.value - a.value > zero * (a.error + b.error);
}

Estimate ratio_of(const Estimate& q, const Estimate& m) {
  const Quad ratio = -q.value / m.value;
  const double divisor = std::abs(static_cast<double>(m.value));
  return {ratio, q.error / divisor + std::abs(static_cast<double>(ratio)) *
                                         (m.error / divisor + (q.value == 0 ? 0 : kQuadRounding))};
}

HighChoice high_step0(const HighDictionary& dictionary, const PathRule& rule, double zero) {
  const Estimates m = dictionary.column(dictionary.labels().z0());
  Estimates ratios;
  for (std::size_t i = 0; i < m.size(); ++i) {
    ratios.push_back(ratio_of(dictionary.q()[i], m[i]));  // q' / c', the paper's sign
    ratios.back().value = -ratios.back().value;
  }
  const Estimate threshold = plus(ratios[least_of(ratios)], rule.lexicographic ? rule.delta : 0);
  HighChoice choice;
  for (std::size_t i = 0; i < m.size(); ++i) {
    if (surely_less(threshold, ratios[i], zero)) continue;
    ++choice.tied;
    if (choice.row < 0 || rule.lexicographic) choice.row = static_cast<Index>(i);
  }
  choice.ratio = {-ratios[choice.row].value, ratios[choice.row].error};
  choice.pivot = m[choice.row];
  return choice;
}

HighChoice high_step1(const HighDictionary& dictionary, Variable driving,
                      const std::vector<Variable>& first, const PathRule& rule, double zero) {
  const Estimates m = dictionary.column(driving);
  std::vector<Index> blocking;
  Estimates ratios;
  for (std::size_t i = 0; i < m.size(); ++i) {
    if (!surely_less(m[i], {-static_cast<Quad>(rule.pivot), 0}, zero)) continue;
    blocking.push_back(static_cast<Index>(i));
    ratios.push_back(ratio_of(dictionary.q()[i], m[i]));
  }
  const bool undecided = in_doubt(dictionary.q(), m, blocking, rule.pivot);
  if (blocking.empty()) {
    HighChoice nothing;
    nothing.undecided = undecided;
    return nothing;
  }
  const Estimate least = ratios[least_of(ratios)];
  const auto chosen = [&](std::size_t k, Index tied) {
    return HighChoice{blocking[k], ratios[k], m[blocking[k]], tied, undecided};
  };
  const auto place_of = [&](Index row) {
    return std::find(blocking.begin(), blocking.end(), row) - blocking.begin();
  };
  std::vector<Index> tied;
  const Estimate threshold = plus(least, rule.lexicographic ? rule.delta : 0);
  for (std::size_t k = 0; k < blocking.size(); ++k)
    if (!surely_less(threshold, ratios[k], zero)) tied.push_back(blocking[k]);
  const Index count = static_cast<Index>(tied.size());
  if (!rule.lexicographic) return chosen(place_of(tied.front()), count);

  const Index z0_row = dictionary.labels().row_of(dictionary.labels().z0());
  const std::size_t z0 = place_of(z0_row);
  if (z0 < blocking.size() && !surely_less(plus(least, rule.z0), ratios[z0], zero))
    return chosen(z0, count);
  return chosen(
      place_of(lexicographically_least(dictionary, m, first, rule, zero, std::move(tied))), count);
}

}  // namespace lcp
