#pragma once

#include <atomic>
#include <filesystem>
#include <functional>

#include "harness/measure/runner.h"
#include "harness/tables/table.h"

namespace lcp {

/// Runs `plan` into a new directory: env.json first, then rows.jsonl, a line per finished pair.
/// Returns the number of rows. Throws std::invalid_argument if `directory` exists, UnwritableOutput
/// where it cannot be written, and as run() does; rows finished before an interruption or an error
/// stay. `plan.environment` is filled.
std::size_t run_into(const std::filesystem::path& directory, RunPlan plan,
                     const std::function<void(const Progress&)>& progress,
                     const std::atomic<bool>& interrupted);

/// Rows of a run directory. Throws UnreadableInput where they are missing or malformed.
std::vector<Record> read_run(const std::filesystem::path& directory);

/// Writes table.txt, table.csv and table.json from the rows of a run directory, and returns the
/// table. Throws UnreadableInput and UnwritableOutput.
Table write_tables(const std::filesystem::path& directory);

/// Draws the chart of time against accuracy (chart.svg, .gp, .dat) from the rows of a run directory,
/// unless nothing counts in them. Throws as write_tables and draw_chart do.
void write_chart(const std::filesystem::path& directory);

}  // namespace lcp
