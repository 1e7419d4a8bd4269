#pragma once

#include "solvers/linalg/labels.h"
#include "solvers/linalg/pivoting_options.h"
#include "solvers/linalg/scaled_problem.h"

namespace lcp {

/// The same dictionary as `Tableau` without the tableau: an LU factorisation of the k x k kernel
/// M_RA, where R are the rows whose w is nonbasic and A the basic z (and z0), and one product with
/// the n x k columns of A per column asked for:
///     M_RA x_A = -b_R,   y = b + M_.A x_A                                            (6), (7)
/// with b = q for q', b = M_.j for the column of z_j, b = -e_i for that of w_i.
///
/// k stays near the number of active constraints, so a pivot costs 2/3 k^3 + 2 n k + k^2 instead of
/// n^2. The kernel is factorised afresh every `refactor_every` pivots; in between, columns of the
/// last factorised dictionary are carried through the pivots since (product form, n each). With
/// refactor_every = 1 no rounding outlives a pivot: the error is that of one LU solve.
///
/// Columns are read where the problem holds them, and products are scaled as they come out.
class Basis {
 public:
  /// As for `Tableau`.
  Basis(const ScaledProblem& problem, const std::vector<Index>& alpha,
        const PivotingOptions& options);

  /// False once a kernel was singular or not finite in floating point.
  bool usable() const { return usable_; }
  const Labels& labels() const { return labels_; }
  const VectorXd& q() const { return q_; }
  void column(Variable v, VectorXd& out);
  void entries(Variable v, const std::vector<Index>& rows, VectorXd& out);
  Variable pivot(const Pivot& pivot, const VectorXd& column);
  void rebuild(const std::vector<Pivot>& path);
  /// Whether |w - M z - q - z0 c|_inf of the basic solution is at most e_max. Only the rows R can be
  /// off, since the other w are computed from z: after a factorisation it is known. Later a running
  /// estimate answers (see drift_), unless it comes within a factor of 1000 of e_max: then the basis is
  /// factorised afresh, and nothing that was added up since is left.
  bool error_within(double e_max);
  const VectorXd& covering() const;
  /// Factorises this basis afresh, unless that was done last, and improves the basic z by one step of
  /// iterative refinement: x_A -= M_RA^-1 (q_R + M_RA x_A). The basic w of q() stay as they were. False
  /// if the kernel is singular.
  bool refine();

  Index factorisations() const { return factorisations_; }
  Index replayed() const { return 0; }

 private:
  /// A pivot since the last factorisation.
  struct Eta {
    Pivot pivot;
    Variable left;
    VectorXd column;  ///< m' of the entering variable when it entered.
  };

  const ScaledProblem& problem_;
  std::vector<Index> alpha_;
  Index refactor_every_;
  Labels labels_;
  Labels factored_;            ///< Labels when the kernel was factorised.
  mutable VectorXd covering_;  ///< Empty until asked for.
  VectorXd q_;
  std::vector<Index> R_;          ///< Rows whose w was nonbasic then, ascending.
  std::vector<Index> A_rows_;     ///< Dictionary rows of the basic z (and z0) then, ascending.
  std::vector<Index> A_columns_;  ///< Their columns of M, in that order, without z0.
  Index z0_place_ = -1;           ///< Place of z0 in A_rows_, or -1.
  std::vector<Index> w_of_row_;   ///< Row i held w of this index then; 0 for the rows A.
  Eigen::PartialPivLU<MatrixXd> lu_;
  VectorXd kernel_residual_;  ///< q_R + M_RA x_A of the last factorisation.
  double kernel_error_ = 0;   ///< Maximum norm of kernel_residual_.
  double drift_ = 0;          ///< Estimate of what the pivots since have added to it: the sum of
                              ///< machine epsilon (1 + |theta|) growth_.
  double growth_ = 1;         ///< Largest |m'|_inf and |m'|_inf / |m'_s| since.
  std::vector<Eta> etas_;     ///< The first `pivots_` are in use; the others keep their memory.
  Index pivots_ = 0;
  bool usable_ = true;
  Index factorisations_ = 0;

  // Room to work in.
  MatrixXd kernel_;
  mutable VectorXd permuted_;
  VectorXd x_, y_, coefficients_;

  /// Factorises the kernel of labels_; not usable unless every pivot of its LU is larger than
  /// `pivot_tolerance`.
  void factorise(double pivot_tolerance);
  /// Solves M_RA x_A = -b_R, where b_R comes as `b` and x_A goes.
  void solve_kernel(VectorXd& b) const;
  /// y = b + M_.A x_A, where b is M_.j if j >= 0, else 0.
  void product(const VectorXd& x, Index j, VectorXd& y);
  /// out = y in the rows of w, x in the others.
  void spread(const VectorXd& y, const VectorXd& x, VectorXd& out) const;
  /// x_A for the column of `v` in the factorised dictionary.
  void kernel_part(Variable v, VectorXd& x) const;
  /// Column of `v` in the factorised dictionary.
  void factored_column(Variable v, VectorXd& out);
  /// Its entries in the given rows, one dot product of length k each.
  void factored_entries(Variable v, const std::vector<Index>& rows, VectorXd& out);
  /// The column of the variable that left by `eta`, just after: that of the one which replaced it,
  /// divided by the pivot.
  static VectorXd entries_after_leaving(const Eta& eta, const std::vector<Index>& rows);
  /// First pivot after which `v` was nonbasic for good, or -1 if it was so at the factorisation.
  Index last_left(Variable v) const;
};

}  // namespace lcp
