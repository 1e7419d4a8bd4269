#include "harness/studies/perturb/perturb_pages.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "harness/present/columns.h"

namespace lcp {

namespace {

using FlipColumns = std::vector<Column<FlipRow>>;

bool has_rate(const FlipRow& row) { return row.kind != "baseline" && row.trials > 0; }

/// The rate or an end of its interval.
Column<FlipRow> rate_column(const char* key, double (*value)(const FlipRow&)) {
  return {{key}, [value](const FlipRow& row) { return has_rate(row) ? Cell(value(row)) : Cell(); }};
}

/// A column for readers: of a row that was tried, or of a disturbed one.
template <class Value>
Column<FlipRow> shown(const char* heading, const char* meaning, bool (*applies)(const FlipRow&),
                      Value value) {
  return {{"", heading, meaning},
          [=](const FlipRow& row) { return applies(row) ? Cell(value(row)) : Cell(); }};
}

std::string out_of(Index part, Index whole) { return fmt::format("{}/{}", part, whole); }

FlipColumns read_columns() {
  const auto tried = [](const FlipRow& row) { return row.trials > 0; };
  const auto other_z = [](const FlipRow& row) { return has_rate(row) && row.other_z > 0; };
  const auto spread = [](const FlipRow& row) { return has_rate(row) && row.pivot_ratio; };
  const auto if_any = [](Column<FlipRow> column) {
    column.only_if_any = true;
    return column;
  };
  const auto left_out = [&](const char* heading, const char* meaning, Index FlipRow::*field) {
    return if_any({{"", heading, meaning},
                   [=](const FlipRow& row) { return row.*field > 0 ? Cell(row.*field) : Cell(); }});
  };
  return {
      {{"", "kind"},
       [](const FlipRow& row) { return row.kind == "baseline" ? row.label : "  " + row.kind; }},
      shown("trials", "disturbed runs (beside the solver: undisturbed ones); blank: does not apply",
            tried, [](const FlipRow& row) { return row.trials; }),
      shown("solved", "of the trials", tried, [](const FlipRow& row) { return row.solved; }),
      shown("flips",
            "trials whose verdict is solved where the undisturbed one is not (gained), or the "
            "reverse (lost)",
            has_rate, [](const FlipRow& row) { return row.flips(); }),
      shown("95%",
            "Wilson interval of flips / trials, as if trials of one instance were independent",
            has_rate,
            [](const FlipRow& row) {
              return fmt::format("{:.1f}-{:.1f}%", 100 * row.rate().low, 100 * row.rate().high);
            }),
      shown("lost", "", has_rate, [](const FlipRow& row) { return row.lost; }),
      shown("gained", "", has_rate, [](const FlipRow& row) { return row.gained; }),
      shown("other", "solved in neither, and another verdict", has_rate,
            [](const FlipRow& row) { return row.other_changes; }),
      shown("flipped", "instances with a flip, of those tried", has_rate,
            [](const FlipRow& row) { return out_of(row.instances_flipped, row.instances); }),
      shown("z's", "instances with more than one solution, of those solved twice or more", has_rate,
            [](const FlipRow& row) { return out_of(row.several, row.compared); }),
      shown("most", "solutions told apart on one instance", has_rate,
            [](const FlipRow& row) { return row.most_distinct; }),
      if_any(shown(
          "same w",
          "of the solved runs whose z is not the undisturbed one's (the first solved run's), "
          "those whose w is",
          other_z, [](const FlipRow& row) { return out_of(row.other_z_same_w, row.other_z); })),
      if_any(shown(
          "same v", "and those that move the contacts alike: v+ = W f + vbar (w without contacts)",
          other_z,
          [](const FlipRow& row) { return out_of(row.other_z_same_motion, row.other_z); })),
      shown("pivots", "median over the solved runs", tried,
            [](const FlipRow& row) { return cell_of(row.pivots); }),
      shown("spread", "most over least pivots on one instance: median, largest", spread,
            [](const FlipRow& row) {
              return fmt::format("{:.2f} {:.2f}", *row.pivot_ratio, *row.pivot_ratio_max);
            }),
      left_out("trivial", "instances that z = 0 solves, left out", &FlipRow::trivial),
      left_out("refused", "runs unsupported by the solver, left out", &FlipRow::unsupported),
      left_out("not run", "instances too large, left out", &FlipRow::not_run)};
}

/// A row as programs read it. Rates are null where nothing was measured.
FlipColumns flip_columns() {
  FlipColumns columns = {{{"corpus"}, [](const FlipRow& row) { return row.corpus; }},
                         {{"solver"}, [](const FlipRow& row) { return row.solver; }},
                         {{"label"}, [](const FlipRow& row) { return row.label; }},
                         {{"start"}, [](const FlipRow& row) { return row.start; }},
                         {{"kind"}, [](const FlipRow& row) { return row.kind; }},
                         {{"flips"}, [](const FlipRow& row) { return row.flips(); }}};
  for (const auto& [key, field] : std::initializer_list<std::pair<const char*, Index FlipRow::*>>{
           {"instances", &FlipRow::instances},
           {"trials", &FlipRow::trials},
           {"solved", &FlipRow::solved},
           {"baseline_solved", &FlipRow::baseline_solved},
           {"lost", &FlipRow::lost},
           {"gained", &FlipRow::gained},
           {"other_changes", &FlipRow::other_changes},
           {"instances_flipped", &FlipRow::instances_flipped},
           {"compared", &FlipRow::compared},
           {"several", &FlipRow::several},
           {"most_distinct", &FlipRow::most_distinct},
           {"other_z", &FlipRow::other_z},
           {"other_z_same_w", &FlipRow::other_z_same_w},
           {"other_z_same_motion", &FlipRow::other_z_same_motion},
           {"trivial", &FlipRow::trivial},
           {"unsupported", &FlipRow::unsupported},
           {"not_run", &FlipRow::not_run}})
    columns.push_back({{key}, [field = field](const FlipRow& row) { return row.*field; }});
  columns.push_back(rate_column("flip_rate", [](const FlipRow& row) {
    return static_cast<double>(row.flips()) / static_cast<double>(row.trials);
  }));
  columns.push_back(
      rate_column("flip_rate_low", [](const FlipRow& row) { return row.rate().low; }));
  columns.push_back(
      rate_column("flip_rate_high", [](const FlipRow& row) { return row.rate().high; }));
  for (const auto& [key, field] :
       std::initializer_list<std::pair<const char*, std::optional<double> FlipRow::*>>{
           {"pivots", &FlipRow::pivots},
           {"pivot_ratio", &FlipRow::pivot_ratio},
           {"pivot_ratio_max", &FlipRow::pivot_ratio_max}})
    columns.push_back({{key}, [field = field](const FlipRow& row) { return cell_of(row.*field); }});
  return columns;
}

std::string flips_text(const Flips& flips) {
  if (flips.rows.empty()) return "no rows\n";
  const FlipColumns columns = read_columns();
  std::string out;
  for (auto begin = flips.rows.begin(), end = begin; begin != flips.rows.end(); begin = end) {
    end = std::find_if(begin, flips.rows.end(),
                       [&](const FlipRow& row) { return row.corpus != begin->corpus; });
    out += begin->corpus + "\n";
    out += text_table(cells_of(columns, std::vector<FlipRow>(begin, end)), {.empty = ""}) + "\n";
  }
  out += legend(cells_of(columns, flips.rows));
  for (const NotApplicable& each : flips.not_applicable)
    out += folded(fmt::format("{}: {} unsupported for {} instance{}: {}", each.corpus, each.kind,
                              each.instances, each.instances == 1 ? "" : "s", each.reason));
  const PerturbOptions& options = flips.options;
  return out +
         folded(fmt::format(
             "Solved means a natural residual of at most {}. Two z (w) are the same within {} of "
             "their scales. Noise: up to {} last bit{}. Rotation: {}. Seed {}.",
             flips.tolerance, flips.same, options.last_bits, options.last_bits == 1 ? "" : "s",
             options.angle ? fmt::format("up to {} degrees, another polygon", *options.angle)
                           : "by multiples of the directions' spacing, the same polygon",
             options.seed));
}

nlohmann::ordered_json flips_json(const Flips& flips) {
  nlohmann::ordered_json whole = {{"options", nlohmann::json(flips.options)},
                                  {"same", flips.same},
                                  {"tolerance", flips.tolerance},
                                  {"rows", nlohmann::ordered_json::array()},
                                  {"not_applicable", nlohmann::ordered_json::array()}};
  for (const FlipRow& row : flips.rows) whole["rows"].push_back(json_object(flip_columns(), row));
  for (const NotApplicable& each : flips.not_applicable)
    whole["not_applicable"].push_back({{"corpus", each.corpus},
                                       {"kind", each.kind},
                                       {"reason", each.reason},
                                       {"instances", each.instances}});
  return whole;
}

}  // namespace

Described described(const Flips& flips) {
  Described all{.text = flips_text(flips), .json = flips_json(flips)};
  FlipColumns columns = flip_columns();
  std::erase_if(columns, [](const Column<FlipRow>& column) { return column.key == "label"; });
  all.csv = csv_text(cells_of(columns, flips.rows));
  if (std::any_of(flips.rows.begin(), flips.rows.end(),
                  [](const FlipRow& row) { return row.trials > 0; }))
    all.figure = flips_figure(flips);
  return all;
}

}  // namespace lcp
