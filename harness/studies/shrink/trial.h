#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "harness/judge/judge.h"
#include "harness/measure/worker.h"
#include "harness/studies/replay/high_rule.h"
#include "problems/instance.h"
#include "solvers/registry.h"

namespace lcp {

/// How a solver fared on a problem, started cold.
struct Trial {
  Verdict verdict = Verdict::not_run;
  bool unclaimed = false;
  bool trivial = false;
  double residual = 0;  ///< Of its z; infinite without a z.
  Index pivots = 0;

  bool solved() const { return verdict == Verdict::solved; }
};

/// A condition that a smaller problem must still meet.
struct Invariant {
  enum class Keep {
    verdict,  ///< The solver's verdict, and whether its z passes all the same.
    failure,  ///< Any verdict but `solved`, `unsupported` and `not-run`, with a z that does not pass.
  };

  NamedSolver solver;
  Keep keep = Keep::verdict;
  bool solvable = true;  ///< `reference` solves it, and z = 0 does not.
  NamedSolver reference;
  /// The solver's own rule solves it in 113 bits (harness/studies/replay/high_path.h), so that the failure is
  /// that of rounding.
  std::optional<PathRule> by_rounding = {};
  double tolerance = 1e-6;  ///< Of the judge.
};

/// How both solvers fared on a problem.
struct Fared {
  bool keeps = false;
  Trial solver;
  Trial reference;  ///< not_run where nobody asked.
};

/// Solves candidates, each in a worker process of its own, and says which keep the invariant. Answers
/// are remembered by content.
class Trials {
 public:
  /// `max_solves` limits the solves of both solvers together. `progress` is told of them.
  Trials(Invariant invariant, const Limits& limits, Index max_solves,
         const std::atomic<bool>& interrupted, std::function<void(Index)> progress);

  /// Solves regardless of the budget. After an interruption: not_run.
  Trial run(const NamedSolver& solver, const Problem& problem);

  /// The problem to begin with. From now on a candidate has to fare as it did.
  void begin_with(const Problem& problem, const Fared& fared);
  /// Whether a smaller problem keeps the invariant. False once the budget is spent or the user
  /// interrupts, which stopped() then reports.
  bool keeps(const Problem& problem);

  /// How a problem fared that was begun with or keeps the invariant.
  const Fared& fared(const Problem& problem) const { return known_.at(content_hash(problem)); }

  /// Whether the rule of Invariant::by_rounding, if any, solves the problem in 113 bits.
  bool rule_solves(const Problem& problem) const;

  bool stopped() const { return stopped_; }
  bool interrupted() const { return interrupted_; }
  Index solves() const { return solves_; }

 private:
  bool fares_alike(const Trial& trial) const;
  Fared try_out(const Problem& problem);

  Invariant invariant_;
  Limits limits_;
  Index max_solves_;
  const std::atomic<bool>& interrupted_;
  std::function<void(Index)> progress_;
  Trial model_;
  std::map<std::string, Fared> known_;  ///< By content_hash.
  Index solves_ = 0;
  bool stopped_ = false;
};

/// Whether this is a failure as Keep::failure means it.
bool is_failure(const Trial& trial);

}  // namespace lcp
