#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/studies/paper/scene_table.h"
#include "harness/studies/paper/text_lines.h"

namespace lcp {

/// A solver of Table III with its simulations.
struct SolverLine {
  const PaperColumn& solver;
  const std::vector<LoopColumn>& columns;  ///< As plan.scenes.
  bool measured;                           ///< In the first table too.
};

/// All solvers, those of the first table first.
std::vector<SolverLine> solver_lines(const SceneTable& table);

Motion motion_in(const SceneTable& table, const SolverLine& line, std::size_t scene);

/// The second table: headings, and the cells of one solver in one scene.
extern const Words motion_heads;
Words motion_cells(const SceneTable& table, const SolverLine& line, std::size_t scene);

/// Whether a distance of the hoists' ends is there and small enough.
bool holds(const std::optional<double>& distance);

/// What the paper's text says of the hoists' times, which its cells contradict.
inline constexpr const char* time_ratio_key = "time_ratio";
std::optional<double> told_time_ratio(const SceneTable& table);

/// A value for a reader, or a hyphen.
std::string shown(const std::optional<double>& value, const char* format = "{:.1f}",
                  double scale = 1);

}  // namespace lcp
