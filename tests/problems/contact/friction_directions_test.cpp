#include "problems/contact/friction_directions.h"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/problems/contact/contact_cases.h"

namespace lcp {
namespace {

/// Counterclockwise angle from direction `first` to `second`, in [0, 2 pi).
double angle_between(const Eigen::Vector2d& first, const Eigen::Vector2d& second) {
  const double angle =
      std::atan2(first.x() * second.y() - first.y() * second.x(), first.dot(second));
  return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

void expect_regular(const MatrixXd& directions, Index m) {
  for (Index k = 0; k < m; ++k) {
    EXPECT_NEAR(directions.col(k).norm(), 1, 4e-16);
    EXPECT_NEAR(angle_between(directions.col(k), directions.col((k + 1) % m)),
                2 * std::numbers::pi / static_cast<double>(m), 1e-14)
        << "after direction " << k << " of " << m;
    EXPECT_EQ(directions.col((k + m / 2) % m), -directions.col(k)) << k << " of " << m;
  }
}

TEST(FrictionDirections, AscendFromTheFirstTangentInEqualSteps) {
  const ContactProblem problem = cases::particle(0.5, {-1, 0.3, 0});
  for (const Index m : {2, 4, 6, 8, 10, 16}) {
    const MatrixXd directions = friction_directions(problem, {.directions = m});
    ASSERT_EQ(directions.cols(), m);
    EXPECT_EQ(directions.col(0), Eigen::Vector2d(1, 0));
    expect_regular(directions, m);
  }
}

TEST(FrictionDirections, EighthsOfATurnAreExact) {
  const MatrixXd directions = friction_directions(cases::particle(0.5, {0, 0, 0}), {});
  EXPECT_EQ(directions.col(2), Eigen::Vector2d(0, 1));
  EXPECT_EQ(directions(0, 1), directions(1, 1));
  EXPECT_EQ(directions(0, 3), -directions(1, 3));
}

TEST(FrictionDirections, FollowTheSlipVelocityOnlyWhereAContactSlides) {
  ContactProblem problem;
  problem.contacts = cases::floor_contacts({0.5, 0.5});
  problem.v_before = VectorXd{{0, -0.3, 0.4, 0, 3e-4, 4e-4}};
  const MatrixXd directions =
      friction_directions(problem, {.axes = FrictionModel::Axes::slip, .slip_threshold = 1e-3});
  EXPECT_NEAR((directions.col(0) - Eigen::Vector2d(-0.6, 0.8)).norm(), 0, 1e-15);
  expect_regular(directions.leftCols(8), 8);
  EXPECT_EQ(directions.col(8), Eigen::Vector2d(1, 0));
}

TEST(FrictionDirections, RefuseWhatHasNoOpposites) {
  const ContactProblem problem = cases::particle(0.5, {0, 0, 0});
  EXPECT_THROW(friction_directions(problem, {.directions = 7}), std::invalid_argument);
  EXPECT_THROW(friction_directions(problem, {.directions = 0}), std::invalid_argument);
}

TEST(FrictionDirections, RefuseSlipAxesWithoutAStartVelocity) {
  EXPECT_THROW(
      friction_directions(cases::particle(0.5, {0, 0, 0}), {.axes = FrictionModel::Axes::slip}),
      std::invalid_argument);
}

}  // namespace
}  // namespace lcp
