#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/present/gnuplot_page.h"
#include "harness/present/tag_placement.h"
#include "harness/studies/sufficient/report.h"

namespace lcp {

namespace {

// Pixels.
constexpr double kAbovePanel = 46, kBelowPanel = 58, kChartLeft = 78, kChartWidth = 520,
                 kListLeft = 630;
constexpr double kListLine = 17, kLeastHeight = 300, kListLetter = 6.6, kNameLeft = 46;
constexpr Pixels kNumberTag = {17, 13};

constexpr double kLeastSaved = -100;                    // %; slower models stand at the edge
constexpr double kLeastError = 1e-4, kMostError = 1e4;  // of the tolerance, likewise

struct ModelPoint {
  int number;
  int kind;    ///< Of the axis: colour and marker.
  bool whole;  ///< It went to the end.
  double x, y;
  std::string name;
};

const std::vector<std::string>& axis_kinds() {
  static const std::vector<std::string> all = {"friction",  "contacts", "inactive",   "matrix",
                                               "time step", "solver",   "combination"};
  return all;
}

struct StudyPanel {
  const Study* study;
  std::vector<ModelPoint> points;
  double low = -20, bottom = kLeastError, top = 10;  ///< Ends of the axes.

  double height() const {
    return std::max(kLeastHeight, kListLine * static_cast<double>(points.size() + 1));
  }
  Pixels pixels(const ModelPoint& point) const {
    return {kChartWidth * (point.x - low) / (100 - low),
            height() * std::log(point.y / bottom) / std::log(top / bottom)};
  }
};

StudyPanel panel_of(const Study& study) {
  StudyPanel panel{&study, {}};
  double most = 10;
  for (const ModelRow& row : study.rows) {
    const auto kind =
        std::find(axis_kinds().begin(), axis_kinds().end(), row.axis) - axis_kinds().begin();
    const double error = over_tolerance(row.error, study.plan.criteria);
    panel.points.push_back({.number = static_cast<int>(panel.points.size()) + 1,
                            .kind = static_cast<int>(kind),
                            .whole = row.broken.empty(),
                            .x = std::max(kLeastSaved, 100 * row.step_saved.all),
                            .y = std::clamp(error, kLeastError, kMostError),
                            .name = fmt::format("{}{}", row.model.label,
                                                row.stopped           ? " (stopped: too slow)"
                                                : !row.broken.empty() ? " (broke)"
                                                                      : "")});
    panel.low = std::min(panel.low, panel.points.back().x - 8);
    most = std::max(most, panel.points.back().y);
  }
  panel.bottom = kLeastError / 2;
  panel.top = 3 * std::pow(10, std::ceil(std::log10(most)));
  return panel;
}

std::string data_of(const StudyPanel& panel) {
  std::vector<Pixels> markers;
  for (const ModelPoint& point : panel.points) markers.push_back(panel.pixels(point));
  const std::vector<Pixels> tags =
      place_tags(markers, {}, {kChartWidth, panel.height()}, kNumberTag);
  std::string out = fmt::format("# {}\n", fit_for_gnuplot(panel.study->plan.ladder.scene));
  for (std::size_t i = 0; i < panel.points.size(); ++i) {
    const ModelPoint& p = panel.points[i];
    const double x = panel.low + (100 - panel.low) * tags[i].x / kChartWidth;
    const double y = panel.bottom * std::pow(panel.top / panel.bottom, tags[i].y / panel.height());
    const bool far = std::hypot(tags[i].x - markers[i].x, tags[i].y - markers[i].y) >
                     nearest_tag_distance() + 0.5;
    out += fmt::format("{} {} {} {:.5g} {:.5g} {:.5g} {:.5g} {} \"{}\"\n", p.number, p.kind,
                       p.whole ? 1 : 0, p.x, p.y, x, y, far ? 1 : 0, fit_for_gnuplot(p.name));
  }
  return out + "\n\n";
}

std::string chart_of(const StudyPanel& panel, std::size_t index) {
  return fmt::format(
      R"(set title '{scene}: which model is enough, over {horizon:.3g} s' noenhanced offset 0,-0.4 font ',14'
set border 3 lc rgb '#555555'
set logscale y
set xrange [{low:.6g}:100]
set yrange [{bottom:.6g}:{top:.6g}]
set xtics nomirror 20 format '%g'
set nomytics
set ytics nomirror 10 format '10^{{%L}}'
set grid xtics ytics lc rgb '#e6e6e6' lt 1 lw 0.8
set xlabel 'saved of a step''s processor time (%; least: -100)'
set ylabel 'largest physical error / its tolerance (least: 10^{{-4}})'
set object 1 rectangle from graph 0, first 1 to graph 1, graph 1 fc rgb '#f2dcd3' fs solid 0.6 noborder behind
set object 2 rectangle from graph 0, graph 0 to first 0, first 1 fc rgb '#eeeeee' fs solid 0.8 noborder behind
set label 1 'fails' at graph 0.01, first 1 left offset 0,0.7 tc rgb '#a04000' font ',11'
set label 2 'passes, saves nothing' at graph 0.01, first 1 left offset 0,-0.7 tc rgb '#666666' font ',11'
set label 3 'passes and saves' at graph 0.99, first 1 right offset 0,-0.7 tc rgb '#006644' font ',11'
plot DATA index {index} using 4:5:($8 > 0 ? $6 - $4 : 0):($8 > 0 ? $7 - $5 : 0) with vectors nohead lw 0.6 lc rgb '#999999', \
     DATA index {index} using 4:5:(marker($2, $3)):(colour($2)) with points pt variable ps 0.9 lw 1.5 lc rgb variable, \
     DATA index {index} using 6:7:(sprintf('%d', $1)) with labels font ',11' tc rgb '#222222'
unset object 1
unset object 2
unset label 1
unset label 2
unset label 3
unset logscale
unset grid
unset xlabel
unset ylabel
unset border
unset tics
)",
      fmt::arg("scene", fit_for_gnuplot(panel.study->plan.ladder.scene)),
      fmt::arg("horizon", panel.study->horizon), fmt::arg("low", panel.low),
      fmt::arg("bottom", panel.bottom), fmt::arg("top", panel.top), fmt::arg("index", index));
}

std::string list_of(const StudyPanel& panel, std::size_t index, double width) {
  return fmt::format(
      R"(set title ''
set xrange [0:{width}]
set yrange [{lines}:-0.5]
plot DATA index {index} using (10):0:(marker($2, $3)):(colour($2)) with points pt variable ps 0.9 lw 1.5 lc rgb variable, \
     DATA index {index} using (38):0:(sprintf('%d', $1)) with labels right font ',11' tc rgb '#222222', \
     DATA index {index} using ({name}):0:9 with labels left noenhanced font ',11'
)",
      fmt::arg("width", width), fmt::arg("lines", panel.height() / kListLine - 0.5),
      fmt::arg("index", index), fmt::arg("name", kNameLeft));
}

}  // namespace

void draw_studies(const std::vector<Study>& studies, const std::filesystem::path& svg) {
  std::vector<StudyPanel> panels;
  double height = 0, list_width = 200;
  for (const Study& study : studies) {
    panels.push_back(panel_of(study));
    height += kAbovePanel + panels.back().height() + kBelowPanel;
    for (const ModelPoint& point : panels.back().points)
      list_width = std::max(list_width,
                            kNameLeft + kListLetter * static_cast<double>(point.name.size()) + 12);
  }
  GnuplotPage page{
      .title = "Physical error of models of a scene against the time they save.",
      .width = kListLeft + list_width,
      .height = height,
      .commands =
          R"(COLOURS = '0x0072B2 0xD55E00 0x009E73 0xCC79A7 0xE69F00 0x56B4E9 0x000000'  # Okabe and Ito
FILLED = '7 5 9 13 11 15 3'  # by axis
OPEN = '6 4 8 12 10 14 1'    # not simulated to the end
colour(kind) = int(word(COLOURS, int(kind) + 1))
marker(kind, whole) = int(word(whole > 0 ? FILLED : OPEN, int(kind) + 1))
unset key
)",
      .data =
          "# number, axis, went to the end, saved (%), error over tolerance, "
          "tag: x y, line to it, model\n"};
  double top = 0;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const double panel_height = panels[i].height();
    page.data += data_of(panels[i]);
    page.commands += gnuplot_margins({kChartLeft, kChartWidth, top + kAbovePanel, panel_height},
                                     page.width, page.height);
    page.commands += chart_of(panels[i], i);
    page.commands += gnuplot_margins({kListLeft, list_width, top + kAbovePanel, panel_height},
                                     page.width, page.height);
    page.commands += list_of(panels[i], i, list_width);
    top += kAbovePanel + panel_height + kBelowPanel;
  }
  draw_with_gnuplot(svg, page);
}

}  // namespace lcp
