#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "harness/measure/runner.h"
#include "harness/runs/run_directory.h"
#include "harness/studies/frontier/frontier_grid.h"
#include "harness/studies/frontier/share_line.h"

namespace lcp {

/// Where each solver stops solving, in the plane of two knobs of a family: in every column x the
/// line of y at which half of the draws are solved (share_line.h).
struct FrontierPlan {
  FrontierGrid grid;
  RunPlan limits;  ///< Solvers, tolerance, limits and jobs; the rest is filled by run_frontier.
  std::uint64_t seed = 1;
  Index count = 8;       ///< Draws of a cell, and how many are added at a time.
  Index max_count = 64;  ///< Draws of a cell at most.
  double band =
      0.5;  ///< Widest band asked for on a geometric y, in decades; elsewhere, and where it
            ///< is longer, a step of the grid.
  double width() const { return grid.y.geometric ? band : 0; }  ///< In positions.
};

/// Draws of one cell by one solver.
struct FrontierCell {
  Index drawn = 0;
  Index counted = 0;  ///< Of them: neither trivial (z = 0 solves them) nor unsupported nor not-run.
  Index solved = 0;   ///< Of the counted, by the judge.
  std::map<Verdict, Index> verdicts;   ///< Of the counted, unsupported and not-run.
  std::optional<std::int64_t> pivots;  ///< Median (observed_quantile) over the solved.
};

struct FrontierColumn {
  std::vector<FrontierCell> cells;  ///< By y.
  ShareLine line;
  bool settled = true;  ///< Else max_count draws did not make the band as narrow as asked.
};

struct FrontierRow {
  std::string solver;                   ///< Full spelling.
  std::vector<FrontierColumn> columns;  ///< By x.
};

/// What was found.
struct Frontier {
  FrontierPlan plan;
  std::vector<FrontierRow> rows;
};

/// Draws and solves until every line is settled or its cells have max_count draws; rows go to a run
/// directory (run_directory.h), where Existing::resume finds those it has. A round draws what is
/// wanted, cell by cell, and the next adds `count` draws to the cells whose draws would help
/// (more_wanted): only to the solvers that want them. What is drawn follows from the outcomes
/// alone, so that an interrupted run comes to the same end. Empty when interrupted.
///
/// Throws std::invalid_argument on knobs that the family refuses, before anything is written; and
/// as run_into does.
std::optional<Frontier> run_frontier(const std::filesystem::path& directory,
                                     const FrontierPlan& plan, Existing existing,
                                     const std::function<void(const std::string&)>& note,
                                     const std::function<void(const Progress&)>& progress,
                                     const std::atomic<bool>& interrupted);

/// The column as share_line.h takes it.
std::vector<SharePoint> share_points(const KnobAxis& y, const FrontierColumn& column);

/// How two frontiers of the same plan but another seed compare, for one solver.
struct SeedAgreement {
  std::vector<bool> column_agrees;  ///< By x: see agree().
  Index agree = 0;                  ///< Columns that do.
  Index lines = 0;                  ///< Columns with a line in both.
  Index within = 0;  ///< Of `lines`, those where the second lies in the first's own band.
};

/// By solver.
std::vector<SeedAgreement> seed_agreements(const Frontier& first, const Frontier& second);

}  // namespace lcp
