#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "harness/studies/sheet/render.h"

namespace lcp {

namespace {

constexpr std::size_t widest_setting = 44;  ///< Longer names stand on a line of their own.
constexpr std::size_t most_in_accuracies = 10;
constexpr double near = 2, far = 10;  ///< Ratios whose share of the profile is printed.

std::string figure(const std::optional<double>& value, const char* format = "{:#.3g}") {
  if (!value) return "-";
  return *value == 0 ? "0" : fmt::format(fmt::runtime(format), *value);
}

std::string percent(double share) { return fmt::format("{:.0f}", 100 * share); }

struct SheetColumn {
  std::string heading;
  std::string meaning;
  int width;
  std::string (*cell)(const SheetRow&);
};

const std::vector<SheetColumn>& sheet_columns() {
  static const std::vector<SheetColumn> all = {
      {"solved", "", 7, [](const SheetRow& r) { return fmt::format("{}", r.mass.solved); }},
      {"failed", "at the edge of the plane: cost infinity", 7,
       [](const SheetRow& r) { return fmt::format("{}", r.mass.failed); }},
      {"triv", "solved where z = 0 is a solution too", 5,
       [](const SheetRow& r) { return fmt::format("{}", r.mass.trivial); }},
      {"unsup", "the method does not apply", 6,
       [](const SheetRow& r) { return fmt::format("{}", r.mass.unsupported); }},
      {"n.run", "left out as too large; these five add up to the instances", 6,
       [](const SheetRow& r) { return fmt::format("{}", r.mass.not_run); }},
      {"q25", "", 8,
       [](const SheetRow& r) { return r.cost ? figure(r.cost->low) : std::string("-"); }},
      {"median", "cost of the solved, with quartiles q25 and q75", 8,
       [](const SheetRow& r) { return r.cost ? figure(r.cost->median) : std::string("-"); }},
      {"q75", "", 8,
       [](const SheetRow& r) { return r.cost ? figure(r.cost->high) : std::string("-"); }},
      {"resid", "median natural residual of the solved", 8,
       [](const SheetRow& r) {
         return r.residual ? figure(r.residual->median, "{:.1e}") : std::string("-");
       }},
      {"mean", "shifted geometric mean of the cost of the solved", 8,
       [](const SheetRow& r) { return figure(r.shifted_mean); }},
      {"/best", "that over the same mean of the least costs of the same instances", 7,
       [](const SheetRow& r) { return figure(r.slowdown); }},
      {"best", "instances on which no setting costs less", 5,
       [](const SheetRow& r) { return fmt::format("{}", r.best); }},
      {"2x%", "share of solved + failed within twice the least cost", 5,
       [](const SheetRow& r) { return percent(r.profile.share(near)); }},
      {"10x%", "share within ten times", 5,
       [](const SheetRow& r) { return percent(r.profile.share(far)); }},
      {"never%", "share not solved", 7,
       [](const SheetRow& r) { return percent(r.profile.unreached()); }},
  };
  return all;
}

std::string rows_as_text(const Sheet& sheet, const std::vector<const SheetRow*>& rows) {
  std::size_t width = 8;
  for (const SheetRow* row : rows) {
    const std::size_t size = sheet.settings[row->setting].label.size();
    if (size <= widest_setting) width = std::max(width, size);
  }
  std::string out = std::string(width + 2, ' ');
  for (const SheetColumn& column : sheet_columns())
    out += fmt::format(" {:>{}}", column.heading, column.width);
  out += "\n";
  for (const SheetRow* row : rows) {
    const std::string& label = sheet.settings[row->setting].label;
    out += row->front ? "* " : "  ";
    out += label.size() > widest_setting ? label + "\n" + std::string(width + 2, ' ')
                                         : fmt::format("{:<{}}", label, width);
    for (const SheetColumn& column : sheet_columns())
      out += fmt::format(" {:>{}}", column.cell(*row), column.width);
    out += "\n";
  }
  return out;
}

/// The front's two ends among the settings that solve the most, in words.
std::string sentence(const Sheet& sheet, const Group& group) {
  std::vector<const SheetRow*> most;  // of the front, with the largest share
  double share = 0;
  for (const SheetRow& row : group.rows)
    if (row.front) share = std::max(share, row.mass.share_solved());
  for (const SheetRow& row : group.rows)
    if (row.front && row.mass.share_solved() == share) most.push_back(&row);
  if (most.empty()) return "  Nothing is solved here.\n";
  const SheetRow& fast = **std::min_element(
      most.begin(), most.end(), [](auto* a, auto* b) { return a->cost->median < b->cost->median; });
  const SheetRow& exact = **std::min_element(most.begin(), most.end(), [](auto* a, auto* b) {
    return a->residual->median < b->residual->median;
  });
  const std::string unit =
      sheet.options.measure == Measure::time ? "ms" : to_string(sheet.options.measure);
  std::string out = fmt::format(
      "  Of the settings that solve the largest share ({} of {}), {} costs least: {} {} at a "
      "residual of {}",
      fast.mass.solved, fast.mass.counted(), sheet.settings[fast.setting].label,
      figure(fast.cost->median), unit, figure(fast.residual->median, "{:.1e}"));
  if (&fast == &exact) return out + ", and none of them is more accurate.\n";
  return out + fmt::format(
                   "; {} is the most accurate: {} at {} {}.\n", sheet.settings[exact.setting].label,
                   figure(exact.residual->median, "{:.1e}"), figure(exact.cost->median), unit);
}

std::string step_as_text(const Group& group, const Step& step) {
  const Mass& mass = group.rows[step.row].mass;
  if (step.common == 0) return fmt::format("{}: {}/{}", step.value, mass.solved, mass.counted());
  return fmt::format("{}: {}/{}, cost {}, resid {}", step.value, mass.solved, mass.counted(),
                     figure(step.cost_ratio, "{:.2f}"), figure(step.residual_ratio, "{:.1e}"));
}

/// A line per ladder: each value's solved of counted, cost and residual over those at the base.
std::string ladders_as_text(const Group& group) {
  std::string out;
  for (const Ladder& ladder : group.ladders) {
    out += fmt::format("  {} {} (over {}): ", ladder.name, ladder.option,
                       ladder.steps[ladder.base].value);
    for (std::size_t i = 0; i < ladder.steps.size(); ++i) {
      if (i > 0) out += "; ";
      const Step& step = ladder.steps[i];
      const Mass& mass = group.rows[step.row].mass;
      out += i == ladder.base ? fmt::format("{}: {}/{}", step.value, mass.solved, mass.counted())
                              : step_as_text(group, step);
    }
    out += "\n";
  }
  return out.empty() ? out : "\n" + out;
}

/// Share reached at every accuracy, and done within every budget of time, of the highlighted settings.
std::string accuracies_as_text(const Sheet& sheet, const Group& group) {
  const std::vector<std::size_t> shown = highlights(sheet, group, most_in_accuracies);
  std::size_t width = 8;
  for (const std::size_t i : shown)
    width = std::max(width, sheet.settings[group.rows[i].setting].label.size());
  std::string out = fmt::format("\n  {:<{}}", "reached %", width);
  for (const double accuracy : sheet.options.accuracies) out += fmt::format(" {:>6.0e}", accuracy);
  const bool timed = sheet.options.measure == Measure::time;
  if (timed)
    for (const double budget : sheet.options.budgets_ms)
      out += fmt::format(" {:>8}", fmt::format("<{}ms", budget));
  out += "\n";
  for (const std::size_t i : shown) {
    const SheetRow& row = group.rows[i];
    out += fmt::format("  {:<{}}", sheet.settings[row.setting].label, width);
    for (const Curve& curve : row.within)
      out += fmt::format(" {:>6}", curve.counted == 0 ? "-" : percent(1 - curve.unreached()));
    for (const Curve& curve : row.accuracy_in_time)
      out += fmt::format(" {:>8}", percent(1 - curve.unreached()));
    out += "\n";
  }
  return out;
}

std::string group_as_text(const Sheet& sheet, const Group& group, bool in_full) {
  std::vector<const SheetRow*> rows;
  for (const SheetRow& row : group.rows)
    if (in_full || row.front) rows.push_back(&row);
  const auto front = std::count_if(group.rows.begin(), group.rows.end(),
                                   [](const SheetRow& row) { return row.front; });
  std::string out = fmt::format(
      "{}: {} instance{}, {} solved by no setting; {} of {} setting{} on the front{}\n", group.name,
      group.instances, group.instances == 1 ? "" : "s", group.unsolved_by_all, front,
      group.rows.size(), group.rows.size() == 1 ? " is" : "s are", in_full ? " (*)" : "");
  if (!rows.empty()) out += rows_as_text(sheet, rows);
  out += sentence(sheet, group);
  if (in_full) out += accuracies_as_text(sheet, group);
  return out + ladders_as_text(group) + "\n";
}

}  // namespace

std::string ratio_formula(const SheetOptions& options) {
  if (options.measure == Measure::time) return "c / best";
  return fmt::format("(c + {0}) / (best + {0})", options.count_offset);
}

std::string sheet_caption(const Sheet& sheet) {
  std::string out = fmt::format(
      "Cost is {}; solved means a natural residual of at most {}. Ratios {} are to the least cost "
      "on each instance among these {} settings: others would move every share of them. "
      "Unsupported, not-run and trivial instances do not count in the shares of a setting; "
      "failures do, "
      "at infinity.",
      printed(sheet.options.measure), sheet.tolerance, ratio_formula(sheet.options),
      sheet.settings.size());
  if (!sheet.without_work.empty())
    out += fmt::format(" Left out, since their rows count no {}: {}.",
                       to_string(sheet.options.measure), fmt::join(sheet.without_work, ", "));
  if (sheet.jobs > 1)
    out += fmt::format(" {} jobs ran at the same time: times are disturbed.", sheet.jobs);
  return out;
}

std::string sheet_text(const Sheet& sheet) {
  if (sheet.groups.empty()) return "no rows\n";
  std::string out;
  for (const Group& group : sheet.groups)
    out += group_as_text(sheet, group, &group == &sheet.groups.front());
  for (const SheetColumn& column : sheet_columns())
    if (!column.meaning.empty()) out += fmt::format("  {:<7} {}\n", column.heading, column.meaning);
  out +=
      "  front   no setting is as good in median cost, median residual and share solved, and "
      "better in one;\n"
      "          medians are compared as they are: times a few per cent apart may swap places\n";
  const bool laddered = std::any_of(sheet.groups.begin(), sheet.groups.end(),
                                    [](const Group& group) { return !group.ladders.empty(); });
  if (laddered)
    out +=
        "  ladder  value: solved/counted, then medians of cost and residual over those at the "
        "value after `over`, on what both solve\n";
  return out + sheet_caption(sheet) + "\n";
}

std::string render(const Sheet& sheet, SheetFormat format) {
  switch (format) {
    case SheetFormat::text:
      return sheet_text(sheet);
    case SheetFormat::csv:
      return sheet_csv(sheet);
    case SheetFormat::json:
      return sheet_json(sheet);
  }
  throw std::logic_error("unknown format of a sheet");
}

}  // namespace lcp
