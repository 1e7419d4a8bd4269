#include <fmt/format.h>

#include <algorithm>

#include "harness/studies/paper/paper_table.h"
#include "harness/studies/paper/sections.h"

namespace lcp {

namespace {

using Row = std::vector<Cell>;

ColumnHead reader_head(const std::string& heading, const char* number = "{}", double scale = 1) {
  return {.heading = heading, .number = number, .scale = scale};
}

std::vector<ColumnHead> reader_heads(const std::vector<std::string>& names,
                                     const std::vector<std::string>& headings) {
  std::vector<ColumnHead> heads;
  for (const auto* all : {&names, &headings})
    for (const std::string& each : *all) heads.push_back(reader_head(each));
  for (std::size_t i = names.size(); i < heads.size(); ++i) heads[i].right = true;
  return heads;
}

std::string roman(const PaperTable& table) { return std::string(table.plan.table, 'I'); }

/// The paper's rows, and ours below.
PaperSection main_section(const PaperTable& table) {
  PaperSection section{fmt::format("Table {}. {} ({})", roman(table), table.published.title,
                                   table.published.section),
                       {reader_heads({" ", " "}, table.headings), {}},
                       2};
  const auto add = [&](const std::vector<std::string>& keys) {
    for (const std::string& key : keys) {
      const PaperQuantity& quantity = paper_quantity(key);
      std::string heading = quantity.heading;
      for (const PaperLine& line : lines_of(table, quantity)) {
        Row row = {heading, line.label};
        for (const PaperCell& cell : line.cells)
          row.push_back(quantity.shown(cell.value) + (cell.far ? "*" : " "));
        section.cells.rows.push_back(std::move(row));
        heading.clear();
      }
    }
  };
  add(table.plan.rows);
  section.cells.rows.push_back(Row(table.headings.size() + 2, ""));
  section.cells.rows.back().front() = "ours";
  add(table.plan.own_rows);
  return section;
}

/// Lexicographic order at every threshold, the best one told.
PaperSection sweep_section(const PaperTable& table) {
  PaperSection section{fmt::format("lexicographic in the loop of {}, by threshold delta; best is "
                                   "most successes of those whose robot did not fall, then fewest "
                                   "pivots",
                                   table.plan.scenes.front().scene),
                       {reader_heads({"delta", " "}, {}), {}},
                       2};
  const char* const keys[] = {"success", "failure",     "no_solution",  "cycle",
                              "error",   "lcp_time_ms", "total_pivots", "fell"};
  for (const char* key : keys) {
    std::string heading = paper_quantity(key).heading;
    heading.erase(0, heading.find_first_not_of(' '));
    section.cells.heads.push_back(reader_head(heading));
    section.cells.heads.back().right = true;
  }
  for (std::size_t i = 0; i < table.sweep.size(); ++i) {
    const bool best = table.sweep[i]["solver"] == table.plan.solvers.front().solver;
    Row row = {table.plan.deltas[i], best ? "best" : ""};
    for (const char* key : keys) row.push_back(paper_quantity(key).shown(table.sweep[i].at(key)));
    section.cells.rows.push_back(std::move(row));
  }
  return section;
}

/// The other corpora, with other matrices of the same contacts.
std::vector<PaperSection> corpus_sections(const PaperTable& table) {
  std::vector<PaperSection> sections;
  for (const PaperLayer& layer : table.layers) {
    if (layer.section.empty() || layer.section == rest_section || layer.second_look) continue;
    sections.push_back({layer.section, {reader_heads({" ", " "}, table.headings), {}}, 2});
    for (const char* key : {"success", "no_solution", "cycle", "error", "frictionless_failures"})
      for (const PaperLayer& each : table.layers) {
        if (each.section != layer.section) continue;
        const PaperQuantity& quantity = paper_quantity(key);
        Row row = {each.second_look ? "" : quantity.heading, each.label};
        for (const Cell& object : each.rows)
          row.push_back(quantity.shown(value_in(object, key)) + " ");
        sections.back().cells.rows.push_back(std::move(row));
      }
  }
  return sections;
}

PaperSection hoist_section(const PaperTable& table) {
  PaperSection section{
      "Total computation time (simulation time x frames) of hoist over that of hoist:10ms, and "
      "mean "
      "distance of the links of hoist:10ms from those of hoist at the end, in % of the length",
      {{reader_head(" "), reader_head("time ratio", "{:.1f}"),
        reader_head("by its cells", "{:.1f}"), reader_head("distance (%)", "{:.3g}", 100),
        reader_head(fmt::format("at most {:g} %", 100 * same_motion))},
       {{"published", cell_of(told_time_ratio(table.published)),
         cell_of(printed_time_ratio(table.published)), Cell(), "expected"}}}};
  for (const PaperHoists& hoists : table.hoists)
    section.cells.rows.push_back({hoists.heading, cell_of(hoists.time_ratio), Cell(),
                                  cell_of(hoists.end_distance),
                                  !hoists.end_distance ? "FAILED (one of the two has no end)"
                                  : *hoists.end_distance <= same_motion ? "holds"
                                                                        : "FAILED"});
  return section;
}

/// How long each solver keeps the bodies together and how far from the reference's motion, by scene.
std::vector<PaperSection> motion_sections(const PaperTable& table) {
  std::vector<PaperSection> sections;
  for (std::size_t scene = 0; scene < table.names.size(); ++scene) {
    sections.push_back({table.names[scene],
                        {{reader_head(" "), reader_head("survived (s)"), reader_head("contact"),
                          reader_head("failed"), reader_head("off (%)", "{:.2g}", 100),
                          reader_head("parted (s)", "{:.3g}")},
                         {}}});
    sections.back().cells.heads[1].right = true;
    for (const PaperLayer& layer : table.layers) {
      const Cell& row = layer.rows[scene];
      const Cell& frames = row.at("total_frames");
      const bool moves = frames.is_null() || frames == 0 || row.at("unsupported") != frames;
      const bool reference = &layer == &table.layers[reference_solver];
      Row cells = {layer.label, "unsupported ", Cell(), Cell(), Cell(), Cell()};
      if (moves)
        cells = {layer.label,
                 fmt::format("{:.4g}{}", row.at("survived").get<double>(),
                             row.at("stopped") == true ? "+" : " "),
                 frames,
                 row.at("failure"),
                 reference ? Cell() : row.at("off"),
                 reference ? Cell() : row.at("parted")};
      sections.back().cells.rows.push_back(std::move(cells));
    }
  }
  return sections;
}

/// What each column, or line, is in full, and by what it is judged in the loop.
PaperSection solver_section(const PaperTable& table) {
  PaperSection section{"Solvers, and by what their answers are judged in the loop",
                       {reader_heads({" ", "judged by", "spelling"}, {}), {}}};
  for (const PaperColumn& each : table.plan.solvers)
    section.cells.rows.push_back(
        {each.heading,
         fmt::format("{} {:g}", to_string(each.acceptance.criterion), each.acceptance.tolerance),
         each.solver});
  return section;
}

std::vector<PaperSection> sections_of(const PaperTable& table) {
  std::vector<PaperSection> all = {main_section(table)};
  const auto append = [&](std::vector<PaperSection> more) {
    std::move(more.begin(), more.end(), std::back_inserter(all));
  };
  if (!table.sweep.empty()) all.push_back(sweep_section(table));
  append(corpus_sections(table));
  if (!table.hoists.empty()) all.push_back(hoist_section(table));
  if (table.layers.back().section == rest_section) append(motion_sections(table));
  all.push_back(solver_section(table));
  return all;
}

std::vector<std::string> notes_of(const PaperTable& table) {
  const PaperPlan& plan = table.plan;
  std::vector<std::string> notes = {"published: " + table.source};
  if (plan.by_scene()) {
    for (const PaperScene& each : plan.scenes)
      if (each.name != each.scene) notes.push_back(each.name + ": " + each.scene);
  } else {
    notes.push_back("in the loop: every column drives its own simulation of " +
                    plan.scenes.front().scene + ".");
    for (std::size_t i = 1; i < plan.scenes.size(); ++i)
      notes.push_back(
          fmt::format("{}: the same with {}.", plan.scenes[i].name, plan.scenes[i].scene));
    notes.push_back(fmt::format(
        "on corpus: every column solves the same LCPs, those of {} as driven by {}, in two steps; "
        "the time there is that of both steps.",
        plan.scenes.front().scene, plan.driver));
    notes.push_back("fell: tilted by more than 45 degrees, or ended early.");
  }
  notes.push_back(fmt::format(
      "Judged by the paper's criterion an answer is a success where |w - M z - q - z0 c| <= e_max "
      "= "
      "{} (unscaled, of the solver's own w, which says nothing of signs); by the residual, and in "
      "lines \"at 1e-6\", where the natural residual recomputed from z is at most {} (scaled).",
      by_paper.tolerance, second_look.tolerance));
  if (table.layers.back().section == rest_section)
    notes.push_back(fmt::format(
        "survived: simulated until the bodies flew apart, or all of it; +: stopped after {:g} s of "
        "computing. contact: frames with contact; failed: of their frictional LCPs. off: mean "
        "distance of the links from where {} has them, at the end or at the last twentieth that "
        "both reached, in % of the length of what moves; parted: first twentieth of the duration "
        "at which that exceeds {:g} %.",
        plan.solvers.back().limit.value_or(0), plan.solvers[reference_solver].heading,
        100 * same_motion));
  notes.insert(notes.end(), table.broken.begin(), table.broken.end());
  for (const std::string& each : table.published.notes) notes.push_back("The paper: " + each);
  notes.push_back(fmt::format("{} simulation{} ran at the same time{}.", table.jobs,
                              table.jobs == 1 ? "" : "s",
                              table.jobs == 1 ? "" : ": times are disturbed"));
  notes.push_back(
      "* differs from the published value by more than a factor of 2, or exceeds what "
      "the text allows.");
  return notes;
}

Cell json_of(const PaperTable& table) {
  Cell rows = Cell::array();
  for (const PaperLayer& layer : table.layers)
    for (const Cell& row : layer.rows)
      if (!row.is_null()) rows.push_back(row);
  Cell json = {{"title", table.published.title}, {"source", table.source}, {"rows", rows}};
  if (!table.sweep.empty()) json["delta_sweep"] = table.sweep;
  if (!table.plan.by_scene()) return json;
  Cell ratios = Cell::array(), distances = Cell::array();
  for (const PaperHoists& hoists : table.hoists) {
    const bool holds = hoists.end_distance && *hoists.end_distance <= same_motion;
    ratios.push_back({{"solver", hoists.solver}, {"value", cell_of(hoists.time_ratio)}});
    distances.push_back(
        {{"solver", hoists.solver}, {"value", cell_of(hoists.end_distance)}, {"holds", holds}});
  }
  json["ratio"] = {{"of", "simulation_time_ms * total_frames, hoist over hoist:10ms"},
                   {"published", cell_of(told_time_ratio(table.published))},
                   {"published_cells", cell_of(printed_time_ratio(table.published))},
                   {"measured", ratios}};
  json["distance"] = {
      {"of", "links of hoist:10ms from those of hoist at the end, mean, over the length"},
      {"expected_at_most", same_motion},
      {"measured", distances}};
  return json;
}

/// A line per value.
class ValueLines {
 public:
  ValueLines() {
    for (const char* key : {"table", "part", "mode", "corpus", "criterion", "tolerance", "column",
                            "solver", "quantity", "unit", "value", "published"})
      lines_.heads.push_back({.key = key});
  }

  /// Those of the row's quantities that have one.
  void add_quantities(const Cell& row, const char* part) {
    const Cell published = row.value("published", Cell::object());
    for (const PaperQuantity& quantity : paper_quantities()) {
      const Cell stated = published.value(quantity.key, Cell());
      if (!row.at(quantity.key).is_null() || !stated.is_null())
        add(row, part, quantity.key, quantity.unit, row.at(quantity.key), stated);
    }
  }

  void add(const Cell& row, const char* part, const std::string& quantity, const std::string& unit,
           const Cell& value, const Cell& published = {}) {
    lines_.rows.push_back({row.at("table"), part, row.at("mode"), row.at("corpus"),
                           row.at("criterion"), row.at("tolerance"), row.at("column"),
                           row.at("solver"), quantity, unit, value, published});
  }

  std::string text() const { return csv_text(lines_); }

 private:
  CellTable lines_;
};

std::string csv_of(const PaperTable& table) {
  ValueLines lines;
  for (const PaperLayer& layer : table.layers)
    for (const Cell& row : layer.rows) {
      if (row.is_null()) continue;
      lines.add_quantities(row, "column");
      for (const auto& [key, unit] : {std::pair("survived", "s"), {"off", ""}, {"parted", "s"}})
        if (row.contains(key) && !row.at(key).is_null())
          lines.add(row, "motion", key, unit, row.at(key));
    }
  for (const Cell& row : table.sweep) lines.add_quantities(row, "delta-sweep");
  for (std::size_t i = 0; i < table.hoists.size(); ++i) {
    const PaperHoists& hoists = table.hoists[i];
    Cell both = table.layers[i].rows.front();
    both["column"] = "hoist";
    both["corpus"] = "hoist:10ms";
    lines.add(both, "ratio", "time_ratio", "", cell_of(hoists.time_ratio),
              cell_of(told_time_ratio(table.published)));
    lines.add(both, "ratio", "time_ratio_of_cells", "", {},
              cell_of(printed_time_ratio(table.published)));
    lines.add(both, "distance", "end_distance", "", cell_of(hoists.end_distance));
  }
  return lines.text();
}

}  // namespace

std::string render(const PaperTable& table, TableFormat format) {
  switch (format) {
    case TableFormat::text:
      return section_text(sections_of(table), notes_of(table));
    case TableFormat::csv:
      return csv_of(table);
    case TableFormat::json:
      return json_of(table).dump(1) + "\n";
    case TableFormat::latex:
      break;
  }
  return fmt::format(
             "% * differs from the published value by more than a factor of 2; success: "
             "|w - M z - q - z0 c| at most {}, \"at 1e-6\": natural residual\n",
             by_paper.tolerance) +
         section_latex(sections_of(table));
}

}  // namespace lcp
