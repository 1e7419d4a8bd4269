// Momentum of systems on which nothing acts from outside, while their parts press on one another,
// in the semi-implicit scheme.
//
// A pair of contact forces cancels in every step to rounding. What a step itself keeps depends on
// the bodies: Euler in u keeps a body's linear momentum where its frame is at its centre of mass, and
// its angular momentum where besides its inertia is that of a sphere. A body that tumbles, an arm on
// a joint or a frame off the centre lose dt^2 of it in a step of finite forces, and dt in the step of
// an impact, after which q moves with the new velocity.

#include <gtest/gtest.h>

#include "tests/problems/rigid/simulation_cases.h"

namespace lcp {
namespace {

using cases::record;

/// Balls of `radius` that are part of links.
struct Ball {
  Index link;
  Vector3d centre;  ///< In the link's frame.
  double radius;
};

/// Contacts between balls of different links.
auto balls_on_balls(std::vector<Ball> balls) {
  return [balls = std::move(balls)](const Kinematics& k) {
    std::vector<ContactPoint> found;
    for (std::size_t a = 0; a < balls.size(); ++a) {
      for (std::size_t b = a + 1; b < balls.size(); ++b) {
        if (balls[a].link == balls[b].link) continue;
        const Vector3d to = k.pose[balls[b].link] * balls[b].centre;
        const Vector3d between = k.pose[balls[a].link] * balls[a].centre - to;
        const double depth = balls[a].radius + balls[b].radius - between.norm();
        if (depth < 0) continue;
        const Vector3d normal = between.normalized();
        found.push_back({.position = to + (balls[b].radius - depth / 2) * normal,
                         .normal = normal,
                         .depth = depth,
                         .id = {body_of(balls[a].link), body_of(balls[b].link),
                                static_cast<Index>(balls.size() * a + b)}});
      }
    }
    return found;
  };
}

System floating(std::vector<Link> links, std::vector<Ball> balls) {
  for (std::size_t i = 0; i < links.size(); ++i) links[i].name = "link" + std::to_string(i);
  System system{.model = Model(std::move(links)), .start = {}, .handles = {}};
  system.start = state_at_zero(system.model);
  for (Index i = 0; i < system.model.size(); ++i) system.handles.push_back(i);
  system.collide = balls_on_balls(std::move(balls));
  system.gravity.setZero();
  return system;
}

/// The largest change of momentum (about the world's origin) in one step.
struct Change {
  double angular = 0, linear = 0;
  Index steps = 0;
  double pressure = 0;  ///< Largest contact force, N.
};

/// Of steps in which bodies come together, and of those in which they only press, or do not touch.
struct Changes {
  Change impact, smooth;
};

Changes largest_changes(const System& system, double dt, Index steps) {
  Simulation simulation(
      system, {.scheme = Stepping::Scheme::semi_implicit, .dt = dt, .correction = {.gain = 0}});
  const auto now = [&] {
    return momentum(system.model, kinematics(system.model, simulation.state()));
  };
  Changes changes;
  for (Index i = 0; i < steps; ++i) {
    const Vector6d before = now();
    Change* change = &changes.smooth;
    simulation.step(cases::solver_in_the_loop(), [&](const Frame& frame) {
      for (const ContactPoint& point : frame.points)
        if (point.normal_velocity < -0.01) change = &changes.impact;
      if (frame.points.empty()) return;
      EXPECT_EQ(frame.solution.applied, Applied::frictional);
      change->pressure = std::max(change->pressure, frame.solution.forces.norm());
    });
    const Vector6d lost = now() - before;
    ++change->steps;
    change->angular = std::max(change->angular, lost.head<3>().norm());
    change->linear = std::max(change->linear, lost.tail<3>().norm());
  }
  record("impact, angular", changes.impact.angular);
  record("impact, linear", changes.impact.linear);
  record("smooth, angular", changes.smooth.angular);
  record("smooth, linear", changes.smooth.linear);
  return changes;
}

TEST(Momentum, OfSpheresThatCollideIsConstantToRounding) {
  System system = floating(
      {cases::free_sphere(1, 0.1), cases::free_sphere(2, 0.15), cases::free_sphere(0.5, 0.08)},
      {{0, Vector3d::Zero(), 0.1}, {1, Vector3d::Zero(), 0.15}, {2, Vector3d::Zero(), 0.08}});
  system.start.q.segment<3>(0) = Vector3d(-0.3, 0.02, 0);
  system.start.q.segment<3>(7) = Vector3d(0.01, 0, 0.1);
  system.start.q.segment<3>(14) = Vector3d(0.2, 0, 0.05);
  system.start.u.segment<6>(0) << 3, -2, 5, 2, 0, 0.5;
  system.start.u.segment<6>(12) << 0, 4, 0, -3, 0, 0;
  const Changes changes = largest_changes(system, 1e-3, 200);
  EXPECT_GE(changes.impact.steps, 2);
  for (const Change& change : {changes.impact, changes.smooth}) {
    EXPECT_LE(change.linear, 1e-13);
    EXPECT_LE(change.angular, 1e-13);
  }
}

/// Two bodies of different moments of inertia that run into one another, turning.
System tumbling_bodies() {
  System system =
      floating({cases::free_box(1, {0.3, 0.2, 0.1}), cases::free_box(2, {0.2, 0.2, 0.4})},
               {{0, {0.1, 0.05, 0}, 0.1}, {0, {-0.1, 0, 0}, 0.1}, {1, {0, 0, 0.1}, 0.15}});
  system.start.q.segment<3>(7) = Vector3d(0.3495, 0.05, -0.1);  // 0.5 mm deep
  system.start.u.segment<6>(0) << 3, -2, 5, 2, 0, 0.5;
  system.start.u.segment<6>(6) << 1, 4, 0, -3, 0, 0;
  return system;
}

TEST(Momentum, OfTumblingBodiesIsConstantUpToTheSquareOfTheStepAndInAnImpactUpToTheStep) {
  const System system = tumbling_bodies();
  const Changes coarse = largest_changes(system, 2e-5, 20),
                fine = largest_changes(system, 1e-5, 40);
  EXPECT_GE(fine.impact.steps, 1);
  for (const Change& change : {coarse.impact, coarse.smooth, fine.impact, fine.smooth})
    EXPECT_LE(change.linear, 1e-13);
  EXPECT_LE(fine.smooth.angular, 1e-9);
  EXPECT_NEAR(record("smooth, ratio", coarse.smooth.angular / fine.smooth.angular), 4, 0.1);
  EXPECT_NEAR(record("impact, ratio", coarse.impact.angular / fine.impact.angular), 2, 0.1);
}

/// A free body whose prescribed arm pushes with a ball on the second of two links on a joint; all turn
/// together when it begins.
System arm_on_links(JointKind joint) {
  Link driver = cases::free_box(2, {0.3, 0.2, 0.2}), arm = cases::free_box(0.5, {0.3, 0.05, 0.05});
  driver.centre = {0.02, 0.03, -0.01};
  arm.parent = 0;
  arm.joint = JointKind::prescribed;
  arm.axis = Vector3d::UnitY();
  arm.in_parent.p = {0, 0, 0.1};
  arm.centre = {0.15, 0, 0};
  Link upper = cases::free_box(1, {0.1, 0.1, 0.3}), lower = upper;
  upper.centre = {0.01, 0.02, 0};
  lower.parent = 2;
  lower.joint = joint;
  lower.axis = Vector3d(1, 2, 2) / 3;
  lower.in_parent.p = {0, 0, 0.2};
  lower.centre = {0, 0, 0.1};
  System system =
      floating({driver, arm, upper, lower}, {{1, {0.3, 0, 0}, 0.05}, {3, {0, 0, 0.1}, 0.05}});
  // The arm's ball stands at (0.3, 0, 0.1); the other 0.1 mm less than both radii below it.
  constexpr double apart = 0.0999;
  const Index at = system.model.q_of(2), u = system.model.u_of(2);
  system.start.q.segment<3>(at) = Vector3d(0.31, 0.01, 0.1 - std::sqrt(apart * apart - 2e-4) - 0.3);
  const Vector3d omega(0.3, -0.2, 0.5);
  system.start.u.head<3>() = omega;
  system.start.u.segment<6>(u) << omega, omega.cross(Vector3d(system.start.q.segment<3>(at)));
  constexpr double alpha = 20;  // rad/s^2
  system.reference = [](double t) {
    return JointMotion{VectorXd{{alpha * t * t / 2}}, VectorXd{{alpha * t}}, VectorXd{{alpha}}};
  };
  return system;
}

class ArmOnLinks : public testing::TestWithParam<JointKind> {};

TEST_P(ArmOnLinks, KeepTheirMomentumUpToTheSquareOfTheStepWhileOnePressesOnTheOther) {
  const System system = arm_on_links(GetParam());
  const Changes coarse = largest_changes(system, 2e-5, 20),
                fine = largest_changes(system, 1e-5, 40);
  EXPECT_EQ(fine.impact.steps, 0);
  EXPECT_GT(record("pressure, N", fine.smooth.pressure), 0.1);
  EXPECT_LE(fine.smooth.linear, 1e-9);
  EXPECT_LE(fine.smooth.angular, 1e-9);
  EXPECT_NEAR(record("linear, ratio", coarse.smooth.linear / fine.smooth.linear), 4, 0.2);
  EXPECT_NEAR(record("angular, ratio", coarse.smooth.angular / fine.smooth.angular), 4, 0.2);
}

INSTANTIATE_TEST_SUITE_P(Momentum, ArmOnLinks,
                         testing::Values(JointKind::revolute, JointKind::ball),
                         [](const auto& each) {
                           return each.param == JointKind::ball ? "OnABall" : "OnAHinge";
                         });

}  // namespace
}  // namespace lcp
