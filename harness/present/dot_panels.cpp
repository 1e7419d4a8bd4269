#include "harness/present/dot_panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "harness/present/gnuplot_page.h"

namespace lcp {

namespace {

/// Pixels.
constexpr double page_width = 1240, page_margin = 20, page_head = 84, page_foot = 34;
constexpr double legend_top = 58, legend_mark = 16, legend_gap = 26;
constexpr double plot_width = 200, plot_gap = 30, title_height = 30, axis_height = 32;
constexpr double row_height = 27, letter = 6.6;
/// Of a row's height: between the marks of two series, which would hide one another.
constexpr double series_step = 0.17;
/// The end of an axis over the largest value, so that its mark is whole.
constexpr double linear_room = 1.08, logarithmic_room = 1.3;
constexpr double logarithmic_beyond = 30;
constexpr double most_steps = 4;  // Between ticks: labels of more would meet.

struct DotStyle {
  const char* colour;  // Okabe and Ito
  int marker;
};
constexpr DotStyle dot_styles[] = {{"#000000", 5}, {"#0072B2", 7},  {"#E69F00", 9}, {"#D55E00", 13},
                                   {"#009E73", 6}, {"#CC79A7", 11}, {"#56B4E9", 4}};

const DotStyle& style_of_dots(std::size_t style) {
  return dot_styles[style % std::size(dot_styles)];
}

double letters_wide(const std::string& text) { return letter * static_cast<double>(text.size()); }

double names_wide(const DotPanel& panel) {
  double width = 0;
  for (const std::string& row : panel.rows) width = std::max(width, letters_wide(row));
  return width + 10;
}

/// Where a panel stands, and whether the names of its rows stand beside it.
struct PlacedPanel {
  PageArea plot;
  bool named = false;
};

/// From left to right, and the names once where neighbours have the same rows.
std::vector<PlacedPanel> placed(const std::vector<DotPanel>& panels) {
  std::vector<PlacedPanel> places;
  double left = page_margin, top = page_head, lowest = page_head;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const double height = row_height * static_cast<double>(panels[i].rows.size());
    bool named = left == page_margin || panels[i].rows != panels[i - 1].rows;
    if (left + (named ? names_wide(panels[i]) : 0) + plot_width > page_width - page_margin) {
      left = page_margin;
      top = lowest;
      named = true;
    }
    if (named) left += names_wide(panels[i]);
    places.push_back({{left, plot_width, top + title_height, height}, named});
    left += plot_width + plot_gap;
    lowest = std::max(lowest, top + title_height + height + axis_height);
  }
  return places;
}

double page_height(const std::vector<PlacedPanel>& places) {
  double bottom = page_head;
  for (const PlacedPanel& place : places)
    bottom = std::max(bottom, place.plot.top + place.plot.height + axis_height);
  return bottom + page_foot;
}

/// 1, 2 or 5 times a power of ten: the least that takes no more than most_steps to `high`.
double tick_step(double high) {
  const double power = std::pow(10, std::floor(std::log10(high / most_steps)));
  for (const double step : {power, 2 * power, 5 * power})
    if (step * most_steps >= high) return step;
  return 10 * power;
}

std::string axis_of(const DotPanel& panel) {
  double low = INFINITY, high = 0;
  for (const DotSeries& series : panel.series)
    for (const double value : series.values)
      if (std::isfinite(value)) {
        low = std::min(low, value);
        high = std::max(high, value);
      }
  if (low > 0 && low < INFINITY && high > logarithmic_beyond * low)
    return fmt::format(
        "set logscale x\nset xrange [{:.4g}:{:.4g}]\nset xtics {:g}, {:g} nomirror format '%g'\n",
        low / logarithmic_room, high * logarithmic_room, std::pow(10, std::ceil(std::log10(low))),
        std::pow(10, std::ceil(std::log10(high / low) / most_steps)));
  if (!(high > 0)) high = 1;
  return fmt::format(
      "unset logscale x\nset xrange [0:{:.4g}]\nset xtics 0, {:g} nomirror format '%g'\n",
      linear_room * high, tick_step(high));
}

std::string names_of(const DotPanel& panel, bool named) {
  std::string out = "set ytics (";
  for (std::size_t i = 0; i < panel.rows.size(); ++i)
    out +=
        fmt::format("{}'{}' {}", i > 0 ? ", " : "", named ? fit_for_gnuplot(panel.rows[i]) : "", i);
  return out + ") nomirror scale 0 noenhanced\n";
}

/// The data sets of a panel, a value and a height per line, and what draws them from `first` on.
struct DrawnDots {
  std::string data, plots;
  std::size_t sets = 0;
};

DrawnDots drawn(const DotPanel& panel, std::size_t first) {
  DrawnDots dots;
  for (std::size_t s = 0; s < panel.series.size(); ++s) {
    const DotSeries& series = panel.series[s];
    if (series.values.size() != panel.rows.size())
      throw std::invalid_argument(fmt::format("panel '{}': {} values for {} rows", panel.title,
                                              series.values.size(), panel.rows.size()));
    const double aside =
        series_step * (static_cast<double>(s) - static_cast<double>(panel.series.size() - 1) / 2);
    std::string lines;
    for (std::size_t i = 0; i < panel.rows.size(); ++i)
      if (std::isfinite(series.values[i]))
        lines += fmt::format("{:.6g} {:.3f}\n", series.values[i], static_cast<double>(i) + aside);
    if (lines.empty()) continue;
    const DotStyle& style = style_of_dots(series.style);
    dots.data += lines + "\n\n";
    dots.plots +=
        fmt::format("{} DATA index {} using 1:2 with points pt {} ps 0.8 lw 1.5 lc rgb '{}'",
                    dots.plots.empty() ? "" : ",", first + dots.sets++, style.marker, style.colour);
  }
  return dots;
}

std::string text_at(double x, double y, double height) {
  return fmt::format("at screen {:.5f}, screen {:.5f}", x / page_width, 1 - y / height);
}

/// Title, legend and caption, as labels of a plot of nothing.
std::string frame_commands(const DotPage& page, double height) {
  std::string out = fmt::format(
      "unset border\nunset tics\nunset title\nunset grid\nset label 1 '{}' {} left noenhanced font "
      "',16'\nset label 2 '{}' {} left noenhanced font ',11' tc rgb '#555555'\n",
      fit_for_gnuplot(page.title), text_at(page_margin, 24, height), fit_for_gnuplot(page.caption),
      text_at(page_margin, height - 16, height));
  double left = page_margin + legend_mark / 2;
  for (std::size_t i = 0; i < page.legend.size(); ++i) {
    const DotStyle& style = style_of_dots(i);
    out += fmt::format(
        "set label {} '{}' {} left noenhanced offset 1.4,0 point pt {} ps 0.9 lw 1.5 lc rgb '{}'\n",
        i + 3, fit_for_gnuplot(page.legend[i]), text_at(left, legend_top, height), style.marker,
        style.colour);
    left += legend_mark + letters_wide(page.legend[i]) * 1.1 + legend_gap;
  }
  return out + "plot NaN\n";
}

}  // namespace

void draw_dots(const std::filesystem::path& svg, const DotPage& page) {
  const std::vector<PlacedPanel> places = placed(page.panels);
  GnuplotPage out{page.title, page_width, page_height(places), {}, {}};
  out.commands = "unset key\nset border 1 lc rgb '#555555'\nset yrange [0:1]\n";
  std::size_t sets = 0;
  for (std::size_t i = 0; i < page.panels.size(); ++i) {
    const DotPanel& panel = page.panels[i];
    const DrawnDots dots = drawn(panel, sets);
    sets += dots.sets;
    out.data += dots.data;
    out.commands += gnuplot_margins(places[i].plot, out.width, out.height) + axis_of(panel) +
                    "unset ytics\n" + names_of(panel, places[i].named) +
                    fmt::format(
                        "set yrange [{}:-0.5]\nset grid xtics ytics lc rgb '#ececec' lt 1\n"
                        "set title '{}' noenhanced offset 0,-0.5 font ',13'\nplot{}\n",
                        static_cast<double>(panel.rows.size()) - 0.5, fit_for_gnuplot(panel.title),
                        dots.plots.empty() ? " NaN" : dots.plots);
  }
  out.commands += frame_commands(page, out.height);
  draw_with_gnuplot(svg, out);
}

}  // namespace lcp
