#include "harness/studies/shrink/parts.h"

#include <gtest/gtest.h>

#include "problems/contact/friction_lcp.h"

namespace lcp {
namespace {

/// Four contacts of a body of 6 freedoms, the third without friction.
ContactProblem four_contacts() {
  ContactProblem problem;
  for (Index i = 0; i < 4; ++i)
    problem.contacts.push_back(make_contact({0, 0, 1}, {1, 0, 0}, i == 2 ? 0 : 0.5, {0, 1, i}));
  MatrixXd A(6, 12);
  for (Index j = 0; j < 12; ++j)
    for (Index i = 0; i < 6; ++i) A(i, j) = static_cast<double>((3 * i + 5 * j + i * j) % 11) - 5;
  problem.W = delassus_matrix(A, 1e-3);
  problem.vbar = VectorXd::LinSpaced(12, -1, 0.7);
  return problem;
}

ContactProblem only(const ContactProblem& all, const std::vector<Index>& contacts) {
  ContactProblem some;
  std::vector<Index> axes;
  for (const Index i : contacts) {
    some.contacts.push_back(all.contacts[i]);
    for (Index k = 0; k < 3; ++k) axes.push_back(3 * i + k);
  }
  some.W = all.W(axes, axes);
  some.vbar = all.vbar(axes);
  return some;
}

void expect_same(const Problem& a, const Problem& b) {
  EXPECT_EQ(a.M, b.M);
  EXPECT_EQ(a.q, b.q);
  EXPECT_EQ(a.s_z, b.s_z);
  EXPECT_EQ(a.s_w, b.s_w);
  ASSERT_EQ(a.friction.has_value(), b.friction.has_value());
  if (!a.friction) return;
  EXPECT_EQ(a.friction->W, b.friction->W);
  EXPECT_EQ(a.friction->vbar, b.friction->vbar);
  EXPECT_EQ(a.friction->mu, b.friction->mu);
  EXPECT_EQ(a.friction->directions, b.friction->directions);
  EXPECT_EQ(a.friction->directions_per_contact, b.friction->directions_per_contact);
  EXPECT_EQ(a.friction->normal_row, b.friction->normal_row);
  EXPECT_EQ(a.friction->friction_row, b.friction->friction_row);
  EXPECT_EQ(a.friction->cone_row, b.friction->cone_row);
}

TEST(Parts, FewerContactsAreTheLcpOfThoseContacts) {
  const ContactProblem all = four_contacts();
  for (const std::vector<Index>& kept : {std::vector<Index>{0, 1, 2, 3}, {1, 3}, {2}, {0, 2}})
    expect_same(keep_contacts(friction_lcp(all), kept), friction_lcp(only(all, kept)));
}

TEST(Parts, HalfTheDirectionsAreTheLcpWithHalfAsMany) {
  const ContactProblem all = four_contacts();
  const Problem four = halve_directions(friction_lcp(all, {.directions = 8}));
  expect_same(four, friction_lcp(all, {.directions = 4}));
  ASSERT_TRUE(can_halve_directions(four));
  expect_same(halve_directions(four), friction_lcp(all, {.directions = 2}));
  EXPECT_FALSE(can_halve_directions(halve_directions(four)));
  EXPECT_FALSE(can_halve_directions(frictionless_lcp(all)));
}

TEST(Parts, RowsAreAPrincipalProblemInTheSameScales) {
  const Problem whole = friction_lcp(four_contacts());
  const Problem part = restricted(whole, {0, 7, 9});
  EXPECT_EQ(part.M(1, 2), whole.M(7, 9));
  EXPECT_EQ(part.q(2), whole.q(9));
  EXPECT_EQ(part.s_w(1), whole.s_w(7));
  EXPECT_FALSE(part.friction);
}

TEST(Parts, RoundingKeepsSymmetryAndOpposites) {
  const Problem whole = frictionless_lcp(four_contacts());
  ASSERT_EQ(whole.M, whole.M.transpose());
  for (const int digits : {1, 2, 5, 16}) {
    const Problem round = round_numbers(whole, digits);
    EXPECT_EQ(round.M, round.M.transpose());
    EXPECT_LE(digits_of(round), digits);
    EXPECT_EQ(round_numbers(round, digits).M, round.M);
    EXPECT_EQ(round_numbers(whole, digits).q, round.q);
  }
  EXPECT_EQ(round_numbers(whole, 17).M, whole.M);
  EXPECT_TRUE(round_numbers(whole, 17).friction);
  EXPECT_FALSE(round_numbers(whole, 1).friction);
}

TEST(Parts, CountsTheDigitsOfTheLongestNumber) {
  Problem problem;
  problem.M = MatrixXd{{0.5, 2}, {0, 100}};
  problem.q = VectorXd{{-1, 3}};
  EXPECT_EQ(digits_of(problem), 1);
  problem.q(1) = 1.25e-7;
  EXPECT_EQ(digits_of(problem), 3);
  problem.M(0, 0) = 1.0 / 3;
  EXPECT_GE(digits_of(problem), 16);
}

}  // namespace
}  // namespace lcp
