#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "solvers/names.h"
#include "solvers/problem.h"

namespace lcp {

/// A solver's own word on its answer; the truth is the judge's to find.
enum class Claim {
  solved,       ///< z is a solution.
  ray,          ///< Nothing blocks the driving variable (secondary ray); proves nothing by itself.
  exhausted,    ///< The search queue ran empty.
  infeasible,   ///< No w, z >= 0 exist: y >= 0, M'y <= 0, q'y < 0 is in `certificate`.
  cycle,        ///< A basis came back with the same entering variable.
  limit,        ///< Pivots, nodes or sweeps ran out.
  singular,     ///< No usable pivot, a singular basis, or non-finite numbers.
  unsupported,  ///< The method does not apply to this problem; `message` says why.
};

/// Deterministic counts of the work.
struct Work {
  Index pivots = 0;     ///< Basis changes computed, abandoned branches included ("total pivots").
  Index path = 0;       ///< Basis changes on the path to the returned basis.
  Index nodes = 0;      ///< Search nodes opened.
  Index generated = 0;  ///< Search nodes generated.
  Index largest_queue = 0;   ///< Most nodes waiting at once.
  Index replayed = 0;        ///< Tableau pivots repeated to return to an abandoned branch.
  Index factorisations = 0;  ///< LU factorisations of a basis.
  Index sweeps = 0;          ///< Passes of an iterative method.
  Index start_pivots = 0;    ///< Principal pivots taken to enter the starting basis, |alpha|.
  /// Times a start was replaced by a cold one: an unusable basis with restart=cold, a two-step solve
  /// whose first step failed, or a missing previous solution; or a search was given up
  /// for another (patience).
  Index restarts = 0;
  Index frictionless_pivots = 0;  ///< Of the first step of a two-step solve; not in `pivots`.

  Work& operator+=(const Work& other);
};

/// What a method returns. There is no time in it (the runner measures) and no verdict.
struct Result {
  Claim claim = Claim::singular;
  std::string message;
  VectorXd z;         ///< n; defined and finite on every claim.
  VectorXd w;         ///< n, or empty where the method keeps no w of its own.
  double z0 = 0;      ///< Artificial variable left in the basis.
  VectorXd covering;  ///< The c that multiplies z0 in original rows; empty when there is no z0.
  std::optional<std::vector<Index>> basis;  ///< alpha = {i : z_i basic}, ascending.
  VectorXd certificate;                     ///< y of Claim::infeasible.
  Work work;
};

/// Where to start: a basis for methods that pivot, a point for those that approach a solution. Each
/// takes what it can use; where a start holds a point alone, its alpha is empty, which is a cold start
/// to a method that pivots.
struct Start {
  std::vector<Index> alpha;  ///< The rows i whose z_i is basic.
  VectorXd z = {};           ///< n, or empty where only a basis is known.
};

/// One basis change, for traces. Variables are w_i = i, z_i = n + i, z0 = 2n.
struct PivotEvent {
  Index node = 0;    ///< Number of the node opened (search), else the pivot's number.
  Index parent = 0;  ///< Node it continues; not `node - 1` where a search went back.
  Index row = 0;
  int entering = 0;
  int leaving = 0;
  double ratio = 0;  ///< -q'_s / m'_s, value of the entering variable, in the solver's scale.
  double pivot = 0;  ///< m'_s.
  Index tied = 1;    ///< Rows the ratio test could not tell apart, or candidates of the search.
  const std::vector<int>* basic = nullptr;  ///< Basic variable of each row after the pivot.
};

using Observer = std::function<void(const PivotEvent&)>;

/// Things a caller may add to a problem.
struct Call {
  std::optional<Start> start;
  Observer observer;  ///< Empty: nobody watches.
};

}  // namespace lcp
