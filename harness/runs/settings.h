#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "harness/measure/runner.h"

namespace lcp {

/// Where the instances of a run come from.
struct Origin {
  std::string suite;                 ///< Empty when corpora are named.
  std::vector<std::string> corpora;  ///< As on the command line.
  Index every = 1;                   ///< Every so many of each corpus are kept.
  Index limit = 0;                   ///< At most so many of each corpus are kept; 0: all.

  bool operator==(const Origin&) const = default;
};

/// The question of a run: run.json of its directory. Nothing in it is measured but `seconds`.
struct RunSettings {
  static constexpr int schema = 1;

  Origin origin;
  Index instances = 0;  ///< Of all shards together.
  Shard shard;
  std::string start = "cold";  ///< All of them, joined by ", ".
  double tolerance = 0;
  double timeout_s = 0;
  std::int64_t memory_bytes = 0;
  Index max_contacts = 0;
  std::vector<std::string> solvers;  ///< Full spellings in their order.
  /// Wall clock of the run; empty unless one session did it from beginning to end.
  std::optional<double> seconds;
};

RunSettings settings_of(const RunPlan& plan, const Origin& origin);

/// In what two sets of settings differ so that their rows do not belong into one table, a line each:
/// `tolerance 1e-06, 1e-09`. Solvers, shard, number of instances and seconds may differ.
std::vector<std::string> conflicts(const RunSettings& a, const RunSettings& b);

/// Appends those of `more` that are not there yet.
void append_missing(std::vector<std::string>& all, const std::vector<std::string>& more);

/// Sorts rows by place, then by solver in the order of `solvers`, then by start in the order of
/// all_start_kinds: the order in which one uninterrupted session with one job writes them.
void sort_rows(std::vector<Record>& rows, const std::vector<std::string>& solvers);

/// `2/4`: the second of four.
std::string to_string(const Shard& shard);
/// Throws std::invalid_argument unless `text` is I/N with 1 <= I <= N.
Shard parse_shard(const std::string& text);

void to_json(nlohmann::json& json, const RunSettings& settings);
/// Throws std::invalid_argument saying which field is missing or malformed.
void from_json(const nlohmann::json& json, RunSettings& settings);

}  // namespace lcp
