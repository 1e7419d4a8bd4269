#pragma once

#include <ostream>
#include <random>

#include "solvers/linalg/natural_residual.h"
#include "solvers/registry.h"

namespace lcp {
inline void PrintTo(Claim claim, std::ostream* out) { *out << to_string(claim); }
}  // namespace lcp

namespace lcp::cases {

/// LCP from rows of M and q, with the scales of a plain problem.
inline Problem plain(const MatrixXd& M, const VectorXd& q) {
  Problem problem;
  problem.M = M;
  problem.q = q;
  set_plain_scales(problem);
  return problem;
}

inline Result solve(const std::string& solver, const Problem& problem, const Call& call = {}) {
  return make_solver(solver).solver->solve(problem, call);
}

/// The natural residual of an answer, in double.
inline double residual(const Problem& problem, const Result& result) {
  VectorXd w;
  return natural_residual(problem, result.z, w);
}

/// Cycles under the lowest-index rule (Kostreva 1979; also in drake's and QuantEcon's tests).
inline Problem kostreva() {
  MatrixXd M(3, 3);
  M << 1, 2, 0, 0, 1, 2, 2, 0, 1;
  return plain(M, VectorXd::Constant(3, -1));
}

/// Cottle, Pang, Stone, example 4.4.7: z = (0, 1, 3) after five pivots.
inline Problem example_4_4_7() {
  MatrixXd M(3, 3);
  M << 0, -1, 2, 2, 0, -2, -1, 1, 0;
  return plain(M, Eigen::Vector3d(-3, 6, -1));
}

/// Murty's exponential family: unit lower triangular, 2 below the diagonal, z = (2^n, 0, ...).
inline Problem murty(Index n) {
  MatrixXd M = MatrixXd::Identity(n, n);
  VectorXd q = VectorXd::Zero(n);
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < i; ++j) M(i, j) = 2;
    for (Index k = n - i; k <= n; ++k) q(i) -= std::ldexp(1.0, static_cast<int>(k));
  }
  Problem problem = plain(M, q);
  problem.pivot_limit = Index{1} << (n + 1);
  return problem;
}

/// Symmetric positive definite M and a q of mixed signs.
inline Problem positive_definite(Index n, unsigned seed) {
  std::mt19937_64 generator(seed);
  const auto uniform = [&generator] {
    return 2 * static_cast<double>(generator() >> 11) * 0x1p-53 - 1;
  };
  const MatrixXd A = MatrixXd::NullaryExpr(n, n, uniform);
  const VectorXd q = VectorXd::NullaryExpr(n, uniform);
  return plain(A * A.transpose() + MatrixXd::Identity(n, n), q);
}

}  // namespace lcp::cases
