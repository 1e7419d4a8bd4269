#include "harness/studies/paper/table_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace lcp {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Without what tells a line of a terminal's table that it stands below another.
std::string unindented(const std::string& label) {
  const std::size_t begin = label.find_first_not_of(' ');
  return begin == std::string::npos ? label : label.substr(begin);
}

/// The place of a name in the legend, where it is put if it is new.
std::size_t entry(std::vector<std::string>& legend, const std::string& name) {
  const auto found = std::find(legend.begin(), legend.end(), name);
  if (found != legend.end()) return static_cast<std::size_t>(found - legend.begin());
  legend.push_back(name);
  return legend.size() - 1;
}

/// A panel of the lines of a quantity, which are published, measured one way, another, ...
DotPanel panel_of(const PaperQuantity& quantity, const std::vector<PaperLine>& lines,
                  const std::vector<std::string>& columns, std::vector<std::string>& legend) {
  DotPanel panel{unindented(quantity.label), columns, {}};
  for (const PaperLine& line : lines) {
    DotSeries series{entry(legend, unindented(line.label)), {}};
    for (const PaperCell& cell : line.cells)
      series.values.push_back(cell.value ? *cell.value * quantity.scale : none);
    panel.series.push_back(std::move(series));
  }
  return panel;
}

/// A panel per row that the paper publishes.
template <class Table>
DotPage published_rows(const Table& table, const std::vector<std::string>& columns,
                       const char* caption) {
  DotPage page{fmt::format("Table {}. {} ({})", std::string(table.published.table, 'I'),
                           table.published.title, table.published.section),
               {},
               {},
               caption};
  for (const std::string& key : table.plan.rows) {
    const PaperQuantity& quantity = paper_quantity(key);
    const std::vector<PaperLine> lines = lines_of(table, quantity);
    if (!lines.empty() && lines.front().kind == PaperLine::Kind::published)
      page.panels.push_back(panel_of(quantity, lines, columns, page.legend));
  }
  return page;
}

/// Of the sweep, with the thresholds at which the robot fell told apart.
std::vector<DotPanel> sweep_panels(const PaperTable& table, std::vector<std::string>& legend) {
  std::vector<DotPanel> panels;
  for (const char* key : {"success", "failure", "total_pivots"}) {
    const PaperQuantity& quantity = paper_quantity(key);
    DotPanel panel{fmt::format("sweep: {}", quantity.label), table.plan.deltas, {}};
    for (std::string& row : panel.rows) row = "delta = " + row;
    for (const bool fell : {false, true}) {
      DotSeries series{entry(legend, fell ? "in the loop, fell" : "in the loop"), {}};
      for (const LoopColumn& column : table.sweep)
        series.values.push_back(column.fell() == fell ? quantity.in_loop(column).value_or(none)
                                                      : none);
      panel.series.push_back(std::move(series));
    }
    panels.push_back(std::move(panel));
  }
  return panels;
}

double nodes_a_frame(const LoopColumn& column) {
  const LoopSummary& summary = column.summary;
  return summary.total_frames == 0
             ? none
             : static_cast<double>(summary.nodes) / static_cast<double>(summary.total_frames);
}

}  // namespace

DotPage picture_of(const PaperTable& table) {
  std::vector<std::string> columns;
  for (const PaperColumn& column : table.plan.columns) columns.push_back(column.heading);
  DotPage page = published_rows(table, columns,
                                "In the loop each solver drives its own simulation; on corpus all "
                                "solve the LCPs of one. Judged by "
                                "the criterion of the paper, at 1e-6 by the natural residual.");
  if (table.sweep.empty()) return page;
  for (DotPanel& panel : sweep_panels(table, page.legend)) page.panels.push_back(std::move(panel));
  return page;
}

DotPage picture_of(const SceneTable& table) {
  std::vector<std::string> columns;
  for (const ScenePlace& place : table.plan.scenes) columns.push_back(place.column);
  return published_rows(table, columns, "Each solver drives its own simulation of every scene.");
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
  const auto add = [&](const std::string& title, const auto& value_of) {
    DotPanel panel{title, rows, {}};
    for (const ChoiceTable& table : tables) {
      panel.series.push_back({entry(page.legend, table.scene), {}});
      for (const LoopColumn& column : table.columns)
        panel.series.back().values.push_back(value_of(column));
    }
    page.panels.push_back(std::move(panel));
  };
  add("frames that failed",
      [](const LoopColumn& column) { return static_cast<double>(column.summary.failure); });
  add("nodes a frame", nodes_a_frame);
  add("violated contacts",
      [](const LoopColumn& column) { return static_cast<double>(column.summary.violated); });
  add("penetration (mm)", [](const LoopColumn& column) { return 1e3 * column.summary.depth_max; });
  return page;
}

}  // namespace lcp
