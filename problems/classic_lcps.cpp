#include "problems/classic_lcps.h"

#include <cmath>

namespace lcp {

namespace {

/// The limit of problems whose number of pivots doubles with every row.
Index exponential_limit(Index n) { return Index{1} << (n + 1); }

}  // namespace

MatrixXd unit_lower_with_twos(Index n) {
  MatrixXd L = MatrixXd::Constant(n, n, 2).triangularView<Eigen::StrictlyLower>();
  L.diagonal().setOnes();
  return L;
}

ClassicLcp murty_exponential(Index n) {
  VectorXd q(n);
  double sum = 0;
  for (Index i = 0; i < n; ++i) q(i) = -(sum += std::ldexp(1, static_cast<int>(n - i)));
  return {.M = unit_lower_with_twos(n),
          .q = q,
          .solution = VectorXd::Unit(n, 0) * std::ldexp(1, static_cast<int>(n)),
          .pivot_limit = exponential_limit(n),
          .source =
              "K. G. Murty, Linear Complementarity, Linear and Nonlinear Programming, 1988, "
              "chapter 6; Siconos (exp_murty2, in reversed order); QuantEcon"};
}

ClassicLcp fathi(int variant, Index n) {
  const MatrixXd L = unit_lower_with_twos(n);
  MatrixXd M = L * L.transpose();
  if (variant == 2) M.array() += 4;
  if (variant == 3) M.rightCols(n - 1).array() -= 4;
  const VectorXd solution = VectorXd::Unit(n, 0) / M(0, 0);
  return {.M = M,
          .q = VectorXd::Constant(n, -1),
          .solution = solution,
          .pivot_limit = exponential_limit(n),
          .source =
              "Y. Fathi, Computational complexity of LCPs associated with positive definite "
              "symmetric matrices, Mathematical Programming 17, 1979; hnm4lcp"};
}

ClassicLcp csizmadia(Index n) {
  const MatrixXd M =
      2 * MatrixXd::Identity(n, n) - MatrixXd(MatrixXd::Ones(n, n).triangularView<Eigen::Lower>());
  VectorXd x(n);
  for (Index i = 0; i < n; ++i) x(i) = i % 2 == 0 ? 1 : 0;
  return {.M = M,
          .q = VectorXd::Ones(n) - x - M * x,
          .solution = x,
          .source =
              "E. de Klerk, M. E.-Nagy, On the complexity of computing the handicap of a "
              "sufficient matrix, Mathematical Programming 129, 2011; hnm4lcp"};
}

ClassicLcp ben_gharbia_gilbert(Index n) {
  MatrixXd M = MatrixXd::Identity(n, n);
  for (Index j = 0; j < n; ++j) {
    M((j + 1) % n, j) = n % 2 == 1 ? 2 : 4.0 / 3;
    if (n % 2 == 0) M((j + 2) % n, j) = 0.5;
  }
  return {.M = M,
          .q = VectorXd::Ones(n),
          .solution = VectorXd::Zero(n),
          .source =
              "I. Ben Gharbia, J. Ch. Gilbert, Nonconvergence of the plain Newton-min "
              "algorithm for linear complementarity problems with a P-matrix, Mathematical "
              "Programming 134, 2012; hnm4lcp"};
}

}  // namespace lcp
