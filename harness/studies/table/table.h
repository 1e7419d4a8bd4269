#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "harness/judge/acceptance.h"
#include "harness/record.h"

namespace lcp {

struct ColumnHead;

/// What one solver did on one corpus, in the shape of a column of the paper's Table I.
///
/// success + failure + unsupported + not_run + trivial = instances, and
/// no_solution + cycle + error = failure. Means of work are over `success` and those failures that
/// returned an answer (a killed worker takes its counts with it); times and residuals are over
/// `success` alone.
struct TableRow {
  std::string corpus;
  std::string solver;  ///< Full spelling.
  std::string start;   ///< What it started from.
  /// The spelling, with every option in which settings of one row differ, and where rows of the table
  /// start differently ` [START]`.
  std::string label;
  Index instances = 0;
  std::optional<double> contacts;  ///< Mean over instances with contact; empty without any.
  std::optional<double> active;    ///< Mean over those of them where it is known.
  Index success = 0;
  Index failure = 0;
  Index no_solution = 0;  ///< ray, exhausted, infeasible, false-infeasible.
  Index cycle = 0;        ///< cycle, limit, timeout.
  Index error = 0;        ///< wrong, inaccurate, singular, crash, memory.
  Index wrong = 0;        ///< Of `error`: claimed solved or infeasible, and fails the check.
  Index unclaimed = 0;    ///< Of `failure`: z passes although the solver claims a failure.
  Index unsupported = 0;
  Index not_run = 0;
  Index trivial = 0;  ///< Solved where z = 0 is a solution too; a failure there stays a failure.
  std::map<Verdict, Index> verdicts;  ///< Of all instances, trivial ones included.
  std::optional<double> pivots;       ///< Mean.
  std::optional<double> nodes;        ///< Mean.
  std::optional<double> sweeps;       ///< Mean.
  std::optional<double> time_median_ms;
  std::optional<double> residual_median;
  std::optional<double> residual_max;
  /// Against the same solver's cold solves of the same instances in the same table; empty in rows that
  /// are cold themselves, and where there are none. Unsupported and not-run instances do not count.
  std::optional<double> gained;      ///< Instances solved that it does not solve cold.
  std::optional<double> lost;        ///< Instances that it solves cold alone.
  std::optional<double> time_ratio;  ///< Median of time over time cold, where both are solved.
  Index restarted = 0;  ///< Instances where a start was replaced by a cold one (Work::restarts).
};

struct Table {
  /// By corpus, then by solver and its start, each in order of first appearance.
  std::vector<TableRow> rows;
  double tolerance = 0;  ///< At which `solved` was judged.
  Acceptance::Criterion criterion =
      Acceptance::Criterion::residual;  ///< By which `solved` was judged.
  std::string start;  ///< Of the rows; where they differ, all kinds, joined by ", ".
  bool several_starts = false;
  int jobs = 1;  ///< Most pairs that ran at the same time: it disturbs times.
};

/// The tolerance at which all rows were judged, 0 without rows. Throws std::invalid_argument where
/// there are several.
double common_tolerance(const std::vector<Record>& records);

/// Counts records; `tolerance` re-judges them, without it they are taken as judged. Throws
/// std::invalid_argument when records were judged at different tolerances and none is given.
Table make_table(const std::vector<Record>& records, std::optional<double> tolerance = {});

/// Counts records judged anew by a criterion. The paper's knows no trivial instances: they count as
/// success or failure like all others, and a failed claim is never `unclaimed`.
Table make_table(const std::vector<Record>& records, const Acceptance& acceptance);

enum class TableFormat { text, csv, json, latex };

/// `text`: a block per corpus for a terminal; `csv`: a line per row; `json`: {"rows": [...]}, an
/// object per row, null where nothing was measured; `latex`: a tabular per corpus with a column per
/// solver, for plain LaTeX.
std::string render(const Table& table, TableFormat format);

/// The quantities of a solver in their order, as `text` explains them below its blocks; those that say
/// something only where rows start differently are left out where they do not.
std::vector<ColumnHead> table_columns(bool several_starts);

/// What a reader calls each solver among `records`, by full spelling: the spelling, with the options
/// in which several settings of one registry row differ written out where they have their default,
/// all in alphabetical order.
std::map<std::string, std::string> labels(const std::vector<Record>& records);

/// Writes table.txt, table.csv and table.json from the rows of a run directory, and returns the
/// table. Throws UnreadableInput and UnwritableOutput.
Table write_tables(const std::filesystem::path& directory);

}  // namespace lcp
