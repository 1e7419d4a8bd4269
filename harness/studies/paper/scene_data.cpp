#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "harness/studies/paper/data_rows.h"
#include "harness/studies/paper/scene_cells.h"
#include "harness/present/escaping.h"

namespace lcp {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json row_of(const SceneTable& table, const SolverLine& line, std::size_t scene) {
  Json row = loop_object(table.published, table.plan.scenes[scene].column, line.columns[scene]);
  row["fell"] = nullptr;  // The first link of a chain or a net may well turn over.
  const Motion motion = motion_in(table, line, scene);
  row["survived"] = motion.survived;
  row["stopped"] = line.columns[scene].summary.stopped;
  row["off"] = json_of(motion.distance);
  row["parted"] = json_of(motion.parted);
  return row;
}

/// What the hoists say of a solver, with the fields that csv_line asks for.
Json hoist_object(const SceneTable& table, std::size_t i) {
  const PaperColumn& solver = table.plan.solvers[i];
  return row_object(table.published.table, "hoist", solver.solver, "in-loop", "hoist:10ms",
                    solver.acceptance);
}

Json ratio_of(const SceneTable& table) {
  Json measured = Json::array();
  for (std::size_t i = 0; i < table.solvers.size(); ++i)
    measured.push_back({{"solver", table.plan.solvers[i].solver},
                        {"value", json_of(time_ratio(table, table.solvers[i]))}});
  return {{"of", "simulation_time_ms * total_frames, hoist over hoist:10ms"},
          {"published", json_of(told_time_ratio(table))},
          {"published_cells", json_of(printed_time_ratio(table.published))},
          {"measured", measured}};
}

Json distance_of(const SceneTable& table) {
  Json measured = Json::array();
  for (std::size_t i = 0; i < table.solvers.size(); ++i) {
    const std::optional<double> distance = end_distance(table, table.solvers[i]);
    measured.push_back({{"solver", table.plan.solvers[i].solver},
                        {"value", json_of(distance)},
                        {"holds", holds(distance)}});
  }
  return {{"of", "links of hoist:10ms from those of hoist at the end, mean, over the length"},
          {"expected_at_most", kSameMotion},
          {"measured", measured}};
}

std::string latex_rows(const SceneTable& table, const std::vector<std::string>& keys) {
  std::string out;
  for (const std::string& key : keys) {
    const PaperQuantity& quantity = paper_quantity(key);
    out += latex_row(quantity, lines_of(table, quantity));
  }
  return out;
}

std::string latex_motions(const SceneTable& table) {
  if (table.rest.empty()) return "";
  std::string out;
  for (std::size_t scene = 0; scene < table.plan.scenes.size(); ++scene) {
    out += "\n\\begin{tabular}{l|rrrrr}\n" + latex_escaped(table.plan.scenes[scene].column);
    for (const std::string& each : motion_heads) out += " & " + latex_escaped(each);
    out += " \\\\ \\hline\n";
    for (const SolverLine& line : solver_lines(table)) {
      out += latex_escaped(line.solver.heading);
      for (const std::string& cell : motion_cells(table, line, scene)) out += " & " + cell;
      out += " \\\\\n";
    }
    out += "\\end{tabular}\n";
  }
  return out;
}

}  // namespace

std::string scene_json(const SceneTable& table) {
  Json rows = Json::array();
  for (const SolverLine& line : solver_lines(table))
    for (std::size_t scene = 0; scene < line.columns.size(); ++scene)
      rows.push_back(row_of(table, line, scene));
  return Json{{"title", table.published.title},
              {"source", table.source},
              {"rows", rows},
              {"ratio", ratio_of(table)},
              {"distance", distance_of(table)}}
             .dump(1) +
         "\n";
}

std::string scene_csv(const SceneTable& table) {
  std::string out = csv_head;
  for (const SolverLine& line : solver_lines(table))
    for (std::size_t scene = 0; scene < line.columns.size(); ++scene) {
      const Json row = row_of(table, line, scene);
      out += csv_lines(row, "column");
      for (const auto& [key, unit] : {std::pair("survived", "s"), {"off", ""}, {"parted", "s"}})
        if (!row.at(key).is_null()) out += csv_line(row, "motion", key, unit, row.at(key), {});
    }
  for (std::size_t i = 0; i < table.solvers.size(); ++i) {
    const Json object = hoist_object(table, i);
    out += csv_line(object, "ratio", time_ratio_key, "",
                    json_of(time_ratio(table, table.solvers[i])), json_of(told_time_ratio(table)));
    out += csv_line(object, "ratio", "time_ratio_of_cells", "", {},
                    json_of(printed_time_ratio(table.published)));
    out += csv_line(object, "distance", "end_distance", "",
                    json_of(end_distance(table, table.solvers[i])), {});
  }
  return out;
}

std::string scene_latex(const SceneTable& table) {
  std::string out = fmt::format(
      "% {}\n% * differs from the published value by more than a factor of 2\n"
      "\\begin{{tabular}}{{ll|{}}}\n & ",
      table.published.title, std::string(table.plan.scenes.size(), 'r'));
  for (const ScenePlace& place : table.plan.scenes) out += " & " + latex_escaped(place.column);
  out += " \\\\ \\hline\n" + latex_rows(table, table.plan.rows) + "\\hline\n" +
         latex_rows(table, table.plan.own_rows) + "\\end{tabular}\n\n";
  out += fmt::format(
      "\\begin{{tabular}}{{l|rr}}\n & time of hoist over hoist:10ms & distance of their ends "
      "(\\%) \\\\ \\hline\npublished & {} (by its cells {}) & at most {:g} \\\\\n",
      shown(told_time_ratio(table)), shown(printed_time_ratio(table.published)), 100 * kSameMotion);
  for (std::size_t i = 0; i < table.solvers.size(); ++i)
    out += fmt::format("{} & {} & {} \\\\\n", table.plan.solvers[i].heading,
                       shown(time_ratio(table, table.solvers[i])),
                       shown(end_distance(table, table.solvers[i]), "{:.3g}", 100));
  return out + "\\end{tabular}\n" + latex_motions(table);
}

}  // namespace lcp
