#include "harness/studies/sheet/sheet_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "harness/studies/sheet/chart.h"
#include "harness/studies/sheet/render.h"

namespace lcp {

namespace {

constexpr std::size_t most_profile_panels = 13;

/// Which of a row's curves is drawn.
using CurveOf = const Curve& (*)(const SheetRow&, std::size_t);

const Curve& profile_of(const SheetRow& row, std::size_t) { return row.profile; }
const Curve& within_of(const SheetRow& row, std::size_t i) { return row.within.at(i); }
const Curve& in_time_of(const SheetRow& row, std::size_t i) { return row.accuracy_in_time.at(i); }

/// Settings in colour: from setting to place in the legend, ordered by where the curve ends.
std::map<std::size_t, int> styles(const Sheet& sheet, const Group& group, CurveOf curve,
                                  std::size_t i) {
  std::vector<std::size_t> order = highlights(sheet, group, most_highlights_of_curves);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return curve(group.rows[a], i).unreached() < curve(group.rows[b], i).unreached();
  });
  std::map<std::size_t, int> styles;
  for (const std::size_t row : order)
    styles.emplace(group.rows[row].setting, static_cast<int>(styles.size()));
  return styles;
}

/// Names with the share that never rises, and of how many where it is not of all.
std::vector<std::string> legend(const Sheet& sheet, const Group& group,
                                const std::map<std::size_t, int>& styles, CurveOf curve,
                                std::size_t i, const char* never) {
  std::vector<std::string> names(styles.size());
  for (const SheetRow& row : group.rows) {
    const auto style = styles.find(row.setting);
    if (style == styles.end()) continue;
    const Curve& drawn = curve(row, i);
    const std::string of =
        drawn.counted < group.instances ? fmt::format(" of {}", drawn.counted) : "";
    names[static_cast<std::size_t>(style->second)] =
        fmt::format("{}  ({:.0f} % {}{})", sheet.settings[row.setting].label,
                    100 * drawn.unreached(), never, of);
  }
  return names;
}

StepPanel panel(const Group& group, const std::map<std::size_t, int>& styles, CurveOf curve,
                std::size_t i) {
  StepPanel panel;
  for (const SheetRow& row : group.rows) {
    const auto style = styles.find(row.setting);
    panel.curves.push_back({style == styles.end() ? -1 : style->second, curve(row, i)});
  }
  return panel;
}

/// From the least to the largest step of all panels, at least a decade.
LogRange range_of(const std::vector<StepPanel>& panels, double floor) {
  double low = INFINITY, high = 0;
  for (const StepPanel& panel : panels)
    for (const StepCurve& curve : panel.curves)
      for (const double at : curve.curve.reached) {
        low = std::min(low, std::max(at, floor));
        high = std::max(high, at);
      }
  if (high == 0) return {floor, 10 * floor};
  return {low, std::max(10 * low, high)};
}

/// Where 0 stands among counts: a curve that rises there does so at the left end of the axis.
constexpr double least_count = 0.5;

/// Residuals are scaled: at 1 an answer is as bad as z = 0 on many an instance.
constexpr double largest_residual_drawn = 1;

double least_cost_drawn(const Sheet& sheet) {
  return sheet.options.measure == Measure::time ? 1e-9 : least_count;
}

std::string greys(const Group& group, const std::map<std::size_t, int>& styles) {
  const std::size_t others = group.rows.size() - styles.size();
  return others == 0 ? ""
                     : fmt::format("Grey: {} other setting{}. ", others, others == 1 ? "" : "s");
}

const Group& first_group(const Sheet& sheet) {
  const std::vector<const Group*> drawn = drawn_groups(sheet, 1);
  if (drawn.empty()) throw std::invalid_argument("no run to draw: none is counted in any corpus");
  return *drawn.front();
}

std::string group_title(const Group& group) {
  return fmt::format("{} ({} instance{})", group.name, group.instances,
                     group.instances == 1 ? "" : "s");
}

/// The panels at every value of a list, the one at `first` large and so in front.
template <class Title>
std::vector<StepPanel> panels_at(const Group& group, const std::map<std::size_t, int>& styles,
                                 CurveOf curve, std::size_t count, std::size_t first, Title title) {
  std::vector<StepPanel> panels;
  const auto add = [&](std::size_t i) {
    panels.push_back(panel(group, styles, curve, i));
    panels.back().title = title(i);
  };
  add(first);
  for (std::size_t i = 0; i < count; ++i)
    if (i != first) add(i);
  return panels;
}

}  // namespace

StepCurvePage profile_page(const Sheet& sheet) {
  const Group& first = first_group(sheet);
  const auto style = styles(sheet, first, profile_of, 0);
  StepCurvePage page;
  page.title = fmt::format("Performance profile: {}", printed(sheet.options.measure));
  page.x_label =
      fmt::format("ratio tau to the least {} on the instance", printed(sheet.options.measure));
  page.y_label = "share of instances within tau";
  page.legend = legend(sheet, first, style, profile_of, 0, "never");
  for (const Group* group : drawn_groups(sheet, most_profile_panels)) {
    page.panels.push_back(panel(*group, style, profile_of, 0));
    page.panels.back().title = group == &first
                                   ? fmt::format("{}, {} of them solved by no setting",
                                                 group_title(*group), group->unsolved_by_all)
                                   : fmt::format("{} ({})", group->name, group->instances);
  }
  page.x = range_of(page.panels, 1);
  page.caption = greys(first, style) + sheet_caption(sheet);
  return page;
}

StepCurvePage cumulative_page(const Sheet& sheet) {
  const std::vector<double>& accuracies = sheet.options.accuracies;
  const auto distance = [&](double accuracy) {
    return std::abs(std::log(accuracy / sheet.tolerance));
  };
  const auto nearest = static_cast<std::size_t>(
      std::min_element(accuracies.begin(), accuracies.end(),
                       [&](double a, double b) { return distance(a) < distance(b); }) -
      accuracies.begin());
  const Group& group = first_group(sheet);
  const auto style = styles(sheet, group, within_of, nearest);
  StepCurvePage page;
  page.title = fmt::format("Accuracy reached within {}: {}", printed(sheet.options.measure),
                           group_title(group));
  page.x_label = printed(sheet.options.measure);
  page.y_label = "share of instances solved to the accuracy";
  page.legend = legend(sheet, group, style, within_of, nearest, "never");
  page.panels = panels_at(group, style, within_of, accuracies.size(), nearest, [&](std::size_t i) {
    return fmt::format("residual <= {:.0e}", accuracies[i]);
  });
  page.x = range_of(page.panels, least_cost_drawn(sheet));
  page.caption = greys(group, style) +
                 "Stored answers judged anew at each accuracy; instances that z = 0 solves to it "
                 "leave that panel. " +
                 sheet_caption(sheet);
  return page;
}

StepCurvePage accuracy_page(const Sheet& sheet) {
  const std::vector<double>& budgets = sheet.options.budgets_ms;
  const Group& group = first_group(sheet);
  const std::size_t middle = budgets.size() / 2;
  const auto style = styles(sheet, group, in_time_of, middle);
  StepCurvePage page;
  page.title = fmt::format("Accuracy reached in a given time: {}", group_title(group));
  page.x_label = "natural residual r";
  page.y_label = "share of instances answered in time to r";
  page.legend = legend(sheet, group, style, in_time_of, middle, "not in time");
  page.panels = panels_at(group, style, in_time_of, budgets.size(), middle,
                          [&](std::size_t i) { return fmt::format("within {} ms", budgets[i]); });
  page.x = range_of(page.panels, residual_floor);
  if (page.x.low < largest_residual_drawn)
    page.x.high = std::min(page.x.high, largest_residual_drawn);
  page.caption =
      greys(group, style) +
      "Of answers that claim to be a solution; what is worse than a residual of 1 lies beyond "
      "the right end. " +
      sheet_caption(sheet);
  return page;
}

}  // namespace lcp
