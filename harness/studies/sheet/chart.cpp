#include "harness/studies/sheet/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "harness/present/tag_placement.h"
#include "harness/studies/sheet/render.h"
#include "solvers/options.h"

namespace lcp {

namespace {

/// The page, in pixels. Left of each panel the chart, right of it the list of settings and failures.
constexpr double chart_head = 34, panel_head = 44, panel_foot = 62;
constexpr double chart_left = 92, chart_width = 500, least_panel_height = 280;
constexpr double list_left = 620, list_line = 18, number_right = 38, name_left = 44;
constexpr double letter_width = 6.7, least_name_width = 250, bar_width = 150, words_width = 230;
constexpr double half_bar = 0.28;  // Of a line of the list.
constexpr Pixels tag_size = {17, 13};
constexpr double bar_thickness = 2;
constexpr std::size_t most_panels = 9;
/// Settings in one panel's list: all, where they are so few; else the highlights and, as far as there
/// is room, the rest of the front.
constexpr std::size_t few_settings = 20, most_listed = 14, most_highlights = 10;
constexpr Look in_grey = {.colour = mid_grey};

/// Axes are padded by this factor on either side, and span at least a decade.
constexpr double padding = 1.7;

LogRange padded(double low, double high) {
  const double widen = std::max(padding, std::sqrt(10 * low / high));
  return {low / widen, high * widen};
}

/// "3 of 50 failed, 7 unsupported": what is not in the plane.
std::string mass_in_words(const Mass& mass) {
  std::string words =
      mass.counted() == 0 ? "none counted" : fmt::format("{} of {}", mass.failed, mass.counted());
  for (const auto& [count, name] : {std::pair{mass.trivial, "trivial"},
                                    {mass.unsupported, "unsupported"},
                                    {mass.not_run, "not run"}})
    if (count > 0) words += fmt::format(", {} {}", count, name);
  return words;
}

/// Places in the group's rows of what is in colour and in the list.
std::set<std::size_t> listed_rows(const Sheet& sheet, const Group& group) {
  std::set<std::size_t> listed;
  if (group.rows.size() > few_settings)
    for (const std::size_t i : highlights(sheet, group, most_highlights)) listed.insert(i);
  for (std::size_t i = 0; i < group.rows.size(); ++i)
    if (group.rows.size() <= few_settings || (group.rows[i].front && listed.size() < most_listed))
      listed.insert(i);
  return listed;
}

/// One group on the page.
class Plane {
 public:
  Plane(const Sheet& sheet, const Group& group, const std::vector<std::string>& rows)
      : sheet_(sheet), group_(group), rows_(rows), listed_(listed_rows(sheet, group)) {
    double fast = INFINITY, slow = 0, exact = sheet.tolerance, rough = sheet.tolerance;
    for (std::size_t i = 0; i < group.rows.size(); ++i) {
      if (!group.rows[i].cost) continue;
      const Mark at = mark(i);
      fast = std::min(fast, at.x_low);
      slow = std::max(slow, at.x_high);
      exact = std::min(exact, at.y_low);
      rough = std::max(rough, at.y_high);
    }
    cost_ = slow > 0 ? padded(fast, slow) : LogRange{0.1, 10};
    residual_ = padded(exact, rough);
    if (exact > residual_floor)  // down to a labelled tick
      residual_.low = std::pow(10, std::floor(std::log10(residual_.low)));
  }

  double height() const {
    const std::size_t lines = listed_.size() + (listed_.size() < group_.rows.size() ? 1 : 0);
    return std::max(least_panel_height, list_line * static_cast<double>(lines + 1));
  }

  double name_width() const {
    double width = least_name_width;
    for (const std::size_t i : listed_)
      width = std::max(width, letter_width * static_cast<double>(setting(i).label.size()));
    return width;
  }

  Panel chart(double top) const {
    Index counted = 0;
    for (const SheetRow& row : group_.rows) counted = std::max(counted, row.mass.counted());
    Panel panel{.area = {chart_left, chart_width, top, height()},
                .title = fmt::format("{}: {} instance{} counted", group_.name, counted,
                                     counted == 1 ? "" : "s")};
    const Measure measure = sheet_.options.measure;
    panel.x = axis(fmt::format("median {} of a solved instance", printed(measure)), cost_, 8,
                   {cost_floor(measure), "0"});
    panel.y = axis("median natural residual", residual_, 9, {residual_floor, "exact"});
    const Look line = {.colour = 0x888888, .dash = 1};
    panel.series.push_back({.marks = {{.x = cost_.low, .y = sheet_.tolerance, .look = line},
                                      {.x = cost_.high, .y = sheet_.tolerance}}});
    panel.series.push_back({.kind = Series::Kind::text,
                            .marks = {{.x = cost_.value(chart_width - 4, chart_width),
                                       .y = above(sheet_.tolerance, -9),
                                       .text = "tolerance",
                                       .look = line}},
                            .size = 0.9,
                            .align = Series::Align::right});
    panel.series.push_back(stairs());
    for (const Ladder& ladder : group_.ladders) panel.series.push_back(joined(ladder));
    Series others{.kind = Series::Kind::points, .size = 0.45}, rings = others, points = others;
    rings.size = 1.9;
    points.size = 1;
    for (std::size_t i = 0; i < group_.rows.size(); ++i) {
      if (!group_.rows[i].cost) continue;
      const Mark at = mark(i);
      if (is_listed(i))
        points.marks.push_back(at);
      else
        others.marks.push_back({.x = at.x, .y = at.y, .look = in_grey});
      if (group_.rows[i].front)
        rings.marks.push_back({.x = at.x, .y = at.y, .look = {black}, .filled = false});
    }
    for (Series& series : {std::ref(others), std::ref(rings)}) panel.series.push_back(series);
    add_tags(panel, points.marks);
    panel.series.push_back(std::move(points));
    return panel;
  }

  /// Number, marker and name of every listed setting, and its failures as a bar.
  Panel list(double top, double name_width) const {
    const double bar = name_left + name_width, width = bar + bar_width + words_width;
    Panel panel{
        .area = {list_left, width, top, height()}, .title = "failed: cost infinite", .axes = false};
    panel.x = {.low = 0, .high = width};
    panel.y = {.low = height() / list_line - 0.5, .high = -0.5};
    using Kind = Series::Kind;
    Series points{.kind = Kind::points}, bars{.kind = Kind::boxes};
    Series texts{.kind = Kind::text}, numbers{.kind = Kind::text, .align = Series::Align::right};
    double y = 0;
    const auto box = [&](double from, double to, Colour colour) {
      if (to > from)
        bars.marks.push_back({.x_low = bar + bar_width * from,
                              .x_high = bar + bar_width * to,
                              .y_low = y - half_bar,
                              .y_high = y + half_bar,
                              .look = {colour}});
    };
    const auto add = [&](const std::string& name, const Look& look, const Mass& mass) {
      const auto share = [&](Index count) {
        return mass.instances == 0 ? 0 : double(count) / double(mass.instances);
      };
      points.marks.push_back({.x = 10, .y = y, .look = look, .filled = mass.failed == 0});
      texts.marks.push_back({.x = name_left, .y = y, .text = name, .look = {black}});
      box(0, 1, pale_grey);
      box(share(mass.counted()), 1, mid_grey);
      box(0, share(mass.failed), look.colour);
      texts.marks.push_back(
          {.x = bar + bar_width + 6, .y = y, .text = mass_in_words(mass), .look = {black}});
      ++y;
    };
    Mass others;
    for (std::size_t i = 0; i < group_.rows.size(); ++i) {
      const Mass& mass = group_.rows[i].mass;
      if (is_listed(i)) {
        numbers.marks.push_back({.x = number_right, .y = y, .text = number(i), .look = {black}});
        add(setting(i).label, look(i), mass);
        continue;
      }
      for (const auto count : {&Mass::instances, &Mass::solved, &Mass::failed, &Mass::trivial,
                               &Mass::unsupported, &Mass::not_run})
        others.*count += mass.*count;
    }
    if (others.instances > 0)
      add(fmt::format("{} others, in grey", group_.rows.size() - listed_.size()), in_grey, others);
    panel.series = {bars, points, texts, numbers};
    return panel;
  }

 private:
  const Setting& setting(std::size_t i) const { return sheet_.settings[group_.rows[i].setting]; }
  std::string number(std::size_t i) const { return fmt::format("{}", group_.rows[i].setting + 1); }
  bool is_listed(std::size_t i) const { return listed_.count(i) > 0; }
  Look look(std::size_t i) const {
    return is_listed(i) ? look_of_solver(rows_[group_.rows[i].setting]) : in_grey;
  }

  /// A setting that solved something, at its medians, with its quartiles.
  Mark mark(std::size_t i) const {
    const SheetRow& row = group_.rows[i];
    const double least = cost_floor(sheet_.options.measure);
    const Spread &cost = *row.cost, &residual = *row.residual;
    return {.x = std::max(cost.median, least),
            .y = std::max(residual.median, residual_floor),
            .x_low = std::max(cost.low, least),
            .x_high = std::max(cost.high, least),
            .y_low = std::max(residual.low, residual_floor),
            .y_high = std::max(residual.high, residual_floor),
            .text = number(i),
            .look = look(i),
            .filled = row.mass.failed == 0};
  }

  static Axis axis(const std::string& label, const LogRange& range, std::size_t ticks, Tick zero) {
    Axis axis{.label = label, .low = range.low, .high = range.high, .scale = Axis::Scale::log};
    const bool has_zero = range.low < zero.at;
    axis.ticks = round_ticks(has_zero ? 3 * zero.at : range.low, range.high, ticks, axis.scale);
    if (has_zero) axis.ticks.push_back(std::move(zero));
    return axis;
  }

  double above(double residual, double pixels) const {
    return residual_.value(residual_.pixels(residual, height()) + pixels, height());
  }

  /// The front of those that solve the most, from the top of the axis down and to its right end.
  Series stairs() const {
    Series stairs{.size = 5};
    std::vector<Mark> corners;
    for (const std::size_t i : best_solving_front(group_)) corners.push_back(mark(i));
    std::sort(corners.begin(), corners.end(),
              [](const Mark& a, const Mark& b) { return a.x < b.x; });
    double y = residual_.high;
    const auto add = [&](double x, double at) {
      stairs.marks.push_back({.x = x, .y = at, .look = {0xdddddd}});
    };
    for (const Mark& corner : corners) {
      add(corner.x, y);
      add(corner.x, y = corner.y);
    }
    if (!corners.empty()) add(cost_.high, y);
    return stairs;
  }

  /// Empty where no setting is listed: among grey points lines would be a tangle.
  Series joined(const Ladder& ladder) const {
    Series line;
    bool any = false;
    for (const Step& step : ladder.steps) {
      any |= is_listed(step.row);
      if (!group_.rows[step.row].cost) continue;
      const Mark at = mark(step.row);
      Look solid = at.look;
      solid.dash = 0;
      line.marks.push_back({.x = at.x, .y = at.y, .look = solid});
    }
    return any && line.marks.size() > 1 ? line : Series{};
  }

  /// Numbers of the points, each beside its own, led there by a line where it stands farther away.
  void add_tags(Panel& panel, const std::vector<Mark>& points) const {
    const auto x = [&](double cost) { return cost_.pixels(cost, chart_width); };
    const auto y = [&](double residual) { return residual_.pixels(residual, height()); };
    std::vector<Pixels> markers;
    std::vector<TagBox> bars;
    for (const Mark& point : points) {
      const Pixels at = {x(point.x), y(point.y)};
      markers.push_back(at);
      bars.push_back({{(x(point.x_low) + x(point.x_high)) / 2, at.y},
                      {x(point.x_high) - x(point.x_low), bar_thickness}});
      bars.push_back({{at.x, (y(point.y_low) + y(point.y_high)) / 2},
                      {bar_thickness, y(point.y_high) - y(point.y_low)}});
    }
    const std::vector<Pixels> places = place_tags(markers, bars, {chart_width, height()}, tag_size);
    Series leaders{.size = 0.6};
    Series tags{.kind = Series::Kind::text, .align = Series::Align::centre};
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Mark tag = {.x = cost_.value(places[i].x, chart_width),
                        .y = residual_.value(places[i].y, height()),
                        .text = points[i].text,
                        .look = {black}};
      tags.marks.push_back(tag);
      if (std::hypot(places[i].x - markers[i].x, places[i].y - markers[i].y) <
          nearest_tag_distance() + 0.5)
        continue;
      leaders.marks.push_back({.x = points[i].x, .y = points[i].y, .look = {0x999999}});
      leaders.marks.push_back({.x = tag.x, .y = tag.y});
      leaders.marks.push_back({});
    }
    panel.series.push_back(std::move(leaders));
    panel.series.push_back(std::move(tags));
  }

  const Sheet& sheet_;
  const Group& group_;
  const std::vector<std::string>& rows_;
  std::set<std::size_t> listed_;
  LogRange cost_, residual_;
};

}  // namespace

double cost_floor(Measure measure) { return measure == Measure::time ? 1e-9 : 0.5; }

std::vector<std::string> rows_of_settings(const Sheet& sheet) {
  std::vector<std::string> rows;
  for (const Setting& setting : sheet.settings) rows.push_back(parse_spelling(setting.solver).name);
  return rows;
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

Figure chart_figure(const Sheet& sheet) {
  const std::vector<const Group*> groups = drawn_groups(sheet, most_panels);
  if (groups.empty()) throw std::invalid_argument("no run to draw: none is counted in any corpus");
  const std::vector<std::string> rows = rows_of_settings(sheet);
  std::vector<Plane> planes;
  double name_width = 0;
  std::size_t corpora = 0, shown = 0;
  for (const Group* group : groups) {
    planes.emplace_back(sheet, *group, rows);
    name_width = std::max(name_width, planes.back().name_width());
    shown += group->name != all_corpora;
  }
  for (const Group& group : sheet.groups) corpora += group.name != all_corpora;
  Figure figure{
      .title = fmt::format("Median {} against median residual of every setting, and its failures",
                           printed(sheet.options.measure)),
      .caption =
          "Filled marker: no failure; open: some; bars: quartiles over the solved; thin "
          "lines: one option varied. Ringed: on the front of cost, residual and share solved; "
          "grey stairs: the front of those that solve the most. In the list, from the right: "
          "trivial, unsupported and not run."};
  if (shown < corpora)
    figure.caption += fmt::format(" {} more corpora are not drawn.", corpora - shown);
  double top = chart_head;
  for (const Plane& plane : planes) {
    figure.panels.push_back(plane.chart(top + panel_head));
    figure.panels.push_back(plane.list(top + panel_head, name_width));
    top += panel_head + plane.height() + panel_foot;
  }
  figure.width = list_left + figure.panels.back().area.width;
  figure.height = top;
  return figure;
}

}  // namespace lcp
