#pragma once

#include <string>

#include "harness/judge/judge.h"

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

/// The paper's criterion with its e_max = 1e-3 (V).
inline constexpr Acceptance by_paper{Acceptance::Criterion::paper, 1e-3};

/// The number that a criterion compares with its tolerance.
double error_of(const Accuracy& accuracy, Acceptance::Criterion criterion);

std::string to_string(Acceptance::Criterion criterion);  ///< residual, paper.
/// Throws std::invalid_argument with the list of criteria.
Acceptance::Criterion criterion_from_string(const std::string& name);

}  // namespace lcp
