#include <fmt/format.h>

#include <cmath>

#include "harness/studies/frontier/frontier_render.h"
#include "harness/present/escaping.h"

namespace lcp {

namespace {

using nlohmann::json;

std::string counted_verdicts(const FrontierCell& cell) {
  std::string text;
  for (const auto& [verdict, count] : cell.verdicts)
    text += fmt::format("{}{} {}", text.empty() ? "" : "; ", to_string(verdict), count);
  return text;
}

std::string csv_lines(const Frontier& frontier) {
  const FrontierGrid& grid = frontier.plan.grid;
  std::string text;
  for (const FrontierRow& row : frontier.rows)
    for (std::size_t x = 0; x < row.columns.size(); ++x)
      for (std::size_t y = 0; y < row.columns[x].cells.size(); ++y) {
        const FrontierCell& cell = row.columns[x].cells[y];
        const Interval interval = wilson_interval(cell.solved, cell.counted);
        text += fmt::format("{},{},{},{},{},{},{},{:.4f},{:.4f},{},{}\n", csv_quoted(row.solver),
                            frontier.plan.seed, grid.x.values[x], grid.y.values[y], cell.drawn,
                            cell.counted, cell.solved, interval.low, interval.high,
                            cell.pivots ? std::to_string(*cell.pivots) : "",
                            csv_quoted(counted_verdicts(cell)));
      }
  return text;
}

json axis_json(const KnobAxis& axis) {
  return {{"knob", axis.knob}, {"values", axis.values}, {"geometric", axis.geometric}};
}

/// The knob's value at a position of y; null for an open end.
json value_json(const KnobAxis& y, double position) {
  return std::isfinite(position) ? json(y.value_at(position)) : json();
}

json cell_json(double y, const FrontierCell& cell) {
  const Interval interval = wilson_interval(cell.solved, cell.counted);
  json verdicts = json::object();
  for (const auto& [verdict, count] : cell.verdicts) verdicts[to_string(verdict)] = count;
  return {{"y", y},
          {"drawn", cell.drawn},
          {"counted", cell.counted},
          {"solved", cell.solved},
          {"low", interval.low},
          {"high", interval.high},
          {"pivots_median", cell.pivots ? json(*cell.pivots) : json()},
          {"verdicts", verdicts}};
}

json column_json(double x, const KnobAxis& y, const FrontierColumn& column) {
  const ShareLine& line = column.line;
  json object = {{"x", x}, {"line", to_string(line.kind)}, {"settled", column.settled}};
  if (line.kind == ShareLine::Kind::crossing) {
    object["y"] = value_json(y, line.u);
    object["low"] = value_json(y, line.low);
    object["high"] = value_json(y, line.high);
    object["rising"] = line.rising;
  }
  if (line.kind == ShareLine::Kind::several) {
    object["crossings"] = json::array();
    for (const double u : line.crossings) object["crossings"].push_back(value_json(y, u));
  }
  object["cells"] = json::array();
  for (std::size_t i = 0; i < column.cells.size(); ++i)
    object["cells"].push_back(cell_json(y.values[i], column.cells[i]));
  return object;
}

json rows_json(const Frontier& frontier) {
  const FrontierGrid& grid = frontier.plan.grid;
  json rows = json::array();
  for (const FrontierRow& row : frontier.rows) {
    json columns = json::array();
    for (std::size_t x = 0; x < row.columns.size(); ++x)
      columns.push_back(column_json(grid.x.values[x], grid.y, row.columns[x]));
    rows.push_back({{"solver", row.solver}, {"columns", columns}});
  }
  return rows;
}

}  // namespace

std::string frontier_csv(const FrontierReport& report) {
  const FrontierGrid& grid = report.first.plan.grid;
  return fmt::format(
             "solver,seed,{},{},drawn,counted,solved,share_low,share_high,pivots_median,verdicts\n",
             grid.x.knob, grid.y.knob) +
         csv_lines(report.first) + (report.second ? csv_lines(*report.second) : "");
}

json frontier_json(const FrontierReport& report) {
  const FrontierPlan& plan = report.first.plan;
  json object = {{"family", plan.grid.family},
                 {"x", axis_json(plan.grid.x)},
                 {"y", axis_json(plan.grid.y)},
                 {"tolerance", plan.limits.tolerance},
                 {"timeout_s", std::chrono::duration<double>(plan.limits.timeout).count()},
                 {"count", plan.count},
                 {"max_count", plan.max_count},
                 {"band_decades", plan.band},
                 {"seed", plan.seed},
                 {"rows", rows_json(report.first)}};
  if (!report.second) return object;
  json again = {{"seed", report.second->plan.seed},
                {"rows", rows_json(*report.second)},
                {"agreement", json::array()}};
  const std::vector<SeedAgreement> all = seed_agreements(report.first, *report.second);
  for (std::size_t s = 0; s < all.size(); ++s)
    again["agreement"].push_back({{"solver", report.first.rows[s].solver},
                                  {"columns", all[s].column_agrees},
                                  {"agree", all[s].agree},
                                  {"lines", all[s].lines},
                                  {"within", all[s].within}});
  object["check"] = again;
  return object;
}

}  // namespace lcp
