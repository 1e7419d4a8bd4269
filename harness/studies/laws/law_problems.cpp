#include "harness/studies/laws/law_problems.h"

#include <random>

#include "problems/contact/contact_problem.h"
#include "problems/contact/friction_lcp.h"

namespace lcp {

namespace {

/// Uniform in (-1, 1) from the upper 53 bits: the standard library's distributions differ between
/// implementations.
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : random_(seed) {}
  double operator()() { return 2 * (static_cast<double>(random_() >> 11) + 0.5) * 0x1p-53 - 1; }

 private:
  std::mt19937_64 random_;
};

/// A mass point that slides into the corner of floor and wall: two contacts, W = dt/m A A'.
Problem point_in_corner() {
  const double mass = 2, dt = 1e-3, mu = 0.5;
  const Eigen::Vector3d x(1, 0, 0), y(0, 1, 0), up(0, 0, 1);
  ContactProblem problem;
  problem.contacts = {make_contact(up, x, mu, {0, 1, 0}), make_contact(x, y, mu, {0, 1, 1})};
  const MatrixXd A = contact_axes(problem.contacts);
  problem.dt = dt;
  problem.W = dt / mass * A * A.transpose();
  problem.vbar = A * Eigen::Vector3d(-0.3, 0.2, -0.5);
  return friction_lcp(problem);
}

}  // namespace

Problem plain_problem(MatrixXd M, VectorXd q) {
  Problem problem;
  problem.M = std::move(M);
  problem.q = std::move(q);
  set_plain_scales(problem);
  return problem;
}

SolvedProblem strictly_complementary(Index n, std::uint64_t seed, bool symmetric) {
  Uniform uniform(seed);
  const auto draw = [&] { return uniform(); };
  const MatrixXd A = MatrixXd::NullaryExpr(n, n, draw);
  const MatrixXd B = MatrixXd::NullaryExpr(n, n, draw);
  MatrixXd M = A * A.transpose() / static_cast<double>(n) + MatrixXd::Identity(n, n);
  if (!symmetric) M += (B - B.transpose()) / 2;
  VectorXd z = VectorXd::Zero(n), w = VectorXd::Zero(n);
  for (Index i = 0; i < n; ++i) {
    const double size = 1.5 + uniform() / 2;
    (uniform() < 0 ? z : w)(i) = size;
  }
  const VectorXd q = w - M * z;
  return {plain_problem(std::move(M), q), z};
}

SolvedProblem permuted(const SolvedProblem& solved, const std::vector<Index>& order) {
  const MatrixXd M = solved.problem.M(order, order);
  const VectorXd q = solved.problem.q(order);
  return {plain_problem(M, q), solved.z(order)};
}

std::vector<NamedProblem> sample_problems() {
  const MatrixXd ones = MatrixXd::Ones(2, 2);
  const MatrixXd bimatrix{{0, 0, 10, 20}, {0, 0, 30, 15}, {10, 20, 0, 0}, {30, 15, 0, 0}};
  return {
      {"P-matrix", strictly_complementary(12, 1, false).problem},
      {"symmetric positive definite", strictly_complementary(12, 2, true).problem},
      {"degenerate (Cottle, Pang, Stone 4.1.14)", plain_problem(ones, VectorXd::Constant(2, -1))},
      {"secondary ray (Cottle, Pang, Stone 4.4.23)",
       plain_problem(bimatrix, VectorXd::Constant(4, -1))},
      {"infeasible", plain_problem(-MatrixXd::Ones(1, 1), VectorXd::Constant(1, -1))},
      {"contact", point_in_corner()},
  };
}

}  // namespace lcp
