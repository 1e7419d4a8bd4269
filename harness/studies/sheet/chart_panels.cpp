#include "harness/studies/sheet/chart_panels.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "harness/studies/sheet/chart.h"

namespace lcp {

namespace {

constexpr double least_panel_height = 280;
constexpr Pixels tag_size = {17, 13};
constexpr double bar_thickness = 2;
constexpr std::size_t most_panels = 9;
/// Settings in one panel's list: all, where they are so few; else the highlights and, as far as there
/// is room, the rest of the front.
constexpr std::size_t few_settings = 20;
constexpr std::size_t most_listed = 14;
constexpr std::size_t most_highlights = 10;

/// Axes are padded by this factor on either side, and span at least a decade.
constexpr double padding = 1.7;

LogRange padded(double low, double high) {
  const double widen = std::max(padding, std::sqrt(10 * low / high));
  return {low / widen, high * widen};
}

/// The axes hold every quartile and the tolerance.
void set_ranges(ChartPanel& panel, const Sheet& sheet) {
  const Measure measure = sheet.options.measure;
  double fast = INFINITY, slow = 0, exact = sheet.tolerance, rough = sheet.tolerance;
  for (const ChartPoint& point : panel.points) {
    if (!point.cost) continue;
    fast = std::min(fast, shown_cost(point.cost->low, measure));
    slow = std::max(slow, shown_cost(point.cost->high, measure));
    exact = std::min(exact, shown_residual(point.residual->low));
    rough = std::max(rough, shown_residual(point.residual->high));
  }
  const bool anything_solved = slow > 0;
  panel.cost = anything_solved ? padded(fast, slow) : LogRange{0.1, 10};
  panel.residual = padded(exact, rough);
  if (exact > residual_floor)  // down to a labelled tick
    panel.residual.low = std::pow(10, std::floor(std::log10(panel.residual.low)));
}

/// Places in the group's rows of what is in colour and in the list.
std::set<std::size_t> listed_rows(const Sheet& sheet, const Group& group) {
  std::set<std::size_t> listed;
  if (group.rows.size() <= few_settings) {
    for (std::size_t i = 0; i < group.rows.size(); ++i) listed.insert(i);
    return listed;
  }
  for (const std::size_t i : highlights(sheet, group, most_highlights)) listed.insert(i);
  for (std::size_t i = 0; i < group.rows.size() && listed.size() < most_listed; ++i)
    if (group.rows[i].front) listed.insert(i);
  return listed;
}

/// The front of those that solve the most, from the top of the axis down and to its right end.
std::vector<Pixels> front_stairs(const ChartPanel& panel, Measure measure) {
  double share = 0;
  for (const ChartPoint& point : panel.points)
    if (point.front) share = std::max(share, point.mass.share_solved());
  std::vector<Pixels> corners;
  for (const ChartPoint& point : panel.points)
    if (point.front && point.mass.share_solved() == share)
      corners.push_back(
          {shown_cost(point.cost->median, measure), shown_residual(point.residual->median)});
  std::sort(corners.begin(), corners.end(), [](Pixels a, Pixels b) { return a.x < b.x; });
  std::vector<Pixels> stairs;
  double above = panel.residual.high;
  for (const Pixels& corner : corners) {
    stairs.push_back({corner.x, above});
    stairs.push_back(corner);
    above = corner.y;
  }
  if (!corners.empty()) stairs.push_back({panel.cost.high, above});
  return stairs;
}

}  // namespace

double cost_floor(Measure measure) { return measure == Measure::time ? 1e-9 : 0.5; }

double shown_residual(double residual) { return std::max(residual, residual_floor); }

double shown_cost(double cost, Measure measure) { return std::max(cost, cost_floor(measure)); }

std::size_t ChartPanel::lines() const {
  const auto listed = static_cast<std::size_t>(std::count_if(
      points.begin(), points.end(), [](const ChartPoint& point) { return point.listed; }));
  return listed + (listed < points.size() ? 1 : 0);
}

Index ChartPanel::counted() const {
  Index most = 0;
  for (const ChartPoint& point : points) most = std::max(most, point.mass.counted());
  return most;
}

double ChartPanel::height() const {
  return std::max(least_panel_height, chart_line_height * static_cast<double>(lines() + 1));
}

Mass ChartPanel::others() const {
  Mass sum;
  for (const ChartPoint& point : points) {
    if (point.listed) continue;
    sum.instances += point.mass.instances;
    sum.solved += point.mass.solved;
    sum.failed += point.mass.failed;
    sum.trivial += point.mass.trivial;
    sum.unsupported += point.mass.unsupported;
    sum.not_run += point.mass.not_run;
  }
  return sum;
}

std::vector<const Group*> drawn_groups(const Sheet& sheet, std::size_t most) {
  std::vector<const Group*> drawn;
  for (const Group& group : sheet.groups) {
    const bool counted = std::any_of(group.rows.begin(), group.rows.end(),
                                     [](const SheetRow& row) { return row.mass.counted() > 0; });
    if (counted && drawn.size() < most) drawn.push_back(&group);
  }
  return drawn;
}

std::vector<ChartPanel> chart_panels(const Sheet& sheet) {
  const Measure measure = sheet.options.measure;
  std::map<std::string, int> row_numbers;
  for (const Setting& setting : sheet.settings)
    row_numbers.emplace(setting.row, static_cast<int>(row_numbers.size()));

  std::vector<ChartPanel> panels;
  for (const Group* group : drawn_groups(sheet, most_panels)) {
    const std::set<std::size_t> listed = listed_rows(sheet, *group);
    ChartPanel panel;
    panel.title = group->name;
    for (std::size_t i = 0; i < group->rows.size(); ++i) {
      const SheetRow& row = group->rows[i];
      const Setting& setting = sheet.settings[row.setting];
      panel.points.push_back({static_cast<int>(row.setting) + 1, row_numbers.at(setting.row),
                              setting.label, row.mass, row.cost, row.residual, row.front,
                              listed.count(i) > 0});
    }
    set_ranges(panel, sheet);
    panel.stairs = front_stairs(panel, measure);
    for (const Ladder& ladder : group->ladders) {
      ChartLine line;
      line.row = panel.points[ladder.steps.front().row].row;
      line.listed = false;  // among grey points lines would be a tangle
      for (const Step& step : ladder.steps) {
        const ChartPoint& point = panel.points[step.row];
        line.listed |= point.listed;
        if (point.cost)
          line.vertices.push_back(
              {shown_cost(point.cost->median, measure), shown_residual(point.residual->median)});
      }
      if (line.listed && line.vertices.size() > 1) panel.ladders.push_back(line);
    }
    panels.push_back(std::move(panel));
  }
  return panels;
}

std::vector<Pixels> tag_positions(const ChartPanel& panel, Measure measure) {
  const double height = panel.height();
  const auto x = [&](double cost) {
    return panel.cost.pixels(shown_cost(cost, measure), chart_width);
  };
  const auto y = [&](double residual) {
    return panel.residual.pixels(shown_residual(residual), height);
  };
  std::vector<Pixels> markers;
  std::vector<Box> bars;
  const auto has_tag = [](const ChartPoint& point) { return point.cost && point.listed; };
  for (const ChartPoint& point : panel.points) {
    if (!has_tag(point)) continue;
    const Spread &cost = *point.cost, &residual = *point.residual;
    markers.push_back({x(cost.median), y(residual.median)});
    bars.push_back({{(x(cost.low) + x(cost.high)) / 2, y(residual.median)},
                    {x(cost.high) - x(cost.low), bar_thickness}});
    bars.push_back({{x(cost.median), (y(residual.low) + y(residual.high)) / 2},
                    {bar_thickness, y(residual.high) - y(residual.low)}});
  }
  const std::vector<Pixels> tags = place_tags(markers, bars, {chart_width, height}, tag_size);
  std::vector<Pixels> positions;
  auto tag = tags.begin();
  for (const ChartPoint& point : panel.points) {
    if (!has_tag(point)) {
      positions.push_back({NAN, NAN});
      continue;
    }
    positions.push_back(
        {panel.cost.value(tag->x, chart_width), panel.residual.value(tag->y, height)});
    ++tag;
  }
  return positions;
}

}  // namespace lcp
