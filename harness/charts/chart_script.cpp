#include "harness/charts/chart_script.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "harness/charts/gnuplot_page.h"
#include "harness/charts/tag_placement.h"

namespace lcp {

namespace {

/// The page, in pixels. Left of each panel the chart, right of it the list of solvers and failures.
constexpr double head = 44, foot = 62;
constexpr double chart_left = 92, chart_width = 500;
constexpr double list_left = 620;
constexpr double name_left = 44, letter_width = 6.7, least_name_width = 250;
constexpr double bar_width = 170, count_width = 80;
constexpr double line_height = 18;
constexpr double least_height = 280;
constexpr Pixels tag_size = {17, 13};
constexpr double bar_thickness = 2;

/// Axes are padded by this factor on either side, and span at least a decade.
constexpr double padding = 1.7;

struct Range {
  double low;
  double high;
  /// Position of `value` on a logarithmic axis of `length` pixels, and back.
  double pixels(double value, double length) const {
    return length * std::log(value / low) / std::log(high / low);
  }
  double value(double at, double length) const { return low * std::pow(high / low, at / length); }
};

struct Panel {
  std::string corpus;
  std::vector<ChartPoint> points;
  Range time_ms;
  Range residual;
  double height() const {
    return std::max(least_height, line_height * static_cast<double>(points.size() + 1));
  }
};

double shown(double residual) { return std::max(residual, residual_floor); }

Range padded(double low, double high) {
  const double widen = std::max(padding, std::sqrt(10 * low / high));
  return {low / widen, high * widen};
}

/// The axes hold every quartile and the tolerance.
void set_ranges(Panel& panel, double tolerance) {
  double fast = INFINITY, slow = 0, exact = tolerance, rough = tolerance;
  for (const ChartPoint& point : panel.points) {
    if (!point.time_ms || !point.residual) continue;
    fast = std::min(fast, point.time_ms->low);
    slow = std::max(slow, point.time_ms->high);
    exact = std::min(exact, shown(point.residual->low));
    rough = std::max(rough, shown(point.residual->high));
  }
  const bool anything_solved = slow > 0;
  panel.time_ms = anything_solved ? padded(fast, slow) : Range{0.1, 10};
  panel.residual = padded(exact, rough);
  if (exact > residual_floor)  // down to a labelled tick
    panel.residual.low = std::pow(10, std::floor(std::log10(panel.residual.low)));
}

std::vector<Panel> make_panels(const std::vector<ChartPoint>& points, double tolerance) {
  std::vector<Panel> panels;
  for (const ChartPoint& point : points) {
    if (panels.empty() || panels.back().corpus != point.corpus)
      panels.push_back({point.corpus, {}, {}, {}});
    panels.back().points.push_back(point);
  }
  std::erase_if(panels, [](const Panel& panel) {
    return std::all_of(panel.points.begin(), panel.points.end(),
                       [](const ChartPoint& point) { return point.counted == 0; });
  });
  for (Panel& panel : panels) set_ranges(panel, tolerance);
  return panels;
}

/// What depends on all panels: the list is as wide as its longest name.
struct Page {
  explicit Page(const std::vector<Panel>& panels) {
    for (const Panel& panel : panels) {
      height += head + panel.height() + foot;
      for (const ChartPoint& point : panel.points)
        name_width = std::max(name_width, letter_width * static_cast<double>(point.label.size()));
    }
  }
  double bar_left() const { return name_left + name_width; }
  double list_width() const { return bar_left() + bar_width + count_width; }
  double width() const { return list_left + list_width(); }

  double height = 0;
  double name_width = least_name_width;
};

/// Position of each key in order of first appearance.
class Numbering {
 public:
  int operator()(const std::string& key) {
    return numbers_.emplace(key, static_cast<int>(numbers_.size())).first->second;
  }

 private:
  std::map<std::string, int> numbers_;
};

std::string data_columns(const std::optional<Spread>& spread) {
  if (!spread) return "NaN NaN NaN";
  return fmt::format("{} {} {}", spread->low, spread->median, spread->high);
}

/// Where the tags of a panel's points stand, in data coordinates; NaN where there is no point.
std::vector<Pixels> tag_positions(const Panel& panel) {
  const double height = panel.height();
  const auto x = [&](double time) { return panel.time_ms.pixels(time, chart_width); };
  const auto y = [&](double residual) { return panel.residual.pixels(shown(residual), height); };
  std::vector<Pixels> markers;
  std::vector<Box> bars;
  for (const ChartPoint& point : panel.points) {
    if (!point.time_ms) continue;
    const Spread &time = *point.time_ms, &residual = *point.residual;
    markers.push_back({x(time.median), y(residual.median)});
    bars.push_back({{(x(time.low) + x(time.high)) / 2, y(residual.median)},
                    {x(time.high) - x(time.low), bar_thickness}});
    bars.push_back({{x(time.median), (y(residual.low) + y(residual.high)) / 2},
                    {bar_thickness, y(residual.high) - y(residual.low)}});
  }
  const std::vector<Pixels> tags = place_tags(markers, bars, {chart_width, height}, tag_size);
  std::vector<Pixels> positions;
  auto tag = tags.begin();
  for (const ChartPoint& point : panel.points) {
    if (!point.time_ms) {
      positions.push_back({NAN, NAN});
      continue;
    }
    positions.push_back(
        {panel.time_ms.value(tag->x, chart_width), panel.residual.value(tag->y, height)});
    ++tag;
  }
  return positions;
}

std::string data(const std::vector<Panel>& panels) {
  std::string out =
      "# number label row, time (ms): quartile median quartile, residual: the same, failed "
      "counted, "
      "tag: x y\n";
  Numbering solvers, rows;
  for (const Panel& panel : panels) {
    out += fmt::format("# {}\n", fit_for_gnuplot(panel.corpus));
    const std::vector<Pixels> tags = tag_positions(panel);
    for (std::size_t i = 0; i < panel.points.size(); ++i) {
      const ChartPoint& point = panel.points[i];
      out += fmt::format("{} \"{}\" {}  {}  {}  {} {}  {:.4g} {:.4g}\n", solvers(point.label) + 1,
                         fit_for_gnuplot(point.label), rows(point.row), data_columns(point.time_ms),
                         data_columns(point.residual), point.failed, point.counted, tags[i].x,
                         tags[i].y);
    }
    out += "\n\n";  // gnuplot's end of a data set
  }
  return out;
}

std::string script_head(const std::string& name, double tolerance, const Page& page, int rows) {
  return fmt::format(
      R"(# Median time against median residual of every solver setting, and its failures.
# To restyle: edit, then gnuplot {name}.gp > {name}.svg
DATA = '{name}.dat'
tolerance = {tolerance}
residual_floor = {floor}
last_row = {last_row}
COLOURS = '0x0072B2 0xD55E00 0x009E73 0xCC79A7 0xE69F00 0x56B4E9 0x000000'  # Okabe and Ito
FILLED = '7 5 9 13 11'  # no failure
OPEN = '6 4 8 12 10'    # some failures
colour(row) = int(word(COLOURS, int(row) % words(COLOURS) + 1))
marker(row, failed) = int(word(failed > 0 ? OPEN : FILLED, int(row) % words(FILLED) + 1))
shown(residual) = residual > residual_floor ? residual : residual_floor
far(dx, dy) = dx * dx + dy * dy > {near} ** 2
set terminal svg size {width},{height} enhanced background '#ffffff' font 'sans-serif,12'
set datafile missing NaN
set multiplot
unset key
)",
      fmt::arg("name", name), fmt::arg("tolerance", tolerance), fmt::arg("floor", residual_floor),
      fmt::arg("last_row", rows - 1), fmt::arg("near", nearest_tag_distance() + 0.5),
      fmt::arg("width", page.width()), fmt::arg("height", page.height));
}

/// Ticks at 1, 2 and 5 times the powers of ten, where there are too few of these alone.
std::string ticks(const Range& range) {
  if (range.high / range.low > 100) return "autofreq ";
  std::string list;
  for (int decade = static_cast<int>(std::floor(std::log10(range.low)));
       std::pow(10, decade) <= range.high; ++decade)
    for (const int mantissa : {1, 2, 5})
      list += fmt::format("{}{}e{}", list.empty() ? "" : ", ", mantissa, decade);
  return fmt::format("({}) ", list);
}

/// The chart proper: lines that join the settings of one row, quartile bars, markers, number tags.
std::string script_chart(const Panel& panel, std::size_t index) {
  Index counted = 0;
  for (const ChartPoint& point : panel.points) counted = std::max(counted, point.counted);
  const bool at_floor = panel.residual.low < residual_floor;
  const bool long_axis = panel.residual.high / panel.residual.low > 1e7;
  return fmt::format(
      R"(set title '{corpus}: {counted} instances counted' noenhanced offset 0,-0.4 font ',14'
set border 3 lc rgb '#555555'
set logscale xy
set xrange [{x_low:.6g}:{x_high:.6g}]
set yrange [{y_low:.6g}:{y_high:.6g}]
set xtics nomirror {x_ticks}format '%g'
set nomytics
set ytics {step} nomirror format '10^{{%L}}'
{floor_tick}set grid xtics ytics lc rgb '#e6e6e6' lt 1 lw 0.8
set xlabel 'median time of a solved instance (ms)'
set ylabel 'median natural residual'
set arrow 1 from graph 0, first tolerance to graph 1, first tolerance nohead dt 2 lc rgb '#888888'
set label 1 'tolerance' at graph 0.995, first tolerance right offset 0,0.5 tc rgb '#888888' font ',10'
plot for [row=0:last_row] DATA index {index} using (column(3) == row ? column(5) : NaN):(shown(column(8))) \
       with lines lw 1 lc rgb colour(row), \
     DATA index {index} using 5:(shown($8)):4:6:(shown($7)):(shown($9)):(colour($3)) \
       with xyerrorbars pt 0 lw 0.8 lc rgb variable, \
     DATA index {index} using 5:(far(log($12/$5) * {x_scale:.6g}, log($13/shown($8)) * {y_scale:.6g}) ? shown($8) : NaN):($12 - $5):($13 - shown($8)) \
       with vectors nohead lw 0.6 lc rgb '#999999', \
     DATA index {index} using 5:(shown($8)):(marker($3, $10)):(colour($3)) \
       with points pt variable ps 0.8 lw 1.5 lc rgb variable, \
     DATA index {index} using 12:13:(sprintf('%d', $1)) with labels font ',11' tc rgb '#222222'
unset arrow 1
unset label 1
unset logscale
unset grid
unset xlabel
unset ylabel
unset border
unset tics
)",
      fmt::arg("corpus", fit_for_gnuplot(panel.corpus)), fmt::arg("counted", counted),
      fmt::arg("index", index), fmt::arg("x_low", panel.time_ms.low),
      fmt::arg("x_high", panel.time_ms.high), fmt::arg("y_low", panel.residual.low),
      fmt::arg("y_high", panel.residual.high), fmt::arg("x_ticks", ticks(panel.time_ms)),
      fmt::arg("step", long_axis ? 100 : 10),
      fmt::arg("floor_tick", at_floor ? "set ytics add ('exact' residual_floor)\n" : ""),
      fmt::arg("x_scale", chart_width / std::log(panel.time_ms.high / panel.time_ms.low)),
      fmt::arg("y_scale", panel.height() / std::log(panel.residual.high / panel.residual.low)));
}

/// The list beside it: number, marker and name of every solver, and its failures as a bar.
std::string script_list(const Panel& panel, std::size_t index, const Page& page) {
  return fmt::format(
      R"(set title 'failed' offset 0,-0.4 font ',14'
set xrange [0:{width}]
set yrange [{lines}:-0.5]
plot DATA index {index} using (10):0:(marker($3, $10)):(colour($3)) with points pt variable ps 0.8 lw 1.5 lc rgb variable, \
     DATA index {index} using (38):0:(sprintf('%d', $1)) with labels right font ',11' tc rgb '#222222', \
     DATA index {index} using ({name}):0:2 with labels left noenhanced font ',11', \
     DATA index {index} using ({bar}):0:({bar}):({bar} + {bar_width}):($0-0.28):($0+0.28) with boxxyerror fs solid 1 noborder lc rgb '#eeeeee', \
     DATA index {index} using ({bar}):0:({bar}):({bar} + ($11 > 0 ? {bar_width} * $10 / $11 : 0)):($0-0.28):($0+0.28):(colour($3)) \
       with boxxyerror fs solid 0.75 noborder lc rgb variable, \
     DATA index {index} using ({bar} + {bar_width} + 6):0:($11 == 0 ? 'not counted' : sprintf('%d of %d', $10, $11)) with labels left font ',11'
)",
      fmt::arg("width", page.list_width()), fmt::arg("name", name_left),
      fmt::arg("bar", page.bar_left()), fmt::arg("bar_width", bar_width),
      fmt::arg("lines", panel.height() / line_height - 0.5), fmt::arg("index", index));
}

std::string script(const std::vector<Panel>& panels, const std::string& name, double tolerance) {
  Numbering rows;
  int row_count = 0;
  for (const Panel& panel : panels)
    for (const ChartPoint& point : panel.points)
      row_count = std::max(row_count, rows(point.row) + 1);
  const Page page(panels);
  std::string out = script_head(name, tolerance, page, row_count);
  double top = 0;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const double height = panels[i].height();
    out += fmt::format("\n# {}\n", fit_for_gnuplot(panels[i].corpus));
    out +=
        gnuplot_margins({chart_left, chart_width, top + head, height}, page.width(), page.height);
    out += script_chart(panels[i], i);
    out += gnuplot_margins({list_left, page.list_width(), top + head, height}, page.width(),
                           page.height);
    out += script_list(panels[i], i, page);
    top += head + height + foot;
  }
  out += fmt::format(
      "\nunset title\nset label 2 'open marker: some instances failed; filled: none did; bars: "
      "quartiles over the solved' at screen {:.5f}, screen {:.5f} left font ',11' "
      "tc rgb '#666666'\nplot NaN\n",
      list_left / page.width(), 22 / page.height);
  return out + "unset multiplot\n";
}

}  // namespace

ChartFiles chart_files(const std::vector<ChartPoint>& points, double tolerance,
                       const std::string& name) {
  const std::vector<Panel> panels = make_panels(points, tolerance);
  if (panels.empty()) throw std::invalid_argument("no run to draw: none is counted in any corpus");
  return {script(panels, name, tolerance), data(panels)};
}

}  // namespace lcp
