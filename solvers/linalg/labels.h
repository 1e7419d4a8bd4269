#pragma once

#include <utility>
#include <vector>

#include "solvers/problem.h"

namespace lcp {

/// w_i is i, z_i is n + i, z0 is 2n.
using Variable = int;

/// One basis change: the variable that enters takes the row of the one that leaves.
struct Pivot {
  Index row;
  Variable entering;

  bool operator==(const Pivot&) const = default;
};

/// Which variable stands in which row of the dictionary
///     basic = M' nonbasic + q'                                                            (5)
/// The entering variable inherits the row of the leaving one, in every representation, so that
/// "lowest row" means the same thing everywhere.
class Labels {
 public:
  /// The dictionary in which z_i is basic for i in alpha and w_i for the others, in row i.
  Labels(Index n, const std::vector<Index>& alpha) : n_(n), basic_(n), row_(2 * n + 1, -1) {
    for (Index i = 0; i < n; ++i) basic_[i] = w(i);
    for (const Index i : alpha) basic_[i] = z(i);
    for (Index i = 0; i < n; ++i) row_[basic_[i]] = i;
  }

  Index size() const { return n_; }
  Variable w(Index i) const { return static_cast<Variable>(i); }
  Variable z(Index i) const { return static_cast<Variable>(n_ + i); }
  Variable z0() const { return static_cast<Variable>(2 * n_); }
  bool is_w(Variable v) const { return v < n_; }
  /// i of w_i or z_i.
  Index index(Variable v) const { return is_w(v) ? v : v - n_; }
  /// w_i for z_i and z_i for w_i; z0 has no complement.
  Variable complement(Variable v) const { return is_w(v) ? z(v) : w(v - n_); }

  Variable basic(Index row) const { return basic_[row]; }
  const std::vector<Variable>& basic() const { return basic_; }
  /// Row of a basic variable, -1 for a nonbasic one.
  Index row_of(Variable v) const { return row_[v]; }
  bool is_basic(Variable v) const { return row_[v] >= 0; }

  /// Carries the basis change out and returns the variable that left.
  Variable exchange(const Pivot& pivot) {
    const Variable leaving = std::exchange(basic_[pivot.row], pivot.entering);
    row_[leaving] = -1;
    row_[pivot.entering] = pivot.row;
    return leaving;
  }

 private:
  Index n_;
  std::vector<Variable> basic_;
  std::vector<Index> row_;
};

}  // namespace lcp
