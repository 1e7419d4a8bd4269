#pragma once

#include "solvers/problem.h"

namespace lcp {

/// Twice continuously differentiable curve of several components through values at equidistant
/// times from 0: a cubic between neighbours, at rest at both ends (clamped spline). Outside it stays
/// where it ends. Cost to build: O(knots) per component.
class CubicSpline {
 public:
  /// `values`: components x knots, at times 0, spacing (s), 2 spacing, ... Throws
  /// std::invalid_argument unless there are 2 knots of finite values and spacing is positive.
  CubicSpline(MatrixXd values, double spacing);

  struct Point {
    VectorXd value, rate, acceleration;
  };
  /// Throws std::invalid_argument on NaN.
  Point at(double time) const;

 private:
  MatrixXd values_;
  MatrixXd second_;  ///< Second derivatives at the knots.
  double spacing_;
};

}  // namespace lcp
