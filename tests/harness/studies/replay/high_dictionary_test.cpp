#include "harness/studies/replay/high_dictionary.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/harness/studies/replay/rounded_zero.h"

namespace lcp {
namespace {

constexpr double zero = 10;

double near(const Estimate& x) { return static_cast<double>(x.value); }

TEST(QuadMatrix, InvertsAHilbertMatrixToTwentyFourDigits) {
  constexpr Index n = 8;  // condition 1.5e10
  QuadMatrix hilbert(n, n), inverse(n, n);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) hilbert(i, j) = inverse(i, j) = Quad(1) / (i + j + 1);
  ASSERT_TRUE(invert(inverse));
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j) {
      Quad sum = i == j ? -1 : 0;
      for (Index k = 0; k < n; ++k) sum += hilbert(i, k) * inverse(k, j);
      EXPECT_LT(static_cast<double>(magnitude(sum)), 1e-22);
    }
}

TEST(QuadMatrix, ExchangesRowsWhereAPivotIsZero) {
  QuadMatrix swap = QuadMatrix::Zero(2, 2);
  swap(0, 1) = 2;
  swap(1, 0) = 4;
  ASSERT_TRUE(invert(swap));
  EXPECT_EQ(static_cast<double>(swap(0, 1)), 0.25);
  EXPECT_EQ(static_cast<double>(swap(1, 0)), 0.5);
  EXPECT_EQ(static_cast<double>(swap(0, 0)), 0);
}

TEST(QuadMatrix, SaysThatASingularMatrixHasNoInverse) {
  QuadMatrix ones(2, 2);
  for (const Index i : {0, 1})
    for (const Index j : {0, 1}) ones(i, j) = 1;
  EXPECT_FALSE(invert(ones));
}

/// z_1 = (3 - w_1 - z_2) / 2 and w_2 = 1 - ... of M = (2 1; 1 3), q = (-3, 1) with z_1 basic:
/// z_1 = 1.5 + w_1 / 2 - z_2 / 2, w_2 = 2.5 + w_1 / 2 + 2.5 z_2.
TEST(HighDictionary, IsThatOfTwoRowsByHand) {
  const Problem problem = plain_problem(MatrixXd{{2, 1}, {1, 3}}, VectorXd{{-3, 1}});
  const HighProblem high(problem, false);
  const HighDictionary dictionary(high, Labels(2, {0}), zero);
  ASSERT_TRUE(dictionary.usable());
  EXPECT_EQ(near(dictionary.q()[0]), 1.5);
  EXPECT_EQ(near(dictionary.q()[1]), 2.5);
  const Estimates of_z2 = dictionary.column(dictionary.labels().z(1));
  EXPECT_EQ(near(of_z2[0]), -0.5);
  EXPECT_EQ(near(of_z2[1]), 2.5);
  const Estimates of_w1 = dictionary.column(dictionary.labels().w(0));
  EXPECT_EQ(near(of_w1[0]), 0.5);
  EXPECT_EQ(near(of_w1[1]), 0.5);
  EXPECT_EQ(near(dictionary.entries(dictionary.labels().w(0), {1})[0]), 0.5);
}

TEST(HighDictionary, WorksInTheScalesAsked) {
  Problem problem = plain_problem(MatrixXd{{2, 1}, {1, 3}}, VectorXd{{-3, 1}});
  problem.s_z = VectorXd{{2, 5}};
  problem.s_w = VectorXd{{4, 8}};
  const HighProblem high(problem, true);
  const HighDictionary dictionary(high, Labels(2, {0}), zero);
  EXPECT_DOUBLE_EQ(near(dictionary.q()[0]), 1.5 / 2);
  EXPECT_DOUBLE_EQ(near(dictionary.q()[1]), 2.5 / 8);
  EXPECT_DOUBLE_EQ(near(dictionary.column(dictionary.labels().z(1))[1]), 2.5 / 8 * 5);
}

/// (6)-(7): with c = 1 in the dictionary of alpha.
TEST(HighDictionary, HasOnesForZ0AtAStart) {
  const Problem problem = plain_problem(MatrixXd{{2, 1}, {1, 3}}, VectorXd{{-3, 1}});
  const HighProblem high(problem, false, {0});
  const HighDictionary dictionary(high, Labels(2, {0}), zero);
  for (const Estimate& entry : dictionary.column(dictionary.labels().z0()))
    EXPECT_EQ(near(entry), 1);
}

/// The dictionary in which z0 and z_1 are basic in rows 1 and 2.
HighDictionary after_two_pivots(const HighProblem& high) {
  Labels labels(3, {});
  labels.exchange({0, labels.z0()});
  labels.exchange({1, labels.z(0)});
  return {high, labels, zero};
}

TEST(HighDictionary, TellsATrueZeroFromASmallNumber) {
  const Instance exact = rounded_zero(), small = rounded_zero(-0x1p-52);
  const HighProblem of_exact(exact.problem, false), of_small(small.problem, false);
  const HighDictionary zero_there = after_two_pivots(of_exact), number = after_two_pivots(of_small);
  EXPECT_EQ(near(zero_there.column(zero_there.labels().z(1))[2]), 0);
  EXPECT_EQ(near(number.column(number.labels().z(1))[2]), -0x1p-52);
  EXPECT_EQ(near(zero_there.q()[2]), 0);
}

/// w_3 = z_1 + z_2 - 1 is 0 at z = (1, 0) for any a in M = (1 1; 1 a), q = (-1, -1). With a = 1 + 2^-52 the
/// condition is 2e16, and 113 bits leave 1e-18 of it: what the data's rounding could be as well.
TEST(HighDictionary, DoubtsAZeroThatItDoesNotResolve) {
  for (const double a : {2.0, 1 + 0x1p-52}) {
    const Problem problem =
        plain_problem(MatrixXd{{1, 1, 0}, {1, a, 0}, {1, 1, 0}}, VectorXd::Constant(3, -1));
    const HighProblem high(problem, false);
    const HighDictionary dictionary(high, Labels(3, {0, 1}), zero);
    ASSERT_TRUE(dictionary.usable());
    EXPECT_EQ(near(dictionary.q()[2]), 0);
    EXPECT_EQ(dictionary.q()[2].doubt > 0, a < 2) << a;
  }
}

TEST(HighDictionary, SaysThatASingularBasisIsNotUsable) {
  // Rank 1 in the doubles, not only up to rounding: the second row is 3 times the first.
  const Problem problem =
      plain_problem(MatrixXd{{0.1, 0.7}, {3 * 0.125, 3 * 0.875}}, VectorXd{{-1, -1}});
  const Problem singular =
      plain_problem(MatrixXd{{0.125, 0.875}, {0.375, 2.625}}, VectorXd{{-1, -1}});
  const HighProblem high_regular(problem, false), high_singular(singular, true);
  EXPECT_TRUE(HighDictionary(high_regular, Labels(2, {0, 1}), zero).usable());
  EXPECT_FALSE(HighDictionary(high_singular, Labels(2, {0, 1}), zero).usable());
}

TEST(HighDictionary, ItsErrorsBoundWhatIsKnownExactly) {
  const SolvedProblem solved = strictly_complementary(12, 5, false);
  std::vector<Index> alpha;
  for (Index i = 0; i < 12; ++i)
    if (solved.z(i) > 0) alpha.push_back(i);
  const HighProblem high(solved.problem, false);
  const HighDictionary dictionary(high, Labels(12, alpha), zero);
  ASSERT_TRUE(dictionary.usable());
  for (const Index i : alpha) {
    EXPECT_NEAR(near(dictionary.q()[i]), solved.z(i), 1e-13);
    EXPECT_GT(dictionary.q()[i].error, 0);
    EXPECT_LT(dictionary.q()[i].error, 1e-30);
  }
}

}  // namespace
}  // namespace lcp
