#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "harness/record.h"
#include "solvers/registry.h"

namespace lcp {

/// What is run, and how far a pair (instance, solver) may go.
struct RunPlan {
  std::vector<Instance> instances;
  std::vector<NamedSolver> solvers;
  double tolerance = 1e-6;                        ///< Dimensionless, for the judge.
  std::chrono::nanoseconds timeout = std::chrono::seconds(10);  ///< Of one solve.
  std::int64_t memory_bytes = std::int64_t{2} << 30;            ///< Resident memory of a worker.
  int jobs = 1;                                   ///< Pairs solved at the same time.
  Index max_contacts = 60;                        ///< Instances above get `not-run` rows.
  int max_samples = 9;                            ///< Timed repetitions of a solved pair.
  double spread = 0.05;  ///< Repetitions stop when the quartiles are this close, over the median.
  std::string environment;                        ///< Id of env.json.
};

struct Progress {
  std::size_t done = 0;   ///< Pairs finished.
  std::size_t total = 0;
  std::string at;         ///< Instance being worked on.
};

/// Runs every pair, each in a worker process of its own, and hands over each finished record.
/// Records of one instance arrive together, in solver order. Solvers are interleaved: one repetition
/// of each before the next repetition of any, so that drift of the machine hits all alike. A pair
/// that fails is run once. Judging, checks and I/O stay outside the clock.
///
/// When `interrupted` becomes true the workers are killed and the function returns; the instance in
/// progress is given up, records handed over before stand. Exceptions of `finished` (a full disk)
/// kill the workers and pass through.
void run(const RunPlan& plan, const std::function<void(const Record&)>& finished,
         const std::function<void(const Progress&)>& progress,
         const std::atomic<bool>& interrupted);

/// Solves one instance in this process: islands of contacts that do not influence one another apart,
/// joined to one result with the sum of their work.
Result solve_instance(const Solver& solver, const Instance& instance, const Call& call = {});

}  // namespace lcp
