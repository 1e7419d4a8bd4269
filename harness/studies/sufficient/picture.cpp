#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/present/tag_placement.h"
#include "harness/studies/sufficient/report.h"

namespace lcp {

namespace {

// Pixels.
constexpr double kListLine = 17, kLeastHeight = 300, kListLetter = 6.6, kNameLeft = 46;
constexpr Pixels kNumberTag = {17, 13};

constexpr double kLeastSaved = -100;                    // %; slower models stand at the edge
constexpr double kLeastError = 1e-4, kMostError = 1e4;  // of the tolerance, likewise

/// A marker as its axis has it, hollow where the model was not simulated to the end.
Mark mark_of(const ModelRow& row, double x, double y) {
  static const std::vector<std::string> axes = {"friction",  "contacts", "inactive",   "matrix",
                                                "time step", "solver",   "combination"};
  const auto axis = std::find(axes.begin(), axes.end(), row.axis) - axes.begin();
  return {.x = x,
          .y = y,
          .look = look_at(static_cast<std::size_t>(axis)),
          .filled = row.broken.empty()};
}

std::string listed(const ModelRow& row) {
  return row.model.label + (row.stopped           ? " (stopped: too slow)"
                            : !row.broken.empty() ? " (broke)"
                                                  : "");
}

/// The models of a study by number: names, and how wide they are.
Panel list_panel(const Study& study, const PageArea& area) {
  Panel panel{.area = area, .axes = false};
  panel.x = {.low = 0, .high = area.width};
  panel.y = {.low = area.height / kListLine - 0.5, .high = -0.5};
  Series points{.kind = Series::Kind::points}, names{.kind = Series::Kind::text};
  Series numbers{.kind = Series::Kind::text, .align = Series::Align::right};
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    const auto line = static_cast<double>(i);
    points.marks.push_back(mark_of(study.rows[i], 10, line));
    numbers.marks.push_back(
        {.x = 38, .y = line, .text = fmt::format("{}", i + 1), .look = {black}});
    names.marks.push_back(
        {.x = kNameLeft, .y = line, .text = listed(study.rows[i]), .look = {black}});
  }
  panel.series = {points, numbers, names};
  return panel;
}

Series box(double left, double right, double bottom, double top, Colour colour) {
  return {
      .kind = Series::Kind::boxes,
      .marks = {{.x_low = left, .x_high = right, .y_low = bottom, .y_high = top, .look = {colour}}},
      .opacity = 0.7};
}

Series words(double x, double y, const char* text, Colour colour,
             Series::Align align = Series::Align::left) {
  return {.kind = Series::Kind::text,
          .marks = {{.x = x, .y = y, .text = text, .look = {colour}}},
          .align = align};
}

Panel chart_panel(const Study& study, const PageArea& area) {
  Series points{.kind = Series::Kind::points}, ways{.size = 0.6};
  Series numbers{.kind = Series::Kind::text, .align = Series::Align::centre};
  double low = -20, most = 10;
  for (const ModelRow& row : study.rows) {
    points.marks.push_back(mark_of(
        row, std::max(kLeastSaved, 100 * row.step_saved.all),
        std::clamp(over_tolerance(row.error, study.plan.criteria), kLeastError, kMostError)));
    low = std::min(low, points.marks.back().x - 8);
    most = std::max(most, points.marks.back().y);
  }
  const double bottom = kLeastError / 2, top = 3 * std::pow(10, std::ceil(std::log10(most)));
  std::vector<Pixels> markers;
  for (const Mark& mark : points.marks)
    markers.push_back({area.width * (mark.x - low) / (100 - low),
                       area.height * std::log(mark.y / bottom) / std::log(top / bottom)});
  const std::vector<Pixels> tags = place_tags(markers, {}, {area.width, area.height}, kNumberTag);
  for (std::size_t i = 0; i < tags.size(); ++i) {
    const double x = low + (100 - low) * tags[i].x / area.width;
    const double y = bottom * std::pow(top / bottom, tags[i].y / area.height);
    numbers.marks.push_back({.x = x, .y = y, .text = fmt::format("{}", i + 1), .look = {black}});
    if (std::hypot(tags[i].x - markers[i].x, tags[i].y - markers[i].y) <=
        nearest_tag_distance() + 0.5)
      continue;
    const Mark& point = points.marks[i];
    for (const auto& [to_x, to_y] : {std::pair(point.x, point.y), {x, y}, {NAN, NAN}})
      ways.marks.push_back({.x = to_x, .y = to_y, .look = {0x999999}});
  }
  const double edge = low + 0.01 * (100 - low), line = std::pow(top / bottom, 11 / area.height);
  return {
      .area = area,
      .title = fmt::format("{}: which model is enough, over {:.3g} s", study.plan.ladder.scene,
                           study.horizon),
      .x = {.label = "saved of a step's processor time (%; least: -100)", .low = low, .high = 100},
      .y = {.label = "largest physical error / its tolerance (least: 1e-4)",
            .low = bottom,
            .high = top,
            .scale = Axis::Scale::log},
      .series = {box(low, 100, 1, top, 0xf2dcd3), box(low, 0, bottom, 1, 0xeeeeee),
                 words(edge, line, "fails", 0xa04000),
                 words(edge, 1 / line, "passes, saves nothing", 0x666666),
                 words(99, 1 / line, "passes and saves", 0x006644, Series::Align::right), ways,
                 points, numbers}};
}

}  // namespace

Figure figure_of(const std::vector<Study>& studies) {
  PageArea chart{.left = 78, .width = 520}, list{.left = 630, .width = 200};
  for (const Study& study : studies)
    for (const ModelRow& row : study.rows)
      list.width = std::max(list.width,
                            kNameLeft + kListLetter * static_cast<double>(listed(row).size()) + 12);
  Figure figure{.title = "Physical error of models of a scene against the time they save",
                .width = list.left + list.width,
                .height = 20};
  for (const Study& study : studies) {
    chart.top = list.top = figure.height + 46;
    chart.height = list.height =
        std::max(kLeastHeight, kListLine * static_cast<double>(study.rows.size() + 1));
    figure.panels.push_back(chart_panel(study, chart));
    figure.panels.push_back(list_panel(study, list));
    figure.height = chart.top + chart.height + 58;
  }
  return figure;
}

}  // namespace lcp
