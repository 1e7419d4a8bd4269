#pragma once

#include <atomic>
#include <nlohmann/json.hpp>

#include "harness/runs/run_directory.h"
#include "problems/registry.h"

namespace lcp {

/// Six published instances and three solvers: 18 pairs, done in about a tenth of a second.
inline RunPlan small_plan() {
  RunPlan plan;
  plan.instances = generate("published", {.count = 6, .seed = 1});
  plan.solvers = make_solvers({"lemke", "lexicographic", "best-first"});
  plan.timeout = std::chrono::seconds(60);
  plan.max_samples = 1;
  return plan;
}

/// Runs `plan` into `directory`; gives up after `pairs` pairs, unless that is 0.
inline RunReport run_small(const std::string& directory, const RunPlan& plan,
                           Existing existing = Existing::refuse, std::size_t pairs = 0) {
  std::atomic<bool> interrupted = false;
  return run_into(
      directory, plan, {"small", {}}, existing, [](const std::string&) {},
      [&](const Progress& progress) { interrupted = pairs > 0 && progress.done >= pairs; },
      interrupted);
}

/// Rows without what depends on time and machine.
inline std::vector<nlohmann::json> deterministic_rows(const std::string& directory) {
  std::vector<nlohmann::json> rows;
  for (const Record& record : read_run(directory)) {
    rows.push_back(record);
    for (const char* field : {"times_ns", "median_ns", "environment"}) rows.back().erase(field);
  }
  return rows;
}

}  // namespace lcp
