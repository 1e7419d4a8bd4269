#include "harness/studies/paper/scene_cells.h"

#include <fmt/format.h>

namespace lcp {

std::string shown(const std::optional<double>& value, const char* format, double scale) {
  return value ? fmt::format(fmt::runtime(format), scale * *value) : "-";
}

bool holds(const std::optional<double>& distance) { return distance && *distance <= kSameMotion; }

std::optional<double> told_time_ratio(const SceneTable& table) {
  return table.published.value(time_ratio_key, "hoist");
}

std::vector<SolverLine> solver_lines(const SceneTable& table) {
  std::vector<SolverLine> lines;
  for (std::size_t i = 0; i < table.solvers.size(); ++i)
    lines.push_back({table.plan.solvers[i], table.solvers[i], true});
  for (std::size_t i = 0; i < table.rest.size(); ++i)
    lines.push_back({table.plan.rest[i], table.rest[i], false});
  return lines;
}

Motion motion_in(const SceneTable& table, const SolverLine& line, std::size_t scene) {
  return motion_of(line.columns[scene].summary, table.solvers[table.plan.reference][scene].summary,
                   table.lengths[scene]);
}

Words motion_cells(const SceneTable& table, const SolverLine& line, std::size_t scene) {
  const LoopSummary& summary = line.columns[scene].summary;
  if (summary.total_frames > 0 && summary.unsupported == summary.total_frames)
    return {"unsupported", "-", "-", "-", "-"};
  const Motion motion = motion_in(table, line, scene);
  const bool reference = &line.columns == &table.solvers[table.plan.reference];
  return {fmt::format("{:.4g}{}", motion.survived, summary.stopped ? "+" : ""),
          fmt::format("{}", summary.total_frames), fmt::format("{}", summary.failure),
          reference ? "-" : shown(motion.distance, "{:.2g}", 100),
          reference ? "-" : shown(motion.parted, "{:.3g}")};
}

const Words motion_heads = {"survived (s)", "contact", "failed", "off (%)", "parted (s)"};

}  // namespace lcp
