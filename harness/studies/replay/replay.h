#pragma once

#include "harness/judge/judge.h"
#include "harness/measure/solve.h"
#include "harness/studies/replay/high_path.h"
#include "harness/studies/trace.h"

namespace lcp {

/// The path or rule that the solver's pivots are compared with.
enum class Beside {
  path,    ///< The path that the same rule takes in 113 bits.
  search,  ///< Each pivot by itself: may a search take it, from the same basis in 113 bits?
  none,    ///< The method shows no pivots, or has a rule that replay does not know.
};

/// Where the solver's run first leaves what 113 bits allow.
struct Departure {
  enum class Why {
    zero_pivot,      ///< m'_s is 0.
    no_pivot,        ///< m'_s is not below minus the pivot tolerance.
    larger_ratio,    ///< Another row blocks earlier.
    lost_tie,        ///< Tied, and the rule's order prefers another row.
    infeasible,      ///< Of a search: min q' falls to -epsilon or below.
    singular_basis,  ///< Of a search: the basis pivoted on is singular to 113 bits.
    ended,           ///< The run ends here, where the rule goes on.
    went_on,         ///< The rule ends here, where the run goes on.
  } why = Why::ended;
  Index pivot = 0;        ///< Number of the pivot, from 1.
  Variable entering = 0;  ///< The driving variable.
  Index row = -1;         ///< Taken by the run; -1 where it ended.
  Estimate size = {},
           ratio = {};        ///< m' and -q'/m' of that row in 113 bits; no ratio where m' is 0.
  Quad q_min = 0;             ///< Of a search: min q' after the pivot in 113 bits.
  Variable rule_leaves = -1;  ///< What leaves by the rule; -1: nothing, or a search.
  HighChoice rule = {};       ///< Of a path: the rule's own choice.
};

struct ReplayOptions {
  double tolerance = 1e-6;  ///< Of the judge.
  HighLimits high;
  Index before = 8;  ///< Pivots shown before the departure (or the end), and after it.
  Index after = 4;
  Index largest_condition = 200;  ///< As Trace::Options; only pivots shown have a condition.
};

/// One solve pivot by pivot beside its rule in 113 bits. Of an instance that falls into islands, the
/// first that departs is shown, else the first that fails, else the first.
struct Replay {
  Beside comparison = Beside::none;
  Claim claim = Claim::singular;  ///< Of the whole instance, as are the next three.
  std::string message;
  Judgement judgement;
  std::optional<double> basis_residual;  ///< See high_path.h; empty without a regular basis.

  Index island = 0, islands = 1;
  std::vector<Index> rows;  ///< Of the island, in the instance.
  Claim island_claim = Claim::singular;
  std::vector<Trace::Step> steps;  ///< Every pivot, in the numbering of the island.
  std::size_t begin = 0, end = 0;  ///< Those to be shown.
  std::optional<Departure> departure;
  /// Of Beside::path, from the departure on: the first pivot of the run that is 0 in 113 bits, from
  /// the run's own basis; looked for among the first HighLimits::most_pivots.
  std::optional<Departure> first_none;

  HighPath path;                            ///< Of Beside::path.
  double path_residual = 0;                 ///< Natural residual of its z, on the island.
  Verdict path_verdict = Verdict::not_run;  ///< `wrong` where that is too large for `solved`.
  std::size_t checked = 0;                  ///< Of Beside::search: pivots checked, in order.
};

/// Solves the instance and compares; see Replay. The costs are those of HighDictionary, once for each
/// pivot in 113 bits. Throws std::invalid_argument as solve_instance does.
Replay replay(const NamedSolver& solver, const Instance& instance, StartKind start,
              const ReplayOptions& options);

}  // namespace lcp
