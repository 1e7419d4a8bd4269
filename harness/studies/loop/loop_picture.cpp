#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "harness/present/gnuplot_page.h"
#include "harness/studies/loop/loop.h"

namespace lcp {

namespace {

// Pixels.
constexpr double kPageLeft = 92, kPanelWidth = 560, kPageHead = 64, kPanelHeight = 150,
                 kBetween = 34, kPageFoot = 60, kKeyLine = 18, kKeyLetter = 6.7;
constexpr Index kDrawnParts = 125, kMarkerEvery = 15;

/// What one panel shows. Values below `floor` stand at it, since exact agreement has no logarithm, and
/// those above `ceiling` at that.
struct Quantity {
  const char* title;
  double floor, ceiling;
  std::function<double(const LoopSample&)> value;
};

const std::array<Quantity, 4>& quantities() {
  static const std::array<Quantity, 4> all{
      {{"distance of links, largest (mm)", 1e-13, 1e6,
        [](const LoopSample& s) { return 1e3 * s.drift.distance; }},
       {"difference of energy (J)", 1e-16, 1e6, [](const LoopSample& s) { return s.drift.energy; }},
       {"difference of overlap (mm)", 1e-13, 1e6,
        [](const LoopSample& s) { return 1e3 * s.drift.depth; }},
       {"natural residual of the frame''s LCP (10 and more at 10)", 1e-17, 10,
        [](const LoopSample& s) { return s.residual; }}}};
  return all;
}

std::string data_of(const LoopStudy& study) {
  std::string out = "# time (s), then what each panel shows; a data set per line\n";
  for (const LoopLine& line : study.lines) {
    out += fmt::format("# {}\n", fit_for_gnuplot(line.label));
    bool any = false;
    for (const LoopSample& sample : thinned(line, study.reference.simulated(), kDrawnParts)) {
      out += fmt::format("{:.5g}", sample.time);
      for (const Quantity& quantity : quantities()) {
        const double value = quantity.value(sample);
        out += std::isfinite(value)
                   ? fmt::format(" {:.3g}", std::clamp(value, quantity.floor, quantity.ceiling))
                   : std::string(" NaN");
      }
      out += '\n';
      any = true;
    }
    if (!any) out += "NaN NaN NaN NaN NaN\n";
    out += "\n\n";
  }
  return out;
}

std::string panel_of(const LoopStudy& study, std::size_t k) {
  const bool last = k + 1 == quantities().size();
  std::string out =
      fmt::format("set title '{}' offset 0,-0.6 font ',12'\nset format x '{}'\n{}",
                  quantities()[k].title, last ? "%g" : "", last ? "set xlabel 'time (s)'\n" : "");
  out += "plot ";
  for (std::size_t i = 0; i < study.lines.size(); ++i)
    out += fmt::format("{}DATA index {} using 1:{} with linespoints ls {} pointinterval {}",
                       i ? ", \\\n     " : "", i, k + 2, i + 1, kMarkerEvery);
  return out + "\n";
}

/// Line styles: the controls grey and black, solvers in colours with dashes and markers of their own.
std::string styles(const LoopStudy& study) {
  static const std::array<const char*, 7> colours = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                     "#E69F00", "#56B4E9", "#000000"};
  static const std::array<int, 8> markers = {7, 5, 9, 13, 11, 6, 4, 12};
  std::string out;
  std::size_t solver = 0;
  for (std::size_t i = 0; i < study.lines.size(); ++i) {
    if (study.lines[i].control) {
      out += fmt::format("set style line {} lw 1.4 dt {} pt 0 lc rgb '{}'\n", i + 1,
                         i == 0 ? "1" : "(2,3)", i == 0 ? "#999999" : "#444444");
      continue;
    }
    out += fmt::format("set style line {} lw 1.6 dt {} pt {} ps 0.6 lc rgb '{}'\n", i + 1,
                       solver % 3 == 0   ? "1"
                       : solver % 3 == 1 ? "(9,4)"
                                         : "(9,3,2,3)",
                       markers[solver % markers.size()], colours[solver % colours.size()]);
    ++solver;
  }
  return out;
}

std::string key_of(const LoopStudy& study, double width) {
  const std::size_t count = study.lines.size();
  std::string out = fmt::format(
      "set title ''\nunset xlabel\nunset logscale\nunset border\nunset tics\nunset grid\n"
      "set xrange [0:{:g}]\nset yrange [{}:-0.5]\n",
      width, static_cast<double>(count) - 0.5);
  for (std::size_t i = 0; i < count; ++i) {
    const Track& track = study.lines[i].track;
    const std::string end = track.broken.empty() ? ""
                            : track.stopped
                                ? fmt::format(" (stopped at {:.3g} s)", track.simulated())
                                : fmt::format(" (broke at {:.3g} s)", track.simulated());
    out += fmt::format(
        "set arrow from 2,{0} to 34,{0} nohead ls {1}\n"
        "set label '' at 18,{0} point ls {1}\n"
        "set label '{2}{3}' at 42,{0} left noenhanced font ',11'\n",
        i, i + 1, fit_for_gnuplot(study.lines[i].label), end);
  }
  return out + "plot NaN\n";
}

}  // namespace

void draw_loop_study(const LoopStudy& study, const std::filesystem::path& svg) {
  double key_width = 150;
  for (const LoopLine& line : study.lines)
    key_width = std::max(
        key_width, 60 + kKeyLetter * static_cast<double>(line.label.size() +
                                                         (line.track.broken.empty() ? 0 : 20)));
  const double key_left = kPageLeft + kPanelWidth + 24;
  const double panels = static_cast<double>(quantities().size());
  GnuplotPage page{
      .title = fmt::format("How motions of {} part, by what drives them.", study.reference.scene),
      .width = key_left + key_width,
      .height = kPageHead + panels * (kPanelHeight + kBetween) - kBetween + kPageFoot,
      .commands = "set datafile missing NaN\nunset key\n" + styles(study),
      .data = data_of(study)};
  page.commands += fmt::format(
      "set label 1 '{}: distance from the motion that {} drives' at screen {:.5f}, screen {:.5f} "
      "left noenhanced font ',14'\n",
      fit_for_gnuplot(study.reference.scene), fit_for_gnuplot(study.reference.solver),
      kPageLeft / page.width, 1 - 14 / page.height);
  page.commands += fmt::format(
      "set border 3 lc rgb '#555555'\nset tics nomirror\nset grid xtics ytics lc rgb '#e6e6e6' lt "
      "1 "
      "lw 0.8\nset logscale y\nset nomytics\nset format y '10^{{%L}}'\nset xrange [0:{:g}]\n",
      study.reference.simulated());
  for (std::size_t k = 0; k < quantities().size(); ++k) {
    page.commands += gnuplot_margins(
        {kPageLeft, kPanelWidth, kPageHead + static_cast<double>(k) * (kPanelHeight + kBetween),
         kPanelHeight},
        page.width, page.height);
    page.commands += panel_of(study, k);
    if (k == 0) page.commands += "unset label 1\n";
  }
  page.commands += gnuplot_margins(
      {key_left, key_width, kPageHead, kKeyLine * static_cast<double>(study.lines.size())},
      page.width, page.height);
  page.commands += key_of(study, key_width);
  draw_with_gnuplot(svg, page);
}

}  // namespace lcp
