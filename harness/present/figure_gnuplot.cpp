#include <fmt/format.h>

#include <algorithm>

#include "harness/present/columns.h"
#include "harness/present/figure.h"
#include "harness/present/gnuplot_page.h"

namespace lcp {

namespace {

constexpr double caption_line = 16, caption_letter = 6.2, legend_line = 20, legend_letter = 7;
constexpr double legend_stroke = 34, narrow = 400;
constexpr int filled_markers[] = {7, 5, 9, 13, 11, 15}, open_markers[] = {6, 4, 8, 12, 10, 14};
constexpr const char* dash_types[] = {"1", "2", "4", "(18,4)", "(3,4)"};

std::string quoted(const std::string& text) { return "'" + fit_for_gnuplot(text) + "'"; }

std::string drawn_marker(const Look& look, bool filled) {
  return fmt::format("{}", (filled ? filled_markers : open_markers)[look.marker % 6]);
}

/// Data sets and the clauses of a plot command that draw them.
class GnuplotData {
 public:
  void add(const Series& series) {
    if (series.marks.empty()) return;
    const Look& look = series.marks.front().look;
    std::string lines;
    for (const Mark& m : series.marks) lines += line_of(series.kind, m);
    if (lines.find_first_not_of('\n') == std::string::npos) return;
    const std::string set = fmt::format("DATA index {}", sets_++);
    data_ += lines + "\n\n";
    const std::string solid =
        series.opacity < 1 ? fmt::format("transparent solid {:.2f}", series.opacity) : "solid 1";
    switch (series.kind) {
      case Series::Kind::line:
        clause(fmt::format("{} using 1:2 with lines lw {:g} dt {} lc rgb '#{:06x}'", set,
                           series.size, dash_types[look.dash % 5], look.colour));
        return;
      case Series::Kind::points: {
        const bool bars = std::any_of(series.marks.begin(), series.marks.end(), [](const Mark& m) {
          return !std::isnan(m.x_low) || !std::isnan(m.y_low);
        });
        if (bars) clause(set + " using 1:2:5:6:7:8:3 with xyerrorbars pt 0 lw 0.8 lc rgb variable");
        clause(
            fmt::format("{} using 1:2:4:3 with points pt variable ps {:g} lw 1.5 lc rgb variable",
                        set, 0.8 * series.size));
        return;
      }
      case Series::Kind::boxes:
        clause(fmt::format("{} using 1:2:3:4:5:6:7 with boxxyerror fs {} noborder lc rgb variable",
                           set, solid));
        return;
      case Series::Kind::area:
        clause(fmt::format("{} using 1:2:3 with filledcurves closed fc rgb variable fs {} noborder",
                           set, solid));
        return;
      case Series::Kind::text: {
        constexpr const char* aligns[] = {"left", "center", "right"};
        clause(
            fmt::format("{} using 1:2:4:3 with labels {} noenhanced font ',{:.0f}' tc rgb variable",
                        set, aligns[static_cast<int>(series.align)], 11 * series.size));
        return;
      }
    }
  }

  /// The plot command of what was added since the last one.
  std::string plot() {
    const std::string command = "plot " + (clauses_.empty() ? "NaN" : clauses_) + "\n";
    clauses_.clear();
    return command;
  }

  const std::string& data() const { return data_; }

 private:
  static std::string line_of(Series::Kind kind, const Mark& m) {
    const auto or_else = [](double value, double other) {
      return std::isnan(value) ? other : value;
    };
    const bool placed = !std::isnan(m.x) && !std::isnan(m.y);
    switch (kind) {
      case Series::Kind::line:
        return placed ? fmt::format("{:.7g} {:.7g}\n", m.x, m.y) : "\n";
      case Series::Kind::points:
        if (!placed) return "";
        return fmt::format("{:.7g} {:.7g} {} {} {:.7g} {:.7g} {:.7g} {:.7g}\n", m.x, m.y,
                           m.look.colour, drawn_marker(m.look, m.filled), or_else(m.x_low, m.x),
                           or_else(m.x_high, m.x), or_else(m.y_low, m.y), or_else(m.y_high, m.y));
      case Series::Kind::boxes:
        return fmt::format("{:.7g} {:.7g} {:.7g} {:.7g} {:.7g} {:.7g} {}\n", m.x_low, m.y_low,
                           m.x_low, m.x_high, m.y_low, m.y_high, m.look.colour);
      case Series::Kind::area:
        return placed ? fmt::format("{:.7g} {:.7g} {}\n", m.x, m.y, m.look.colour) : "\n";
      case Series::Kind::text:
        if (!placed || m.text.empty()) return "";
        return fmt::format("{:.7g} {:.7g} {} \"{}\"\n", m.x, m.y, m.look.colour,
                           fit_for_gnuplot(m.text));
    }
    return "";
  }

  void clause(const std::string& text) {
    clauses_ += (clauses_.empty() ? "" : ", \\\n     ") + text;
  }

  std::string data_, clauses_;
  std::size_t sets_ = 0;
};

std::string axis_commands(const char* name, const Axis& axis, double length) {
  const bool log = axis.scale == Axis::Scale::log;
  std::string ticks;
  if (!axis.ticks.empty()) {
    for (const Tick& tick : axis.ticks)
      ticks += fmt::format("{}{} {:.7g}", ticks.empty() ? "(" : ", ", quoted(tick.label), tick.at);
    ticks += ")";
  } else if (log) {
    const double decades = std::abs(std::log10(axis.high / axis.low));
    ticks = fmt::format("1e{:.0f} format '10^{{%L}}'",
                        std::max(1.0, std::ceil(decades * 40 / std::max(length, 40.0))));
  } else {
    ticks = "autofreq format '%g'";
  }
  return fmt::format(
      "{log} logscale {0}\nset {0}range [{low:.7g}:{high:.7g}]\nset {0}tics out scale 0.5 nomirror "
      "{ticks} "
      "{enhanced} font ',11'\n{grid}set {0}label {label} noenhanced{offset}\n",
      name, fmt::arg("log", log ? "set" : "unset"), fmt::arg("low", axis.low),
      fmt::arg("high", axis.high), fmt::arg("ticks", ticks),
      fmt::arg("enhanced", axis.ticks.empty() ? "enhanced" : "noenhanced"),
      fmt::arg("grid", axis.grid
                           ? fmt::format("set grid {}tics lc rgb '#e6e6e6' lt 1 lw 0.8\n", name)
                           : std::string()),
      fmt::arg("label", quoted(axis.label)),
      fmt::arg("offset", *name == 'y' ? " offset 1.5,0" : ""));
}

std::string panel_commands(const Panel& panel, GnuplotData& data) {
  std::string out = fmt::format("set title {} noenhanced offset 0,-0.3 font ',13'\nunset grid\n",
                                quoted(panel.title));
  if (panel.axes) {
    out += "set border 3 lc rgb '#555555'\nset nomxtics\nset nomytics\n" +
           axis_commands("x", panel.x, panel.area.width) +
           axis_commands("y", panel.y, panel.area.height);
  } else {
    out += fmt::format(
        "unset border\nunset tics\nunset xlabel\nunset ylabel\nunset logscale\n"
        "set xrange [{:.7g}:{:.7g}]\nset yrange [{:.7g}:{:.7g}]\n",
        panel.x.low, panel.x.high, panel.y.low, panel.y.high);
  }
  for (const Series& series : panel.series) data.add(series);
  return out + data.plot();
}

/// Title, caption and legend as a panel over the whole page, in its pixels.
Panel frame_of(const Figure& figure, const std::vector<std::string>& caption, double height) {
  Panel page{.area = {0, figure.width, 0, height}, .axes = false};
  page.x = {.low = 0, .high = figure.width};
  page.y = {.low = height, .high = 0};
  Series title{.kind = Series::Kind::text, .size = 1.35}, small{.kind = Series::Kind::text};
  Series names{.kind = Series::Kind::text, .size = 1.1}, points{.kind = Series::Kind::points};
  title.marks = {{.x = 14, .y = 20, .text = figure.title, .look = {black}}};
  for (std::size_t i = 0; i < caption.size(); ++i)
    small.marks.push_back({.x = 14,
                           .y = figure.height + 10 + caption_line * static_cast<double>(i),
                           .text = caption[i],
                           .look = {dark_grey}});
  const PageArea& area = figure.legend_area;
  double x = area.left, y = area.top + legend_line / 2;
  for (const LegendEntry& entry : figure.legend) {
    if (area.height == 0) break;
    const double length =
        legend_stroke + 20 + legend_letter * static_cast<double>(entry.name.size());
    if (x > area.left && (area.width < narrow || x + length > area.left + area.width)) {
      x = area.left;
      y += legend_line;
    }
    if (entry.line)
      page.series.push_back({.kind = Series::Kind::line,
                             .marks = {{.x = x, .y = y, .look = entry.look},
                                       {.x = x + legend_stroke, .y = y, .look = entry.look}},
                             .size = 2});
    if (entry.point)
      points.marks.push_back(
          {.x = x + legend_stroke / 2, .y = y, .look = entry.look, .filled = entry.filled});
    names.marks.push_back(
        {.x = x + legend_stroke + 6, .y = y, .text = entry.name, .look = {black}});
    x += length;
  }
  for (Series* series : {&points, &names, &title, &small})
    page.series.push_back(std::move(*series));
  return page;
}

std::vector<std::string> lines_of(const std::string& text, double width) {
  std::vector<std::string> lines;
  if (text.empty()) return lines;
  std::string broken =
      folded(text, static_cast<std::size_t>(std::max(40.0, width / caption_letter)));
  for (std::size_t begin = 0, end; begin < broken.size(); begin = end + 1) {
    end = broken.find('\n', begin);
    lines.push_back(broken.substr(begin, end - begin));
  }
  return lines;
}

}  // namespace

void draw_figure(const std::filesystem::path& svg, const Figure& figure) {
  const std::vector<std::string> caption = lines_of(figure.caption, figure.width - 28);
  const double height = figure.height + caption_line * static_cast<double>(caption.size()) + 8;
  GnuplotPage page{figure.title, figure.width, height, "unset key\n", ""};
  GnuplotData data;
  std::vector<Panel> panels = figure.panels;
  panels.push_back(frame_of(figure, caption, height));
  for (const Panel& panel : panels)
    page.commands +=
        gnuplot_margins(panel.area, figure.width, height) + panel_commands(panel, data);
  page.data = data.data();
  draw_with_gnuplot(svg, page);
}

}  // namespace lcp
