#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "harness/record.h"
#include "harness/runs/settings.h"

namespace lcp {

/// The run that a report shows.
struct ReportedRun {
  std::string name;                     ///< Of its directory.
  std::optional<RunSettings> settings;  ///< Empty where there is no run.json, as in older runs.
  std::vector<nlohmann::json> environments;
  std::vector<Record> rows;
};

/// Reads a run directory; run.json and env.json may be missing. Throws UnreadableInput, naming the
/// file, where rows are missing, malformed or zero in number, or another file is malformed.
ReportedRun read_reported_run(const std::filesystem::path& directory);

/// Notes that a reader of the numbers needs and could not guess: several jobs, a build that is not the
/// measured one, rows of several environments, pairs without a row, a line each.
std::vector<std::string> reading_notes(const ReportedRun& run);

/// Everything of a run that the page shows, so that it can filter and draw and need not judge:
///
///     name, program, settings, environments, notes
///     verdicts    {name, column} in the order of all_verdicts
///     instances   {name, corpus, n, contacts, active, sha256, command, simulated}
///     variants    {solver, label, row, start, options, arguments, look}: a solver from a start
///     strings     messages and what workers wrote at their end
///     rows        by quantity, a list with one entry per row of the run (see `columns`)
///     judgements  {kinds: [{verdict, column, unclaimed, counted}], at: per tolerance of the table a
///                 list with the place in `kinds` of what judged() says of every row}
///     table       {columns, tolerances: [{tolerance, own, columns}]}: make_table at each tolerance
///
/// A list whose entries are all equal is stored as {"all": entry}. `residual` and `zero_residual`,
/// from which the curves of accuracy are made, are exact; other residuals have four digits.
nlohmann::ordered_json report_data(const ReportedRun& run);

/// Tolerances at which the page can judge: 1e-3, 1e-4, ... 1e-12, largest first.
std::vector<double> report_tolerances();

}  // namespace lcp
