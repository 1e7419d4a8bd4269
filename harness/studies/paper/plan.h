#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/judge/acceptance.h"

namespace lcp {

/// A column of a table: a solver, and by what its answers are judged while it drives a simulation.
struct PaperColumn {
  std::string name;     ///< The published column's, else the solver's.
  std::string heading;  ///< For a reader.
  std::string solver;   ///< Full spelling; empty where the sweep finds it.
  Acceptance acceptance = by_paper;
  /// Of each simulation, s of computing. In Table III, solvers with one are in the second table alone.
  std::optional<double> limit = {};
};

/// A scene under the name that a table gives it.
struct PaperScene {
  std::string name;   ///< Of a column of Table III; of lines of Tables I and II.
  std::string scene;  ///< Spelling.
};

/// What is computed to set one of the paper's tables beside its printed form: every solver in the loop
/// of every scene, and on the corpus of the first.
struct PaperPlan {
  int table = 0;
  std::vector<PaperScene> scenes;
  std::vector<PaperColumn> solvers;
  /// Thresholds delta of `lexicographic` from which the best in the loop of the first scene is taken;
  /// the column without a solver gets it.
  std::vector<std::string> deltas;
  std::vector<std::string> rows, own_rows;  ///< Keys of quantities: the paper's, and ours below.
  std::string driver;  ///< Solver that drives the scene of the corpus; empty: no corpus.
  int samples = 1;     ///< Timed repetitions on the corpus.
  int jobs = 1;        ///< Unless the user says otherwise.
  std::optional<double> duration;  ///< Of every simulation, s. Default: the scene's.

  /// Whether the table's columns are scenes and each solver is a line of a row, as in Table III.
  bool by_scene() const { return table == 3; }
};

/// In Table III, the solver whose motion all others' are compared with: place in PaperPlan::solvers.
inline constexpr std::size_t reference_solver = 1;

/// By which rows on the corpus are judged once more.
inline constexpr Acceptance second_look{Acceptance::Criterion::residual, 1e-6};

/// The plan of Table `table`: 1, 2 or 3, whose columns are `hoist` at 1 and 10 ms, `ring` and `net`.
/// With `all_solvers` also the rest of the own rows, in Table III with `limit`. Throws
/// std::invalid_argument on a table that is not published.
PaperPlan paper_plan(int table, bool all_solvers, double limit = 600);

/// The paper's solver at its constants.
extern const char* const proposed_solver;

/// The column of a delta of the sweep.
PaperColumn column_of_delta(const std::string& delta);

}  // namespace lcp
