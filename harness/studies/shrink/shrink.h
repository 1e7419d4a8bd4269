#pragma once

#include <optional>
#include <string>
#include <vector>

#include "harness/studies/shrink/trial.h"
#include "problems/instance.h"

namespace lcp {

/// How much of one kind was there, and how much is left.
struct Reduction {
  std::string what;  ///< rows, contacts, directions, digits.
  Index from, to;
};

/// An instance reduced to what a failure needs.
struct Shrunk {
  Instance instance;
  Trial before, after;  ///< Of the solver on the instance given, and on this one.
  Trial reference;      ///< Of the reference solver on this one.
  std::vector<Reduction> reductions;
  Index solves = 0;
  bool minimal =
      false;  ///< Without any one of its contacts or rows, or with a digit less, it would not do.
};

struct ShrinkOptions {
  Limits limits{std::chrono::seconds(10), std::int64_t{2} << 30};  ///< Of one solve.
  Index max_solves = 20000;
  std::function<void(Index)> progress = [](Index) {};  ///< Solves so far.
};

/// Takes away contacts and friction directions, in turns until neither goes; then rows and digits
/// likewise (shrink/parts.h), as long as the invariant holds, each time by ddmin. Deterministic, unless
/// a verdict depends on the clock (timeout, memory).
///
/// The result is named shrunk/SOLVER-VERDICT-HASH after the first 8 digits of its sha256. Provenance:
/// parent, parent_sha256, solver, verdict, keep, reference, by_rounding, tolerance,
/// taken_away.
///
/// Throws std::invalid_argument where the solver does not fail on `parent`, or, if the invariant asks
/// for it, the reference does not solve it, z = 0 does, or the rule fails in 113 bits too. After an interruption: the smallest found.
Shrunk shrink(const Instance& parent, const Invariant& invariant, const ShrinkOptions& options,
              const std::atomic<bool>& interrupted);

}  // namespace lcp
