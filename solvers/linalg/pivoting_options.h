#pragma once

#include "solvers/options.h"

namespace lcp {

enum class Restart {
  none,  ///< An unusable starting basis is claimed `singular`.
  cold,  ///< The problem is solved from scratch instead, and the restart counted.
};

/// Options that every pivoting method has.
struct PivotingOptions {
  double pivot = 0;          ///< Pivot tolerance: m'_i < -pivot may be a pivot.
  bool scale = false;        ///< Work on the problem scaled by s_z, s_w.
  Index max_pivots = 0;      ///< 0: the problem's own limit.
  Index refactor_every = 1;  ///< Factorised rows only.
  Restart restart = Restart::none;
};

/// Basis changes before `limit`.
inline Index pivot_limit(const PivotingOptions& options, const Problem& problem) {
  return options.max_pivots > 0 ? options.max_pivots : problem.max_pivots();
}

/// Their table; refactor_every is left out on a tableau, which is never factorised afresh.
OptionTable tableau_option_table(PivotingOptions& options);
OptionTable factorised_option_table(PivotingOptions& options);

}  // namespace lcp
