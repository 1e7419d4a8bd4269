#pragma once

#include "solvers/result.h"

namespace lcp {

/// The problem as a pivoting method sees it: w^ = M^ z^ + q^ + c^ z0 with M^ = S_w^-1 M S_z,
/// q^ = S_w^-1 q, so that every z^_i and w^_i is dimensionless; or the problem as it is stored
/// (scale=off, the paper's N and m/s).
///
/// The covering vector c^ is 1 in the scale worked in, or the instance's own, divided by s_w and by
/// its largest entry when scaled. Costs O(n); M^ is formed, in one pass over M, only when asked for as
/// a whole: a method that needs a few columns takes them from M and scales what comes out.
class ScaledProblem {
 public:
  ScaledProblem(const Problem& problem, bool scale);

  Index size() const { return q_.size(); }
  const MatrixXd& M() const;
  const VectorXd& q() const { return q_; }
  const VectorXd& c() const { return c_; }

  /// M^_ij is stored_ij column_scale(j) row_scales()_i, up to two roundings.
  const MatrixXd& stored() const { return problem_.M; }
  double column_scale(Index j) const { return scaled_ ? problem_.s_z(j) : 1; }
  const VectorXd& row_scales() const { return row_scales_; }

  /// Puts z^, w^ and z0 back into the problem's own units; `covering` is c^ in the same rows as w^, or
  /// empty.
  void unscale(VectorXd& z, VectorXd& w, VectorXd& covering) const;

 private:
  const Problem& problem_;
  bool scaled_;
  VectorXd row_scales_;  ///< 1 / s_w, or 1.
  VectorXd q_;
  VectorXd c_;
  mutable MatrixXd M_;  ///< M^, once it was asked for.
};

}  // namespace lcp
