#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "harness/present/figure.h"
#include "harness/studies/loop/loop.h"
#include "solvers/options.h"

namespace lcp {

namespace {

constexpr Index kDrawnParts = 125, kMarkerEvery = 15;
constexpr double kLetter = 6.7, kLegendLine = 20;  // pixels

/// What a panel shows. Values below `floor` stand at it, since exact agreement has no logarithm, and
/// those above `ceiling` at that.
struct DriftPanel {
  const char* title;
  double floor, ceiling;
  double (*value)(const LoopSample&);
};

constexpr DriftPanel kDriftPanels[] = {
    {"distance of links, largest (mm)", 1e-13, 1e6,
     [](const LoopSample& s) { return 1e3 * s.drift.distance; }},
    {"difference of energy (J)", 1e-16, 1e6, [](const LoopSample& s) { return s.drift.energy; }},
    {"difference of overlap (mm)", 1e-13, 1e6,
     [](const LoopSample& s) { return 1e3 * s.drift.depth; }},
    {"natural residual of the frame's LCP (10 and more at 10)", 1e-17, 10,
     [](const LoopSample& s) { return s.residual; }}};

/// The reference disturbed and with half the time step grey and dark; solvers as everywhere, settings
/// of one by markers and dashes.
std::vector<Look> looks_of(const std::vector<DriftLine>& lines) {
  std::vector<Look> looks;
  std::map<std::string, int> settings;
  for (const DriftLine& line : lines) {
    if (line.control) {
      looks.push_back(looks.size() == 1 ? Look{mid_grey} : Look{dark_grey, 0, 4});
      continue;
    }
    const std::string row = parse_spelling(line.track.solver).name;
    looks.push_back(look_of_solver(row));
    const int earlier = settings[row]++;
    looks.back().marker += earlier;
    looks.back().dash += earlier;
  }
  return looks;
}

std::string with_end(const DriftLine& line) {
  if (line.track.broken.empty()) return line.label;
  return fmt::format("{} ({} at {:.3g} s)", line.label, line.track.stopped ? "stopped" : "broke",
                     line.track.simulated());
}

}  // namespace

Figure loop_figure(const LoopStudy& study) {
  const Track& reference = study.lines.front().track;
  const double duration = reference.simulated();
  const std::vector<Look> looks = looks_of(study.lines);
  const PanelGrid grid{
      .abreast = 1, .width = 560, .height = 150, .above = 34, .below = 6, .top = 26};
  constexpr std::size_t count = std::size(kDriftPanels);
  Figure figure{.title = fmt::format("{}: distance from the motion that {} drives", reference.scene,
                                     reference.solver),
                .height = grid.page_height(count) + 48};
  for (std::size_t k = 0; k < count; ++k) {
    const DriftPanel& shown = kDriftPanels[k];
    Panel panel{.area = grid.area(k), .title = shown.title};
    const bool last = k + 1 == count;
    panel.x = {.label = last ? "time (s)" : "",
               .high = duration,
               .ticks = round_ticks(0, duration, 8, Axis::Scale::linear)};
    if (!last)
      for (Tick& tick : panel.x.ticks) tick.label.clear();
    double low = shown.ceiling, high = shown.floor;
    for (std::size_t i = 1; i < looks.size(); ++i) {
      Series line{.size = 1.6}, markers{.kind = Series::Kind::points, .size = 0.75};
      for (const LoopSample& sample : thinned(study.lines[i], duration, kDrawnParts)) {
        const double value = std::clamp(shown.value(sample), shown.floor, shown.ceiling);
        if (!line.marks.empty() && !study.lines[i].control && line.marks.size() % kMarkerEvery == 0)
          markers.marks.push_back({.x = sample.time, .y = value, .look = looks[i]});
        line.marks.push_back({.x = sample.time, .y = value, .look = looks[i]});
        low = std::fmin(low, value);
        high = std::fmax(high, value);
      }
      panel.series.push_back(std::move(line));
      panel.series.push_back(std::move(markers));
    }
    panel.y = {.low = std::pow(10, std::floor(std::log10(std::min(low, high)))),
               .high = std::pow(10, std::floor(std::log10(high)) + 1),
               .scale = Axis::Scale::log};
    figure.panels.push_back(std::move(panel));
  }
  double longest = 0;
  for (std::size_t i = 1; i < looks.size(); ++i) {
    figure.legend.push_back({.name = with_end(study.lines[i]),
                             .look = looks[i],
                             .line = true,
                             .point = !study.lines[i].control});
    longest = std::max(longest, static_cast<double>(figure.legend.back().name.size()));
  }
  const double left = grid.page_width(1);
  figure.width = left + 60 + kLetter * longest;
  figure.legend_area = {left, 1, grid.area(0).top,
                        kLegendLine * static_cast<double>(figure.legend.size())};
  figure.height = std::max(figure.height, figure.legend_area.top + figure.legend_area.height);
  return figure;
}

}  // namespace lcp
