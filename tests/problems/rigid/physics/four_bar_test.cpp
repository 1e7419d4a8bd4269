// Four bars joined by hinges into a loop move as one degree of freedom.

#include <gtest/gtest.h>

#include "problems/decompositions.h"
#include "tests/problems/rigid/simulation_cases.h"

namespace lcp {
namespace {

using cases::kGravity;

/// Crank, coupler and rocker with the ground as the fourth bar, in the x-z plane, hinges along y.
/// Each bar is a slender box along x in its frame; angles are about -y, so that they turn x to z.
struct FourBar {
  double crank = 0.3, coupler = 0.7, rocker = 0.5, ground = 0.6;  // m, between hinges
  double crank_mass = 1, coupler_mass = 2, rocker_mass = 1.5;     // kg

  struct Angles {
    double coupler, rocker;  // From x, as the crank's.
  };

  /// Closed by intersecting circles about both ends of what is left, rocker upwards.
  Angles close(double theta) const {
    const double x = ground - crank * std::cos(theta), z = -crank * std::sin(theta);
    const double d = std::hypot(x, z), towards = std::atan2(z, x);
    const double inner =
        std::acos((coupler * coupler + d * d - rocker * rocker) / (2 * coupler * d));
    const double angle = towards + inner;
    const double rx = crank * std::cos(theta) + coupler * std::cos(angle) - ground;
    const double rz = crank * std::sin(theta) + coupler * std::sin(angle);
    return {angle, std::atan2(rz, rx)};
  }

  static double slender(double mass, double length) { return mass * length * length / 12; }

  /// Reduced inertia: kinetic energy is m(theta) omega^2 / 2.
  double inertia(double theta) const {
    const Angles at = close(theta);
    // Loop velocities: crank i + coupler j = rocker, in the two axes.
    const double det = -coupler * rocker * std::sin(at.coupler - at.rocker);
    const double phi = crank * rocker * std::sin(theta - at.rocker) / det;  // d coupler / d theta
    const double psi = crank * coupler * std::sin(theta - at.coupler) / det;
    const double vx = -crank * std::sin(theta) - coupler / 2 * std::sin(at.coupler) * phi;
    const double vz = crank * std::cos(theta) + coupler / 2 * std::cos(at.coupler) * phi;
    return slender(crank_mass, 2 * crank) + coupler_mass * (vx * vx + vz * vz) +
           slender(coupler_mass, coupler) * phi * phi +
           slender(rocker_mass, 2 * rocker) * psi * psi;
  }

  double potential(double theta) const {
    const Angles at = close(theta);
    return kGravity *
           (crank_mass * crank / 2 * std::sin(theta) +
            coupler_mass * (crank * std::sin(theta) + coupler / 2 * std::sin(at.coupler)) +
            rocker_mass * rocker / 2 * std::sin(at.rocker));
  }

  /// From d/dt (m omega) = m' omega^2 / 2 - V'; derivatives by central differences of fourth order.
  double acceleration(double theta, double omega) const {
    const auto slope = [&](auto f) {
      const double h = 1e-3;
      return (8 * (f(theta + h) - f(theta - h)) - (f(theta + 2 * h) - f(theta - 2 * h))) / (12 * h);
    };
    const double dm = slope([this](double t) { return inertia(t); });
    const double dv = slope([this](double t) { return potential(t); });
    return -(dm * omega * omega / 2 + dv) / inertia(theta);
  }
};

Link bar(const char* name, double length, double mass) {
  Link link;
  link.name = name;
  link.joint = JointKind::revolute;
  link.axis = -Vector3d::UnitY();
  link.mass = mass;
  link.centre = {length / 2, 0, 0};
  // What turns about x plays no part in the plane, but must be positive.
  const double across = FourBar::slender(mass, length);
  link.inertia = Vector3d(1e-3 * mass, across, across).asDiagonal();
  return link;
}

Model model_of(const FourBar& bars) {
  Link crank = bar("crank", bars.crank, bars.crank_mass);
  Link coupler = bar("coupler", bars.coupler, bars.coupler_mass);
  coupler.parent = 0;
  coupler.in_parent.p = {bars.crank, 0, 0};
  Link rocker = bar("rocker", bars.rocker, bars.rocker_mass);
  rocker.in_parent.p = {bars.ground, 0, 0};
  Loop loop;
  loop.name = "coupler-rocker";
  loop.joint = JointKind::revolute;
  loop.link1 = 1;
  loop.link2 = 2;
  loop.in_link1.p = {bars.coupler, 0, 0};
  loop.in_link2.p = {bars.rocker, 0, 0};
  loop.axis = -Vector3d::UnitY();
  crank.parent = rocker.parent = Link::world;
  return Model({crank, coupler, rocker}, {loop});
}

State at_rest(const FourBar& bars, const Model& model, double theta) {
  State state = state_at_zero(model);
  const auto [coupler, rocker] = bars.close(theta);
  state.q << theta, coupler - theta, rocker;
  return state;
}

TEST(FourBarLoop, AcceleratesAsTheLagrangianOfItsOneFreedom) {
  const FourBar bars;
  const Model model = model_of(bars);
  ForwardDynamics dynamics(model, {});
  for (const double theta : {0.4, 1.2, 2.3, 4.0}) {
    const State state = at_rest(bars, model, theta);
    const Kinematics k = kinematics(model, state);
    ASSERT_LE(k.loops[0].gap, 1e-14);
    dynamics.assemble(k, VectorXd::Zero(3), {0, 0, -kGravity});
    const double expected = bars.acceleration(theta, 0);
    EXPECT_NEAR(dynamics.disassemble(VectorXd(0)).joints(0), expected, 1e-9 * std::abs(expected));
  }
}

TEST(FourBarLoop, SwingsAsTheLagrangianOfItsOneFreedom) {
  const FourBar bars;
  Model model = model_of(bars);
  const State start = at_rest(bars, model, 0.4);
  Simulation simulation({.model = std::move(model), .start = start, .handles = {}}, {.dt = 1e-3});
  const ContactSolver none;
  double theta = 0.4, omega = 0;
  for (int i = 0; i < 1000; ++i) {
    simulation.step(none);
    const double h = 1e-3;  // RK4 on (theta, omega)
    const double k1 = bars.acceleration(theta, omega);
    const double k2 = bars.acceleration(theta + h / 2 * omega, omega + h / 2 * k1);
    const double k3 = bars.acceleration(theta + h / 2 * (omega + h / 2 * k1), omega + h / 2 * k2);
    const double k4 = bars.acceleration(theta + h * (omega + h / 2 * k2), omega + h * k3);
    theta += h * omega + h * h / 6 * (k1 + k2 + k3);
    omega += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  EXPECT_GT(std::abs(theta - 0.4), 1) << "it must have moved";
  EXPECT_NEAR(simulation.state().q(0), theta, 1e-6);
}

TEST(FourBarLoop, HoldsThreeOfFiveDirectionsTwice) {
  const FourBar bars;
  const Model closed = model_of(bars);
  const Model open(closed.links());
  const State state = at_rest(bars, closed, 0.9);
  const Kinematics k = kinematics(open, state);
  ForwardDynamics dynamics(open, {1, 2});
  dynamics.assemble(k, VectorXd::Zero(3), Vector3d::Zero());
  const MatrixXd Phi = at_origin(dynamics.handle_dynamics()).Phi;
  const Matrix6d Q = Phi.topLeftCorner<6, 6>() - Phi.topRightCorner<6, 6>() -
                     Phi.bottomLeftCorner<6, 6>() + Phi.bottomRightCorner<6, 6>();
  const Vector3d hinge = k.pose[2] * Vector3d(bars.rocker, 0, 0);
  Eigen::Matrix<double, 6, 5> T;
  T << stack(Vector3d::UnitX(), Vector3d::Zero()), stack(Vector3d::UnitZ(), Vector3d::Zero()),
      force_at(hinge, Vector3d::UnitX()), force_at(hinge, Vector3d::UnitY()),
      force_at(hinge, Vector3d::UnitZ());
  const VectorXd gamma = small_singular_values(T.transpose() * Q * T), values = gamma / gamma(0);
  EXPECT_GT(values(1), 1e-3);
  EXPECT_LT(values(2), 1e-12);
}

}  // namespace
}  // namespace lcp
