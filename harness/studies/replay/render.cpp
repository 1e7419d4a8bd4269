#include "harness/studies/replay/render.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/present/columns.h"

namespace lcp {

namespace {

using Json = nlohmann::ordered_json;

double rounded(const Estimate& x) { return static_cast<double>(x.value); }

/// Infinite figures are strings.
Json number(double value) {
  if (std::isfinite(value)) return value;
  return fmt::format("{}", value);
}

/// Name in the instance of a variable of the shown island.
std::string name_in(const Replay& replay, Variable v, Index n) {
  const Index size = static_cast<Index>(replay.rows.size());
  if (v == 2 * size) return "z0";
  return v < size ? variable_name(static_cast<int>(replay.rows[v]), n)
                  : variable_name(static_cast<int>(n + replay.rows[v - size]), n);
}

Index row_in(const Replay& replay, Index row) { return replay.rows[row] + 1; }

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
      return ", which is 0 in exact arithmetic";
    case Why::no_pivot:
      return fmt::format(", which is {:.4g} in 113 bits and no pivot", rounded(departure.size));
    case Why::larger_ratio:
      return fmt::format(", whose ratio, {:.6g} in 113 bits, is not the least",
                         rounded(departure.ratio));
    case Why::lost_tie:
      return ", which is tied in 113 bits but not the row to take";
    case Why::infeasible:
      return fmt::format(", which leaves min q' = {:.4g} in 113 bits",
                         static_cast<double>(departure.q_min));
    case Why::singular_basis:
      return ", in a basis that is singular to 113 bits";
    case Why::ended:
    case Why::went_on:
      break;
  }
  return "";
}

/// A pivot judged by itself.
std::string of_one_pivot(const Replay& replay, const Departure& departure, Index n) {
  const PivotEvent& taken = replay.steps[departure.pivot - 1].event;
  return fmt::format("number {}: {} enters and takes row {} ({} leaves) with pivot {:.3g}{}",
                     departure.pivot, name_in(replay, taken.entering, n), row_in(replay, taken.row),
                     name_in(replay, taken.leaving, n), taken.pivot, fault(departure));
}

std::string of_a_path(const Replay& replay, Index n) {
  const Departure& departure = *replay.departure;
  if (departure.why == Departure::Why::ended)
    return fmt::format("the run ends after {} pivots ({}), where {} enters and {}",
                       replay.steps.size(), to_string(replay.island_claim),
                       name_in(replay, departure.entering, n), of_the_rule(replay, n));
  return of_one_pivot(replay, departure, n) + "; " + of_the_rule(replay, n);
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

bool is_at(const std::optional<Departure>& found, std::size_t k) {
  return found && found->pivot == static_cast<Index>(k) + 1;
}

/// A pivot of the run, or of the rule in 113 bits.
struct Taken {
  Variable entering, leaving;
  Index row, tied;
  double ratio, size;
};

std::optional<Taken> by_run(const Replay& replay, std::size_t k) {
  if (k >= replay.steps.size()) return std::nullopt;
  const PivotEvent& event = replay.steps[k].event;
  return Taken{event.entering, event.leaving, event.row, event.tied, event.ratio, event.pivot};
}

std::optional<Taken> by_rule(const Replay& replay, std::size_t k) {
  if (k >= replay.path.pivots.size()) return std::nullopt;
  const auto& [entering, leaving, choice] = replay.path.pivots[k];
  return Taken{
      entering, leaving, choice.row, choice.tied, rounded(choice.ratio), rounded(choice.pivot)};
}

using PivotColumns = std::vector<Column<std::size_t>>;  // Of a pivot by its number, from 0.

/// The columns of what `taken` gives, empty where it gives nothing.
PivotColumns columns_of(const Replay& replay, Index n,
                        std::optional<Taken> (*taken)(const Replay&, std::size_t)) {
  const auto column = [&replay, taken](ColumnHead head, auto value) -> Column<std::size_t> {
    return {std::move(head), [&replay, taken, value](std::size_t k) {
              const std::optional<Taken> pivot = taken(replay, k);
              return pivot ? Cell(value(*pivot)) : Cell();
            }};
  };
  return {
      column({"entering", "enters"},
             [&replay, n](const Taken& p) { return name_in(replay, p.entering, n); }),
      column({"leaving", "leaves"},
             [&replay, n](const Taken& p) { return name_in(replay, p.leaving, n); }),
      column({"row"}, [&replay](const Taken& p) { return row_in(replay, p.row); }),
      column({"ratio", "ratio", "", "{:.4g}"}, [](const Taken& p) { return number(p.ratio); }),
      column({"tied", "tied"}, [](const Taken& p) { return p.tied; }),
      column({"size", "pivot size", "", "{:.4g}"}, [](const Taken& p) { return number(p.size); })};
}

/// The number of a pivot, what the run took and its condition.
PivotColumns columns_of_run(const Replay& replay, Index n) {
  PivotColumns columns = columns_of(replay, n, by_run);
  columns.insert(columns.begin(), {{"pivot"}, [](std::size_t k) { return k + 1; }});
  columns.push_back({{"condition", "cond", "", "{:.2g}"}, [&replay](std::size_t k) {
                       const bool known = k < replay.steps.size() && replay.steps[k].condition;
                       return known ? number(*replay.steps[k].condition) : Cell();
                     }});
  return columns;
}

std::string pivots_text(const Replay& replay, Index n) {
  PivotColumns columns = columns_of_run(replay, n);
  columns.insert(columns.begin(), {{"", "  pivot"}, [&replay](std::size_t k) {
                                     const char* mark = is_at(replay.departure, k)    ? "> "
                                                        : is_at(replay.first_none, k) ? "0 "
                                                                                      : "  ";
                                     return k < replay.steps.size()
                                                ? fmt::format("{}{:>5}", mark, k + 1)
                                                : std::string();
                                   }});
  if (replay.comparison != Beside::none)
    columns.push_back({{"", "|"}, [](std::size_t) { return "|"; }});
  if (replay.comparison == Beside::path) {
    for (Column<std::size_t>& column : columns_of(replay, n, by_rule))
      if (column.key != "tied") columns.push_back(std::move(column));
    (columns.end() - 5)->heading = "113:";
  } else if (replay.comparison == Beside::search) {
    columns.push_back(
        {{"", "parent"}, [&replay](std::size_t k) { return replay.steps[k].event.parent; }});
    columns.push_back(
        {{"", "113 bits"}, [&replay](std::size_t k) {
           return is_at(replay.departure, k) ? "not allowed" : k < replay.checked ? "allowed" : "-";
         }});
  }
  std::vector<std::size_t> shown;
  for (std::size_t k = replay.begin; k < replay.end; ++k) shown.push_back(k);
  if (is_at(replay.departure, replay.end) && replay.end < replay.path.pivots.size())
    shown.push_back(replay.end);  // that the rule alone takes
  std::string out = text_table(cells_of(columns, shown), {.empty = ""});
  const std::size_t before = replay.begin, after = replay.steps.size() - replay.end;
  if (before + after > 0)
    out +=
        fmt::format("  left out: {} pivots before these, {} after them (--all)\n", before, after);
  return out;
}

Json departure_json(const Replay& replay, const std::optional<Departure>& found, Index n) {
  static constexpr const char* words[] = {"zero pivot",    "no pivot",       "larger ratio",
                                          "lost tie",      "infeasible",     "singular basis",
                                          "the run ended", "the run went on"};
  if (!found) return nullptr;
  Json out = {{"pivot", found->pivot},
              {"why", words[static_cast<int>(found->why)]},
              {"entering", name_in(replay, found->entering, n)},
              {"row", nullptr},
              {"rule_row", nullptr}};
  if (found->row >= 0) {
    out["row"] = row_in(replay, found->row);
    out["pivot_in_113_bits"] = number(rounded(found->size));
    out["ratio_in_113_bits"] = number(rounded(found->ratio));
  }
  if (found->rule.row >= 0) {
    out["rule_row"] = row_in(replay, found->rule.row);
    out["rule_ratio"] = number(rounded(found->rule.ratio));
    out["rule_pivot"] = number(rounded(found->rule.pivot));
  }
  return out;
}

Json pivots_json(const Replay& replay, Index n) {
  Json all = Json::array();
  for (std::size_t k = replay.begin; k < replay.end; ++k) {
    all.push_back(json_object(columns_of_run(replay, n), k));
    if (k < replay.path.pivots.size())
      all.back()["in_113_bits"] = json_object(columns_of(replay, n, by_rule), k);
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
  const auto say = [&out](const std::string& words) { out += folded("  " + words, 100, 4); };
  if (!replay.message.empty()) say(replay.message);
  say(fmt::format(
      "claimed {}, residual {:.2e}; {}", to_string(replay.claim), judgement.accuracy.residual,
      replay.basis_residual
          ? fmt::format("its basis solved in 113 bits: residual {:.2e}", *replay.basis_residual)
          : "no basis that is regular to 113 bits"));
  if (replay.islands > 1)
    say(fmt::format("island {} of {} ({} rows) is shown", replay.island + 1, replay.islands,
                    replay.rows.size()));
  say(comparison(replay));
  if (replay.comparison != Beside::none) say(sentence(replay, n));
  if (replay.first_none && replay.first_none->pivot != replay.departure->pivot)
    say("first pivot that is none: " + of_one_pivot(replay, *replay.first_none, n));
  if (replay.steps.empty() && replay.path.pivots.empty()) return out;
  return out + pivots_text(replay, n);
}

Json json(const Replay& replay, Index n) {
  Json out = {{"claim", to_string(replay.claim)},
              {"message", replay.message},
              {"verdict", to_string(replay.judgement.verdict)},
              {"residual", number(replay.judgement.accuracy.residual)},
              {"basis_residual", nullptr},
              {"comparison", to_string(replay.comparison)},
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
