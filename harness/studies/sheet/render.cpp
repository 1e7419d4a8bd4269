#include "harness/studies/sheet/render.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "harness/present/columns.h"

namespace lcp {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_in_accuracies = 10;

/// A line of the sheet: a setting on a group.
struct SheetLine {
  const Sheet& sheet;
  const Group& group;
  const SheetRow& row;

  const Setting& setting() const { return sheet.settings[row.setting]; }
};

using SheetColumns = std::vector<Column<SheetLine>>;

std::vector<SheetLine> lines_of(const Sheet& sheet, const Group& group) {
  std::vector<SheetLine> lines;
  for (const SheetRow& row : group.rows) lines.push_back({sheet, group, row});
  return lines;
}

Column<SheetLine> text_of(const char* key, std::string Setting::*field) {
  return {{.key = key}, [field](const SheetLine& line) { return Cell(line.setting().*field); }};
}

Column<SheetLine> count_of(const char* key, const char* heading, const char* meaning,
                           Index Mass::*field) {
  return {{.key = key, .heading = heading, .meaning = meaning},
          [field](const SheetLine& line) { return Cell(line.row.mass.*field); }};
}

Column<SheetLine> quantile_of(const char* key, const char* heading, const char* meaning,
                              const char* number, std::optional<Spread> SheetRow::*spread,
                              double Spread::*field) {
  return {{.key = key, .heading = heading, .meaning = meaning, .number = number},
          [spread, field](const SheetLine& line) {
            return line.row.*spread ? Cell((*(line.row.*spread)).*field) : Cell();
          }};
}

/// A share of what is counted, for a reader in per cent; empty where nothing is.
Column<SheetLine> share_of(std::string key, std::string heading, const char* meaning,
                           std::function<const Curve&(const SheetRow&)> curve,
                           double (*share)(const Curve&, double), double at = 0) {
  return {{.key = std::move(key),
           .heading = std::move(heading),
           .meaning = meaning,
           .scale = 100,
           .exact = "{:.4g}"},
          [=](const SheetLine& line) {
            const Curve& drawn = curve(line.row);
            return drawn.counted == 0 ? Cell() : Cell(share(drawn, at));
          }};
}

const Curve& profile(const SheetRow& row) { return row.profile; }
double share_at(const Curve& curve, double at) { return curve.share(at); }
double share_reached(const Curve& curve, double) { return 1 - curve.unreached(); }
double share_never(const Curve& curve, double) { return curve.unreached(); }

const SheetColumns& mass_columns() {
  static const SheetColumns all = {
      count_of("instances", "", "", &Mass::instances),
      count_of("solved", "solved", "", &Mass::solved),
      count_of("failed", "failed", "at the edge of the plane: cost infinity", &Mass::failed),
      count_of("trivial", "triv", "solved where z = 0 is a solution too", &Mass::trivial),
      count_of("unsupported", "unsup", "the method does not apply", &Mass::unsupported),
      count_of("not_run", "n.run", "left out as too large; these five add up to the instances",
               &Mass::not_run)};
  return all;
}

/// What a reader sees of a setting, and a program between its names and its curves.
SheetColumns quantity_columns() {
  SheetColumns all = mass_columns();
  using S = SheetRow;
  for (const auto& [key, heading, meaning, field] :
       {std::tuple{"cost_q25", "q25", "", &Spread::low},
        std::tuple{"cost_median", "median", "cost of the solved, with quartiles q25 and q75",
                   &Spread::median},
        std::tuple{"cost_q75", "q75", "", &Spread::high}})
    all.push_back(quantile_of(key, heading, meaning, "{:#.3g}", &S::cost, field));
  all.push_back(quantile_of("residual_q25", "", "", "", &S::residual, &Spread::low));
  all.push_back(quantile_of("residual_median", "resid", "median natural residual of the solved",
                            "{:.1e}", &S::residual, &Spread::median));
  all.push_back(quantile_of("residual_q75", "", "", "", &S::residual, &Spread::high));
  all.push_back({{.key = "shift"}, [](const SheetLine& line) { return Cell(line.group.shift); }});
  all.push_back({{.key = "shifted_mean",
                  .heading = "mean",
                  .meaning = "shifted geometric mean of the cost of the solved",
                  .number = "{:#.3g}"},
                 [](const SheetLine& line) { return cell_of(line.row.shifted_mean); }});
  all.push_back({{.key = "slowdown",
                  .heading = "/best",
                  .meaning = "that over the same mean of the least costs of the same instances",
                  .number = "{:#.3g}"},
                 [](const SheetLine& line) { return cell_of(line.row.slowdown); }});
  all.push_back(
      {{.key = "best", .heading = "best", .meaning = "instances on which no setting costs less"},
       [](const SheetLine& line) { return Cell(line.row.best); }});
  all.push_back({{.key = "front"}, [](const SheetLine& line) { return Cell(line.row.front); }});
  for (const auto& [ratio, heading, meaning] :
       {std::tuple{1, "", ""},
        std::tuple{2, "2x%", "share of solved + failed within twice the least cost"},
        std::tuple{5, "", ""}, std::tuple{10, "10x%", "share within ten times"},
        std::tuple{100, "", ""}})
    all.push_back(
        share_of(fmt::format("profile_{}", ratio), heading, meaning, profile, share_at, ratio));
  all.push_back(share_of("never", "never%", "share not solved", profile, share_never));
  return all;
}

/// Shares reached at every accuracy, and done within every budget of time.
SheetColumns curve_columns(const Sheet& sheet) {
  SheetColumns all;
  const SheetOptions& options = sheet.options;
  for (std::size_t i = 0; i < options.accuracies.size(); ++i)
    all.push_back(share_of(
        fmt::format("reached_{:.0e}", options.accuracies[i]),
        fmt::format("{:.0e}", options.accuracies[i]), "",
        [i](const SheetRow& row) -> const Curve& { return row.within.at(i); }, share_reached));
  for (std::size_t i = 0; options.measure == Measure::time && i < options.budgets_ms.size(); ++i)
    all.push_back(share_of(
        fmt::format("done_in_{}ms", options.budgets_ms[i]),
        fmt::format("<{}ms", options.budgets_ms[i]), "",
        [i](const SheetRow& row) -> const Curve& { return row.accuracy_in_time.at(i); },
        share_reached));
  return all;
}

std::string sheet_csv(const Sheet& sheet) {
  SheetColumns columns = {
      {{.key = "group"}, [](const SheetLine& line) { return Cell(line.group.name); }},
      text_of("label", &Setting::label),
      text_of("solver", &Setting::solver),
      text_of("row", &Setting::row),
      text_of("start", &Setting::start),
      {{.key = "measure"},
       [](const SheetLine& line) { return Cell(to_string(line.sheet.options.measure)); }},
      {{.key = "tolerance"}, [](const SheetLine& line) { return Cell(line.sheet.tolerance); }}};
  for (const SheetColumns& more : {quantity_columns(), curve_columns(sheet)})
    columns.insert(columns.end(), more.begin(), more.end());
  std::string out = csv_head({columns.begin(), columns.end()});
  for (const Group& group : sheet.groups)
    out += csv_rows(cells_of(columns, lines_of(sheet, group)));
  return out;
}

Json as_json(const std::optional<Spread>& spread) {
  if (!spread) return {};
  return {{"q25", spread->low}, {"median", spread->median}, {"q75", spread->high}};
}

/// Four digits: a curve's steps are for drawing.
Json as_json(const Curve& curve) {
  Json reached = Json::array();
  for (const double value : curve.reached)
    reached.push_back(std::strtod(fmt::format("{:.4g}", value).c_str(), nullptr));
  return {{"counted", curve.counted}, {"reached", std::move(reached)}};
}

/// A list of what `make` makes of each of `all`.
template <class All, class Make>
Json list_of(const All& all, Make make) {
  Json list = Json::array();
  for (const auto& each : all) list.push_back(make(each));
  return list;
}

Json as_json(const std::vector<Curve>& curves) {
  return list_of(curves, [](const Curve& curve) { return as_json(curve); });
}

/// The curves over costs and residuals are many: a corpus has them when it is chosen alone.
Json as_json(const SheetLine& line, bool in_full) {
  const SheetRow& row = line.row;
  Json object = json_object(mass_columns(), line, {{"setting", row.setting}});
  object.update({{"cost", as_json(row.cost)},
                 {"residual", as_json(row.residual)},
                 {"shifted_mean", cell_of(row.shifted_mean)},
                 {"slowdown", cell_of(row.slowdown)},
                 {"best", row.best},
                 {"front", row.front},
                 {"profile", as_json(row.profile)}});
  if (in_full)
    object.update(
        {{"within", as_json(row.within)}, {"accuracy_in_time", as_json(row.accuracy_in_time)}});
  return object;
}

Json as_json(const Ladder& ladder, const Group& group) {
  return {{"name", ladder.name},
          {"option", ladder.option},
          {"base", ladder.steps[ladder.base].value},
          {"steps", list_of(ladder.steps, [&](const Step& step) -> Json {
             return {{"value", step.value},
                     {"setting", group.rows[step.row].setting},
                     {"common", step.common},
                     {"cost_ratio", cell_of(step.cost_ratio)},
                     {"residual_ratio", cell_of(step.residual_ratio)}};
           })}};
}

std::string sheet_json(const Sheet& sheet) {
  const Json object = {
      {"measure", to_string(sheet.options.measure)},
      {"unit", sheet.options.measure == Measure::time ? "ms" : "count"},
      {"tolerance", sheet.tolerance},
      {"ratio", ratio_formula(sheet.options)},
      {"curve", "the k-th value of `reached`: there the share rises to k / counted"},
      {"accuracies", sheet.options.accuracies},
      {"budgets_ms", sheet.options.budgets_ms},
      {"jobs", sheet.jobs},
      {"without_work", sheet.without_work},
      {"settings", list_of(sheet.settings,
                           [](const Setting& setting) -> Json {
                             return {{"label", setting.label},
                                     {"solver", setting.solver},
                                     {"row", setting.row},
                                     {"start", setting.start}};
                           })},
      {"groups", list_of(sheet.groups, [&](const Group& group) -> Json {
         const bool in_full = &group == &sheet.groups.front();
         return {{"name", group.name},
                 {"instances", group.instances},
                 {"unsolved_by_all", group.unsolved_by_all},
                 {"shift", group.shift},
                 {"rows", list_of(lines_of(sheet, group),
                                  [&](const SheetLine& line) { return as_json(line, in_full); })},
                 {"ladders", list_of(group.ladders, [&](const Ladder& ladder) {
                    return as_json(ladder, group);
                  })}};
       })}};
  return object.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string figure(const std::optional<double>& value, const char* format = "{:#.3g}") {
  return printed({.number = format}, cell_of(value));
}

/// The front's two ends among the settings that solve the most, in words.
std::string sentence(const Sheet& sheet, const Group& group) {
  const std::vector<std::size_t> most = best_solving_front(group);
  if (most.empty()) return "  Nothing is solved here.";
  const auto least = [&](std::optional<Spread> SheetRow::*of) -> const SheetRow& {
    return group.rows[*std::min_element(most.begin(), most.end(), [&](auto a, auto b) {
      return (group.rows[a].*of)->median < (group.rows[b].*of)->median;
    })];
  };
  const SheetRow &fast = least(&SheetRow::cost), &exact = least(&SheetRow::residual);
  const std::string unit =
      sheet.options.measure == Measure::time ? "ms" : to_string(sheet.options.measure);
  const std::string out = fmt::format(
      "  Of the settings that solve the largest share ({} of {}), {} costs least: {} {} at a "
      "residual of {}",
      fast.mass.solved, fast.mass.counted(), sheet.settings[fast.setting].label,
      figure(fast.cost->median), unit, figure(fast.residual->median, "{:.1e}"));
  if (&fast == &exact) return out + ", and none of them is more accurate.";
  return out +
         fmt::format("; {} is the most accurate: {} at {} {}.", sheet.settings[exact.setting].label,
                     figure(exact.residual->median, "{:.1e}"), figure(exact.cost->median), unit);
}

/// A line per ladder: each value's solved of counted, cost and residual over those at the base.
std::string ladders_as_text(const Group& group) {
  std::string out;
  for (const Ladder& ladder : group.ladders) {
    const Step& base = ladder.steps[ladder.base];
    std::vector<std::string> steps;
    for (const Step& step : ladder.steps) {
      const Mass& mass = group.rows[step.row].mass;
      steps.push_back(fmt::format("{}: {}/{}", step.value, mass.solved, mass.counted()));
      if (&step != &base && step.common > 0)
        steps.back() += fmt::format(", cost {}, resid {}", figure(step.cost_ratio, "{:.2f}"),
                                    figure(step.residual_ratio, "{:.1e}"));
    }
    out += folded(fmt::format("  {} {} (over {}): {}", ladder.name, ladder.option, base.value,
                              fmt::join(steps, "; ")),
                  100, 6);
  }
  return out.empty() ? out : "\n" + out;
}

std::string group_as_text(const Sheet& sheet, const Group& group, bool in_full) {
  SheetColumns columns = quantity_columns(), curves = curve_columns(sheet);
  columns.insert(columns.begin(),
                 {{.heading = "  setting"}, [](const SheetLine& line) {
                    return Cell((line.row.front ? "* " : "  ") + line.setting().label);
                  }});
  std::vector<SheetLine> shown = lines_of(sheet, group), highlighted;
  const auto front = std::count_if(shown.begin(), shown.end(),
                                   [](const SheetLine& line) { return line.row.front; });
  std::string out = folded(fmt::format(
      "{}: {} instance{}, {} solved by no setting; {} of {} setting{} on the front{}", group.name,
      group.instances, group.instances == 1 ? "" : "s", group.unsolved_by_all, front, shown.size(),
      shown.size() == 1 ? " is" : "s are", in_full ? " (*)" : ""));
  std::vector<SheetLine> rows;
  for (const SheetLine& line : shown)
    if (in_full || line.row.front) rows.push_back(line);
  if (!rows.empty()) out += text_table(cells_of(columns, rows));
  out += folded(sentence(sheet, group), 100, 2);
  if (in_full) {
    curves.insert(curves.begin(), {{.heading = "reached %"}, [](const SheetLine& line) {
                                     return Cell(line.setting().label);
                                   }});
    for (const std::size_t i : highlights(sheet, group, most_in_accuracies))
      highlighted.push_back({sheet, group, group.rows[i]});
    out += "\n" + text_table(cells_of(curves, highlighted), {.indent = "  "});
  }
  return out + ladders_as_text(group) + "\n";
}

std::string sheet_text(const Sheet& sheet) {
  if (sheet.groups.empty()) return "no rows\n";
  std::string out;
  for (const Group& group : sheet.groups)
    out += group_as_text(sheet, group, &group == &sheet.groups.front());
  const SheetColumns columns = quantity_columns();
  out += legend({{columns.begin(), columns.end()}, {}});
  out += folded(
      "  front   no setting is as good in median cost, median residual and share solved, and "
      "better in one; medians are compared as they are: times a few per cent apart may swap places",
      100, 10);
  const bool laddered = std::any_of(sheet.groups.begin(), sheet.groups.end(),
                                    [](const Group& group) { return !group.ladders.empty(); });
  if (laddered)
    out += folded(
        "  ladder  value: solved/counted, then medians of cost and residual over those at the "
        "value "
        "after `over`, on what both solve",
        100, 10);
  return out + folded(sheet_caption(sheet));
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
      "failures do, at infinity.",
      printed(sheet.options.measure), sheet.tolerance, ratio_formula(sheet.options),
      sheet.settings.size());
  if (!sheet.without_work.empty())
    out += fmt::format(" Left out, since their rows count no {}: {}.",
                       to_string(sheet.options.measure), fmt::join(sheet.without_work, ", "));
  if (sheet.jobs > 1)
    out += fmt::format(" {} jobs ran at the same time: times are disturbed.", sheet.jobs);
  return out;
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
