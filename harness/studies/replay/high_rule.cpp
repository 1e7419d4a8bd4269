#include "harness/studies/replay/high_rule.h"

#include <algorithm>
#include <cmath>

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
  const std::map<std::string, std::string> set = settings_of(solver);
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

std::map<std::string, std::string> settings_of(const NamedSolver& solver) {
  std::map<std::string, std::string> set;
  for (const Option& option : solver.solver->options()) set[option.name] = option.get();
  return set;
}

bool surely_less(const Estimate& a, const Estimate& b, double zero) {
  return a.value < b.value && b.value - a.value > zero * (a.error + b.error);
}

bool may_be_pivot(const Estimate& m, double pivot, double zero) {
  return surely_less(m, {-static_cast<Quad>(pivot), 0}, zero);
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
    if (!may_be_pivot(m[i], rule.pivot, zero)) continue;
    blocking.push_back(static_cast<Index>(i));
    ratios.push_back(ratio_of(dictionary.q()[i], m[i]));
  }
  HighChoice choice;
  choice.undecided = in_doubt(dictionary.q(), m, blocking, rule.pivot);
  if (blocking.empty()) return choice;
  const Estimate least = ratios[least_of(ratios)];
  const Estimate threshold = plus(least, rule.lexicographic ? rule.delta : 0);
  const auto place_of = [&](Index row) {
    return std::find(blocking.begin(), blocking.end(), row) - blocking.begin();
  };
  std::vector<Index> tied;
  for (std::size_t k = 0; k < blocking.size(); ++k)
    if (!surely_less(threshold, ratios[k], zero)) tied.push_back(blocking[k]);
  choice.tied = static_cast<Index>(tied.size());
  std::size_t place = place_of(dictionary.labels().row_of(dictionary.labels().z0()));
  if (!rule.lexicographic)
    place = place_of(tied.front());
  else if (place == blocking.size() || surely_less(plus(least, rule.z0), ratios[place], zero))
    place = place_of(lexicographically_least(dictionary, m, first, rule, zero, std::move(tied)));
  choice.row = blocking[place];
  choice.ratio = ratios[place];
  choice.pivot = m[choice.row];
  return choice;
}

}  // namespace lcp
