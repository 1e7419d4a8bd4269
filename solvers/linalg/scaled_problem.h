#pragma once

#include "solvers/result.h"

namespace lcp {

/// The problem as a pivoting method sees it: w^ = M^ z^ + q^ + c^ z0 with M^ = S_w^-1 M S_z,
/// q^ = S_w^-1 q, so that every z^_i and w^_i is dimensionless; or the problem as it is stored
/// (scale=off, the paper's N and m/s).
///
/// The covering vector c^ is 1 in the scale worked in, or the instance's own, divided by s_w and by
/// its largest entry when scaled. Costs one pass over M when scaled and nothing otherwise.
class ScaledProblem {
 public:
  ScaledProblem(const Problem& problem, bool scale);

  Index size() const { return q_.size(); }
  const MatrixXd& M() const { return scaled_ ? M_ : problem_.M; }
  const VectorXd& q() const { return q_; }
  const VectorXd& c() const { return c_; }

  /// Puts z^, w^ and z0 back into the problem's own units; `covering` is c^ in the same rows as w^.
  void unscale(VectorXd& z, VectorXd& w, VectorXd& covering) const;

 private:
  const Problem& problem_;
  bool scaled_;
  MatrixXd M_;
  VectorXd q_;
  VectorXd c_;
};

}  // namespace lcp
