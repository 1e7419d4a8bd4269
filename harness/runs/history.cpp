#include "harness/runs/history.h"

#include <algorithm>
#include <exception>
#include <numeric>

namespace lcp {

namespace {

namespace fs = std::filesystem;

/// Seconds a pair's solves took: the samples and, where these are several, the warm-up before them.
double solving_seconds(const Record& record) {
  const std::int64_t samples =
      std::accumulate(record.times_ns.begin(), record.times_ns.end(), std::int64_t{0});
  const std::int64_t warm_up = record.times_ns.size() > 1 ? *record.median_ns() : 0;
  return static_cast<double>(samples + warm_up) * 1e-9;
}

/// Rows of a run, or none where they are packed away.
std::vector<Record> rows_at_hand(const PastRun& run) {
  if (!fs::exists(run.directory / "rows.jsonl")) return {};
  try {
    return read_run(run.directory);
  } catch (const std::exception&) {
    return {};  // A forecast needs no row; whoever wants these will hear what is wrong with them.
  }
}

}  // namespace

std::vector<PastRun> past_runs(const std::vector<fs::path>& roots) {
  std::vector<std::pair<fs::file_time_type, PastRun>> found;
  for (const fs::path& root : roots) {
    std::error_code nothing_there;
    for (const fs::directory_entry& entry : fs::directory_iterator(root, nothing_there)) {
      const fs::path file = entry.path() / "run.json";
      if (!fs::exists(file, nothing_there)) continue;
      try {
        const RunHeader header = read_run_header(entry.path());
        if (header.settings.seconds)
          found.push_back(
              {fs::last_write_time(file),
               {entry.path(), header.settings, header.environments.front().value("cpu", "unknown"),
                header.environments.front().value("jobs", 1)}});
      } catch (const std::exception&) {
        continue;
      }
    }
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
    return std::tie(b.first, a.second.directory) < std::tie(a.first, b.second.directory);
  });
  std::vector<PastRun> runs;
  for (auto& [time, run] : found) runs.push_back(std::move(run));
  return runs;
}

Forecast forecast(const RunPlan& plan, const std::vector<PastRun>& runs) {
  std::map<PairKey, double> seconds_of;
  for (const PastRun& run : runs) {
    const std::vector<Record> rows = rows_at_hand(run);
    double solving = 0;
    for (const Record& row : rows) solving += solving_seconds(row);
    const double jobs = run.jobs;
    const double other = std::max(0.0, *run.settings.seconds * jobs - solving);
    for (const Record& row : rows)
      seconds_of.try_emplace(key_of(row),
                             solving_seconds(row) + other / static_cast<double>(rows.size()));
  }
  Forecast forecast;
  for (const PairKey& pair : open_pairs(plan)) {
    if (const auto found = seconds_of.find(pair); found != seconds_of.end()) {
      ++forecast.known;
      forecast.seconds += found->second / plan.jobs;
    } else {
      ++forecast.unknown;
    }
  }
  const std::chrono::duration<double> timeout = plan.timeout;
  forecast.most_seconds = static_cast<double>(forecast.unknown) * timeout.count() / plan.jobs;
  return forecast;
}

}  // namespace lcp
