#include "harness/studies/replay/render.h"

#include <fmt/format.h>

#include <cmath>
#include <sstream>

namespace lcp {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t columns = 98;
constexpr const char* indent = "  ";

double rounded(Quad x) { return static_cast<double>(x); }
double rounded(const Estimate& x) { return rounded(x.value); }

/// Name in the instance of a variable of the shown island.
std::string name_in(const Replay& replay, Variable v, Index n) {
  const Index size = static_cast<Index>(replay.rows.size());
  if (v == 2 * size) return "z0";
  return v < size ? variable_name(static_cast<int>(replay.rows[v]), n)
                  : variable_name(static_cast<int>(n + replay.rows[v - size]), n);
}

Index row_in(const Replay& replay, Index row) { return replay.rows[row] + 1; }

/// Lines of at most `columns`, indented, broken between words.
std::string folded(const std::string& text) {
  std::string out, line;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (!line.empty() && line.size() + word.size() + 1 > columns) {
      out += indent + line + "\n";
      line = "  ";
    }
    line += (line.empty() || line == "  " ? "" : " ") + word;
  }
  return out + indent + line + "\n";
}

std::string of_the_rule(const Replay& replay, Index n) {
  const Departure& departure = *replay.departure;
  if (departure.rule.row < 0) {
    return replay.path.claim == Claim::ray
               ? "by the rule nothing blocks (a ray)"
               : fmt::format("the rule ends here: {}", to_string(replay.path.claim));
  }
  return fmt::format("the rule takes row {} ({} leaves; ratio {:.4g}, pivot {:.4g})",
                     row_in(replay, departure.rule.row), name_in(replay, departure.rule_leaves, n),
                     rounded(departure.rule.ratio), rounded(departure.rule.pivot));
}

std::string fault(const Departure& departure) {
  using Why = Departure::Why;
  switch (departure.why) {
    case Why::zero_pivot:
      return "which is 0 in exact arithmetic";
    case Why::no_pivot:
      return fmt::format("which is {:.4g} in 113 bits and no pivot", rounded(departure.size));
    case Why::larger_ratio:
      return fmt::format("whose ratio, {:.6g} in 113 bits, is not the least",
                         rounded(departure.ratio));
    case Why::lost_tie:
      return "which is tied in 113 bits but not the row to take";
    case Why::infeasible:
      return fmt::format("which leaves min q' = {:.4g} in 113 bits", rounded(departure.q_min));
    case Why::singular_basis:
      return "in a basis that is singular to 113 bits";
    case Why::ended:
    case Why::went_on:
      return "";
  }
  return "";
}

std::string of_a_path(const Replay& replay, Index n) {
  const Departure& departure = *replay.departure;
  if (departure.why == Departure::Why::ended)
    return fmt::format("the run ends after {} pivots ({}), where {} enters and {}",
                       replay.steps.size(), to_string(replay.island_claim),
                       name_in(replay, departure.entering, n), of_the_rule(replay, n));
  const PivotEvent& taken = replay.steps[departure.pivot - 1].event;
  const std::string what = fault(departure);
  return fmt::format("number {}: {} enters and takes row {} ({} leaves) with pivot {:.3g}{}{}; {}",
                     departure.pivot, name_in(replay, taken.entering, n), row_in(replay, taken.row),
                     name_in(replay, taken.leaving, n), taken.pivot, what.empty() ? "" : ", ", what,
                     of_the_rule(replay, n));
}

/// A pivot judged by itself.
std::string of_one_pivot(const Replay& replay, const Departure& departure, Index n) {
  const PivotEvent& taken = replay.steps[departure.pivot - 1].event;
  return fmt::format("number {}: {} enters and takes row {} ({} leaves) with pivot {:.3g}, {}",
                     departure.pivot, name_in(replay, taken.entering, n), row_in(replay, taken.row),
                     name_in(replay, taken.leaving, n), taken.pivot, fault(departure));
}

/// Empty where the first wrong pivot is the one.
std::string of_the_first_none(const Replay& replay, Index n) {
  if (!replay.first_none || replay.first_none->pivot == replay.departure->pivot) return "";
  return "first pivot that is none: " + of_one_pivot(replay, *replay.first_none, n);
}

std::string end_of_path(const Replay& replay) {
  if (replay.path.undecided) return "undecided (113 bits do not resolve the next pivot)";
  if (replay.path.cut_short) return "stopped";
  if (replay.path.claim == Claim::singular) return "basis singular to 113 bits";
  return to_string(replay.path_verdict);
}

std::string comparison(const Replay& replay) {
  switch (replay.comparison) {
    case Beside::path:
      return fmt::format(
          "the same rule in 113 bits: {} after {} pivots{}", end_of_path(replay),
          replay.path.pivots.size(),
          replay.path.z.size() > 0 ? fmt::format(", residual {:.2e}", replay.path_residual) : "");
    case Beside::search:
      return fmt::format(
          "compared: whether each pivot is one the search may take (m' < -pivot, then min q' > "
          "-epsilon), from the same basis in 113 bits; {} of {} pivots looked at",
          replay.checked, replay.steps.size());
    case Beside::none:
      return replay.steps.empty()
                 ? "no comparison: this method takes no pivots, or does not show them"
                 : "no comparison: replay does not know this row's rule; its pivots alone";
  }
  return "";
}

std::string header(const Replay& replay) {
  std::string line = fmt::format("  {:>5} {:>6} {:>6} {:>10} {:>4} {:>10} {:>8}", "pivot", "enters",
                                 "leaves", "ratio", "tied", "pivot size", "cond");
  if (replay.comparison == Beside::path)
    line += fmt::format(" | {:>6} {:>6} {:>10} {:>10}", "113:", "leaves", "ratio", "pivot size");
  if (replay.comparison == Beside::search) line += fmt::format(" | {:>6} 113 bits", "parent");
  return line + "\n";
}

bool departs_at(const Replay& replay, std::size_t k) {
  return replay.departure && replay.departure->pivot == static_cast<Index>(k) + 1;
}

/// > the first wrong pivot, 0 the first that is 0 in 113 bits.
const char* mark(const Replay& replay, std::size_t k) {
  if (departs_at(replay, k)) return "> ";
  return replay.first_none && replay.first_none->pivot == static_cast<Index>(k) + 1 ? "0 " : indent;
}

std::string left_part(const Replay& replay, std::size_t k, Index n) {
  if (k >= replay.steps.size()) return fmt::format("{:<57}", "");
  const Trace::Step& step = replay.steps[k];
  const PivotEvent& event = step.event;
  return fmt::format("{}{:>5} {:>6} {:>6} {:>10.4g} {:>4} {:>10.4g} {:>8}", mark(replay, k), k + 1,
                     name_in(replay, event.entering, n), name_in(replay, event.leaving, n),
                     event.ratio, event.tied, event.pivot,
                     step.condition ? fmt::format("{:.2g}", *step.condition) : "-");
}

std::string right_part(const Replay& replay, std::size_t k, Index n) {
  if (replay.comparison == Beside::search) {
    const char* word = departs_at(replay, k) ? "not allowed" : k < replay.checked ? "allowed" : "-";
    return fmt::format(" | {:>6} {}", replay.steps[k].event.parent, word);
  }
  if (replay.comparison == Beside::none) return "";
  if (k >= replay.path.pivots.size()) return " |";
  const HighPivot& pivot = replay.path.pivots[k];
  return fmt::format(" | {:>6} {:>6} {:>10.4g} {:>10.4g}", name_in(replay, pivot.entering, n),
                     name_in(replay, pivot.leaving, n), rounded(pivot.choice.ratio),
                     rounded(pivot.choice.pivot));
}

/// Pivots shown, those that only the rule takes among them.
std::size_t shown_end(const Replay& replay) {
  const bool more = departs_at(replay, replay.end) && replay.end < replay.path.pivots.size();
  return replay.end + (more ? 1 : 0);
}

std::string left_out(const Replay& replay) {
  const std::size_t before = replay.begin, after = replay.steps.size() - replay.end;
  if (before + after == 0) return "";
  return fmt::format("  left out: {} pivots before these, {} after them (--all)\n", before, after);
}

Json number(double value) {
  if (std::isfinite(value)) return value;
  return fmt::format("{}", value);
}

const char* word(Departure::Why why) {
  static constexpr const char* words[] = {"zero pivot",    "no pivot",       "larger ratio",
                                          "lost tie",      "infeasible",     "singular basis",
                                          "the run ended", "the run went on"};
  return words[static_cast<int>(why)];
}

Json departure_json(const Replay& replay, const std::optional<Departure>& found, Index n) {
  if (!found) return nullptr;
  const Departure& departure = *found;
  Json out = {{"pivot", departure.pivot},
              {"why", word(departure.why)},
              {"entering", name_in(replay, departure.entering, n)},
              {"row", nullptr},
              {"rule_row", nullptr}};
  if (departure.row >= 0) {
    out["row"] = row_in(replay, departure.row);
    out["pivot_in_113_bits"] = number(rounded(departure.size));
    out["ratio_in_113_bits"] = number(rounded(departure.ratio));
  }
  if (departure.rule.row >= 0) {
    out["rule_row"] = row_in(replay, departure.rule.row);
    out["rule_ratio"] = number(rounded(departure.rule.ratio));
    out["rule_pivot"] = number(rounded(departure.rule.pivot));
  }
  return out;
}

Json pivots_json(const Replay& replay, Index n) {
  Json all = Json::array();
  for (std::size_t k = replay.begin; k < replay.end; ++k) {
    const Trace::Step& step = replay.steps[k];
    all.push_back({{"pivot", k + 1},
                   {"entering", name_in(replay, step.event.entering, n)},
                   {"leaving", name_in(replay, step.event.leaving, n)},
                   {"row", row_in(replay, step.event.row)},
                   {"ratio", number(step.event.ratio)},
                   {"tied", step.event.tied},
                   {"size", number(step.event.pivot)},
                   {"condition", nullptr}});
    if (step.condition) all.back()["condition"] = number(*step.condition);
    if (k >= replay.path.pivots.size()) continue;
    const HighPivot& high = replay.path.pivots[k];
    all.back()["in_113_bits"] = {{"entering", name_in(replay, high.entering, n)},
                                 {"leaving", name_in(replay, high.leaving, n)},
                                 {"row", row_in(replay, high.choice.row)},
                                 {"ratio", number(rounded(high.choice.ratio))},
                                 {"tied", high.choice.tied},
                                 {"size", number(rounded(high.choice.pivot))}};
  }
  return all;
}

}  // namespace

std::string sentence(const Replay& replay, Index n) {
  if (replay.departure)
    return "first wrong pivot: " + (replay.comparison == Beside::path
                                        ? of_a_path(replay, n)
                                        : of_one_pivot(replay, *replay.departure, n));
  if (replay.comparison == Beside::search)
    return fmt::format("no wrong pivot among the {} looked at", replay.checked);
  return replay.path.cut_short
             ? fmt::format("no wrong pivot among the {} followed", replay.path.pivots.size())
             : fmt::format("no wrong pivot: both take the same {}", replay.steps.size());
}

std::string text(const Replay& replay, const std::string& title, Index n) {
  const Judgement& judgement = replay.judgement;
  std::string out = fmt::format("{}: {}\n", title, to_string(judgement.verdict));
  if (!replay.message.empty()) out += folded(replay.message);
  out += folded(fmt::format(
      "claimed {}, residual {:.2e}; {}", to_string(replay.claim), judgement.accuracy.residual,
      replay.basis_residual
          ? fmt::format("its basis solved in 113 bits: residual {:.2e}", *replay.basis_residual)
          : "no basis that is regular to 113 bits"));
  if (replay.islands > 1)
    out += folded(fmt::format("island {} of {} ({} rows) is shown", replay.island + 1,
                              replay.islands, replay.rows.size()));
  out += folded(comparison(replay));
  if (replay.comparison != Beside::none) out += folded(sentence(replay, n));
  const std::string none = of_the_first_none(replay, n);
  if (!none.empty()) out += folded(none);
  if (replay.steps.empty() && replay.path.pivots.empty()) return out;
  out += header(replay);
  for (std::size_t k = replay.begin; k < shown_end(replay); ++k)
    out += left_part(replay, k, n) + right_part(replay, k, n) + "\n";
  return out + left_out(replay);
}

Json json(const Replay& replay, Index n) {
  static constexpr const char* comparisons[] = {"path", "search", "none"};
  Json out = {{"claim", to_string(replay.claim)},
              {"message", replay.message},
              {"verdict", to_string(replay.judgement.verdict)},
              {"residual", number(replay.judgement.accuracy.residual)},
              {"basis_residual", nullptr},
              {"comparison", comparisons[static_cast<int>(replay.comparison)]},
              {"island", replay.island + 1},
              {"islands", replay.islands},
              {"pivots", replay.steps.size()}};
  if (replay.basis_residual) out["basis_residual"] = number(*replay.basis_residual);
  if (replay.comparison == Beside::path)
    out["in_113_bits"] = {
        {"claim", to_string(replay.path.claim)}, {"verdict", to_string(replay.path_verdict)},
        {"cut_short", replay.path.cut_short},    {"undecided", replay.path.undecided},
        {"pivots", replay.path.pivots.size()},   {"residual", number(replay.path_residual)}};
  if (replay.comparison == Beside::search) out["checked"] = replay.checked;
  out["sentence"] = replay.comparison == Beside::none ? "" : sentence(replay, n);
  out["departure"] = departure_json(replay, replay.departure, n);
  out["first_none"] = departure_json(replay, replay.first_none, n);
  out["shown"] = pivots_json(replay, n);
  return out;
}

}  // namespace lcp
