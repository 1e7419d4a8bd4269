#include "harness/present/step_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "harness/present/gnuplot_page.h"

namespace lcp {

namespace {

/// Pixels.
constexpr double least_page_width = 1060, curves_head = 34;
constexpr PageArea large = {74, 540, 70, 370};
constexpr double legend_left = 640, legend_line = 20, legend_stroke = 34;
constexpr double legend_letter = 7.2;
constexpr int small_columns = 4;
constexpr double small_top = 510, small_left = 62, small_pitch = 250, small_row = 215;
constexpr double small_width = 182, small_height = 140;
constexpr int large_labels = 9, small_labels = 5;
constexpr std::size_t caption_letters = 165, small_title_letters = 36;
constexpr double caption_line = 16;
constexpr int large_columns = 180, small_columns_of_pixels = 60;

double small_rows(const StepCurvePage& page) {
  return std::ceil(static_cast<double>(page.panels.size() - 1) / small_columns);
}

/// Wide enough for the longest name in the legend.
double width_of(const StepCurvePage& page) {
  double width = least_page_width;
  for (const std::string& name : page.legend)
    width = std::max(
        width, legend_left + legend_stroke + 16 + legend_letter * static_cast<double>(name.size()));
  return width;
}

/// Decades between two ticks, so that labels do not meet.
int tick_decades(const LogRange& x, int most_labels) {
  const double decades = std::log10(x.high / x.low);
  return std::max(1, static_cast<int>(std::ceil(decades / most_labels)));
}

/// A title that is too long loses its middle.
std::string shortened(const std::string& title, std::size_t letters) {
  if (title.size() <= letters) return title;
  const std::size_t end = (letters - 3) / 2;
  return title.substr(0, letters - 3 - end) + "..." + title.substr(title.size() - end);
}

std::vector<std::string> wrapped(const std::string& text, std::size_t letters) {
  std::vector<std::string> lines;
  std::size_t begin = 0;
  while (begin < text.size()) {
    std::size_t end = std::min(begin + letters, text.size());
    if (end < text.size())
      if (const std::size_t space = text.rfind(' ', end); space > begin) end = space;
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

std::string style_of(int style, bool is_large) {
  if (style < 0) return "lw 0.7 lc rgb '#cccccc'";
  static const char* const colours[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                        "#E69F00", "#56B4E9", "#000000"};
  static const char* const dashes[] = {"1", "2", "4", "(18,4)", "(3,4)"};
  return fmt::format("lw {} lc rgb '{}' dt {}", is_large ? 1.9 : 1.3, colours[style % 7],
                     dashes[style % 5]);
}

/// Legend beside the large panel: a stroke and a name per entry, set as arrows and labels.
std::string legend_commands(const StepCurvePage& page, double height) {
  std::string out;
  const auto screen = [&](double x, double y) {
    return fmt::format("screen {:.5f}, screen {:.5f}", x / width_of(page), 1 - y / height);
  };
  for (std::size_t i = 0; i < page.legend.size(); ++i) {
    const double y = large.top + 10 + legend_line * static_cast<double>(i);
    out += fmt::format("set arrow {} from {} to {} nohead {}\n", i + 1, screen(legend_left, y),
                       screen(legend_left + legend_stroke, y), style_of(static_cast<int>(i), true));
    out += fmt::format("set label {} '{}' at {} left noenhanced font ',12'\n", i + 1,
                       fit_for_gnuplot(page.legend[i]), screen(legend_left + legend_stroke + 8, y));
  }
  return out;
}

std::string caption_commands(const StepCurvePage& page, double height) {
  std::string out = "unset title\nunset border\nunset tics\nunset xlabel\nunset ylabel\n";
  const std::vector<std::string> lines = wrapped(page.caption, caption_letters);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double y = height - 12 - caption_line * static_cast<double>(lines.size() - 1 - i);
    out += fmt::format(
        "set label {} '{}' at screen 0.02, screen {:.5f} left noenhanced font ',11' tc rgb "
        "'#555555'\n",
        i + 1, fit_for_gnuplot(lines[i]), 1 - y / height);
  }
  return out + fmt::format(
                   "set label {} '{}' at screen 0.5, screen {:.5f} center noenhanced font "
                   "',15'\nplot NaN\n",
                   lines.size() + 1, fit_for_gnuplot(page.title), 1 - curves_head / 2 / height);
}

}  // namespace

std::vector<Pixels> step_corners(const Curve& curve, const LogRange& x, int columns) {
  std::vector<Pixels> corners = {{x.low, curve.share(x.low)}};
  for (int column = 1; column <= columns; ++column) {
    const double at = column == columns ? x.high : x.value(column, columns);
    const double share = curve.share(at);
    if (share == corners.back().y) continue;
    corners.push_back({at, corners.back().y});
    corners.push_back({at, share});
  }
  corners.push_back({x.high, corners.back().y});
  return corners;
}

void draw_step_curves(const std::filesystem::path& svg, const StepCurvePage& page) {
  const double captions =
      caption_line * static_cast<double>(wrapped(page.caption, caption_letters).size());
  const double small = small_rows(page);
  const double height =
      (small > 0 ? small_top + small_row * small : small_top - 20) + captions + 14;
  GnuplotPage out;
  out.title = page.title;
  out.width = width_of(page);
  out.height = height;
  std::size_t data_set = 0;
  for (std::size_t p = 0; p < page.panels.size(); ++p) {
    const StepPanel& panel = page.panels[p];
    const bool is_large = p == 0;
    PageArea area = large;
    if (!is_large) {
      const auto column = static_cast<double>((p - 1) % small_columns);
      const double row = std::floor(static_cast<double>(p - 1) / small_columns);
      area = {small_left + small_pitch * column, small_width, small_top + small_row * row + 14,
              small_height};
    }
    out.commands += gnuplot_margins(area, out.width, height);
    out.commands += fmt::format(
        "unset key\nset border 3 lc rgb '#555555'\nset logscale x\nset xrange [{:.6g}:{:.6g}]\nset "
        "yrange [0:1.02]\nset xtics 1e{} nomirror format '10^{{%L}}' font ',{}'\n{}set ytics 0, "
        "{}, 1 nomirror format '%g' font ',{}'\nset grid xtics ytics lc rgb '#ececec' lt 1 lw 0.8\n"
        "set title '{}' noenhanced offset 0,{} font ',{}'\n",
        page.x.low, page.x.high, tick_decades(page.x, is_large ? large_labels : small_labels),
        is_large ? 12 : 10, page.x.high / page.x.low > 1e4 ? "set nomxtics\n" : "",
        is_large ? 0.1 : 0.25, is_large ? 12 : 10,
        fit_for_gnuplot(is_large ? panel.title : shortened(panel.title, small_title_letters)),
        is_large ? -0.4 : -0.6, is_large ? 13 : 11);
    if (is_large)
      out.commands +=
          fmt::format("set xlabel '{}'\nset ylabel '{}'\n", page.x_label, page.y_label) +
          legend_commands(page, height);
    std::string plots;
    for (const bool grey : is_large ? std::vector{true, false} : std::vector{false}) {
      for (const StepCurve& curve : panel.curves) {
        if ((curve.style < 0) != grey || curve.curve.counted == 0) continue;
        const int columns = is_large && !grey ? large_columns : small_columns_of_pixels;
        for (const Pixels& corner : step_corners(curve.curve, page.x, columns))
          out.data += fmt::format("{:.4g} {:.4g}\n", corner.x, corner.y);
        out.data += "\n\n";
        plots += fmt::format("{} DATA index {} using 1:2 with lines {}", plots.empty() ? "" : ",",
                             data_set++, style_of(curve.style, is_large));
      }
    }
    out.commands += "plot" + (plots.empty() ? " NaN" : plots) + "\n";
    if (is_large) out.commands += "unset arrow\nunset label\nunset xlabel\nunset ylabel\n";
  }
  out.commands += caption_commands(page, height);
  draw_with_gnuplot(svg, out);
}

}  // namespace lcp
