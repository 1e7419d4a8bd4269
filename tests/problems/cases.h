#pragma once

#include "problems/instance.h"

namespace lcp::cases {

/// first, first + step, ...: exact where both are short binary fractions.
inline VectorXd steps(Index size, double first, double step) {
  return VectorXd::NullaryExpr(size, [=](Index i) { return first + double(i) * step; });
}

/// A problem of n = 2 with the numbers that files lose first, and everything optional set.
inline Problem plain_with_all_options() {
  Problem problem;
  problem.M = MatrixXd{{1.0 / 3, -2e-310}, {0.1, 1.7e308}};
  problem.q = VectorXd{{-1, 5e-324}};
  problem.s_z = VectorXd{{0.3, 7}};
  problem.s_w = VectorXd{{1e-9, 2}};
  problem.c = VectorXd{{1, 2.5}};
  problem.pivot_limit = 17;
  return problem;
}

/// Two contacts, four directions, the second without friction: n = 2 + 4 + 1. The numbers fill every
/// field; they are no contact LCP.
inline Problem with_contacts() {
  Problem problem;
  problem.M =
      MatrixXd::NullaryExpr(7, 7, [](Index i, Index j) { return 1.0 / double(1 + i + 2 * j); });
  problem.q = steps(7, -1, 0.5);
  problem.s_z = steps(7, 1, 0.25);
  problem.s_w = steps(7, 0.125, 0.125);
  FrictionBlocks& blocks = problem.friction.emplace();
  blocks.W = MatrixXd::NullaryExpr(
      6, 6, [](Index i, Index j) { return i == j ? 0.7 : 0.01 * double(i * j); });
  blocks.W(0, 1) = -0.0;
  blocks.vbar = steps(6, -0.5, 0.25);
  blocks.mu = VectorXd{{0.6, 0}};
  blocks.directions = MatrixXd{{1, 0, -1, 0, 1, 0, -1, 0}, {0, 1, 0, -1, 0, 1, 0, -1}};
  blocks.directions_per_contact = 4;
  blocks.normal_row = {0, 1};
  blocks.friction_row = {2, -1};
  blocks.cone_row = {6, -1};
  return problem;
}

/// A 3 x 3 problem with plain scales and an unsymmetric M.
inline Problem plain() {
  Problem problem;
  problem.M = MatrixXd{{4, -1.0 / 3, 0}, {0.1, 5, 1e-7}, {0, 1e22, 3}};
  problem.q = VectorXd{{-1, 0.7, -2.0 / 7}};
  set_plain_scales(problem);
  return problem;
}

/// A solution of the frame before for it; -0 is there to be kept.
inline Start previous_of_contacts() {
  return {.alpha = {0, 6}, .z = VectorXd{{1.0 / 3, 0, -0.0, 0, 0, 0, 2e-300}}};
}

}  // namespace lcp::cases
