#include "harness/studies/shrink/trial.h"

#include <limits>
#include <utility>

#include "harness/measure/runner.h"
#include "harness/studies/replay/high_path.h"
#include "problems/contact/islands.h"

namespace lcp {

Trials::Trials(Invariant invariant, const Limits& limits, Index max_solves,
               const std::atomic<bool>& interrupted, std::function<void(Index)> progress)
    : invariant_(std::move(invariant)),
      limits_(limits),
      max_solves_(max_solves),
      interrupted_(interrupted),
      progress_(std::move(progress)) {}

Trial Trials::run(const NamedSolver& solver, const Problem& problem) {
  RunPlan plan;
  plan.instances = {make_instance("candidate", problem, {})};
  plan.solvers = {solver};
  plan.tolerance = invariant_.tolerance;
  plan.timeout = limits_.time;
  plan.memory_bytes = limits_.resident_bytes;
  plan.max_contacts = std::numeric_limits<Index>::max();
  plan.max_samples = 1;
  Trial trial;
  lcp::run(
      plan,
      [&trial](const Record& record) {
        trial = {
            record.verdict, record.unclaimed, record.trivial,
            record.accuracy ? record.accuracy->residual : std::numeric_limits<double>::infinity(),
            record.work.pivots};
      },
      [](const Progress&) {}, interrupted_);
  progress_(++solves_);
  return trial;
}

bool is_failure(const Trial& trial) {
  return !trial.solved() && trial.verdict != Verdict::unsupported &&
         trial.verdict != Verdict::not_run && !trial.unclaimed;
}

bool Trials::fares_alike(const Trial& trial) const {
  if (invariant_.keep == Invariant::Keep::failure) return is_failure(trial);
  return trial.verdict == model_.verdict && trial.unclaimed == model_.unclaimed;
}

Fared Trials::try_out(const Problem& problem) {
  Fared fared;
  fared.solver = run(invariant_.solver, problem);
  if (!fares_alike(fared.solver)) return fared;
  if (invariant_.solvable && !fared.solver.trivial)
    fared.reference = run(invariant_.reference, problem);
  fared.keeps = (!invariant_.solvable || fared.reference.solved()) && rule_solves(problem);
  return fared;
}

bool Trials::rule_solves(const Problem& problem) const {
  if (!invariant_.by_rounding) return true;
  HighLimits limits;
  limits.interrupted = &interrupted_;
  for (const Island& island : split_islands(problem)) {
    const HighPath path = follow_high_path(island.problem, *invariant_.by_rounding, {}, limits);
    if (path.claim != Claim::solved) return false;
    Result answer;
    answer.z = path.z;
    if (!(measure(island.problem, answer).residual <= invariant_.tolerance)) return false;
  }
  return true;
}

void Trials::begin_with(const Problem& problem, const Fared& fared) {
  model_ = fared.solver;
  known_.emplace(content_hash(problem), fared);
}

bool Trials::keeps(const Problem& problem) {
  const std::string content = content_hash(problem);
  const auto known = known_.find(content);
  if (known != known_.end()) return known->second.keeps;
  stopped_ = stopped_ || solves_ >= max_solves_ || interrupted_;
  if (stopped_) return false;
  const Fared fared = try_out(problem);
  if (interrupted_) {  // What was broken off says nothing.
    stopped_ = true;
    return false;
  }
  known_.emplace(content, fared);
  return fared.keeps;
}

}  // namespace lcp
