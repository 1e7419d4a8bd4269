// Swinging without contacts: the order of the `paper` scheme, which is RK4 there.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/problems/rigid/simulation_cases.h"

namespace lcp {
namespace {

using cases::record;

/// A rod of 0.5 m and 1 kg that hangs from its end on a hinge about y; heavier at the end.
Link rod(Index parent, const Vector3d& axis = Vector3d::UnitY()) {
  Link link;
  link.parent = parent;
  link.joint = JointKind::revolute;
  link.axis = axis.normalized();
  if (parent != Link::world) link.in_parent.p = {0, 0, -0.5};
  link.mass = 1;
  link.centre = {0, 0, -0.3};
  link.inertia = cases::box_inertia(1, {0.02, 0.03, 0.5});
  return link;
}

System hanging(std::vector<Link> links) {
  Model model(std::move(links));
  State start = state_at_zero(model);
  return {.model = std::move(model), .start = std::move(start), .handles = {}};
}

State at(const System& system, double time, Index steps) {
  Simulation simulation(system, {.dt = time / static_cast<double>(steps)});
  for (Index i = 0; i < steps; ++i) simulation.step({});
  return simulation.state();
}

/// How much smaller the error of q after `time` is when dt halves, against a run at dt/16. Near times
/// at which the leading error passes zero dt must be smaller for 16 to show: at 1 s the double
/// pendulum below gives 12.5, 14.4, 15.3 for 200, 400, 800 steps.
double ratio_when_dt_halves(const System& system, double time, Index steps) {
  const VectorXd fine = at(system, time, 16 * steps).q;
  return (at(system, time, steps).q - fine).norm() / (at(system, time, 2 * steps).q - fine).norm();
}

double energy_of(const System& system, const State& state) {
  return energy(system.model, kinematics(system.model, state), system.gravity);
}

/// Energy lost or won over a run, relative to the kinetic energy it takes to fall 1 m.
double energy_error(const System& system, double time, Index steps) {
  const double scale = system.model.mass() * cases::kGravity;
  return std::abs(energy_of(system, at(system, time, steps)) - energy_of(system, system.start)) /
         scale;
}

TEST(Pendulum, ReturnsAfterThePeriodThatTheEllipticIntegralGives) {
  // I theta'' = -m g l sin(theta): T = 4 sqrt(I / (m g l)) K(sin(theta0 / 2)), I about the hinge.
  System system = hanging({rod(Link::world)});
  const Link& link = system.model.link(0);
  const double l = link.centre.norm(), I = link.inertia(1, 1) + link.mass * l * l;
  for (const double amplitude : {0.01, 1.0, 2.5}) {
    system.start.q(0) = amplitude;
    const double period = 4 * std::sqrt(I / (link.mass * cases::kGravity * l)) *
                          std::comp_ellint_1(std::sin(amplitude / 2));
    const State end = at(system, period, 1000);
    EXPECT_LE(record("angle", std::abs(end.q(0) - amplitude) / amplitude), 1e-9);
    EXPECT_LE(record("rate", std::abs(end.u(0)) / amplitude * std::sqrt(I)), 1e-8);
    EXPECT_GT(std::abs(at(system, period / 2, 500).q(0) - amplitude), 1.9 * amplitude)
        << "half a period later it is on the other side";
  }
}

TEST(Pendulum, ErrorOfItsAngleFallsSixteenfoldWhenDtHalves) {
  System system = hanging({rod(Link::world)});
  system.start.q(0) = 2;
  for (const double time : {0.5, 0.7})
    EXPECT_NEAR(record("ratio", ratio_when_dt_halves(system, time, 200)), 16, 2) << time;
}

TEST(DoublePendulum, ErrorOfItsAnglesFallsSixteenfoldWhenDtHalves) {
  System system = hanging({rod(Link::world), rod(0)});
  system.start.q << 1.5, 0.5;
  for (const double time : {0.5, 0.7})
    EXPECT_NEAR(record("ratio", ratio_when_dt_halves(system, time, 200)), 16, 2) << time;
}

TEST(DoublePendulum, OnAxesAskewErrorOfItsAnglesFallsSixteenfoldWhenDtHalves) {
  System system = hanging({rod(Link::world), rod(0, {1, 1, 0.5})});
  system.start.q << 1, 0.5;
  system.start.u << 0.5, -2;
  EXPECT_NEAR(record("ratio", ratio_when_dt_halves(system, 1, 200)), 16, 2);
}

TEST(DoublePendulum, KeepsItsEnergy) {
  System system = hanging({rod(Link::world), rod(0, {1, 1, 0.5})});
  system.start.q << 1, 0.5;
  EXPECT_LE(record("energy", energy_error(system, 1, 1000)), 1e-9);
}

TEST(BallPendulum, ErrorOfItsQuaternionsFallsSixteenfoldWhenDtHalvesAndItKeepsItsEnergy) {
  Link upper = rod(Link::world), lower = rod(0);
  upper.joint = lower.joint = JointKind::ball;
  System system = hanging({upper, lower});
  system.start.u << 3, 1, 2, -1, 2, 0.5;
  EXPECT_NEAR(record("ratio", ratio_when_dt_halves(system, 0.5, 200)), 16, 2);
  EXPECT_LE(record("energy", energy_error(system, 0.5, 1000)), 1e-9);
}

TEST(TumblingBody, ErrorOfItsQuaternionFallsSixteenfoldWhenDtHalvesAndItsCentreFollowsAParabola) {
  cases::Uniform uniform(91);
  System system = hanging({cases::random_link(Link::world, JointKind::free, uniform)});
  system.start.u << 4, -3, 2, 1, 0.5, 2;
  const auto centre = [&](const State& state) {
    return centre_of_mass(system.model, kinematics(system.model, state));
  };
  const Vector3d v = momentum(system.model, kinematics(system.model, system.start)).tail<3>() /
                     system.model.mass();
  constexpr double time = 0.5;
  EXPECT_NEAR(record("ratio", ratio_when_dt_halves(system, time, 50)), 16, 2);
  const Vector3d expected = centre(system.start) + time * v + time * time / 2 * system.gravity;
  EXPECT_LE((centre(at(system, time, 1000)) - expected).norm(), 1e-9);
}

}  // namespace
}  // namespace lcp
