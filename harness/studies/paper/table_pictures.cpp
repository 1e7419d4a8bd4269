#include "harness/studies/paper/table_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace lcp {

namespace {

/// Without the indentation by which it stands below another in a terminal.
std::string unindented(const std::string& label) {
  return label.substr(std::min(label.size(), label.find_first_not_of(' ')));
}

/// Columns of the choices.
constexpr std::array<std::string_view, 4> pictured_choices = {
    "failures", "nodes a frame", "violated contacts", "penetration (mm)"};

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
std::size_t legend_place(DotPage& page, const std::string& name) {
  const auto found = std::find_if(page.legend.begin(), page.legend.end(),
                                  [&](const LegendEntry& each) { return each.name == name; });
  const auto place = static_cast<std::size_t>(found - page.legend.begin());
  if (found == page.legend.end()) page.legend.push_back(entry_of(name, place));
  return place;
}

/// Adds a panel with a series of cells per name, which is NaN where there is no value.
void add_panel(DotPage& page, const std::string& title, const std::vector<std::string>& rows,
               const ColumnHead& head,
               const std::vector<std::pair<std::string, std::vector<Cell>>>& series) {
  page.panels.push_back({title, rows, {}});
  for (const auto& [name, cells] : series) {
    page.panels.back().series.push_back({legend_place(page, name), {}});
    for (const Cell& cell : cells)
      page.panels.back().series.back().values.push_back(
          cell.is_null() ? NAN : head.scale * cell.get<double>());
  }
}

}  // namespace

DotPage picture_of(const PaperTable& table) {
  DotPage page{title_of(table),
               {},
               {},
               table.plan.by_scene()
                   ? "Each solver drives its own simulation of every scene."
                   : "In the loop each solver drives its own simulation; on corpus all solve the "
                     "LCPs of one. Judged by the criterion of the paper, at 1e-6 by the natural "
                     "residual."};
  std::vector<std::string> columns, deltas;
  for (const PaperColumn& column : table.columns) columns.push_back(column.heading);
  for (const std::string& delta : table.plan.deltas) deltas.push_back("delta = " + delta);
  for (const std::string& key : table.plan.rows) {
    const PaperQuantity& quantity = paper_quantity(key);
    std::vector<std::pair<std::string, std::vector<Cell>>> series;
    for (const PaperLine& line : lines_of(table, quantity)) {
      series.push_back({unindented(line.label), {}});
      for (const PaperCell& cell : line.cells) series.back().second.push_back(cell.value);
    }
    add_panel(page, unindented(quantity.heading), columns, quantity, series);
  }
  if (table.sweep.empty()) return page;
  for (const char* key : {"success", "failure", "total_pivots"}) {
    std::vector<Cell> stood, fell;  // The thresholds at which the robot fell are told apart.
    for (const Cell& row : table.sweep) {
      stood.push_back(row.at("fell") == 0 ? row.at(key) : Cell());
      fell.push_back(row.at("fell") == 0 ? Cell() : row.at(key));
    }
    add_panel(page, "sweep: " + paper_quantity(key).heading, deltas, paper_quantity(key),
              {{"in the loop", stood}, {fell_in_the_loop, fell}});
  }
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
    if (std::count(pictured_choices.begin(), pictured_choices.end(), column.key) == 0) continue;
    std::vector<std::pair<std::string, std::vector<Cell>>> series;
    for (const ChoiceTable& table : tables) {
      series.push_back({table.scene, {}});
      for (const LoopColumn& each : table.columns)
        series.back().second.push_back(column.value(each));
    }
    add_panel(page, column.key == "failures" ? "frames that failed" : column.key, rows, column,
              series);
  }
  return page;
}

}  // namespace lcp
