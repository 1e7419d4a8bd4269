#include "problems/features.h"

#include <gtest/gtest.h>

#include "tests/problems/cases.h"

namespace lcp {
namespace {

Problem problem_of(const MatrixXd& M, const VectorXd& q) {
  Problem problem;
  problem.M = M;
  problem.q = q;
  set_plain_scales(problem);
  return problem;
}

TEST(Features, CountWhatIsSeenByEye) {
  const Features found =
      features(problem_of(MatrixXd{{4, 1, 0}, {0, 2, 0}, {0, 0, 0}}, VectorXd{{-1, -1, 3}}));
  EXPECT_EQ(found.n, 3);
  EXPECT_EQ(found.contacts, 0);
  EXPECT_DOUBLE_EQ(found.asymmetry, 0.25);
  EXPECT_DOUBLE_EQ(found.density, 3.0 / 9);
  EXPECT_EQ(found.tied_q, 2);
  EXPECT_EQ(found.rank, 2);
}

TEST(Features, ConditionComparesTheSingularValuesAboveTheThreshold) {
  const Problem problem = problem_of(VectorXd{{8, 2, 1e-9}}.asDiagonal(), VectorXd{{1, 2, 3}});
  EXPECT_EQ(features(problem).rank, 3);
  EXPECT_NEAR(*features(problem).condition, 8e9, 1);
  const Features coarse = features(problem, {.rank_threshold = 1e-6});
  EXPECT_EQ(coarse.rank, 2);
  EXPECT_NEAR(*coarse.condition, 4, 1e-14);
}

TEST(Features, SeeTiesOnlyWithinTheThreshold) {
  const Problem problem = problem_of(MatrixXd::Identity(3, 3), VectorXd{{-1, -1 + 1e-6, 0}});
  EXPECT_EQ(features(problem).tied_q, 1);
  EXPECT_EQ(features(problem, {.tie_threshold = 1e-5}).tied_q, 2);
}

TEST(Features, OfContactsDescribeW) {
  Problem problem = cases::with_contacts();
  problem.friction->W = VectorXd{{4, 2, 1, 0, 0, 0}}.asDiagonal();
  const Features found = features(problem);
  EXPECT_EQ(found.contacts, 2);
  EXPECT_EQ(found.rank, 3);
  EXPECT_NEAR(*found.condition, 4, 1e-14);
}

TEST(Features, HaveNoRankAboveTheLargestSize) {
  const Problem problem = problem_of(MatrixXd::Identity(3, 3), VectorXd::Ones(3));
  const Features found = features(problem, {.largest_svd = 2});
  EXPECT_FALSE(found.rank.has_value());
  EXPECT_FALSE(found.condition.has_value());
}

TEST(Features, OfZeroAndEmptyMatricesHaveNoCondition) {
  const Features zero = features(problem_of(MatrixXd::Zero(2, 2), VectorXd::Ones(2)));
  EXPECT_EQ(zero.rank, 0);
  EXPECT_FALSE(zero.condition.has_value());
  const Features empty = features(problem_of(MatrixXd(0, 0), VectorXd(0)));
  EXPECT_EQ(empty.n, 0);
  EXPECT_EQ(empty.tied_q, 0);
  EXPECT_EQ(empty.rank, 0);
}

}  // namespace
}  // namespace lcp
