#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/judge/acceptance.h"

namespace lcp {

/// A column of a table: a solver, and by what its answers are judged while it drives a simulation.
struct PaperColumn {
  std::string name;     ///< The published column's, else the solver's.
  std::string heading;  ///< For a terminal; broken after spaces and hyphens where it is long.
  std::string solver;   ///< Full spelling; empty where the sweep finds it.
  Acceptance acceptance = by_paper;
};

/// What is computed to set one of the paper's tables beside its printed form.
struct PaperPlan {
  int table = 0;
  std::string scene;                  ///< Full spelling.
  std::optional<std::string> beside;  ///< The same scene in another form, in the loop only.
  std::string beside_label;           ///< What its lines are called.
  std::vector<PaperColumn> columns;
  /// Thresholds delta of `lexicographic` from which the best in the loop is taken; the column
  /// without a solver gets it.
  std::vector<std::string> deltas;
  std::vector<std::string> rows, own_rows;  ///< Keys of quantities: the paper's, and ours below.
  Acceptance second_look;                   ///< By which rows on the corpus are judged once more.
  std::string driver;                       ///< Solver that drives the scene of the corpus.
  int samples = 1;                          ///< Timed repetitions on the corpus.
  int jobs = 1;                             ///< Unless the user says otherwise.
  std::optional<double> duration;           ///< Of every simulation, s. Default: the scene's.
};

/// The plan of Table `table`, 1 or 2; with `all_solvers`, the rest of the own rows as columns.
PaperPlan paper_plan(int table, bool all_solvers);

/// The paper's solver at its constants, judged as there.
PaperColumn proposed_column();

/// Ours: `best-first` with its defaults, judged by the residual.
PaperColumn own_column();

/// A column for every row of the registry that is not among `there`: rows that work in the paper's
/// units (scale = off) judged by its criterion, others by the residual.
std::vector<PaperColumn> rest_of_registry(const std::vector<PaperColumn>& there);

/// The solver of a delta of the sweep, and the column it makes.
PaperColumn column_of_delta(const std::string& delta);

}  // namespace lcp
