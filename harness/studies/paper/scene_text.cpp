#include <fmt/format.h>

#include <algorithm>

#include "harness/studies/paper/scene_cells.h"

namespace lcp {

namespace {

std::string motions_text(const SceneTable& table) {
  if (table.rest.empty()) return "";
  std::string out;
  for (std::size_t scene = 0; scene < table.plan.scenes.size(); ++scene) {
    out += fmt::format("{:<36}", table.plan.scenes[scene].column);
    for (const std::string& each : motion_heads) out += fmt::format(" {:>12}", each);
    out += '\n';
    for (const SolverLine& line : solver_lines(table)) {
      out += fmt::format("  {:<34}", line.solver.heading);
      for (const std::string& cell : motion_cells(table, line, scene))
        out += fmt::format(" {:>12}", cell);
      out += '\n';
    }
    out += '\n';
  }
  return out +
         fmt::format(
             "  survived  simulated until the bodies flew apart, or all of it; +: stopped after\n"
             "            {:g} s of computing\n"
             "  contact   frames with contact\n"
             "  failed    of their frictional LCPs\n"
             "  off       mean distance of the links from where {} has them, at the end or at the\n"
             "            last twentieth that both reached, in % of the length of what moves\n"
             "  parted    first twentieth of the duration at which that exceeds {:g} %\n\n",
             table.plan.limit, table.plan.solvers[table.plan.reference].heading, 100 * kSameMotion);
}

std::string hoists_text(const SceneTable& table) {
  std::string out = fmt::format(
      "Total computation time (simulation time x frames) of hoist over that of hoist:10ms\n"
      "  {:<22}{:>6}, by its cells {}\n",
      "published", shown(told_time_ratio(table)), shown(printed_time_ratio(table.published)));
  for (std::size_t i = 0; i < table.solvers.size(); ++i)
    out += fmt::format("  {:<22}{:>6}\n", table.plan.solvers[i].heading,
                       shown(time_ratio(table, table.solvers[i])));
  out += fmt::format(
      "Mean distance of the links of hoist:10ms from those of hoist at the end, in % of the "
      "length;\nexpected at most {:g} %\n",
      100 * kSameMotion);
  for (std::size_t i = 0; i < table.solvers.size(); ++i) {
    const std::optional<double> distance = end_distance(table, table.solvers[i]);
    out += fmt::format("  {:<22}{:>6}  {}{}\n", table.plan.solvers[i].heading,
                       shown(distance, "{:.3g}", 100), holds(distance) ? "holds" : "FAILED",
                       distance ? "" : " (one of the two has no end)");
  }
  return out + '\n';
}

/// Simulations that ended early; of the second table, which says when, those without a frame.
std::string broken_text(const SceneTable& table) {
  std::string out;
  for (const SolverLine& line : solver_lines(table))
    for (std::size_t scene = 0; scene < line.columns.size(); ++scene) {
      const LoopSummary& summary = line.columns[scene].summary;
      if (summary.broken.empty() || (!line.measured && summary.steps > 0)) continue;
      out += fmt::format("{} in {} ended early: {}\n", line.solver.heading,
                         table.plan.scenes[scene].column, summary.broken);
    }
  return out;
}

std::string legend(const SceneTable& table) {
  std::string out = fmt::format("published: {}\n", table.source);
  for (const PaperColumn& solver : table.plan.solvers)
    out += fmt::format("{}: in the loop of each scene, judged by {}: {}\n", solver.heading,
                       solver.acceptance.criterion == Acceptance::Criterion::paper
                           ? fmt::format("the paper's criterion, {:g}", solver.acceptance.tolerance)
                           : fmt::format("residual, {:g}", solver.acceptance.tolerance),
                       solver.solver);
  for (const ScenePlace& place : table.plan.scenes)
    if (place.column != place.scene) out += fmt::format("{}: {}\n", place.column, place.scene);
  out += broken_text(table);
  for (const std::string& each : table.published.notes) out += "The paper: " + each + "\n";
  int jobs = 1;
  for (const SolverLine& line : solver_lines(table))
    for (const LoopColumn& column : line.columns) jobs = std::max(jobs, column.jobs);
  out += fmt::format("{} simulation{} ran at the same time{}.\n", jobs, jobs == 1 ? "" : "s",
                     jobs == 1 ? "" : ": times are disturbed");
  return out + "* differs from the published value by more than a factor of 2, or exceeds what the text allows.\n";
}

std::string rows_text(const SceneTable& table, const std::vector<std::string>& keys) {
  std::string out;
  for (const std::string& key : keys) {
    const PaperQuantity& quantity = paper_quantity(key);
    out += row_text(quantity, lines_of(table, quantity), 0, table.plan.scenes.size());
  }
  return out;
}

}  // namespace

std::string scene_text(const SceneTable& table) {
  Words columns;
  for (const ScenePlace& place : table.plan.scenes) columns.push_back(place.column);
  return fmt::format("Table III. {} ({})\n\n", table.published.title, table.published.section) +
         heading_lines(columns) + rows_text(table, table.plan.rows) + "ours\n" +
         rows_text(table, table.plan.own_rows) + "\n" + hoists_text(table) + motions_text(table) +
         legend(table);
}

}  // namespace lcp
