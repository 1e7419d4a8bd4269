#include "harness/studies/sheet/chart_script.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/present/gnuplot_page.h"

namespace lcp {

namespace {

/// The page, in pixels. Left of each panel the chart, right of it the list of settings and failures.
constexpr double head = 44, foot = 62;
constexpr double chart_left = 92;
constexpr double list_left = 620;
constexpr double name_left = 44, letter_width = 6.7, least_name_width = 250;
constexpr double bar_width = 150, count_width = 230;
constexpr double legend_height = 46;

/// What depends on all panels: the list is as wide as its longest name.
struct ChartPage {
  explicit ChartPage(const std::vector<ChartPanel>& panels) {
    for (const ChartPanel& panel : panels) {
      height += head + panel.height() + foot;
      for (const ChartPoint& point : panel.points)
        if (point.listed)
          name_width = std::max(name_width, letter_width * static_cast<double>(point.label.size()));
    }
  }
  double bar_left() const { return name_left + name_width; }
  double list_width() const { return bar_left() + bar_width + count_width; }
  double width() const { return list_left + list_width(); }

  double height = legend_height;
  double name_width = least_name_width;
};

std::string data_columns(const std::optional<Spread>& spread) {
  if (!spread) return "NaN NaN NaN";
  return fmt::format("{:.6g} {:.6g} {:.6g}", spread->low, spread->median, spread->high);
}

/// "3 of 50 failed, 7 unsupported": what is not in the plane.
std::string mass_in_words(const Mass& mass) {
  std::string words =
      mass.counted() == 0 ? "none counted" : fmt::format("{} of {}", mass.failed, mass.counted());
  if (mass.trivial > 0) words += fmt::format(", {} trivial", mass.trivial);
  if (mass.unsupported > 0) words += fmt::format(", {} unsupported", mass.unsupported);
  if (mass.not_run > 0) words += fmt::format(", {} not run", mass.not_run);
  return words;
}

std::string point_line(int number, const std::string& label, const ChartPoint* point,
                       const Mass& mass, Pixels tag, bool listed) {
  return fmt::format("{} \"{}\" {}  {}  {}  {} {}  {:.4g} {:.4g}  {} {} {} \"{}\"\n", number,
                     fit_for_gnuplot(label), point ? point->row : -1,
                     data_columns(point ? point->cost : std::nullopt),
                     data_columns(point ? point->residual : std::nullopt), mass.failed,
                     mass.counted(), tag.x, tag.y, listed ? 1 : 0, point && point->front ? 1 : 0,
                     mass.instances, mass_in_words(mass));
}

/// Listed settings first, so that line numbers are those of the list.
std::string panel_data(const ChartPanel& panel, Measure measure) {
  std::string out = fmt::format("# {}\n", fit_for_gnuplot(panel.title));
  const std::vector<Pixels> tags = tag_positions(panel, measure);
  for (const bool listed : {true, false}) {
    const Mass others = panel.others();
    if (!listed && others.instances > 0)
      out +=
          point_line(0, fmt::format("{} others, in grey", panel.points.size() + 1 - panel.lines()),
                     nullptr, others, {NAN, NAN}, true);
    for (std::size_t i = 0; i < panel.points.size(); ++i) {
      const ChartPoint& point = panel.points[i];
      if (point.listed == listed)
        out += point_line(point.number, point.label, &point, point.mass, tags[i], listed);
    }
  }
  out += "\n\n";  // gnuplot's end of a data set
  const std::string nothing = "NaN NaN -1\n";
  for (const ChartLine& line : panel.ladders) {
    for (const Pixels& at : line.vertices)
      out += fmt::format("{:.6g} {:.6g} {}\n", at.x, at.y, line.listed ? line.row : -1);
    out += "\n";
  }
  out += nothing + "\n\n";
  for (const Pixels& at : panel.stairs) out += fmt::format("{:.6g} {:.6g} 0\n", at.x, at.y);
  return out + nothing + "\n\n";
}

std::string chart_data(const std::vector<ChartPanel>& panels, Measure measure) {
  std::string out =
      "# Per panel: number label row, cost: quartile median quartile, residual: the same, failed "
      "counted, tag: x y, listed front instances mass; ladders: cost residual row; stairs.\n";
  for (const ChartPanel& panel : panels) out += panel_data(panel, measure);
  return out;
}

std::string script_head(const std::string& name, const Sheet& sheet, const ChartPage& page) {
  return fmt::format(
      R"(# Median cost against median residual of every setting, and its failures.
# To restyle: edit, then gnuplot {name}.gp > {name}.svg
DATA = '{name}.dat'
tolerance = {tolerance}
residual_floor = {floor}
cost_floor = {cost_floor}
COLOURS = '0x0072B2 0xD55E00 0x009E73 0xCC79A7 0xE69F00 0x56B4E9 0x000000'  # Okabe and Ito
FILLED = '7 5 9 13 11'  # no failure
OPEN = '6 4 8 12 10'    # some failures
GREY = 0xBBBBBB
colour(row) = row < 0 ? GREY : int(word(COLOURS, int(row) % words(COLOURS) + 1))
marker(row, failed) = row < 0 ? 7 : int(word(failed > 0 ? OPEN : FILLED, int(row) % words(FILLED) + 1))
shown(residual) = residual > residual_floor ? residual : residual_floor
cost(x) = x > cost_floor ? x : cost_floor
far(dx, dy) = dx * dx + dy * dy > {near} ** 2
set terminal svg size {width},{height} enhanced background '#ffffff' font 'sans-serif,12'
set datafile missing NaN
set multiplot
unset key
)",
      fmt::arg("name", name), fmt::arg("tolerance", sheet.tolerance),
      fmt::arg("floor", residual_floor), fmt::arg("cost_floor", cost_floor(sheet.options.measure)),
      fmt::arg("near", nearest_tag_distance() + 0.5), fmt::arg("width", page.width()),
      fmt::arg("height", page.height));
}

/// Ticks at 1, 2 and 5 times the powers of ten, where there are too few of these alone.
std::string axis_ticks(const LogRange& range) {
  if (range.high / range.low > 100) return "autofreq ";
  std::string list;
  for (int decade = static_cast<int>(std::floor(std::log10(range.low)));
       std::pow(10, decade) <= range.high; ++decade)
    for (const int mantissa : {1, 2, 5})
      list += fmt::format("{}{}e{}", list.empty() ? "" : ", ", mantissa, decade);
  return fmt::format("({}) ", list);
}

/// The chart proper: stairs of the front, ladders, quartile bars, markers, number tags.
std::string script_chart(const ChartPanel& panel, std::size_t index, Measure measure) {
  const bool at_floor = panel.residual.low < residual_floor;
  const bool long_axis = panel.residual.high / panel.residual.low > 1e7;
  const bool no_work = panel.cost.low < cost_floor(measure);
  return fmt::format(
      R"(set title '{corpus}: {counted} instance{plural} counted' noenhanced offset 0,-0.4 font ',14'
set border 3 lc rgb '#555555'
set logscale xy
set xrange [{x_low:.6g}:{x_high:.6g}]
set yrange [{y_low:.6g}:{y_high:.6g}]
set xtics nomirror {x_ticks}format '%g'
{no_work_tick}set nomytics
set ytics {step} nomirror format '10^{{%L}}'
{floor_tick}set grid xtics ytics lc rgb '#e6e6e6' lt 1 lw 0.8
set xlabel 'median {cost} of a solved instance'
set ylabel 'median natural residual'
set arrow 1 from graph 0, first tolerance to graph 1, first tolerance nohead dt 2 lc rgb '#888888'
set label 1 'tolerance' at graph 0.995, first tolerance right offset 0,0.5 tc rgb '#888888' font ',10'
plot DATA index {stairs} using 1:2 with lines lw 5 lc rgb '#dddddd', \
     DATA index {ladders} using 1:2:(colour($3)) with lines lw 1 lc rgb variable, \
     DATA index {points} using (cost($5)):($14 > 0 ? NaN : shown($8)) with points pt 7 ps 0.35 lc rgb GREY, \
     DATA index {points} using (cost($5)):($14 > 0 ? shown($8) : NaN):(cost($4)):(cost($6)):(shown($7)):(shown($9)):(colour($3)) \
       with xyerrorbars pt 0 lw 0.8 lc rgb variable, \
     DATA index {points} using (cost($5)):(far(log($12/cost($5)) * {x_scale:.6g}, log($13/shown($8)) * {y_scale:.6g}) ? shown($8) : NaN):($12 - cost($5)):($13 - shown($8)) \
       with vectors nohead lw 0.6 lc rgb '#999999', \
     DATA index {points} using (cost($5)):($15 > 0 ? shown($8) : NaN) with points pt 6 ps 1.5 lw 1 lc rgb '#222222', \
     DATA index {points} using (cost($5)):($14 > 0 ? shown($8) : NaN):(marker($3, $10)):(colour($3)) \
       with points pt variable ps 0.8 lw 1.5 lc rgb variable, \
     DATA index {points} using 12:13:(sprintf('%d', $1)) with labels font ',11' tc rgb '#222222'
unset arrow 1
unset label 1
unset logscale
unset grid
unset xlabel
unset ylabel
unset border
unset tics
)",
      fmt::arg("corpus", fit_for_gnuplot(panel.title)), fmt::arg("counted", panel.counted()),
      fmt::arg("plural", panel.counted() == 1 ? "" : "s"), fmt::arg("cost", printed(measure)),
      fmt::arg("points", 3 * index), fmt::arg("ladders", 3 * index + 1),
      fmt::arg("stairs", 3 * index + 2), fmt::arg("x_low", panel.cost.low),
      fmt::arg("x_high", panel.cost.high), fmt::arg("y_low", panel.residual.low),
      fmt::arg("y_high", panel.residual.high), fmt::arg("x_ticks", axis_ticks(panel.cost)),
      fmt::arg("no_work_tick", no_work ? "set xtics add ('0' cost_floor)\n" : ""),
      fmt::arg("step", long_axis ? 100 : 10),
      fmt::arg("floor_tick", at_floor ? "set ytics add ('exact' residual_floor)\n" : ""),
      fmt::arg("x_scale", chart_width / std::log(panel.cost.high / panel.cost.low)),
      fmt::arg("y_scale", panel.height() / std::log(panel.residual.high / panel.residual.low)));
}

/// The list beside it: number, marker and name of every listed setting, and its failures as a bar.
std::string script_list(const ChartPanel& panel, std::size_t index, const ChartPage& page) {
  return fmt::format(
      R"(set title 'failed: cost infinite' offset 0,-0.4 font ',14'
set xrange [0:{width}]
set yrange [{lines}:-0.5]
plot DATA index {points} every ::0::{last} using (10):0:(marker($3, $10)):($1 > 0 ? colour($3) : GREY) with points pt variable ps 0.8 lw 1.5 lc rgb variable, \
     DATA index {points} every ::0::{last} using (38):0:($1 > 0 ? sprintf('%d', $1) : '') with labels right font ',11' tc rgb '#222222', \
     DATA index {points} every ::0::{last} using ({name}):0:2 with labels left noenhanced font ',11', \
     DATA index {points} every ::0::{last} using ({bar}):0:({bar}):({bar} + {bar_width}):($0-0.28):($0+0.28) with boxxyerror fs solid 1 noborder lc rgb '#eeeeee', \
     DATA index {points} every ::0::{last} using ($11 < $16 ? {bar} : NaN):0:({bar} + {bar_width} * $11 / $16):({bar} + {bar_width}):($0-0.28):($0+0.28) \
       with boxxyerror fs pattern 4 noborder lc rgb '#aaaaaa', \
     DATA index {points} every ::0::{last} using ($10 > 0 ? {bar} : NaN):0:({bar}):({bar} + {bar_width} * $10 / $16):($0-0.28):($0+0.28):(colour($3)) \
       with boxxyerror fs solid 0.75 noborder lc rgb variable, \
     DATA index {points} every ::0::{last} using ({bar} + {bar_width} + 6):0:17 with labels left noenhanced font ',11'
)",
      fmt::arg("width", page.list_width()), fmt::arg("name", name_left),
      fmt::arg("bar", page.bar_left()), fmt::arg("bar_width", bar_width),
      fmt::arg("lines", panel.height() / chart_line_height - 0.5), fmt::arg("points", 3 * index),
      fmt::arg("last", panel.lines() - 1));
}

std::string script_legend(const Sheet& sheet, std::size_t panels, const ChartPage& page) {
  std::size_t corpora = 0;
  for (const Group& group : sheet.groups) corpora += group.name != all_corpora;
  const std::size_t shown = panels - (sheet.groups.size() > corpora ? 1 : 0);
  const std::string rest =
      shown < corpora ? fmt::format("; {} more corpora are not drawn", corpora - shown) : "";
  return fmt::format(
      "\nunset title\n"
      "set label 2 'filled marker: no failure; open: some; bars: quartiles over the solved; thin "
      "lines: one option varied{rest}' at screen {left:.5f}, screen {first:.5f} left font ',11' tc "
      "rgb '#555555'\n"
      "set label 3 'ringed: on the front of cost, residual and share solved; grey stairs: the "
      "front "
      "of those that solve the most; hatched: trivial, unsupported, not run' at screen {left:.5f}, "
      "screen {second:.5f} left font ',11' tc rgb '#555555'\nplot NaN\n",
      fmt::arg("rest", rest), fmt::arg("left", chart_left / page.width()),
      fmt::arg("first", 34 / page.height), fmt::arg("second", 16 / page.height));
}

}  // namespace

ChartFiles chart_files(const std::vector<ChartPanel>& panels, const Sheet& sheet,
                       const std::string& name) {
  const Measure measure = sheet.options.measure;
  const ChartPage page(panels);
  std::string script = script_head(name, sheet, page);
  double top = 0;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const double height = panels[i].height();
    script += fmt::format("\n# {}\n", fit_for_gnuplot(panels[i].title));
    script +=
        gnuplot_margins({chart_left, chart_width, top + head, height}, page.width(), page.height);
    script += script_chart(panels[i], i, measure);
    script += gnuplot_margins({list_left, page.list_width(), top + head, height}, page.width(),
                              page.height);
    script += script_list(panels[i], i, page);
    top += head + height + foot;
  }
  script += script_legend(sheet, panels.size(), page) + "unset multiplot\n";
  return {script, chart_data(panels, measure)};
}

}  // namespace lcp
