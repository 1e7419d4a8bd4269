#include "harness/studies/sheet/sheet_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>

#include "harness/studies/sheet/chart.h"
#include "harness/studies/sheet/render.h"

namespace lcp {

namespace {

constexpr std::size_t most_profile_panels = 13;

/// Pixels.
constexpr double least_width = 1060, large_foot = 490, legend_left = 640, legend_letter = 7.4;
constexpr PageArea large_area = {74, 540, 70, 370};
constexpr PanelGrid small_grid = {
    .abreast = 4, .width = 182, .height = 140, .left_of = 66, .above = 34, .below = 41, .top = 506};
constexpr int large_columns = 180, small_columns = 60;
constexpr std::size_t small_title_letters = 30;

/// Residuals are scaled: at 1 an answer is as bad as z = 0 on many an instance.
constexpr double largest_residual_drawn = 1;

using CurveOf = std::function<const Curve&(const SheetRow&)>;

struct CurvePanel {
  std::string title;
  const Group* group;
  CurveOf curve;
};

/// What a picture shows, the large panel first.
struct CurvePage {
  std::string title, x_label, y_label;
  const char* never;  ///< What is said in the legend of the share that never rises.
  double floor;       ///< Where 0 stands.
  double largest = INFINITY;
  std::string note = {};
  std::vector<CurvePanel> panels = {};
};

const Group& first_group(const Sheet& sheet) {
  const std::vector<const Group*> drawn = drawn_groups(sheet, 1);
  if (drawn.empty()) throw std::invalid_argument("no run to draw: none is counted in any corpus");
  return *drawn.front();
}

std::string group_title(const Group& group) {
  return fmt::format("{} ({} instance{})", group.name, group.instances,
                     group.instances == 1 ? "" : "s");
}

/// A title that is too long loses its middle.
std::string shortened(const std::string& title) {
  if (title.size() <= small_title_letters) return title;
  const std::size_t end = (small_title_letters - 3) / 2;
  return title.substr(0, small_title_letters - 3 - end) + "..." + title.substr(title.size() - end);
}

/// From the least to the largest step of all panels, at least a decade.
LogRange range_of(const CurvePage& page) {
  double low = INFINITY, high = 0;
  for (const CurvePanel& panel : page.panels)
    for (const SheetRow& row : panel.group->rows)
      for (const double at : panel.curve(row).reached) {
        low = std::min(low, std::max(at, page.floor));
        high = std::max(high, at);
      }
  if (high == 0) return {page.floor, 10 * page.floor};
  high = std::max(10 * low, high);
  return {low, low < page.largest ? std::min(high, page.largest) : high};
}

/// Settings in colour, ordered by where their curve ends in the large panel.
std::vector<const SheetRow*> in_colour(const Sheet& sheet, const CurvePanel& panel) {
  std::vector<const SheetRow*> rows;
  for (const std::size_t i : highlights(sheet, *panel.group, most_highlights_of_curves))
    rows.push_back(&panel.group->rows[i]);
  std::stable_sort(rows.begin(), rows.end(), [&](const SheetRow* a, const SheetRow* b) {
    return panel.curve(*a).unreached() < panel.curve(*b).unreached();
  });
  return rows;
}

/// The series of a panel; settings that have no look are grey, in the large panel alone.
std::vector<Series> series_of(const CurvePanel& panel, const LogRange& x,
                              const std::map<std::size_t, Look>& looks, bool is_large) {
  std::vector<Series> greys, coloured;
  for (const SheetRow& row : panel.group->rows) {
    const auto look = looks.find(row.setting);
    const bool grey = look == looks.end();
    const Curve& curve = panel.curve(row);
    if (curve.counted == 0 || (grey && !is_large)) continue;
    Series line{.size = grey ? 0.7 : is_large ? 1.9 : 1.3};
    for (const Pixels& corner :
         step_corners(curve, x, is_large && !grey ? large_columns : small_columns))
      line.marks.push_back(
          {.x = corner.x, .y = corner.y, .look = grey ? Look{0xcccccc} : look->second});
    (grey ? greys : coloured).push_back(std::move(line));
  }
  greys.insert(greys.end(), coloured.begin(), coloured.end());
  return greys;
}

Figure figure_of(const Sheet& sheet, const CurvePage& page) {
  const CurvePanel& first = page.panels.front();
  const std::vector<const SheetRow*> coloured = in_colour(sheet, first);
  const std::vector<std::string> all_rows = rows_of_settings(sheet);
  std::vector<std::string> rows;
  for (const SheetRow* row : coloured) rows.push_back(all_rows[row->setting]);
  const std::vector<Look> looks = looks_of_settings(rows);

  Figure figure{.title = page.title};
  figure.width = least_width;
  std::map<std::size_t, Look> look_of_setting;
  for (std::size_t i = 0; i < coloured.size(); ++i) {
    const Curve& curve = first.curve(*coloured[i]);
    const std::string& label = sheet.settings[coloured[i]->setting].label;
    const std::string of = curve.counted < first.group->instances
                               ? fmt::format(" of {}", curve.counted)
                               : std::string();
    figure.legend.push_back(
        {.name = fmt::format("{}  ({:.0f} % {}{})", label, 100 * curve.unreached(), page.never, of),
         .look = looks[i],
         .line = true,
         .point = false});
    figure.width = std::max(
        figure.width, legend_left + 50 + legend_letter * double(figure.legend.back().name.size()));
    look_of_setting.emplace(coloured[i]->setting, looks[i]);
  }
  figure.legend_area = {legend_left, 380, large_area.top, large_area.height};

  const LogRange x = range_of(page);
  for (const CurvePanel& panel : page.panels) {
    const bool is_large = &panel == &first;
    figure.panels.push_back(
        {.area = is_large ? large_area : small_grid.area(figure.panels.size() - 1),
         .title = is_large ? panel.title : shortened(panel.title),
         .x = {.label = is_large ? page.x_label : "",
               .low = x.low,
               .high = x.high,
               .scale = Axis::Scale::log},
         .y = {.label = is_large ? page.y_label : "",
               .high = 1.02,
               .ticks = round_ticks(0, 1, is_large ? 11 : 5, Axis::Scale::linear)},
         .series = series_of(panel, x, look_of_setting, is_large)});
  }
  figure.height =
      page.panels.size() > 1 ? small_grid.page_height(page.panels.size() - 1) : large_foot;
  const std::size_t others = first.group->rows.size() - coloured.size();
  if (others > 0)
    figure.caption = fmt::format("Grey: {} other setting{}. ", others, others == 1 ? "" : "s");
  figure.caption += page.note + sheet_caption(sheet);
  return figure;
}

/// A panel of the first group per value of a list, the one at `first` in front.
template <class Title>
std::vector<CurvePanel> panels_at(const Group& group, std::vector<Curve> SheetRow::*curves,
                                  std::size_t count, std::size_t first, Title title) {
  std::vector<CurvePanel> panels;
  for (std::size_t i = 0; i < count; ++i)
    panels.push_back({title(i), &group,
                      [=](const SheetRow& row) -> const Curve& { return (row.*curves).at(i); }});
  const auto front = panels.begin() + static_cast<std::ptrdiff_t>(first);
  std::rotate(panels.begin(), front, front + 1);
  return panels;
}

}  // namespace

Figure profile_figure(const Sheet& sheet) {
  const std::string cost = printed(sheet.options.measure);
  CurvePage page{.title = "Performance profile: " + cost,
                 .x_label = fmt::format("ratio tau to the least {} on the instance", cost),
                 .y_label = "share of instances within tau",
                 .never = "never",
                 .floor = 1};
  const Group& first = first_group(sheet);
  for (const Group* group : drawn_groups(sheet, most_profile_panels))
    page.panels.push_back({group == &first ? fmt::format("{}, {} of them solved by no setting",
                                                         group_title(first), first.unsolved_by_all)
                                           : fmt::format("{} ({})", group->name, group->instances),
                           group, [](const SheetRow& row) -> const Curve& { return row.profile; }});
  return figure_of(sheet, page);
}

Figure cumulative_figure(const Sheet& sheet) {
  const std::vector<double>& accuracies = sheet.options.accuracies;
  const auto distance = [&](double accuracy) {
    return std::abs(std::log(accuracy / sheet.tolerance));
  };
  const auto nearest =
      std::min_element(accuracies.begin(), accuracies.end(),
                       [&](double a, double b) { return distance(a) < distance(b); }) -
      accuracies.begin();
  const Group& group = first_group(sheet);
  const std::string cost = printed(sheet.options.measure);
  return figure_of(
      sheet,
      {.title = fmt::format("Accuracy reached within {}: {}", cost, group_title(group)),
       .x_label = cost,
       .y_label = "share of instances solved to the accuracy",
       .never = "never",
       .floor = cost_floor(sheet.options.measure),
       .note =
           "Stored answers judged anew at each accuracy; instances that z = 0 solves to it leave "
           "that panel. ",
       .panels = panels_at(
           group, &SheetRow::within, accuracies.size(), static_cast<std::size_t>(nearest),
           [&](std::size_t i) { return fmt::format("residual <= {:.0e}", accuracies[i]); })});
}

Figure accuracy_figure(const Sheet& sheet) {
  const std::vector<double>& budgets = sheet.options.budgets_ms;
  const Group& group = first_group(sheet);
  return figure_of(
      sheet,
      {.title = fmt::format("Accuracy reached in a given time: {}", group_title(group)),
       .x_label = "natural residual r",
       .y_label = "share of instances answered in time to r",
       .never = "not in time",
       .floor = residual_floor,
       .largest = largest_residual_drawn,
       .note = "Of answers that claim to be a solution; what is worse than a residual of 1 lies "
               "beyond the right end. ",
       .panels =
           panels_at(group, &SheetRow::accuracy_in_time, budgets.size(), budgets.size() / 2,
                     [&](std::size_t i) { return fmt::format("within {} ms", budgets[i]); })});
}

}  // namespace lcp
