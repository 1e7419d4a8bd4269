#pragma once

#include <gtest/gtest.h>

#include <cstring>

#include "problems/instance.h"

namespace lcp {

inline void expect_same_bits(const MatrixXd& one, const MatrixXd& two, const char* what) {
  ASSERT_EQ(one.rows(), two.rows()) << what;
  ASSERT_EQ(one.cols(), two.cols()) << what;
  const std::size_t bytes = sizeof(double) * static_cast<std::size_t>(one.size());
  const bool same = bytes == 0 || std::memcmp(one.data(), two.data(), bytes) == 0;
  EXPECT_TRUE(same) << what << " is\n" << two << "\nexpected\n" << one;
}

inline void expect_same(const FrictionBlocks& one, const FrictionBlocks& two) {
  expect_same_bits(one.W, two.W, "W");
  expect_same_bits(one.vbar, two.vbar, "vbar");
  expect_same_bits(one.mu, two.mu, "mu");
  expect_same_bits(one.directions, two.directions, "directions");
  EXPECT_EQ(one.directions_per_contact, two.directions_per_contact);
  EXPECT_EQ(one.normal_row, two.normal_row);
  EXPECT_EQ(one.friction_row, two.friction_row);
  EXPECT_EQ(one.cone_row, two.cone_row);
}

/// The same instance, to the last bit and the sign of zeros.
inline void expect_same(const Instance& one, const Instance& two) {
  EXPECT_EQ(one.name, two.name);
  EXPECT_EQ(one.sha256, two.sha256);
  EXPECT_EQ(one.provenance, two.provenance);
  EXPECT_EQ(one.active_contacts, two.active_contacts);
  ASSERT_EQ(one.known_solution.has_value(), two.known_solution.has_value());
  if (one.known_solution) expect_same_bits(*one.known_solution, *two.known_solution, "solution");
  ASSERT_EQ(one.previous.has_value(), two.previous.has_value());
  if (one.previous) {
    EXPECT_EQ(one.previous->alpha, two.previous->alpha);
    expect_same_bits(one.previous->z, two.previous->z, "previous z");
  }
  expect_same_bits(one.problem.M, two.problem.M, "M");
  expect_same_bits(one.problem.q, two.problem.q, "q");
  expect_same_bits(one.problem.s_z, two.problem.s_z, "s_z");
  expect_same_bits(one.problem.s_w, two.problem.s_w, "s_w");
  expect_same_bits(one.problem.c, two.problem.c, "c");
  EXPECT_EQ(one.problem.pivot_limit, two.problem.pivot_limit);
  ASSERT_EQ(one.problem.friction.has_value(), two.problem.friction.has_value());
  if (one.problem.friction) expect_same(*one.problem.friction, *two.problem.friction);
}

}  // namespace lcp
