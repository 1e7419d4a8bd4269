// A chain that hangs from both its ends: the discrete catenary.

#include <gtest/gtest.h>

#include "tests/problems/rigid/simulation_cases.h"

namespace lcp {
namespace {

using cases::kGravity;

constexpr Index kLinks = 12;
constexpr double kLength = 0.1, kMass = 0.2;  // m, kg

/// Angles from the horizontal under which equal links rest where the pull at the ends has the
/// horizontal part H: tan(theta_i) = (V0 - (i - 1/2) m g) / H, V0 half the weight.
std::vector<double> catenary(double horizontal) {
  std::vector<double> angles;
  for (Index i = 0; i < kLinks; ++i)
    angles.push_back(
        std::atan(kMass * kGravity * (0.5 * kLinks - static_cast<double>(i) - 0.5) / horizontal));
  return angles;
}

double span(const std::vector<double>& angles) {
  double sum = 0;
  for (const double angle : angles) sum += kLength * std::cos(angle);
  return sum;
}

/// Balls at both ends and between, the last closed as a loop; x along the span, z up.
Model chain(double from_end_to_end, double damping) {
  std::vector<Link> links;
  for (Index i = 0; i < kLinks; ++i) {
    Link link;
    link.name = fmt::format("link{}", i + 1);
    link.joint = JointKind::ball;
    link.parent = i == 0 ? Link::world : i - 1;
    if (i > 0) link.in_parent.p = {kLength, 0, 0};
    link.mass = kMass;
    link.centre = {kLength / 2, 0, 0};
    link.inertia = cases::box_inertia(kMass, {kLength, 0.06, 0.06});
    link.damping = damping;
    links.push_back(link);
  }
  Loop end;
  end.link2 = kLinks - 1;
  end.in_link1.p = {from_end_to_end, 0, 0};
  end.in_link2.p = {kLength, 0, 0};
  return Model(std::move(links), {end});
}

/// At rest under these angles downwards.
State hanging(const Model& model, const std::vector<double>& angles) {
  State state = state_at_zero(model);
  for (Index i = 0; i < model.size(); ++i) {
    const double turn = i == 0 ? angles[0] : angles[i] - angles[i - 1];
    state.q.segment<4>(model.q_of(i)) =
        Eigen::Quaterniond(Eigen::AngleAxisd(turn, Vector3d::UnitY())).coeffs();
  }
  return state;
}

TEST(Catenary, IsAtRest) {
  for (const double horizontal : {2.0, 8.0, 40.0}) {
    const std::vector<double> angles = catenary(horizontal);
    const Model model = chain(span(angles), 0);
    const Kinematics k = kinematics(model, hanging(model, angles));
    ASSERT_LE(k.loops[0].gap, 1e-14);
    ForwardDynamics dynamics(model, {});
    dynamics.assemble(k, VectorXd::Zero(model.velocities()), {0, 0, -kGravity});
    const double fall = kGravity / kLength;  // rad/s^2, what a link that falls would turn with
    EXPECT_LE(dynamics.disassemble(VectorXd(0)).joints.cwiseAbs().maxCoeff(), 1e-9 * fall);
  }
}

TEST(Catenary, IsWhereADampedChainComesToRest) {
  const std::vector<double> rest = catenary(3);
  // An arc of the same span: half its opening angle by bisection.
  const auto arc = [](double bend) {
    std::vector<double> angles;
    for (Index i = 0; i < kLinks; ++i)
      angles.push_back(bend * (1 - (2 * static_cast<double>(i) + 1) / kLinks));
    return angles;
  };
  double low = 0, high = 3;
  while (high - low > 1e-15 * high) {
    const double middle = (low + high) / 2;
    if (middle == low || middle == high) break;
    (span(arc(middle)) > span(rest) ? low : high) = middle;
  }
  Model model = chain(span(rest), 0.02);
  const State start = hanging(model, arc(low));
  Simulation simulation({.model = model, .start = start, .handles = {}}, {.dt = 2e-3});
  for (int i = 0; i < 1500; ++i) simulation.step({});
  const Kinematics k = kinematics(model, simulation.state());
  for (Index i = 0; i < kLinks; ++i) {
    const Vector3d along = k.pose[i].R.col(0);
    EXPECT_NEAR(std::atan2(-along.z(), along.x()), rest[i], 5e-3);
  }
  EXPECT_GT(std::abs(arc(low)[0] - rest[0]), 0.05) << "it must have moved";
  EXPECT_LE(k.loops[0].gap, 1e-4 * kLength);
}

}  // namespace
}  // namespace lcp
