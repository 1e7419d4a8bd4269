#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/runs/run_directory.h"

namespace lcp {

/// A run that a past session did from beginning to end.
struct PastRun {
  std::filesystem::path directory;
  RunSettings settings;  ///< With `seconds`.
  std::string cpu;
  int jobs = 1;
};

/// The whole runs right below the directories `roots`, most recent first. What cannot be read there
/// is no run.
std::vector<PastRun> past_runs(const std::vector<std::filesystem::path>& roots);

/// How long a plan will take, going by rows of past runs.
struct Forecast {
  std::size_t known = 0;    ///< Open pairs that a past run has measured.
  double seconds = 0;       ///< Time those pairs took there, with the runner's overhead.
  std::size_t unknown = 0;  ///< Open pairs that no past run has.
  double most_seconds = 0;  ///< Time they take if each is stopped by the limit.
};

/// Each pair counts as the most recent run measured it: its repetitions, and an equal share of the
/// time that run spent outside solves. Reads the rows of all `runs` that are at hand.
Forecast forecast(const RunPlan& plan, const std::vector<PastRun>& runs);

}  // namespace lcp
