#include "harness/studies/frontier/frontier_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lcp {

namespace {

/// The page, in pixels.
constexpr double panel_width = 230, panel_height = 190;
constexpr double left_of_panel = 84, above_panel = 44, below_panel = 66, right_of_panels = 30;
constexpr double page_top = 104;
constexpr std::size_t panels_abreast = 4;
constexpr double cell_gap = 0.02;  // left free on either side of a cell, of its width

/// Share 0 and 1: white, and the blue of Okabe and Ito. Above the third a number is white.
constexpr int none_solved[] = {255, 255, 255}, all_solved[] = {0, 114, 178};
constexpr double dark_share = 0.6;
constexpr int not_counted_colour = 0xdddddd;

int colour_of(double share) {
  int colour = 0;
  for (int part = 0; part < 3; ++part)
    colour = 256 * colour +
             static_cast<int>(
                 std::lround(none_solved[part] + share * (all_solved[part] - none_solved[part])));
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

/// Columns: x and y of the tick, edges, colour, number of the cell (drawn beside the line), its
/// colour.
std::string cells_data(const KnobAxis& x, const KnobAxis& y, const FrontierRow& row) {
  const std::vector<double> across = cell_edges(x), up = cell_edges(y);
  std::string data;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < y.size(); ++j) {
      const FrontierCell& cell = row.columns[i].cells[j];
      const double share =
          cell.counted > 0 ? static_cast<double>(cell.solved) / static_cast<double>(cell.counted)
                           : 0;
      data += fmt::format("{:.6g} {:.6g} {:.6g} {:.6g} {:.6g} {:.6g} {} {} {}\n", x.position(i),
                          y.position(j), across[i], across[i + 1], up[j], up[j + 1],
                          cell.counted > 0 ? colour_of(share) : not_counted_colour,
                          cell.counted > 0 ? fmt::format("{:.0f}", 100 * share) : "-",
                          share > dark_share ? 0xffffff : 0x555555);
    }
  return data + "\n\n";
}

/// x, line, ends of the band; an empty line where the line breaks (two would end the data set). The
/// last row keeps the data set from being empty.
std::string line_data(const KnobAxis& x, const KnobAxis& y, const FrontierRow& row) {
  const double bottom = cell_edges(y).front(), top = cell_edges(y).back();
  std::string data;
  bool broken = true;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const ShareLine& line = row.columns[i].line;
    if (line.kind == ShareLine::Kind::crossing) {
      data += fmt::format("{:.6g} {:.6g} {:.6g} {:.6g}\n", x.position(i), line.u,
                          std::max(line.low, bottom), std::min(line.high, top));
      broken = false;
    } else if (!broken) {
      data += "\n";
      broken = true;
    }
  }
  return data + "NaN NaN NaN NaN\n\n\n";
}

/// x and y of every crossing of the columns that cross several times.
std::string several_data(const KnobAxis& x, const FrontierRow& row) {
  std::string data;
  for (std::size_t i = 0; i < x.size(); ++i)
    for (const double u : row.columns[i].line.crossings)
      data += fmt::format("{:.6g} {:.6g}\n", x.position(i), u);
  return data + "NaN NaN\n\n\n";
}

/// `line in 3 of 5 columns; 2 below`.
std::string panel_note(const FrontierRow& row) {
  Index lines = 0, above = 0, below = 0, several = 0, nothing = 0;
  for (const FrontierColumn& column : row.columns) {
    switch (column.line.kind) {
      case ShareLine::Kind::crossing:
        ++lines;
        break;
      case ShareLine::Kind::above:
        ++above;
        break;
      case ShareLine::Kind::below:
        ++below;
        break;
      case ShareLine::Kind::several:
        ++several;
        break;
      case ShareLine::Kind::nothing:
        ++nothing;
        break;
    }
  }
  const Index all = static_cast<Index>(row.columns.size());
  if (above == all) return "no line: above 1/2 in every column";
  if (below == all) return "no line: below 1/2 in every column";
  if (nothing == all) return "no line: no draw counted";
  if (lines == all) return "line in every column";
  std::string text =
      lines > 0 ? fmt::format("line in {} of {} columns", lines, all) : std::string("no line");
  const auto add = [&text](Index count, const char* what) {
    if (count > 0) text += fmt::format(", {} {}", count, what);
  };
  add(above, "above");
  add(below, "below");
  add(several, "not monotone");
  add(nothing, "not counted");
  return text;
}

/// Ticks at the values of the grid, every so many that they do not touch.
std::string grid_ticks(const KnobAxis& axis, std::size_t most) {
  const std::size_t every = (axis.size() + most - 1) / most;
  std::string list;
  for (std::size_t i = 0; i < axis.size(); i += every)
    list += fmt::format("{}'{}' {:.6g}", list.empty() ? "" : ", ", three_digits(axis.values[i]),
                        axis.position(i));
  return "(" + list + ")";
}

std::string axis_name(const KnobAxis& axis) {
  return axis.knob + (axis.geometric ? " (geometric)" : "");
}

std::string panel_commands(const FrontierGrid& grid, const FrontierRow& row, std::size_t index) {
  return fmt::format(
      R"(set title '{solver}' noenhanced offset 0,0.5 font ',12'
set label 1 '{note}' at graph 0.5, graph 1.06 center font ',10' tc rgb '#555555'
set border 3 lc rgb '#555555'
set xrange [{x_low:.6g}:{x_high:.6g}]
set yrange [{y_low:.6g}:{y_high:.6g}]
set xtics nomirror out {x_ticks} font ',10'
set ytics nomirror out {y_ticks} font ',10'
set xlabel '{x_name}' noenhanced offset 0,0.4
set ylabel '{y_name}' noenhanced offset 1.2,0
plot DATA index {cells} using 1:2:($3+{gap}*($4-$3)):($4-{gap}*($4-$3)):($5+{gap}*($6-$5)):($6-{gap}*($6-$5)):7 with boxxyerror fs solid 1 noborder lc rgb variable, \
     DATA index {line} using 1:3:(0):($4-$3) with vectors nohead lw 4 lc rgb '#E69F00', \
     DATA index {line} using 1:2 with lines lw 2.5 lc rgb '#D55E00', \
     DATA index {line} using 1:2 with points pt 7 ps 0.6 lc rgb '#D55E00', \
     DATA index {several} using 1:2 with points pt 2 ps 0.9 lw 2 lc rgb '#000000', \
     DATA index {cells} using ($3+0.27*($4-$3)):2:(strcol(8) eq '0' ? '' : strcol(8)):9 with labels font ',8' tc rgb variable
)",
      fmt::arg("solver", fit_for_gnuplot(row.solver)), fmt::arg("note", panel_note(row)),
      fmt::arg("x_low", cell_edges(grid.x).front()), fmt::arg("x_high", cell_edges(grid.x).back()),
      fmt::arg("y_low", cell_edges(grid.y).front()), fmt::arg("y_high", cell_edges(grid.y).back()),
      fmt::arg("x_ticks", grid_ticks(grid.x, 7)), fmt::arg("y_ticks", grid_ticks(grid.y, 10)),
      fmt::arg("x_name", axis_name(grid.x)), fmt::arg("y_name", axis_name(grid.y)),
      fmt::arg("gap", cell_gap), fmt::arg("cells", 3 * index), fmt::arg("line", 3 * index + 1),
      fmt::arg("several", 3 * index + 2));
}

/// Title and legend on top: in a plot that spans the page, in its pixels.
std::string page_head(const FrontierPlan& plan, double width, double height) {
  std::string text = gnuplot_margins({0, width, 0, page_top}, width, height);
  text += fmt::format(
      "unset border\nunset tics\nset xrange [0:{width}]\nset yrange [{page_top}:0]\n"
      "set label 1 '{family}: share of draws solved, by {x} and {y}' at 14,20 left noenhanced font "
      "',15'\n"
      "set label 2 '{y}: {y_meaning};  {x}: {x_meaning}' at 14,46 left noenhanced font ',11' "
      "tc rgb '#555555'\n",
      fmt::arg("width", width), fmt::arg("page_top", page_top),
      fmt::arg("family", fit_for_gnuplot(plan.grid.family)), fmt::arg("x", plan.grid.x.knob),
      fmt::arg("y", plan.grid.y.knob),
      fmt::arg("x_meaning", fit_for_gnuplot(knob_meaning(plan.grid, plan.grid.x.knob))),
      fmt::arg("y_meaning", fit_for_gnuplot(knob_meaning(plan.grid, plan.grid.y.knob))));
  constexpr int patches = 5;
  constexpr double patch = 34, middle = 76;
  for (int i = 0; i < patches; ++i) {
    const double share = static_cast<double>(i) / (patches - 1);
    text += fmt::format(
        "set object {} rectangle from {},{} to {},{} fs solid 1 border lc rgb '#bbbbbb' fc rgb "
        "'#{:06x}'\n"
        "set label {} '{:.0f} %' at {},{} center font ',10' tc rgb '#{}'\n",
        i + 1, 14 + patch * i, middle - 9, 14 + patch * (i + 1), middle + 9, colour_of(share),
        10 + i, 100 * share, 14 + patch * (i + 0.5), middle,
        share > dark_share ? "ffffff" : "333333");
  }
  const double line = 14 + patch * patches + 24;
  text += fmt::format(
      "set arrow 1 from {0},{2} to {1},{2} nohead lw 2.5 lc rgb '#D55E00'\n"
      "set arrow 2 from {3},{4} to {3},{5} nohead lw 5 lc rgb '#E69F00'\n"
      "set label 20 'half are solved; bar: its 95 % band' at {6},{2} left font ',11'\n"
      "set label 21 '{{/:Bold x}}  where a share that is not monotone crosses 1/2' at {7},{2} left "
      "font ',11'\n"
      "set label 22 'numbers: % solved of {8} to {9} draws; blank: none' at {10},{2} left font "
      "',11'\n",
      line, line + 36, middle, line + 18, middle - 11, middle + 11, line + 44, line + 280,
      plan.count, plan.max_count, line + 590);
  text += "plot NaN\nunset label\nunset object\nunset arrow\n";
  return text;
}

}  // namespace

GnuplotPage frontier_page(const Frontier& frontier) {
  const FrontierGrid& grid = frontier.plan.grid;
  const std::size_t abreast = std::min(panels_abreast, frontier.rows.size());
  const std::size_t deep = (frontier.rows.size() + panels_abreast - 1) / panels_abreast;
  constexpr double least_width = 1030;  // of the legend
  GnuplotPage page;
  page.title = fmt::format("Share of draws of {} solved, by {} and {}, and the 50 % line.",
                           grid.family, grid.x.knob, grid.y.knob);
  page.width = std::max(
      least_width, static_cast<double>(abreast) * (left_of_panel + panel_width) + right_of_panels);
  page.height = page_top + static_cast<double>(deep) * (above_panel + panel_height + below_panel);
  page.data =
      "# per solver: cells (x y, edges, colour, % solved, its colour), line (x y low high), "
      "crossings of columns with several; geometric axes as log10\n";
  page.commands = "unset key\n" + page_head(frontier.plan, page.width, page.height);
  for (std::size_t i = 0; i < frontier.rows.size(); ++i) {
    const double left = static_cast<double>(i % panels_abreast) * (left_of_panel + panel_width),
                 top = page_top + static_cast<double>(i / panels_abreast) *
                                      (above_panel + panel_height + below_panel);
    page.commands +=
        gnuplot_margins({left + left_of_panel, panel_width, top + above_panel, panel_height},
                        page.width, page.height);
    page.commands += panel_commands(grid, frontier.rows[i], i);
    page.data += cells_data(grid.x, grid.y, frontier.rows[i]) +
                 line_data(grid.x, grid.y, frontier.rows[i]) +
                 several_data(grid.x, frontier.rows[i]);
  }
  return page;
}

void draw_frontier(const Frontier& frontier, const std::filesystem::path& svg) {
  draw_with_gnuplot(svg, frontier_page(frontier));
}

}  // namespace lcp
