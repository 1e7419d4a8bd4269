#pragma once

#include <limits>
#include <vector>

#include "solvers/problem.h"

namespace lcp::cases {

/// min |E y - f| over y >= 0, by Lawson and Hanson's active sets. Source: C. L. Lawson, R. J. Hanson,
/// Solving Least Squares Problems (1974), chapter 23, algorithm NNLS.
inline VectorXd nonnegative_least_squares(const MatrixXd& E, const VectorXd& f) {
  const Index n = E.cols();
  VectorXd y = VectorXd::Zero(n);
  std::vector<bool> in(n, false);
  const double tolerance = 1e-13 * E.norm() * f.norm();
  for (Index round = 0; round < 10 * n; ++round) {
    const VectorXd gradient = E.transpose() * (f - E * y);
    Index enter = -1;
    for (Index j = 0; j < n; ++j)
      if (!in[j] && gradient(j) > tolerance && (enter < 0 || gradient(j) > gradient(enter)))
        enter = j;
    if (enter < 0) return y;
    in[enter] = true;
    for (;;) {
      std::vector<Index> set;
      for (Index j = 0; j < n; ++j)
        if (in[j]) set.push_back(j);
      const VectorXd s = MatrixXd(E(Eigen::all, set)).colPivHouseholderQr().solve(f);
      double step = 1;
      for (std::size_t k = 0; k < set.size(); ++k)
        if (s(k) <= 0) step = std::min(step, y(set[k]) / (y(set[k]) - s(k)));
      for (std::size_t k = 0; k < set.size(); ++k) y(set[k]) += step * (s(k) - y(set[k]));
      if (step == 1 && s.minCoeff() > 0) break;
      for (const Index j : set) {
        if (y(j) > 1e-14 * y.maxCoeff()) continue;
        y(j) = 0;
        in[j] = false;
      }
    }
  }
  return VectorXd::Constant(n, std::numeric_limits<double>::quiet_NaN());
}

/// min |x| subject to G x >= h, which has at most one solution. NaN where there is none. Source: the
/// same, algorithm LDP: with y the nonnegative least squares solution of (G h)' y = (0 1)' and r its
/// residual, x = -r / r_last.
inline VectorXd least_distance(const MatrixXd& G, const VectorXd& h) {
  MatrixXd E(G.cols() + 1, G.rows());
  E << G.transpose(), h.transpose();
  VectorXd f = VectorXd::Zero(E.rows());
  f(E.rows() - 1) = 1;
  const VectorXd r = E * nonnegative_least_squares(E, f) - f;
  return -r.head(G.cols()) / r(G.cols());
}

}  // namespace lcp::cases
