#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "problems/contact/friction_lcp.h"

namespace lcp::cases {

/// Uniform numbers in [-1, 1), the same with every standard library.
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : generator_(seed) {}
  double operator()() { return std::ldexp(static_cast<double>(generator_() >> 11), -52) - 1; }
  double between(double low, double high) { return low + (high - low) * ((*this)() + 1) / 2; }

 private:
  std::mt19937_64 generator_;
};

/// Contacts on a floor, one feature of body 1 each.
inline std::vector<Contact> floor_contacts(const std::vector<double>& mu) {
  std::vector<Contact> contacts;
  for (const double value : mu)
    contacts.push_back(make_contact(Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX(), value,
                                    {1, 0, static_cast<Index>(contacts.size())}));
  return contacts;
}

/// One contact whose axes do not influence one another: W = 0.5 I.
inline ContactProblem particle(double mu, const Eigen::Vector3d& vbar) {
  ContactProblem problem;
  problem.contacts = floor_contacts({mu});
  problem.W = 0.5 * MatrixXd::Identity(3, 3);
  problem.vbar = vbar;
  return problem;
}

/// Contacts with eigenvalues of W spread over [1, condition] and velocities in [-1, 1).
inline ContactProblem random_contacts(const std::vector<double>& mu, double condition,
                                      Uniform& uniform) {
  ContactProblem problem;
  problem.contacts = floor_contacts(mu);
  const Index n = 3 * problem.size();
  const MatrixXd noise = MatrixXd::NullaryExpr(n, n, [&uniform] { return uniform(); });
  const MatrixXd Q = noise.householderQr().householderQ();
  const VectorXd eigenvalues =
      VectorXd::NullaryExpr(n, [&] { return std::exp(uniform.between(0, std::log(condition))); });
  const MatrixXd root = Q * eigenvalues.cwiseSqrt().asDiagonal();
  problem.W = MatrixXd::Zero(n, n);
  problem.W.selfadjointView<Eigen::Lower>().rankUpdate(root);
  problem.W.triangularView<Eigen::StrictlyUpper>() = problem.W.transpose();
  problem.vbar = VectorXd::NullaryExpr(n, [&uniform] { return uniform(); });
  return problem;
}

/// max_i |min(z_i / s_z,i, w_i / s_w,i)|, one row at a time.
inline double natural_residual(const Problem& problem, const VectorXd& z) {
  double residual = 0;
  for (Index i = 0; i < problem.size(); ++i) {
    const double w = problem.M.row(i).dot(z) + problem.q(i);
    residual = std::max(residual, std::abs(std::min(z(i) / problem.s_z(i), w / problem.s_w(i))));
  }
  return residual;
}

}  // namespace lcp::cases
