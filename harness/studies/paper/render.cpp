#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "harness/studies/paper/paper_table.h"

namespace lcp {

namespace {

/// Columns for a reader, text on the right.
std::vector<ColumnHead> reader_heads(const std::vector<std::string>& headings) {
  std::vector<ColumnHead> heads;
  for (const std::string& each : headings)
    heads.push_back({.heading = each, .number = "{}", .right = true});
  return heads;
}

/// A table of lines_of, its own rows and, where there are any, others below `ours`.
PaperSection row_section(const PaperTable& table, const std::string& title,
                         const std::string& section, const std::vector<std::string>& rows,
                         const std::vector<std::string>& own_rows = {}) {
  PaperSection out{title, {{{.heading = " "}, {.heading = " "}}, {}}};
  for (const PaperColumn& column : table.columns)
    out.cells.heads.push_back({.heading = column.heading, .right = true});
  const auto add = [&](const std::string& key) {
    const PaperQuantity& quantity = paper_quantity(key);
    std::string heading = quantity.heading;
    for (const PaperLine& line : lines_of(table, quantity, section)) {
      out.cells.rows.push_back({std::exchange(heading, ""), line.label});
      for (const PaperCell& cell : line.cells)
        out.cells.rows.back().push_back(printed(quantity, quantity.for_reader(cell.value)) +
                                        (cell.far ? "*" : " "));
    }
  };
  for (const std::string& key : rows) add(key);
  if (own_rows.empty()) return out;
  out.cells.rows.emplace_back(out.cells.heads.size(), "").front() = "ours";
  for (const std::string& key : own_rows) add(key);
  return out;
}

/// Lexicographic order at every threshold, the best one told.
PaperSection sweep_section(const PaperTable& table) {
  PaperSection out{fmt::format("lexicographic in the loop of {}, by threshold delta; best is most "
                               "successes of those whose robot did not fall, then fewest pivots",
                               table.plan.scenes.front().scene),
                   {{{.heading = "delta"}, {.heading = " "}}, {}}};
  for (const std::string& delta : table.plan.deltas)
    out.cells.rows.push_back(
        {delta, column_of_delta(delta).solver == table.plan.solvers.front().solver ? "best" : ""});
  for (const char* key : {"success", "failure", "no_solution", "cycle", "error", "lcp_time_ms",
                          "total_pivots", "fell"}) {
    const PaperQuantity& quantity = paper_quantity(key);
    out.cells.heads.push_back(quantity);
    for (std::size_t i = 0; i < table.sweep.size(); ++i)
      out.cells.rows[i].push_back(quantity.for_reader(table.sweep[i].at(key)));
  }
  return out;
}

bool is_small(const Cell& distance) { return !distance.is_null() && distance <= same_motion; }

PaperSection hoist_section(const PaperTable& table) {
  PaperSection out{
      "Total computation time (simulation time x frames) of hoist over that of hoist:10ms, and "
      "mean distance of the links of hoist:10ms from those of hoist at the end, in % of the length",
      {{{.heading = " "},
        {.heading = "time ratio", .number = "{:.1f}"},
        {.heading = "by its cells", .number = "{:.1f}"},
        {.heading = "distance (%)", .number = "{:.3g}", .scale = 100},
        {.heading = fmt::format("at most {:g} %", 100 * same_motion)}},
       {{"published", table.told_ratio, table.printed_ratio, Cell(), "expected"}}},
      1};
  for (const PaperHoists& each : table.hoists)
    out.cells.rows.push_back({each.heading, each.time_ratio, Cell(), each.end_distance,
                              is_small(each.end_distance)   ? "holds"
                              : each.end_distance.is_null() ? "FAILED (one of the two has no end)"
                                                            : "FAILED"});
  return out;
}

/// How long each solver keeps the bodies together and how far from the reference's motion, in a scene.
PaperSection motion_section(const PaperTable& table, std::size_t scene) {
  PaperSection out{
      table.columns[scene].name,
      {reader_heads({" ", "survived (s)", "contact", "failed", "off (%)", "parted (s)"}), {}},
      1};
  out.cells.heads[4].number = "{:.2g}";
  out.cells.heads[4].scale = 100;
  out.cells.heads[5].number = "{:.3g}";
  for (const PaperLayer& layer : table.layers) {
    const Cell& row = layer.rows[scene];
    const bool moves =
        row.at("total_frames") == 0 || row.at("unsupported") != row.at("total_frames");
    const bool compared = moves && &layer != &table.layers[reference_solver];
    out.cells.rows.push_back({layer.label, "unsupported ", Cell(), Cell(),
                              compared ? row.at("off") : Cell(),
                              compared ? row.at("parted") : Cell()});
    if (!moves) continue;
    std::vector<Cell>& cells = out.cells.rows.back();
    cells[1] = fmt::format("{:.4g}{}", row.at("survived").get<double>(),
                           row.at("stopped") == true ? "+" : " ");
    cells[2] = row.at("total_frames");
    cells[3] = row.at("failure");
  }
  return out;
}

std::vector<PaperSection> sections_of(const PaperTable& table) {
  std::vector<PaperSection> all = {
      row_section(table, title_of(table), "", table.plan.rows, table.plan.own_rows)};
  if (!table.sweep.empty()) all.push_back(sweep_section(table));
  for (const PaperLayer& layer : table.layers)
    if (layer.section.starts_with("corpus ") && !layer.second_look)
      all.push_back(
          row_section(table, layer.section, layer.section,
                      {"success", "no_solution", "cycle", "error", "frictionless_failures"}));
  if (!table.hoists.empty()) all.push_back(hoist_section(table));
  if (table.layers.back().section == rest_section)
    for (std::size_t scene = 0; scene < table.columns.size(); ++scene)
      all.push_back(motion_section(table, scene));
  return all;
}

std::vector<std::string> notes_of(const PaperTable& table) {
  const PaperPlan& plan = table.plan;
  const std::string& scene = plan.scenes.front().scene;
  std::vector<std::string> notes = {
      "* differs from the published value by more than a factor of 2, or exceeds what the text "
      "allows.",
      "published: " + table.source};
  if (!plan.by_scene())
    notes.push_back(
        fmt::format("in the loop: every column drives its own simulation. on corpus: every column "
                    "solves the same "
                    "LCPs, those of {} as driven by {}, in two steps; the time there is that of "
                    "both steps. fell: "
                    "tilted by more than 45 degrees, or ended early.",
                    scene, plan.driver));
  for (const PaperScene& each : plan.scenes)
    if (each.name != each.scene) notes.push_back(each.name + ": " + each.scene);
  for (const PaperColumn& each : plan.solvers)
    notes.push_back(fmt::format("{}: {}, judged in the loop by {} {:g}", each.heading, each.solver,
                                to_string(each.acceptance.criterion), each.acceptance.tolerance));
  notes.push_back(fmt::format(
      "paper: |w - M z - q - z0 c| <= e_max = {} (unscaled, of the solver's own w, which says "
      "nothing of signs); residual, and lines \"at 1e-6\": the natural residual recomputed from z "
      "is at "
      "most {} (scaled).",
      by_paper.tolerance, second_look.tolerance));
  if (plan.solvers.back().limit)
    notes.push_back(fmt::format(
        "survived: simulated until the bodies flew apart, or all of it; +: stopped after {:g} s of "
        "computing. contact: frames with contact; failed: of their frictional LCPs. off: mean "
        "distance of the links from where {} has them, at the end or at the last twentieth that "
        "both reached, in % of the length of what moves; parted: first twentieth of the duration "
        "at which that exceeds {:g} %.",
        *plan.solvers.back().limit, plan.solvers[reference_solver].heading, 100 * same_motion));
  notes.insert(notes.end(), table.broken.begin(), table.broken.end());
  for (const std::string& each : table.published.notes) notes.push_back("The paper: " + each);
  notes.push_back(fmt::format("{} simulation{} ran at the same time{}.", table.jobs,
                              table.jobs == 1 ? "" : "s",
                              table.jobs == 1 ? "" : ": times are disturbed"));
  return notes;
}

Cell json_of(const PaperTable& table) {
  Cell rows = Cell::array(), ratios = Cell::array(), distances = Cell::array();
  for (const PaperLayer& layer : table.layers)
    for (const Cell& row : layer.rows)
      if (!row.is_null()) rows.push_back(row);
  Cell object = {{"title", table.published.title}, {"source", table.source}, {"rows", rows}};
  if (!table.sweep.empty()) object["delta_sweep"] = table.sweep;
  if (!table.plan.by_scene()) return object;
  for (const PaperHoists& each : table.hoists) {
    ratios.push_back({{"solver", each.solver}, {"value", each.time_ratio}});
    distances.push_back({{"solver", each.solver},
                         {"value", each.end_distance},
                         {"holds", is_small(each.end_distance)}});
  }
  object["ratio"] = {{"of", "simulation_time_ms * total_frames, hoist over hoist:10ms"},
                     {"published", table.told_ratio},
                     {"published_cells", table.printed_ratio},
                     {"measured", ratios}};
  object["distance"] = {
      {"of", "links of hoist:10ms from those of hoist at the end, mean, over the length"},
      {"expected_at_most", same_motion},
      {"measured", distances}};
  return object;
}

void add_value(CellTable& lines, const Cell& row, const char* part, const std::string& quantity,
               const std::string& unit, const Cell& value, const Cell& published = {}) {
  lines.rows.emplace_back();
  for (const ColumnHead& head : lines.heads)
    lines.rows.back().push_back(row.value(head.key, Cell()));
  lines.rows.back()[1] = part;
  std::copy_n(std::array<Cell, 4>{quantity, unit, value, published}.begin(), 4,
              lines.rows.back().end() - 4);
}

/// Those of the row's quantities that have a value.
void add_values(CellTable& lines, const Cell& row, const char* part) {
  const Cell published = row.value("published", Cell::object());
  for (const PaperQuantity& quantity : paper_quantities()) {
    const Cell stated = published.value(quantity.key, Cell());
    if (!row.at(quantity.key).is_null() || !stated.is_null())
      add_value(lines, row, part, quantity.key, quantity.unit, row.at(quantity.key), stated);
  }
}

/// A line per value.
std::string csv_of(const PaperTable& table) {
  CellTable lines;
  for (const char* key : {"table", "part", "mode", "corpus", "criterion", "tolerance", "column",
                          "solver", "quantity", "unit", "value", "published"})
    lines.heads.push_back({.key = key});
  for (const PaperLayer& layer : table.layers)
    for (const Cell& row : layer.rows) {
      if (row.is_null()) continue;
      add_values(lines, row, "column");
      for (const auto& [key, unit] : {std::pair("survived", "s"), {"off", ""}, {"parted", "s"}})
        if (const Cell value = row.value(key, Cell()); !value.is_null())
          add_value(lines, row, "motion", key, unit, value);
    }
  for (const Cell& row : table.sweep) add_values(lines, row, "delta-sweep");
  for (std::size_t i = 0; i < table.hoists.size(); ++i) {
    const PaperHoists& each = table.hoists[i];
    Cell both = table.layers[i].rows.front();
    both["column"] = "hoist";
    both["corpus"] = "hoist:10ms";
    add_value(lines, both, "ratio", "time_ratio", "", each.time_ratio, table.told_ratio);
    add_value(lines, both, "ratio", "time_ratio_of_cells", "", {}, table.printed_ratio);
    add_value(lines, both, "distance", "end_distance", "", each.end_distance);
  }
  return csv_text(lines);
}

}  // namespace

std::string title_of(const PaperTable& table) {
  return fmt::format("Table {}. {} ({})", std::string(table.plan.table, 'I'), table.published.title,
                     table.published.section);
}

PaperPage page_of(const PaperTable& table) {
  return {sections_of(table), notes_of(table), csv_of(table), json_of(table).dump(1) + "\n"};
}

}  // namespace lcp
