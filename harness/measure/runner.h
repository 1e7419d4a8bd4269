#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "harness/measure/solve.h"
#include "harness/record.h"
#include "solvers/registry.h"

namespace lcp {

/// One part of a run that is shared out: the instances at places index, index + count, ...
struct Shard {
  Index index = 0;
  Index count = 1;

  bool operator==(const Shard&) const = default;
};

/// The pairs to run, and how far a pair (instance, solver from a start) may go.
struct RunPlan {
  std::vector<Instance> instances;
  std::vector<NamedSolver> solvers;
  /// Each solver is run from each, one after the other.
  std::vector<StartKind> starts = {StartKind::cold};
  double tolerance = 1e-6;                                      ///< Dimensionless, for the judge.
  std::chrono::nanoseconds timeout = std::chrono::seconds(10);  ///< Of one solve.
  /// Resident memory of a worker above what it held when it was started.
  std::int64_t memory_bytes = std::int64_t{2} << 30;
  int jobs = 1;             ///< Instances worked on, and so solves running, at the same time.
  Index max_contacts = 60;  ///< Instances above get `not-run` rows.
  int max_samples = 9;      ///< Timed repetitions of a solved pair.
  /// A repetition is timed right after another, untimed one where the last one took less than this:
  /// other workers had the caches in between, and reading a short one's problem back from memory would
  /// take longer than solving it.
  std::chrono::nanoseconds warm_up_below = std::chrono::milliseconds(2);
  double spread = 0.05;  ///< Repetitions stop when the quartiles are this close, over the median.
  std::string environment;  ///< Id of env.json.
  Shard shard;
  Index first_place = 0;  ///< Of instances.front() among all of a run that is done part by part.
  bool keep_answers = false;  ///< Rows of solved pairs hold their z.
  std::set<PairKey> done;     ///< Pairs that have a row already and are left out.
};

/// Pairs of the plan that are to be run, in order: those of its shard without the ones done.
std::vector<PairKey> open_pairs(const RunPlan& plan);

struct Progress {
  std::size_t done = 0;   ///< Pairs finished.
  std::size_t total = 0;  ///< Pairs to be run.
  std::string at;         ///< Instance being worked on.
};

/// Runs every open pair, each in a worker process of its own, and hands over each finished record.
/// Records of one instance arrive together, in the order of solvers and of starts within them;
/// instances arrive in the order of the plan with jobs = 1, else in the order of completion. Judging, splitting into islands, checks and
/// I/O stay outside the clock; both steps of a two-step solve are inside. A row from a previous
/// solution has hash_with_previous as its sha256, since its result depends on that too.
///
/// Solvers, and each one's starts, are interleaved: one repetition of each before the next repetition
/// of any, so that drift of the machine hits all alike. The first run of a pair decides its verdict.
/// Where it claims a solution, it was the warm-up, and timed repetitions follow until the spread is
/// small (3 at least) or there are max_samples, each of less than 2 ms right after another that is not
/// timed, which brings the problem back into the caches; a first run longer than 1 s, or with
/// max_samples = 1, is itself the only sample. That holds for a claim that is `wrong` too: tables and
/// sheets judge it again, by a looser tolerance or the paper's criterion, and compare its time with
/// others'. A pair without a claimed solution, or whose z is not n finite numbers, has one sample, the
/// time of the run that failed, first uses of memory included, and is not run again. Same input, same
/// bits is part of what a solver promises: one whose later answer differs from its first in any field
/// is `wrong`, and the message says why.
///
/// When `interrupted` becomes true the workers are killed and the function returns, after it has
/// handed over the pairs that were finished; the others are given up. Exceptions of `finished` and
/// `progress` (a full disk) kill the workers and pass through. Throws std::invalid_argument on a plan
/// without a start, whose limits are not positive, whose shard does not exist or whose instances are
/// malformed, std::system_error when the system refuses a worker.
void run(const RunPlan& plan, const std::function<void(const Record&)>& finished,
         const std::function<void(const Progress&)>& progress,
         const std::atomic<bool>& interrupted);

}  // namespace lcp
