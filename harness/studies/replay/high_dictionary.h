#pragma once

#include <Eigen/Dense>

#include "harness/judge/quad.h"
#include "solvers/linalg/labels.h"

namespace Eigen {

/// What Eigen asks of a number that it does not know.
template <>
struct NumTraits<lcp::Quad> : GenericNumTraits<lcp::Quad> {
  enum {
    IsInteger = 0,
    IsSigned = 1,
    IsComplex = 0,
    RequireInitialization = 0,
    ReadCost = 1,
    AddCost = 30,
    MulCost = 30
  };
};

}  // namespace Eigen

namespace lcp {

using QuadMatrix = Eigen::Matrix<Quad, Eigen::Dynamic, Eigen::Dynamic>;
using QuadVector = Eigen::Matrix<Quad, Eigen::Dynamic, 1>;

/// Replaces a square matrix by its inverse, k^3 multiply-adds. False, and the matrix as it was, where a
/// pivot is 0 or not finite.
bool invert(QuadMatrix& matrix);

/// The data of an LCP in 113 bits, as a pivoting method sees them (solvers/linalg/scaled_problem.h): M
/// and q are doubles and taken as exact; scaled, their quotients by s_w and s_z round once.
struct HighProblem {
  QuadMatrix M;
  QuadVector q;
  QuadVector c;  ///< Covering vector in original rows: 1, the instance's own, or that of a start.

  /// `alpha` is the starting basis, empty for a cold start; c is then 1 in the dictionary of alpha, that
  /// is c_alpha = -M_alpha,alpha 1 and c_rest = 1 - M_rest,alpha 1.
  HighProblem(const Problem& problem, bool scale, const std::vector<Index>& alpha = {});

  Index size() const { return q.size(); }
};

/// A number and how far it may be off: to first order in the rounding of 113 bits, of the data's
/// quotients and of everything computed from them.
struct Estimate {
  Quad value = 0;
  double error = 0;
  /// Of a number taken for 0: how far it may be from that, where 113 bits do not resolve it (kResolution).
  double doubt = 0;
};

/// The data's own rounding leaves numbers of about 2^-53 of the terms that they are the sum of. Where the
/// error is more than this share of those terms, on bases of condition 1e14 and above, a number that small
/// cannot be told from 0.
inline constexpr double kResolution = 1e-20;

using Estimates = std::vector<Estimate>;

/// The dictionary basic = M' nonbasic + q' of one basis, computed from the data in 113 bits and not
/// from any other dictionary, so that no rounding adds up along a path:
///     M_RA x_A = -b_R,   y = b + M_.A x_A
/// as in solvers/linalg/basis.h, with the inverse V of the k x k kernel M_RA and one step of
/// refinement. The error of x_A is at most (k + 1) 2^-113 |V| (|M_RA||x_A| + |b_R|), to first order.
///
/// A number that is not larger than `zero` times its error is indistinguishable from 0, which a true
/// zero of the exact rational arithmetic always is, and comes out as exactly 0. Any other number has
/// the right sign. What is not zero and yet that small would have to be so by chance.
///
/// Costs k^3 + n k multiply-adds in software (about 50 ns each), and 3 k^2 + n k for every column.
class HighDictionary {
 public:
  HighDictionary(const HighProblem& problem, const Labels& labels, double zero);

  /// False where the basis is singular to 113 bits.
  bool usable() const { return usable_; }
  const Labels& labels() const { return labels_; }
  const Estimates& q() const { return q_; }
  /// m' of a nonbasic variable.
  Estimates column(Variable v) const { return entries(v, rows_); }
  /// Its entries in the given rows.
  Estimates entries(Variable v, const std::vector<Index>& rows) const {
    return entries_of(right_side(v), rows);
  }

 private:
  QuadVector right_side(Variable v) const;
  Estimates kernel_solution(const QuadVector& b) const;
  Estimates entries_of(const QuadVector& b, const std::vector<Index>& rows) const;
  void set_kernel();

  const HighProblem* problem_;
  Labels labels_;
  double zero_;
  std::vector<Index> rows_;              ///< 0 ... n - 1.
  std::vector<Index> R_;                 ///< Rows whose w is nonbasic.
  std::vector<Variable> A_;              ///< Basic z (and z0), by rows of the dictionary.
  std::vector<Index> place_;             ///< Of a dictionary row in A_, or -1 where a w is basic.
  QuadMatrix columns_;                   ///< M_.A: n x k.
  QuadMatrix inverse_;                   ///< V: row a belongs to A_[a], column r to R_[r].
  MatrixXd kernel_size_, inverse_size_;  ///< |M_RA| and |V|.
  bool usable_ = true;
  Estimates q_;
};

}  // namespace lcp
