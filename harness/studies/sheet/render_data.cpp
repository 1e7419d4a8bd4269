#include <fmt/format.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "harness/present/escaping.h"
#include "harness/studies/sheet/render.h"
#include "solvers/options.h"

namespace lcp {

namespace {

using OrderedJson = nlohmann::ordered_json;

/// Ratios at which a CSV has the profile.
constexpr double csv_ratios[] = {1, 2, 5, 10, 100};

/// Four digits: a curve's steps are for drawing.
double rounded(double value) { return std::strtod(fmt::format("{:.4g}", value).c_str(), nullptr); }

std::string in_csv(const std::optional<double>& value) { return value ? shortest(*value) : ""; }

OrderedJson as_json(const std::optional<double>& value) {
  return value ? OrderedJson(*value) : OrderedJson();
}

OrderedJson as_json(const std::optional<Spread>& spread) {
  if (!spread) return {};
  return {{"q25", spread->low}, {"median", spread->median}, {"q75", spread->high}};
}

OrderedJson as_json(const Curve& curve) {
  OrderedJson reached = OrderedJson::array();
  for (const double value : curve.reached) reached.push_back(rounded(value));
  return {{"counted", curve.counted}, {"reached", std::move(reached)}};
}

OrderedJson as_json(const std::vector<Curve>& curves) {
  OrderedJson all = OrderedJson::array();
  for (const Curve& curve : curves) all.push_back(as_json(curve));
  return all;
}

/// The curves over costs and residuals are many: a corpus has them when it is chosen alone.
OrderedJson as_json(const SheetRow& row, bool in_full) {
  const Mass& mass = row.mass;
  OrderedJson object = {{"setting", row.setting},
                        {"instances", mass.instances},
                        {"solved", mass.solved},
                        {"failed", mass.failed},
                        {"trivial", mass.trivial},
                        {"unsupported", mass.unsupported},
                        {"not_run", mass.not_run},
                        {"cost", as_json(row.cost)},
                        {"residual", as_json(row.residual)},
                        {"shifted_mean", as_json(row.shifted_mean)},
                        {"slowdown", as_json(row.slowdown)},
                        {"best", row.best},
                        {"front", row.front},
                        {"profile", as_json(row.profile)}};
  if (in_full) {
    object["within"] = as_json(row.within);
    object["accuracy_in_time"] = as_json(row.accuracy_in_time);
  }
  return object;
}

OrderedJson as_json(const Ladder& ladder, const Group& group) {
  OrderedJson steps = OrderedJson::array();
  for (const Step& step : ladder.steps)
    steps.push_back({{"value", step.value},
                     {"setting", group.rows[step.row].setting},
                     {"common", step.common},
                     {"cost_ratio", as_json(step.cost_ratio)},
                     {"residual_ratio", as_json(step.residual_ratio)}});
  return {{"name", ladder.name},
          {"option", ladder.option},
          {"base", ladder.steps[ladder.base].value},
          {"steps", std::move(steps)}};
}

OrderedJson as_json(const Group& group, bool in_full) {
  OrderedJson object = {{"name", group.name},
                        {"instances", group.instances},
                        {"unsolved_by_all", group.unsolved_by_all},
                        {"shift", group.shift}};
  object["rows"] = OrderedJson::array();
  for (const SheetRow& row : group.rows) object["rows"].push_back(as_json(row, in_full));
  object["ladders"] = OrderedJson::array();
  for (const Ladder& ladder : group.ladders) object["ladders"].push_back(as_json(ladder, group));
  return object;
}

}  // namespace

std::string sheet_json(const Sheet& sheet) {
  OrderedJson object = {
      {"measure", to_string(sheet.options.measure)},
      {"unit", sheet.options.measure == Measure::time ? "ms" : "count"},
      {"tolerance", sheet.tolerance},
      {"ratio", ratio_formula(sheet.options)},
      {"curve", "the k-th value of `reached`: there the share rises to k / counted"},
      {"accuracies", sheet.options.accuracies},
      {"budgets_ms", sheet.options.budgets_ms},
      {"jobs", sheet.jobs},
      {"without_work", sheet.without_work}};
  object["settings"] = OrderedJson::array();
  for (const Setting& setting : sheet.settings)
    object["settings"].push_back({{"label", setting.label},
                                  {"solver", setting.solver},
                                  {"row", setting.row},
                                  {"start", setting.start}});
  object["groups"] = OrderedJson::array();
  for (const Group& group : sheet.groups)
    object["groups"].push_back(as_json(group, &group == &sheet.groups.front()));
  return object.dump(-1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

std::string sheet_csv(const Sheet& sheet) {
  const SheetOptions& options = sheet.options;
  std::string out =
      "group,label,solver,row,start,measure,tolerance,instances,solved,failed,trivial,unsupported,"
      "not_run,cost_q25,cost_median,cost_q75,residual_q25,residual_median,residual_q75,"
      "shift,shifted_mean,slowdown,best,front";
  for (const double ratio : csv_ratios) out += fmt::format(",profile_{}", ratio);
  out += ",never";
  for (const double accuracy : options.accuracies) out += fmt::format(",reached_{:.0e}", accuracy);
  if (options.measure == Measure::time)
    for (const double budget : options.budgets_ms) out += fmt::format(",done_in_{}ms", budget);
  out += "\n";
  const auto spread = [](const std::optional<Spread>& s) {
    return s ? fmt::format(",{},{},{}", shortest(s->low), shortest(s->median), shortest(s->high))
             : ",,,";
  };
  for (const Group& group : sheet.groups) {
    for (const SheetRow& row : group.rows) {
      const Setting& setting = sheet.settings[row.setting];
      const Mass& mass = row.mass;
      out += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}", csv_quoted(group.name),
                         csv_quoted(setting.label), csv_quoted(setting.solver),
                         csv_quoted(setting.row), setting.start, to_string(options.measure),
                         sheet.tolerance, mass.instances, mass.solved, mass.failed, mass.trivial,
                         mass.unsupported, mass.not_run);
      out += spread(row.cost) + spread(row.residual);
      out += fmt::format(",{},{},{},{},{}", shortest(group.shift), in_csv(row.shifted_mean),
                         in_csv(row.slowdown), row.best, row.front ? 1 : 0);
      const auto share = [&](const Curve& curve, double value) {
        return curve.counted == 0 ? std::string() : fmt::format("{:.4g}", value);
      };
      for (const double ratio : csv_ratios)
        out += fmt::format(",{}", share(row.profile, row.profile.share(ratio)));
      out += fmt::format(",{}", share(row.profile, row.profile.unreached()));
      for (const Curve& curve : row.within)
        out += fmt::format(",{}", share(curve, 1 - curve.unreached()));
      for (const Curve& curve : row.accuracy_in_time)
        out += fmt::format(",{}", share(curve, 1 - curve.unreached()));
      out += "\n";
    }
  }
  return out;
}

}  // namespace lcp
