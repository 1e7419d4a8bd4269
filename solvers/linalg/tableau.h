#pragma once

#include "solvers/linalg/labels.h"
#include "solvers/linalg/pivoting_options.h"
#include "solvers/linalg/scaled_problem.h"

namespace lcp {

/// The dictionary basic = M' nonbasic + q' kept as an explicit n x (n + 1) array, one column for
/// each nonbasic variable with z0 among them, updated in place by every pivot (the paper's
/// incremental update, III).
///
/// A pivot costs n (n + 1) multiply-adds, whatever the size of the basis. Nothing is ever computed
/// afresh: rounding of all pivots so far adds up, and grows by 1 / |m'_s| at each.
class Tableau {
 public:
  /// The dictionary whose basic variables are z_i for i in alpha, by (6) and (7), with covering
  /// vector c (alpha empty) or 1 in the pivoted system. Not `usable` unless every pivot of the LU
  /// factors of M_alpha,alpha is larger than `options.pivot`.
  Tableau(const ScaledProblem& problem, const std::vector<Index>& alpha,
          const PivotingOptions& options);

  bool usable() const { return usable_; }
  const Labels& labels() const { return labels_; }
  const VectorXd& q() const { return q_; }
  /// m': the column of a nonbasic variable (n).
  void column(Variable v, VectorXd& out) const { out = columns_.col(place_[v]); }
  /// The entries of that column in the given rows.
  void entries(Variable v, const std::vector<Index>& rows, VectorXd& out) const;
  /// Exchanges the entering variable, whose column is `column`, with the one in `pivot.row`.
  Variable pivot(const Pivot& pivot, const VectorXd& column);
  /// Goes to the dictionary at the end of `path` by repeating its pivots, from the first dictionary or
  /// from the last snapshot on the part that both paths share. The numbers are those of the first time.
  void rebuild(const std::vector<Pivot>& path);
  /// |w - M z - q - z0 c|_inf of the basic solution, in the scale worked in: one product with M.
  double error() const;
  bool error_within(double e_max) const { return error() <= e_max; }
  /// c in original rows.
  const VectorXd& covering() const { return covering_; }

  Index factorisations() const { return factorisations_; }
  Index replayed() const { return replayed_; }

 private:
  const ScaledProblem& problem_;
  std::vector<Index> alpha_;
  Labels labels_;
  MatrixXd columns_;          ///< M' with the column of z0: n x (n + 1).
  std::vector<Index> place_;  ///< Column of a nonbasic variable.
  VectorXd q_;
  VectorXd covering_;
  bool usable_ = true;
  Index factorisations_ = 0;
  Index replayed_ = 0;

  /// The dictionary after the first `depth` pivots of path_.
  struct Snapshot {
    std::size_t depth;
    Labels labels;
    MatrixXd columns;
    std::vector<Index> place;
    VectorXd q;
  };
  std::vector<Pivot> path_;          ///< From the first dictionary to this one.
  bool returns_ = false;             ///< Has gone back once: snapshots are worth their memory.
  std::vector<Snapshot> snapshots_;  ///< Along path_, by depth.

  void set_first_dictionary(double pivot_tolerance);
};

}  // namespace lcp
