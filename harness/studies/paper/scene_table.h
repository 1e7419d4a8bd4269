#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/studies/paper/paper_table.h"
#include "harness/studies/paper/reproduce.h"

namespace lcp {

/// A column of Table III: the paper's name for it, and our scene.
struct ScenePlace {
  std::string column;
  std::string scene;  ///< Spelling.
};

/// What is simulated to set Table III beside its printed form.
struct ScenePlan {
  std::vector<ScenePlace> scenes;
  std::vector<PaperColumn> solvers;  ///< Each a line of every row,
  std::size_t reference = 0;         ///< and the one whose motion all others' are compared with.
  std::vector<PaperColumn> rest;     ///< Solvers of the second table.
  std::vector<std::string> rows, own_rows;  ///< Keys of quantities: the paper's, and ours below.
  double limit = 600;                       ///< Of a simulation of `rest`, s of computing.
  int jobs = 1;                             ///< Unless the user says otherwise: times are in it.
  std::optional<double> duration;           ///< Of every simulation, s. Default: the scene's.
};

/// `hoist` at 1 and 10 ms, `ring` and `net` by the paper's solver and by ours; with `all_solvers`,
/// also by the rest of the own rows.
ScenePlan scene_plan(bool all_solvers);

/// Table III of the paper beside what this program measured.
struct SceneTable {
  ScenePlan plan;
  PublishedTable published;
  std::string source;  ///< Of what is published.
  /// As plan.solvers and plan.rest, each as plan.scenes.
  std::vector<std::vector<LoopColumn>> solvers, rest;
  std::vector<double> lengths;  ///< SceneSetup::length of each scene, m.
};

/// Simulates what the directory does not hold yet and sets the table together. Empty when
/// `interrupted`; what was finished stays. Throws as PaperDirectory and compute_loop_columns do.
std::optional<SceneTable> simulate_scenes(const ScenePlan& plan, const Reproduction& how,
                                          const std::atomic<bool>& interrupted);

/// What simulate_scenes would compute, a line each. The directory is not made.
std::vector<std::string> missing_work(const ScenePlan& plan, const Reproduction& how);

/// The lines of a row: published, then one per solver. Lines without any value are left out.
std::vector<PaperLine> lines_of(const SceneTable& table, const PaperQuantity& quantity);

/// Total computation time (simulation time x frames with contact) of the hoist at 1 ms over that at
/// 10 ms, by the printed cells and by a solver's columns; empty where either ended early.
std::optional<double> printed_time_ratio(const PublishedTable& published);
std::optional<double> time_ratio(const SceneTable& table, const std::vector<LoopColumn>& columns);

/// The distance of two motions, over the length of what moves, up to which they count as the same.
inline constexpr double kSameMotion = 0.05;

/// Distance of the end of the hoist at 10 ms from that at 1 ms, over the length of the chain; empty
/// where either ended early.
std::optional<double> end_distance(const SceneTable& table, const std::vector<LoopColumn>& columns);

/// How far a simulation came, and how far from the reference's motion.
struct Motion {
  double survived = 0;             ///< s.
  std::optional<double> distance;  ///< Over the length, at the last twentieth that both reached.
  std::optional<double> parted;    ///< s; first twentieth at which it exceeds kSameMotion.
};

Motion motion_of(const LoopSummary& motion, const LoopSummary& reference, double length);

/// `text`, `csv`, `json` or `latex`, as the paper's other tables.
std::string render(const SceneTable& table, TableFormat format);

/// The parts of render.
std::string scene_text(const SceneTable& table);
std::string scene_json(const SceneTable& table);
std::string scene_csv(const SceneTable& table);
std::string scene_latex(const SceneTable& table);

}  // namespace lcp
