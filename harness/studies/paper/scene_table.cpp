#include "harness/studies/paper/scene_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "problems/scenes/scene.h"

namespace lcp {

namespace {

// Columns of the hoist that are compared with one another.
constexpr const char* fine = "hoist";
constexpr const char* coarse = "hoist:10ms";

LoopQuestion question(const ScenePlan& plan, const ScenePlace& place, const PaperColumn& solver,
                      std::optional<double> limit) {
  return {make_scene(place.scene).spelling, solver.solver, solver.acceptance, plan.duration, limit};
}

/// The simulations of each solver, as plan.scenes.
std::vector<std::vector<LoopQuestion>> questions_of(const ScenePlan& plan,
                                                    const std::vector<PaperColumn>& solvers,
                                                    std::optional<double> limit) {
  std::vector<std::vector<LoopQuestion>> all;
  for (const PaperColumn& solver : solvers) {
    all.emplace_back();
    for (const ScenePlace& place : plan.scenes)
      all.back().push_back(question(plan, place, solver, limit));
  }
  return all;
}

/// All of the plan, those first whose times are read.
std::vector<LoopQuestion> all_questions(const ScenePlan& plan) {
  std::vector<LoopQuestion> all;
  for (const auto& solver : questions_of(plan, plan.solvers, {}))
    all.insert(all.end(), solver.begin(), solver.end());
  for (const auto& solver : questions_of(plan, plan.rest, plan.limit))
    all.insert(all.end(), solver.begin(), solver.end());
  return all;
}

std::vector<LoopQuestion> open_questions(const PaperDirectory& directory, const ScenePlan& plan) {
  std::vector<LoopQuestion> open = all_questions(plan);
  std::erase_if(open, [&](const LoopQuestion& each) {
    return read_loop_column(directory, each).has_value();
  });
  return open;
}

std::vector<std::vector<LoopColumn>> read_all(
    const PaperDirectory& directory, const std::vector<std::vector<LoopQuestion>>& questions) {
  std::vector<std::vector<LoopColumn>> all;
  for (const auto& solver : questions) {
    all.emplace_back();
    for (const LoopQuestion& each : solver)
      all.back().push_back(read_loop_column(directory, each).value());
  }
  return all;
}

double total_time(const LoopSummary& summary) {
  return summary.simulation_ms * static_cast<double>(summary.total_frames);
}

/// The place of a published column; throws std::out_of_range where the plan leaves it out.
std::size_t place_of(const ScenePlan& plan, const std::string& column) {
  for (std::size_t i = 0; i < plan.scenes.size(); ++i)
    if (plan.scenes[i].column == column) return i;
  throw std::out_of_range(fmt::format("no column '{}' in the plan", column));
}

/// Both simulations of the hoist, the fine one first, where both came to their end.
std::optional<std::pair<const LoopSummary*, const LoopSummary*>> both_hoists(
    const SceneTable& table, const std::vector<LoopColumn>& columns) {
  const LoopSummary& a = columns.at(place_of(table.plan, fine)).summary;
  const LoopSummary& b = columns.at(place_of(table.plan, coarse)).summary;
  if (!a.broken.empty() || !b.broken.empty()) return std::nullopt;
  return std::pair(&a, &b);
}

}  // namespace

ScenePlan scene_plan(bool all_solvers) {
  ScenePlan plan;
  plan.scenes = {{fine, "hoist"}, {coarse, "hoist:dt=0.01"}, {"ring", "ring"}, {"net", "net"}};
  plan.solvers = {proposed_column(), own_column()};
  plan.reference = 1;
  plan.rows = {"duration",    "contacts",          "active", "total_frames", "failure",
               "lcp_time_ms", "simulation_time_ms"};
  plan.own_rows = {"no_solution",   "cycle", "error",           "frictionless_failures",
                   "both_failures", "nodes", "residual_median", "depth_max",
                   "energy_excess", "work",  "gap_end"};
  if (all_solvers) plan.rest = rest_of_registry(plan.solvers);
  return plan;
}

std::optional<SceneTable> simulate_scenes(const ScenePlan& plan, const Reproduction& how,
                                          const std::atomic<bool>& interrupted) {
  const PaperDirectory directory(how.directory, how.jobs, how.note);
  compute_loop_columns(directory, open_questions(directory, plan), how.jobs, how.progress,
                       interrupted);
  if (interrupted) return std::nullopt;
  SceneTable table;
  table.plan = plan;
  table.published = published().table(3);
  table.source = published().source;
  table.solvers = read_all(directory, questions_of(plan, plan.solvers, {}));
  table.rest = read_all(directory, questions_of(plan, plan.rest, plan.limit));
  for (const ScenePlace& place : plan.scenes)
    table.lengths.push_back(make_scene(place.scene).setup.length);
  return table;
}

std::vector<std::string> missing_work(const ScenePlan& plan, const Reproduction& how) {
  const bool begun = std::filesystem::exists(how.directory);
  const std::vector<LoopQuestion> open =
      begun ? open_questions(PaperDirectory(how.directory, how.jobs, how.note), plan)
            : all_questions(plan);
  std::vector<std::string> work;
  for (const LoopQuestion& each : open)
    work.push_back(fmt::format("simulation of {} with {}", each.scene, each.solver));
  return work;
}

std::vector<PaperLine> lines_of(const SceneTable& table, const PaperQuantity& quantity) {
  std::vector<PaperLine> lines = {{PaperLine::Kind::published, "published", "", {}, {}}};
  std::vector<std::optional<double>> printed;
  for (const ScenePlace& place : table.plan.scenes) {
    printed.push_back(table.published.value(quantity.key, place.column));
    lines.front().cells.push_back({printed.back()});
  }
  for (std::size_t s = 0; s < table.solvers.size(); ++s) {
    const PaperColumn& solver = table.plan.solvers[s];
    lines.push_back({PaperLine::Kind::in_loop, solver.heading, "", solver.acceptance, {}});
    for (std::size_t i = 0; i < table.solvers[s].size(); ++i) {
      const std::optional<double> value = quantity.in_loop(table.solvers[s][i]);
      lines.back().cells.push_back({value, value && printed[i] && far_from(*value, *printed[i])});
    }
  }
  std::erase_if(lines, [](const PaperLine& line) {
    return std::none_of(line.cells.begin(), line.cells.end(),
                        [](const PaperCell& cell) { return cell.value.has_value(); });
  });
  return lines;
}

std::optional<double> printed_time_ratio(const PublishedTable& published) {
  const auto total = [&](const char* column) -> std::optional<double> {
    const auto time = published.value("simulation_time_ms", column);
    const auto frames = published.value("total_frames", column);
    if (!time || !frames) return std::nullopt;
    return *time * *frames;
  };
  const std::optional<double> a = total(fine), b = total(coarse);
  if (!a || !b) return std::nullopt;
  return *a / *b;
}

std::optional<double> time_ratio(const SceneTable& table, const std::vector<LoopColumn>& columns) {
  const auto hoists = both_hoists(table, columns);
  if (!hoists || total_time(*hoists->second) == 0) return std::nullopt;
  return total_time(*hoists->first) / total_time(*hoists->second);
}

std::optional<double> end_distance(const SceneTable& table,
                                   const std::vector<LoopColumn>& columns) {
  const auto hoists = both_hoists(table, columns);
  if (!hoists) return std::nullopt;
  const double distance = mean_link_distance(*hoists->first, *hoists->second, 1);
  if (std::isnan(distance)) return std::nullopt;
  return distance / table.lengths.at(place_of(table.plan, fine));
}

Motion motion_of(const LoopSummary& motion, const LoopSummary& reference, double length) {
  Motion found{static_cast<double>(motion.steps) * motion.dt, {}, {}};
  for (Index part = 0; part <= trail_parts; ++part) {
    const double share = static_cast<double>(part) / static_cast<double>(trail_parts);
    const double distance = mean_link_distance(motion, reference, share) / length;
    if (std::isnan(distance)) break;
    found.distance = distance;
    if (!found.parted && distance > kSameMotion) found.parted = share * motion.duration;
  }
  return found;
}

std::string render(const SceneTable& table, TableFormat format) {
  switch (format) {
    case TableFormat::text:
      return scene_text(table);
    case TableFormat::csv:
      return scene_csv(table);
    case TableFormat::json:
      return scene_json(table);
    case TableFormat::latex:
      break;
  }
  return scene_latex(table);
}

}  // namespace lcp
