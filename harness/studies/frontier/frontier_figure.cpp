#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "harness/studies/frontier/frontier_pages.h"

namespace lcp {

namespace {

constexpr PanelGrid panels_of_solvers{.above = 52, .top = 78};
constexpr Colour line_colour = 0xd55e00, band_colour = 0xe69f00, white = 0xffffff;
constexpr double cell_gap = 0.02;     // of a cell's width
constexpr double band_width = 0.018;  // of the panel's
constexpr double dark_share = 0.6;    // Above it a number is white.

/// Share 0 and 1: white, and the blue of Okabe and Ito.
Colour colour_of_share(double share) {
  constexpr int nothing_solved[] = {255, 255, 255}, all_solved[] = {0, 114, 178};
  Colour colour = 0;
  for (int part = 0; part < 3; ++part)
    colour = 256 * colour +
             static_cast<Colour>(std::lround(nothing_solved[part] +
                                             share * (all_solved[part] - nothing_solved[part])));
  return colour;
}

/// Where the cells of an axis meet: half-way between positions, the ends as far out.
std::vector<double> cell_edges(const KnobAxis& axis) {
  std::vector<double> all{0};
  for (std::size_t i = 1; i < axis.size(); ++i)
    all.push_back((axis.position(i - 1) + axis.position(i)) / 2);
  all[0] = 2 * axis.position(0) - all[1];
  all.push_back(2 * axis.position(axis.size() - 1) - all.back());
  return all;
}

/// `line in 3 of 5 columns, 2 below`.
std::string panel_note(const FrontierRow& row) {
  using Kind = ShareLine::Kind;
  std::map<Kind, std::size_t> counts;
  for (const FrontierColumn& column : row.columns) ++counts[column.line.kind];
  const std::size_t all = row.columns.size();
  if (counts[Kind::above] == all) return "no line: above 1/2 in every column";
  if (counts[Kind::below] == all) return "no line: below 1/2 in every column";
  if (counts[Kind::nothing] == all) return "no line: no draw counted";
  if (counts[Kind::crossing] == all) return "line in every column";
  std::string text = counts[Kind::crossing] > 0
                         ? fmt::format("line in {} of {} columns", counts[Kind::crossing], all)
                         : std::string("no line");
  for (const auto& [kind, what] :
       {std::pair(Kind::above, "above"), std::pair(Kind::below, "below"),
        std::pair(Kind::several, "not monotone"), std::pair(Kind::nothing, "not counted")})
    if (counts[kind] > 0) text += fmt::format(", {} {}", counts[kind], what);
  return text;
}

/// An axis whose ticks are at values of the grid, every so many that they do not touch.
Axis grid_axis(const KnobAxis& knob, std::size_t most) {
  Axis axis{.label = knob.knob + (knob.geometric ? " (geometric)" : ""),
            .low = cell_edges(knob).front(),
            .high = cell_edges(knob).back(),
            .grid = false};
  for (std::size_t i = 0; i < knob.size(); i += (knob.size() + most - 1) / most)
    axis.ticks.push_back({knob.position(i), three_digits(knob.values[i])});
  return axis;
}

/// The solver's name, and below it how many columns have a line, over its panel.
Panel heading_panel(const FrontierRow& row, const PageArea& area) {
  Panel panel{
      .area = {area.left, area.width, area.top - 18, 14}, .title = row.solver, .axes = false};
  panel.series = {{.kind = Series::Kind::text,
                   .marks = {{.x = 0.5, .y = 0.5, .text = panel_note(row), .look = {dark_grey}}},
                   .size = 0.9,
                   .align = Series::Align::centre}};
  return panel;
}

Panel solver_panel(const FrontierGrid& grid, const FrontierRow& row, const PageArea& area) {
  using Kind = Series::Kind;
  Panel panel{.area = area, .x = grid_axis(grid.x, 7), .y = grid_axis(grid.y, 10)};
  Series cells{.kind = Kind::boxes}, bands{.kind = Kind::boxes},
      line{.kind = Kind::line, .size = 2};
  Series places{.kind = Kind::points, .size = 0.8}, crossings{.kind = Kind::points};
  Series numbers{.kind = Kind::text, .size = 0.75, .align = Series::Align::centre};
  const std::vector<double> across = cell_edges(grid.x), up = cell_edges(grid.y);
  for (std::size_t i = 0; i < grid.x.size(); ++i) {
    const double x = grid.x.position(i), width = across[i + 1] - across[i];
    for (std::size_t j = 0; j < grid.y.size(); ++j) {
      const FrontierCell& cell = row.columns[i].cells[j];
      const double height = up[j + 1] - up[j];
      const double share =
          cell.counted > 0 ? static_cast<double>(cell.solved) / static_cast<double>(cell.counted)
                           : 0;
      cells.marks.push_back({.x_low = across[i] + cell_gap * width,
                             .x_high = across[i + 1] - cell_gap * width,
                             .y_low = up[j] + cell_gap * height,
                             .y_high = up[j + 1] - cell_gap * height,
                             .look = {cell.counted > 0 ? colour_of_share(share) : 0xdddddd}});
      const std::string number = cell.counted > 0 ? fmt::format("{:.0f}", 100 * share) : "-";
      numbers.marks.push_back({.x = across[i] + 0.27 * width,  // beside the line
                               .y = grid.y.position(j),
                               .text = number == "0" ? "" : number,
                               .look = {share > dark_share ? white : dark_grey}});
    }
    const ShareLine& found = row.columns[i].line;
    for (const double u : found.crossings)
      crossings.marks.push_back({.x = x, .y = u, .look = {black, 3}});
    const bool crosses = found.kind == ShareLine::Kind::crossing;
    line.marks.push_back({.x = x, .y = crosses ? found.u : NAN, .look = {line_colour}});
    if (!crosses) continue;
    places.marks.push_back(line.marks.back());
    const double reach = band_width / 2 * (panel.x.high - panel.x.low);
    bands.marks.push_back({.x_low = x - reach,
                           .x_high = x + reach,
                           .y_low = std::max(found.low, panel.y.low),
                           .y_high = std::min(found.high, panel.y.high),
                           .look = {band_colour}});
  }
  panel.series = {cells, bands, line, places, crossings, numbers};
  return panel;
}

/// What the colours mean, in five steps.
Panel colour_scale() {
  constexpr int steps = 5;
  Panel panel{.area = {14, 170, 40, 18}, .axes = false};
  panel.x.high = steps;
  Series frame{.kind = Series::Kind::boxes}, patches{.kind = Series::Kind::boxes};
  frame.marks = {{.x_low = 0, .x_high = steps, .y_low = 0, .y_high = 1, .look = {mid_grey}}};
  Series shares{.kind = Series::Kind::text, .size = 0.9, .align = Series::Align::centre};
  for (int i = 0; i < steps; ++i) {
    const double share = static_cast<double>(i) / (steps - 1);
    patches.marks.push_back({.x_low = i + 0.02,
                             .x_high = i + 0.98,
                             .y_low = 0.06,
                             .y_high = 0.94,
                             .look = {colour_of_share(share)}});
    shares.marks.push_back({.x = i + 0.5,
                            .y = 0.5,
                            .text = fmt::format("{:.0f} %", 100 * share),
                            .look = {share > dark_share ? white : dark_grey}});
  }
  panel.series = {frame, patches, shares};
  return panel;
}

}  // namespace

Figure frontier_figure(const Frontier& frontier) {
  const FrontierPlan& plan = frontier.plan;
  const FrontierGrid& grid = plan.grid;
  constexpr double least_width = 860;  // of title and legend
  Figure figure{.title = fmt::format("{}: share of draws solved, by {} and {}", grid.family,
                                     grid.x.knob, grid.y.knob)};
  figure.caption = fmt::format("{}: {}; {}: {}. Numbers: % solved of {} to {} draws; blank: none.",
                               grid.y.knob, knob_meaning(grid, grid.y.knob), grid.x.knob,
                               knob_meaning(grid, grid.x.knob), plan.count, plan.max_count);
  figure.width = std::max(least_width, panels_of_solvers.page_width(frontier.rows.size()));
  figure.height = panels_of_solvers.page_height(frontier.rows.size());
  figure.legend = {{.name = "half are solved", .look = {line_colour}, .line = true},
                   {.name = "its 95 % band", .look = {band_colour, 1}},
                   {.name = "where a share that is not monotone crosses 1/2", .look = {black, 3}}};
  figure.legend_area = {200, figure.width - 200, 39, 20};
  figure.panels = {colour_scale()};
  for (std::size_t i = 0; i < frontier.rows.size(); ++i) {
    figure.panels.push_back(heading_panel(frontier.rows[i], panels_of_solvers.area(i)));
    figure.panels.push_back(solver_panel(grid, frontier.rows[i], panels_of_solvers.area(i)));
  }
  return figure;
}

}  // namespace lcp
