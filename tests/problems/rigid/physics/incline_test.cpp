// A block on an incline under pyramids of M directions that stand fixed. The plane stays level and
// gravity leans: by alpha, towards an angle phi from c_0, 0 <= phi <= pi/M.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "tests/problems/rigid/simulation_cases.h"

namespace lcp {
namespace {

using cases::kGravity;
using Eigen::Vector2d;

constexpr double kMu = 0.5;
constexpr double kTime = 0.05;  // s

Vector2d direction(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// The polygon mu conv{c_m} cos(alpha) can hold the pull sin(alpha) up to this tan(alpha).
double steepest_hold(double half_angle, double phi) {
  return kMu * std::cos(half_angle) / std::cos(half_angle - phi);
}

/// Acceleration of a block that slides. Friction is the point of the polygon that does the most
/// work against the slip: a corner c_0 while the slip stays within pi/M of it; else a point of the
/// edge between two corners, and the slip goes along the bisector of these.
Vector2d sliding(double alpha, double half_angle, double phi) {
  const double s = std::sin(alpha), c = std::cos(alpha);
  if (s * std::sin(half_angle - phi) >= kMu * std::sin(half_angle) * c)
    return kGravity * (s * direction(phi) - kMu * c * direction(0));
  return kGravity * (s * std::cos(half_angle - phi) - kMu * std::cos(half_angle) * c) *
         direction(half_angle);
}

/// Velocity of a block after kTime on the incline, from rest.
VectorXd velocity_after(double alpha, Index directions, double phi, Stepping::Scheme scheme) {
  const Vector3d edges(0.2, 0.15, 0.04);
  System system = cases::one_body(
      cases::free_box(2, edges),
      cases::points_on_plane(cases::lower_corners(edges), Vector3d::UnitZ(), 1e-6), kMu);
  system.start.q(2) = edges.z() / 2;
  system.gravity << std::sin(alpha) * direction(phi), -std::cos(alpha);
  system.gravity *= kGravity;
  Simulation simulation(system,
                        {.scheme = scheme, .contact = {.friction = {.directions = directions}}});
  EXPECT_EQ(cases::run(simulation, kTime, cases::solver_in_the_loop()), 0);
  return simulation.state().u;
}

class BlockOnAnIncline : public testing::TestWithParam<std::tuple<Index, double>> {
 protected:
  const Index directions_ = std::get<0>(GetParam());
  const double half_angle_ = std::numbers::pi / static_cast<double>(directions_);
  const double phi_ = std::get<1>(GetParam()) * half_angle_;
};

TEST_P(BlockOnAnIncline, SticksBelowTheAngleThatThePolygonHolds) {
  for (const double share : {0.5, 0.99}) {
    const double alpha = std::atan(share * steepest_hold(half_angle_, phi_));
    const VectorXd u = velocity_after(alpha, directions_, phi_, Stepping::Scheme::semi_implicit);
    EXPECT_LE(cases::record("speed", u.norm()), 1e-9) << share;
  }
}

TEST_P(BlockOnAnIncline, SlidesAboveItAsThePolygonLetsIt) {
  for (const double share : {1.01, 1.5, 4.0}) {
    const double alpha = std::atan(share * steepest_hold(half_angle_, phi_));
    const Vector2d expected = kTime * sliding(alpha, half_angle_, phi_);
    const VectorXd u = velocity_after(alpha, directions_, phi_, Stepping::Scheme::semi_implicit);
    EXPECT_LE(cases::record("velocity", (Vector2d(u.segment<2>(3)) - expected).norm()),
              1e-9 * expected.norm())
        << share << " of the steepest hold";
    EXPECT_LE(u.head<3>().norm(), 1e-9) << "it does not turn";

    // Forces that are held where they were while the block moves on turn it a little.
    const VectorXd held = velocity_after(alpha, directions_, phi_, Stepping::Scheme::paper);
    EXPECT_LE(cases::record("velocity, paper", (Vector2d(held.segment<2>(3)) - expected).norm()),
              0.01 * expected.norm());
    EXPECT_LE(cases::record("turning, rad/s, paper", held.head<3>().norm()), 1e-3);
  }
}

INSTANTIATE_TEST_SUITE_P(FourEightAndSixteenDirections, BlockOnAnIncline,
                         testing::Combine(testing::Values(4, 8, 16),
                                          testing::Values(0, 0.5, 0.8, 1)));

TEST(Incline, SlidesStraightDownOnlyAlongADirectionOrMidwayBetweenTwo) {
  constexpr double half = std::numbers::pi / 8;
  const double alpha = std::atan(1.2 * kMu);
  const auto off_downhill = [&](double phi) {
    const Vector2d u = velocity_after(alpha, 8, phi, Stepping::Scheme::semi_implicit).segment<2>(3);
    return std::abs(std::atan2(u.y(), u.x()) - phi);
  };
  EXPECT_LE(off_downhill(0), 1e-9);
  EXPECT_LE(off_downhill(half), 1e-9);
  EXPECT_GE(off_downhill(0.5 * half), 0.05);
}

TEST(Incline, SlidesAsTheSmoothConeSaysWhenDirectionsFollowTheSlip) {
  // The first direction is the slip's own: g (sin - mu cos) straight down for any phi.
  const Vector3d edges(0.2, 0.15, 0.04);
  System system = cases::one_body(
      cases::free_box(2, edges),
      cases::points_on_plane(cases::lower_corners(edges), Vector3d::UnitZ(), 1e-6), kMu);
  system.start.q(2) = edges.z() / 2;
  const double alpha = std::atan(1.2 * kMu), phi = 0.3;
  system.gravity << std::sin(alpha) * direction(phi), -std::cos(alpha);
  system.gravity *= kGravity;
  system.start.u.segment<2>(3) = 0.1 * direction(phi);
  Simulation simulation(system, {.scheme = Stepping::Scheme::semi_implicit,
                                 .contact = {.friction = {.axes = FrictionModel::Axes::slip}}});
  EXPECT_EQ(cases::run(simulation, kTime, cases::solver_in_the_loop()), 0);
  const double speed = 0.1 + kTime * kGravity * (std::sin(alpha) - kMu * std::cos(alpha));
  EXPECT_LE((Vector2d(simulation.state().u.segment<2>(3)) - speed * direction(phi)).norm(), 1e-9);
}

}  // namespace
}  // namespace lcp
