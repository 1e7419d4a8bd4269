// A sphere on a plane: sliding goes over into rolling, falling into rest.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/problems/rigid/simulation_cases.h"

namespace lcp {
namespace {

using cases::kGravity;
using cases::record;
using Eigen::Vector2d;
using Scheme = Stepping::Scheme;

constexpr double kRadius = 0.1;  // m

/// Over the floor z = 0; touches at its lowest point, also from `reach` above.
System sphere(double mu, double height, double reach = 0) {
  System system = cases::one_body(
      cases::free_sphere(1.5, kRadius),
      [reach](const Kinematics& k) {
        const double depth = kRadius - k.pose[0].p.z();
        std::vector<ContactPoint> found;
        if (depth >= -reach)
          found.push_back({.position = k.pose[0].p - kRadius * Vector3d::UnitZ(),
                           .normal = Vector3d::UnitZ(),
                           .depth = depth,
                           .id = {body_of(0), 0, 0}});
        return found;
      },
      mu);
  system.start.q(2) = kRadius + height;
  return system;
}

/// Velocity of the point that touches.
Vector2d slip(const State& state) {
  const Vector3d omega = state.u.head<3>(), v = state.u.tail<3>();
  return (v + omega.cross(-kRadius * Vector3d::UnitZ())).head<2>();
}

TEST(Sphere, SlidesUntilItRollsWithFiveSeventhsOfItsSpeed) {
  constexpr double mu = 0.3, v0 = 1;
  const double rolls_at = 2 * v0 / (7 * mu * kGravity);  // 97 ms
  for (const Scheme scheme : {Scheme::paper, Scheme::semi_implicit}) {
    for (const double heading : {0.0, 0.4}) {  // rad, across the world's axes
      System system = sphere(mu, 0, 1e-6);
      const Vector2d along(std::cos(heading), std::sin(heading));
      system.start.u.segment<2>(3) = v0 * along;
      Simulation simulation(system, {.scheme = scheme,
                                     .dt = 5e-4,
                                     .contact = {.friction = {.axes = FrictionModel::Axes::slip}}});
      double slid_until = 0;
      const Index failures =
          cases::run(simulation, 1.1 * rolls_at, cases::solver_in_the_loop(), [&](const Frame& f) {
            if (slip(f.state).norm() > 1e-3 * v0) slid_until = f.state.time;
          });
      EXPECT_EQ(failures, 0);
      const State& end = simulation.state();
      EXPECT_NEAR(record("rolls at, s", slid_until), rolls_at, 0.01 * rolls_at);
      const double speed = record("speed", end.u.segment<2>(3).dot(along));
      EXPECT_NEAR(speed, 5.0 / 7 * v0, 0.01 * v0);
      // `paper` holds forces where they were while the sphere rolls on.
      const double slipping = scheme == Scheme::paper ? 1e-4 : 1e-9;
      EXPECT_LE(record("slip", slip(end).norm()), slipping * v0) << "and rolls on";
    }
  }
}

/// What a fall onto the floor does.
struct Fall {
  double deepest = 0;  ///< m.
  double rebound = 0;  ///< m/s, upwards after the first step in contact.
  double after = 0;    ///< m, depth one step after that.
};

Fall fall(double speed, double height, double dt, Scheme scheme, double gain) {
  System system = sphere(0.5, height);
  system.start.u(5) = -speed;
  Simulation simulation(system, {.scheme = scheme, .dt = dt, .correction = {.gain = gain}});
  Fall found;
  bool touched = false;
  for (Index i = 0; i < 40; ++i) {
    bool touches = false;
    simulation.step(cases::solver_in_the_loop(),
                    [&](const Frame& frame) { touches = !frame.points.empty(); });
    const double depth = kRadius - simulation.state().q(2);
    found.deepest = std::max(found.deepest, depth);
    if (!touches || touched) continue;
    touched = true;
    found.rebound = simulation.state().u(5);
    found.after = depth;
  }
  EXPECT_TRUE(touched);
  return found;
}

TEST(Drop, EndsTheApproachInTheStepInWhichItIsSeen) {
  for (const Scheme scheme : {Scheme::paper, Scheme::semi_implicit})
    EXPECT_NEAR(fall(1, 0.0123, 1e-3, scheme, 0).rebound, 0, 1e-12);
}

TEST(Drop, RisesBySoMuchAStepAsTheCorrectionTakesBack) {
  constexpr double dt = 1e-3, gain = 0.005;
  const Fall found = fall(1, 0.0123, dt, Scheme::semi_implicit, gain);
  const double when_seen = found.after + dt * found.rebound;
  EXPECT_NEAR(found.rebound, gain * when_seen / dt, 1e-12);
}

TEST(Drop, SinksNoDeeperThanOneAndAHalfStepsOfTheFall) {
  for (const double speed : {0.1, 1.0, 3.0}) {
    for (const double dt : {1e-3, 1e-2}) {
      for (double share = 0.001; share < 1; share += 0.111) {
        // The sphere is this share of a step above the floor when it is looked at for the last time.
        const double height = share * speed * dt;
        const double paper = fall(speed, height, dt, Scheme::paper, 0).deepest;
        const double semi_implicit = fall(speed, height, dt, Scheme::semi_implicit, 0).deepest;
        EXPECT_LE(paper, 1.5 * (speed + 2 * kGravity * dt) * dt) << speed << " " << dt;
        EXPECT_LE(semi_implicit, (speed + 2 * kGravity * dt) * dt) << speed << " " << dt;
        EXPECT_GT(paper, semi_implicit) << speed << " " << dt << " " << share;
      }
    }
  }
}

TEST(Drop, AtOneMetrePerSecondAndOneMillisecondPaperSinksHalfAStepDeeper) {
  const double paper = record("paper, mm", 1e3 * fall(1, 1e-9, 1e-3, Scheme::paper, 0.005).deepest);
  const double semi_implicit =
      record("semi-implicit, mm", 1e3 * fall(1, 1e-9, 1e-3, Scheme::semi_implicit, 0.005).deepest);
  EXPECT_NEAR(paper, 1.51, 0.005);
  EXPECT_NEAR(semi_implicit, 1.01, 0.005);
}

}  // namespace
}  // namespace lcp
