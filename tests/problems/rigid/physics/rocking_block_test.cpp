// Housner's block rocks from edge to edge: at each impact the angular momentum about the new edge
// stays, and with it the rate falls by 1 - 1.5 sin^2(alpha), where alpha is the angle between the
// diagonal and the height. G. W. Housner, Bull. Seismol. Soc. Am. 53 (1963), 403-417.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/problems/rigid/simulation_cases.h"

namespace lcp {
namespace {

using cases::record;
using Scheme = Stepping::Scheme;

constexpr double kDiagonal = 0.5;  // m, from the edge to the centre

/// A block with alpha that turns about its left edge, down onto the right one; tilted by `tilt`.
System block(double alpha, double tilt, double rate) {
  const Vector3d edges(2 * kDiagonal * std::sin(alpha), 0.3, 2 * kDiagonal * std::cos(alpha));
  System system = cases::one_body(
      cases::free_box(3, edges),
      cases::points_on_plane(cases::lower_corners(edges), Vector3d::UnitZ(), 1e-6), 10);
  // About y the right edge goes down with positive rates; the left one, at the origin, rests.
  const Eigen::AngleAxisd turn(-tilt, Vector3d::UnitY());
  const Vector3d centre = turn * Vector3d(edges.x() / 2, 0, edges.z() / 2);
  const Vector3d omega(0, rate, 0);
  system.start.q.head<3>() = centre;
  system.start.q.segment<4>(3) = Eigen::Quaterniond(turn).coeffs();
  system.start.u << omega, omega.cross(centre);
  return system;
}

/// Every LCP begins from the empty basis: from the normals that are active without friction (those of
/// the left edge, which lifts) the search ends without an answer from 40 degrees on.
Stepping stepping(Scheme scheme) {
  return {.scheme = scheme,
          .dt = 1e-4,
          .contact = {.friction = {}, .start = ContactModel::Start::cold}};
}

double housner(double alpha) { return 1 - 1.5 * std::pow(std::sin(alpha), 2); }

TEST(RockingBlock, LosesRateAsHousnerSaysWhenBothEdgesTouchAtOnce) {
  for (const double mu : {10.0, 30.0}) {
    for (const double degrees : {10.0, 20.0, 30.0, 45.0}) {
      const double alpha = degrees / 180 * std::numbers::pi;
      System system = block(alpha, 0, 1);
      system.mu = mu;
      system.gravity.setZero();
      Simulation simulation(system, stepping(Scheme::semi_implicit));
      simulation.step(cases::solver_in_the_loop(), [](const Frame& frame) {
        EXPECT_EQ(frame.contacts.size(), 4);
        EXPECT_EQ(frame.solution.applied, Applied::frictional);
      });
      EXPECT_NEAR(record("ratio", simulation.state().u(1)), housner(alpha), 1e-9) << degrees;
      EXPECT_NEAR(simulation.state().u(0), 0, 1e-9);
      EXPECT_NEAR(simulation.state().u(2), 0, 1e-9);
    }
  }
}

TEST(RockingBlock, LosesRateAsHousnerSaysWhenItFallsOntoItsOtherEdge) {
  for (const Scheme scheme : {Scheme::paper, Scheme::semi_implicit}) {
    for (const double degrees : {15.0, 25.0}) {
      const double alpha = degrees / 180 * std::numbers::pi;
      const System system = block(alpha, 0.01, 1.5);
      Simulation simulation(system, stepping(scheme));
      double before = 0, after = 0;
      const Index failures =
          cases::run(simulation, 0.02, cases::solver_in_the_loop(), [&](const Frame& frame) {
            const bool right_edge = std::any_of(
                frame.points.begin(), frame.points.end(),
                [](const ContactPoint& p) { return p.id.feature == 0 || p.id.feature == 3; });
            if (!right_edge && after == 0) before = frame.state.u(1);
            if (right_edge && before > 0 && frame.points.size() == 2 && after == 0)
              after = frame.state.u(1);
          });
      EXPECT_EQ(failures, 0);
      EXPECT_GT(before, 1);
      EXPECT_NEAR(record("ratio", after / before), housner(alpha), 0.01) << degrees;
    }
  }
}

TEST(RockingBlock, ABroadBlockStopsSinceItCannotGoOnTurning) {
  // tan(alpha) > sqrt(2): 1 - 1.5 sin^2 < 0, and the left edge may not go down.
  System system = block(60.0 / 180 * std::numbers::pi, 0, 1);
  Simulation simulation(system, stepping(Scheme::semi_implicit));
  simulation.step(cases::solver_in_the_loop());
  // What is left is the acceleration of the edges before the impact, times dt: rate^2 diagonal dt.
  EXPECT_LE(record("speed", simulation.state().u.norm()), 1.01e-4 * kDiagonal);
}

}  // namespace
}  // namespace lcp
