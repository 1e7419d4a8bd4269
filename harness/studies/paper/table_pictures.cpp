#include "harness/studies/paper/table_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lcp {

namespace {

/// Without the indentation by which it stands below another in a terminal.
std::string unindented(const std::string& label) {
  return label.substr(std::min(label.size(), label.find_first_not_of(' ')));
}

constexpr const char* fell_in_the_loop = "in the loop, fell";

/// Looks of what is published and of ways to measure; of a solver its own. The paper's variant of
/// our solver and the robot that fell have open marks.
LegendEntry entry_of(const std::string& name, std::size_t place) {
  if (place == 0) return {name, {black, 1}};
  if (name == "proposed" || name == "best-first")
    return {.name = name, .look = look_of_solver("best-first"), .filled = name == "best-first"};
  if (name == fell_in_the_loop) return {.name = name, .look = look_at(0), .filled = false};
  return {name, look_at(place - 1)};
}

/// The place of a name in the legend, where it is put if it is new.
std::size_t entry(DotPage& page, const std::string& name) {
  const auto found = std::find_if(page.legend.begin(), page.legend.end(),
                                  [&](const LegendEntry& each) { return each.name == name; });
  const auto place = static_cast<std::size_t>(found - page.legend.begin());
  if (found == page.legend.end()) page.legend.push_back(entry_of(name, place));
  return place;
}

double mark_of(const PaperQuantity& quantity, const Cell& value) {
  return value.is_null() ? NAN : value.get<double>() * quantity.scale;
}

/// Of the sweep, with the thresholds at which the robot fell told apart.
void add_sweep(const PaperTable& table, DotPage& page) {
  for (const char* key : {"success", "failure", "total_pivots"}) {
    const PaperQuantity& quantity = paper_quantity(key);
    DotPanel panel{"sweep: " + quantity.heading, table.plan.deltas, {}};
    for (std::string& row : panel.rows) row = "delta = " + row;
    for (const bool fell : {false, true}) {
      panel.series.push_back({entry(page, fell ? fell_in_the_loop : "in the loop"), {}});
      for (const Cell& row : table.sweep)
        panel.series.back().values.push_back(
            row.at("fell") == int{fell} ? mark_of(quantity, row.at(key)) : NAN);
    }
    page.panels.push_back(std::move(panel));
  }
}

}  // namespace

DotPage picture_of(const PaperTable& table) {
  DotPage page{fmt::format("Table {}. {} ({})", std::string(table.plan.table, 'I'),
                           table.published.title, table.published.section),
               {},
               {},
               table.plan.by_scene()
                   ? "Each solver drives its own simulation of every scene."
                   : "In the loop each solver drives its own simulation; on corpus all solve the "
                     "LCPs of one. "
                     "Judged by the criterion of the paper, at 1e-6 by the natural residual."};
  for (const std::string& key : table.plan.rows) {
    const PaperQuantity& quantity = paper_quantity(key);
    const std::vector<PaperLine> lines = lines_of(table, quantity);
    if (lines.empty() || lines.front().label != "published") continue;
    DotPanel panel{unindented(quantity.heading), {}, {}};
    for (const PaperColumn& column : table.columns) panel.rows.push_back(column.heading);
    for (const PaperLine& line : lines) {
      panel.series.push_back({entry(page, unindented(line.label)), {}});
      for (const PaperCell& cell : line.cells)
        panel.series.back().values.push_back(mark_of(quantity, cell.value));
    }
    page.panels.push_back(std::move(panel));
  }
  if (!table.sweep.empty()) add_sweep(table, page);
  return page;
}

DotPage picture_of(const std::vector<ChoiceTable>& tables) {
  DotPage page{
      "What each choice that the paper leaves open does, in the loop of both scenes",
      {},
      {},
      "Every row drives its own simulation and differs from the first in its choice alone."};
  std::vector<std::string> rows;
  for (const Choice& choice : choices()) {
    rows.push_back(choice.what + ": " + choice.way);
    // Where gnuplot's strings end.
    if (const auto quote = rows.back().find('\''); quote != std::string::npos)
      rows.back().replace(quote, 1, "\u2019");
  }
  for (const Column<LoopColumn>& column : choice_columns()) {
    const auto& key = column.key;
    if (key != "failures" && key != "nodes a frame" && key != "violated contacts" &&
        key != "penetration (mm)")
      continue;
    DotPanel panel{key == "failures" ? "frames that failed" : key, rows, {}};
    for (const ChoiceTable& table : tables) {
      panel.series.push_back({entry(page, table.scene), {}});
      for (const LoopColumn& each : table.columns) {
        const Cell value = column.value(each);
        panel.series.back().values.push_back(value.is_null() ? NAN
                                                             : column.scale * value.get<double>());
      }
    }
    page.panels.push_back(std::move(panel));
  }
  return page;
}

}  // namespace lcp
