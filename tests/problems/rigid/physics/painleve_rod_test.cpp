// Painleve's rod slides on its lower end. A normal force a with friction mu a against the slip
// accelerates that end upwards by (1 + 3 cos^2 - 3 mu sin cos) a / m, theta being the angle to the
// floor: above mu = (1 + 3 cos^2) / (3 sin cos), 4/3 at tan(theta) = 2, it drives the end into the
// floor, and rigid bodies with Coulomb friction have no finite acceleration. At velocity level a
// step still has a solution: an impulse that ends the slip (impact without collision).
// D. E. Stewart, SIAM Review 42 (2000), 3-39.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/problems/rigid/simulation_cases.h"

namespace lcp {
namespace {

using cases::record;

constexpr double kMass = 1, kHalfLength = 0.5;
const double kCriticalMu = 4.0 / 3;

/// A thin rod at tan(theta) = 2 that leans forward, along x, over its lower end, which slides.
System rod(double mu, double speed) {
  const double cosine = 1 / std::sqrt(5), sine = 2 / std::sqrt(5);
  const double across = kMass * std::pow(kHalfLength, 2) / 3;
  Link link = cases::free_body(kMass, Vector3d(1e-3 * across, across, across).asDiagonal());
  System system = cases::one_body(
      link, cases::points_on_plane({{-kHalfLength, 0, 0}}, Vector3d::UnitZ(), 1e-6), mu);
  const Eigen::AngleAxisd turn(-std::atan2(sine, cosine), Vector3d::UnitY());
  system.start.q.head<3>() = kHalfLength * Vector3d(cosine, 0, sine);
  system.start.q.segment<4>(3) = Eigen::Quaterniond(turn).coeffs();
  system.start.u(3) = speed;
  return system;
}

/// The frame of the first step.
void first_step(double mu, double speed, const std::function<void(const Frame&)>& look) {
  Simulation simulation(rod(mu, speed), {.scheme = Stepping::Scheme::semi_implicit});
  simulation.step(cases::solver_in_the_loop(), look);
}

/// Direction in which the lower end must slide for friction to press it into the floor: that of the
/// lean, or against it.
double pressing_direction() {
  double direction = 0;
  first_step(0.1, 1, [&](const Frame& frame) { direction = frame.contacts.W(0, 1) > 0 ? 1 : -1; });
  return direction;
}

TEST(PainleveRod, NormalForcesWithFrictionPressTheEndDownAboveFourThirds) {
  const double slip = pressing_direction();
  const auto lift = [&](double mu) {  // normal velocity that a force (1, -mu slip) gives
    double found = 0;
    first_step(mu, slip, [&](const Frame& frame) {
      found = frame.contacts.W(0, 0) - mu * slip * frame.contacts.W(0, 1);
    });
    return found * kMass / 1e-3;
  };
  EXPECT_NEAR(lift(0), 1 + 3 * 0.2, 1e-9);
  EXPECT_NEAR(lift(kCriticalMu), 0, 1e-9);
  EXPECT_GT(lift(kCriticalMu - 1e-6), 0);
  EXPECT_LT(lift(kCriticalMu + 1e-6), 0);
}

TEST(PainleveRod, EveryStepHasASolutionBelowAndAboveTheCriticalFriction) {
  const double slip = pressing_direction();
  for (const double mu : {0.5, 1.2, kCriticalMu, 1.4, 2.0, 10.0}) {
    for (const double speed : {slip, -slip, 0.01 * slip}) {
      first_step(mu, speed, [&](const Frame& frame) {
        EXPECT_EQ(frame.solution.applied, Applied::frictional) << mu << " " << speed;
        const double residual =
            cases::natural_residual(frame.solution.frictional, frame.solution.with_friction.z);
        EXPECT_LE(record("residual", residual), 1e-9);
      });
    }
  }
}

TEST(PainleveRod, TheSlipEndsInOneStepAboveTheCriticalFrictionAndGoesOnBelow) {
  const double slip = pressing_direction();
  const auto slip_after = [&](double mu, double speed) {
    double found = 0;
    first_step(mu, speed, [&](const Frame& frame) {
      const VectorXd v =
          post_velocities(*frame.solution.frictional.friction, frame.solution.forces);
      EXPECT_GE(v(0), -1e-12);
      found = v(1);
    });
    return found;
  };
  EXPECT_GT(record("slip at 1.2", std::abs(slip_after(1.2, slip))), 0.5);
  EXPECT_LE(record("slip at 1.5", std::abs(slip_after(1.5, slip))), 1e-9);
  EXPECT_GT(std::abs(slip_after(1.5, -slip)), 0.5) << "the other way friction lifts the end";
}

}  // namespace
}  // namespace lcp
