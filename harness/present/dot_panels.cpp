#include "harness/present/dot_panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lcp {

namespace {

/// Pixels.
constexpr double dots_width = 1240, dots_margin = 20, dots_head = 84;
constexpr double plot_width = 200, plot_gap = 30, title_height = 30, axis_height = 32;
constexpr double row_height = 27, letter = 6.6;
/// Of a row's height: between the marks of two series, which would hide one another.
constexpr double series_step = 0.17;
/// The end of an axis over the largest value, so that its mark is whole.
constexpr double linear_room = 1.08, log_room = 1.3;
constexpr double log_beyond = 30;

Axis axis_of(const DotPanel& panel) {
  double low = INFINITY, high = 0;
  for (const DotSeries& series : panel.series)
    for (const double value : series.values)
      if (std::isfinite(value)) {
        low = std::min(low, value);
        high = std::max(high, value);
      }
  if (low > 0 && high > log_beyond * low) {
    Axis axis{.low = low / log_room, .high = log_room * high, .scale = Axis::Scale::log};
    axis.ticks = round_ticks(axis.low, axis.high, 4, axis.scale);
    double wide = 0;
    for (const Tick& tick : axis.ticks) wide += letter * static_cast<double>(tick.label.size() + 1);
    if (wide > plot_width) axis.ticks.clear();  // Powers of ten alone.
    return axis;
  }
  Axis axis{.high = high > 0 ? linear_room * high : 1};
  axis.ticks = round_ticks(0, axis.high, 4, axis.scale);
  return axis;
}

Series series_of(const DotPanel& panel, std::size_t place, const LegendEntry& entry) {
  const std::vector<double>& values = panel.series[place].values;
  if (values.size() != panel.rows.size())
    throw std::invalid_argument(fmt::format("panel '{}': {} values for {} rows", panel.title,
                                            values.size(), panel.rows.size()));
  const double others = static_cast<double>(panel.series.size() - 1);
  Series series{.kind = Series::Kind::points};
  for (std::size_t i = 0; i < values.size(); ++i)
    series.marks.push_back(
        {.x = std::isfinite(values[i]) ? values[i] : NAN,
         .y = static_cast<double>(i) + series_step * (static_cast<double>(place) - others / 2),
         .look = entry.look,
         .filled = entry.filled});
  return series;
}

}  // namespace

Figure figure_of(const DotPage& page) {
  Figure figure{.title = page.title,
                .caption = page.caption,
                .width = dots_width,
                .height = dots_head,
                .legend = page.legend,
                .legend_area = {dots_margin, dots_width - 2 * dots_margin, dots_head - 40, 20}};
  double left = dots_margin, top = dots_head;
  for (const DotPanel& panel : page.panels) {
    const auto rows = static_cast<double>(panel.rows.size());
    double names = 10;
    for (const std::string& row : panel.rows)
      names = std::max(names, letter * static_cast<double>(row.size()) + 10);
    bool named = &panel == &page.panels.front() || panel.rows != (&panel - 1)->rows;
    if (left + (named ? names : 0) + plot_width > dots_width - dots_margin) {
      left = dots_margin;
      top = figure.height;
      named = true;
    }
    if (named) left += names;
    Panel drawn{.area = {left, plot_width, top + title_height, row_height * rows},
                .title = panel.title,
                .x = axis_of(panel),
                .y = {.low = rows - 0.5, .high = -0.5}};
    for (std::size_t i = 0; i < panel.rows.size(); ++i)
      drawn.y.ticks.push_back({static_cast<double>(i), named ? panel.rows[i] : ""});
    for (std::size_t s = 0; s < panel.series.size(); ++s)
      drawn.series.push_back(series_of(panel, s, page.legend.at(panel.series[s].entry)));
    figure.height = std::max(figure.height, top + title_height + row_height * rows + axis_height);
    figure.panels.push_back(std::move(drawn));
    left += plot_width + plot_gap;
  }
  return figure;
}

}  // namespace lcp
