#include "harness/runs/merge.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <stdexcept>

namespace lcp {

namespace {

using nlohmann::json;

/// `cpu: "a", "b"`: the first fields in which two environments differ, apart from their ids.
std::string difference(const json& a, const json& b) {
  std::vector<std::string> found;
  for (const auto& [field, value] : a.items())
    if (field != "id" && (!b.contains(field) || b.at(field) != value))
      found.push_back(fmt::format("{}: {}, {}", field, value.dump(),
                                  b.contains(field) ? b.at(field).dump() : "unknown"));
  return fmt::format("{}", fmt::join(found, "; "));
}

[[noreturn]] void refuse(const StoredRun& a, const StoredRun& b, const std::string& what) {
  throw std::invalid_argument(
      fmt::format("{} and {} {}", a.directory.string(), b.directory.string(), what));
}

void require_alike(const StoredRun& first, const StoredRun& run, const MergeOptions& options) {
  if (const std::vector<std::string> found = conflicts(first.settings, run.settings);
      !found.empty())
    refuse(first, run, fmt::format("were asked for different things: {}", fmt::join(found, "; ")));
  if (options.mixed) return;
  const json& here = first.environments.front();
  for (const json& environment : run.environments) {
    if (environment.at("commit") != here.at("commit"))
      refuse(first, run,
             fmt::format("are of different commits, {} and {}: --mixed joins them all the same",
                         here.at("commit").dump(), environment.at("commit").dump()));
    if (environment.at("id") != here.at("id"))
      refuse(first, run,
             fmt::format("ran in different environments ({}): --mixed joins them all the same",
                         difference(here, environment)));
  }
}

void require_no_pair_twice(const std::vector<StoredRun>& runs) {
  std::map<PairKey, const StoredRun*> holder;
  for (const StoredRun& run : runs)
    for (const Record& row : run.rows)
      if (const auto [found, added] = holder.try_emplace(key_of(row), &run); !added)
        refuse(
            *found->second, run,
            fmt::format("both hold {} of {}: a pair may have one row", row.solver, row.instance));
}

/// Tells which shards of the first run's number are missing.
void note_missing_shards(const std::vector<StoredRun>& runs,
                         const std::function<void(const std::string&)>& note) {
  const Index count = runs.front().settings.shard.count;
  std::vector<Index> missing;
  for (Index index = 0; index < count; ++index)
    if (std::none_of(runs.begin(), runs.end(), [&](const StoredRun& run) {
          return run.settings.shard == Shard{index, count};
        }))
      missing.push_back(index + 1);
  if (!missing.empty())
    note(fmt::format("missing: shard {} of {}", fmt::join(missing, ", "), count));
}

}  // namespace

StoredRun merge(const std::vector<StoredRun>& runs, const std::filesystem::path& out,
                const MergeOptions& options, const std::function<void(const std::string&)>& note) {
  if (runs.empty()) throw std::invalid_argument("merge: no run to join, expected at least 1");
  for (const StoredRun& run : runs) require_alike(runs.front(), run, options);
  require_no_pair_twice(runs);

  StoredRun whole{out, runs.front().settings, {}, {}};
  whole.settings.seconds.reset();  // No session did all of it.
  whole.settings.shard = {};
  note_missing_shards(runs, note);
  for (const StoredRun& run : runs) {
    for (const json& environment : run.environments)
      if (std::none_of(whole.environments.begin(), whole.environments.end(),
                       [&](const json& each) { return each.at("id") == environment.at("id"); }))
        whole.environments.push_back(environment);
    append_missing(whole.settings.solvers, run.settings.solvers);
    whole.rows.insert(whole.rows.end(), run.rows.begin(), run.rows.end());
  }
  sort_rows(whole.rows, whole.settings.solvers);
  return whole;
}

}  // namespace lcp
