#pragma once

#include <optional>
#include <string>

#include "harness/record.h"

namespace lcp {

/// When an answer that claims to be solved counts as solved.
struct Acceptance {
  enum class Criterion {
    residual,  ///< The judge's: natural residual (scaled) of at most `tolerance`.
    paper,     ///< The paper's: |w - M z - q - z0 c|_inf of the solver's own w and z0 of at most
    ///< `tolerance` (unscaled, e_max); the unscaled natural residual where it keeps no w.
  };

  Criterion criterion = Criterion::residual;
  double tolerance = 1e-6;

  bool operator==(const Acceptance&) const = default;
};

/// The columns of the paper's tables, and what stands beside them.
enum class Standing {
  success,      ///< `solved`, and z = 0 is no solution.
  trivial,      ///< `solved` where z = 0 passes too; the paper's criterion knows none.
  no_solution,  ///< ray, exhausted, infeasible, false-infeasible.
  cycle,        ///< cycle, limit, timeout.
  error,        ///< wrong, inaccurate, singular, crash, memory.
  unsupported,
  not_run,
};

std::string to_string(Standing standing);  ///< As enumerated.

/// What a run comes to by a criterion.
struct Judged {
  Verdict verdict;
  bool unclaimed = false;  ///< Claims a failure (not `unsupported`) while its z passes.
  bool trivial = false;    ///< z = 0 passes, whatever the verdict.

  Standing standing() const;
  bool success() const { return standing() == Standing::success; }
  bool failure() const;  ///< no_solution, cycle or error.
  /// In the denominator of shares: success or failure.
  bool counted() const { return success() || failure(); }
};

/// The one place that says "solved". A claim `solved` with an accuracy is `solved` where the criterion's
/// error is at most its tolerance; else `inaccurate` where it passed at `own_tolerance`, the one of
/// its run, and `wrong` where it did not, and always by the paper's criterion. Any other run keeps the
/// verdict `otherwise`. By the paper's criterion nothing is trivial or unclaimed.
Judged judged(Claim claim, Verdict otherwise, const std::optional<Accuracy>& accuracy,
              const Acceptance& acceptance, double own_tolerance);

/// A row as it was judged when it was measured, or anew by a criterion from what it stores.
Judged judged(const Record& record, const std::optional<Acceptance>& acceptance = {});

/// The paper's criterion with its e_max = 1e-3 (V).
inline constexpr Acceptance by_paper{Acceptance::Criterion::paper, 1e-3};

/// The number that a criterion compares with its tolerance.
double error_of(const Accuracy& accuracy, Acceptance::Criterion criterion);

}  // namespace lcp
