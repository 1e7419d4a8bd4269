#pragma once

#include <atomic>
#include <filesystem>
#include <functional>

#include "harness/measure/runner.h"
#include "harness/runs/settings.h"

namespace lcp {

/// A run directory holds
///
///     run.json     what was asked for (RunSettings)
///     env.json     on what it ran; env-ID.json where a later session or another shard ran on
///                  something else. A row names its environment by id.
///     rows.jsonl   a line per finished pair
///
/// and the tables, sheet and pictures derived from these. Every file but rows.jsonl appears in one piece, and
/// rows.jsonl grows by whole lines: whatever ends the program, the rows in it are right.

/// How run_into treats a directory that exists.
enum class Existing {
  refuse,
  resume,  ///< Runs the pairs that have no row in it yet; begins it where there is none.
};

/// Several instances that are run in the place of one of a plan, as disturbed versions of it.
struct Expansion {
  std::function<Index(const Instance&)> count;                 ///< How many; cheap.
  std::function<std::vector<Instance>(const Instance&)> make;  ///< The instances, so many.
};

struct RunReport {
  std::size_t rows_before = 0;  ///< Rows that were there before.
  std::size_t rows = 0;         ///< Rows written now.
};

/// Runs `plan` into a directory. `plan.environment` and `plan.done` are filled. What a user should
/// know but need not act on (the run goes on in another environment, from a changed tree) goes to
/// `note`, a line each.
///
/// Throws std::invalid_argument when the directory exists and is not to be resumed, or was begun by
/// another commit, as another shard or with other settings; UnreadableInput when its files are
/// damaged; UnwritableOutput where it cannot be written; and as run() does. Rows finished before an
/// interruption or an error stay.
RunReport run_into(const std::filesystem::path& directory, RunPlan plan, const Origin& origin,
                   Existing existing, const std::function<void(const std::string&)>& note,
                   const std::function<void(const Progress&)>& progress,
                   const std::atomic<bool>& interrupted);

/// The same, with each instance of the plan expanded when its turn comes, so that only what is made of
/// one of them is in memory at a time. What comes of one instance stays in its shard; rows are
/// numbered (Record::place) through all that is made.
RunReport run_into(const std::filesystem::path& directory, RunPlan plan, const Expansion& expansion,
                   const Origin& origin, Existing existing,
                   const std::function<void(const std::string&)>& note,
                   const std::function<void(const Progress&)>& progress,
                   const std::atomic<bool>& interrupted);

/// A run directory made ready for rows.
struct OpenRun {
  RunSettings settings;     ///< For its run.json: solvers of earlier sessions come first.
  std::string environment;  ///< For its rows: id of this session's.
  bool begun = false;       ///< A session was there before.
};

/// Makes `directory` ready, for what draws its instances as it goes; run_into does the same for a
/// plan. It has its environment's file then, but run.json only if it had one (see
/// write_run_settings). Throws as run_into does.
OpenRun open_run(const std::filesystem::path& directory, RunSettings settings, int jobs,
                 Existing existing, const std::function<void(const std::string&)>& note);

/// Writes run.json. Throws UnwritableOutput.
void write_run_settings(const std::filesystem::path& directory, const RunSettings& settings);

/// Appends rows to a run directory. It and the function returned throw UnwritableOutput.
std::function<void(const Record&)> open_rows(const std::filesystem::path& directory);

/// The pairs that have a row in a run directory; none where there is no such directory or no row.
/// Throws UnreadableInput where rows are malformed.
std::set<PairKey> pairs_done(const std::filesystem::path& directory);

/// Descriptions of what a run ran on: env.json, then env-*.json by name. Throws UnreadableInput,
/// naming the file, where one is malformed or env.json is missing.
std::vector<nlohmann::json> read_environments(const std::filesystem::path& directory);

/// A run directory's description of its rows.
struct RunHeader {
  RunSettings settings;
  std::vector<nlohmann::json> environments;  ///< env.json, then env-*.json by name.
};

/// Throws UnreadableInput, naming the file, where one is missing or malformed.
RunHeader read_run_header(const std::filesystem::path& directory);

/// All that a run directory holds.
struct StoredRun {
  std::filesystem::path directory;
  RunSettings settings;
  std::vector<nlohmann::json> environments;  ///< As in RunHeader.
  std::vector<Record> rows;                  ///< By place, then by solver in the run's order.
};

/// Throws UnreadableInput, naming the file, where one is missing or malformed.
StoredRun read_stored_run(const std::filesystem::path& directory);

/// Writes a directory anew, in one piece. Throws std::invalid_argument if it exists,
/// UnwritableOutput where it cannot be written.
void write_stored_run(const StoredRun& run);

/// Rows of a run directory in the order of read_stored_run; in file order where there is no
/// run.json. Throws UnreadableInput where they are missing or malformed.
std::vector<Record> read_run(const std::filesystem::path& directory);

}  // namespace lcp
