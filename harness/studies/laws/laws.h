#pragma once

#include <functional>
#include <string>
#include <vector>

#include "solvers/names.h"
#include "solvers/registry.h"

namespace lcp {

struct LawOutcome {
  enum class Status {
    holds,
    broken,
    not_applicable,  ///< The row answers `unsupported`, or claims nothing the law speaks of.
  } status;
  std::string detail;  ///< What broke the law, or why it does not apply.
};

/// Something every row of the registry must obey, whatever its method.
struct Law {
  std::string name;
  std::string statement;
  std::function<LawOutcome(const NamedSolver&)> check;
  /// It speaks of the answers. A peer's are its library's and never repaired: where they break the
  /// law that is a finding, while the other laws bind the adapter as they bind every row.
  bool of_answers = false;
};

const std::vector<Law>& laws();

/// Checks one law; an exception out of the solver breaks it.
LawOutcome check(const Law& law, const NamedSolver& solver);

/// How near the permutation law wants the solution, in max |dz_i / s_z,i|.
struct LawTolerances {
  double pivoting = 1e-8;       ///< Rows that end on a basis.
  double own_tolerances = 100;  ///< Iterative rows: this many times their option `tolerance`.
};

}  // namespace lcp
