// A chain round a fixed cylinder slips where the pulls at its ends differ by more than friction
// holds: Euler and Eytelwein's T2 / T1 = exp(mu beta).

#include <gtest/gtest.h>

#include <numbers>

#include "problems/collision/collision.h"
#include "tests/problems/rigid/simulation_cases.h"

namespace lcp {
namespace {

constexpr Index kArch = 12, kArm = 2, kLinks = kArch + 2 * kArm;
constexpr double kLength = 0.03, kRadius = 0.0005, kMass = 0.01;  // of a link, m, kg
constexpr double kDepth = 1e-6;                                  // m, by which links press at first
constexpr double kHeld = 10;                                     // N, T1

/// Half way round, links tangent in their middle, arms straight down.
State start(const Model& model) {
  State state = state_at_zero(model);
  const double turn = std::numbers::pi / kArch;
  std::vector<double> pitch(kArm, std::numbers::pi / 2);
  for (Index i = 0; i < kArch; ++i)
    pitch.push_back(std::numbers::pi / 2 - turn * (static_cast<double>(i) + 0.5));
  pitch.insert(pitch.end(), kArm, -std::numbers::pi / 2);
  state.q.head<3>() = Vector3d(-kLength / 2 / std::sin(turn / 2), 0, -kLength * kArm);
  for (Index i = 0; i < model.size(); ++i) {
    const double angle = i == 0 ? pitch[0] : pitch[i] - pitch[i - 1];
    state.q.segment<4>(model.q_of(i) + (i == 0 ? 3 : 0)) =
        Eigen::Quaterniond(Eigen::AngleAxisd(-angle, Vector3d::UnitY())).coeffs();
  }
  return state;
}

Model chain() {
  std::vector<Link> links;
  for (Index i = 0; i < kLinks; ++i) {
    Link link = cases::free_box(kMass, {kLength, 0.01, 0.01});
    link.centre = {kLength / 2, 0, 0};
    if (i > 0) {
      link.parent = i - 1;
      link.joint = JointKind::ball;
      link.in_parent.p = {kLength, 0, 0};
      link.damping = 1e-4;
    }
    links.push_back(link);
  }
  return Model(std::move(links));
}

/// T1 down at the first end, T2 down at the last.
System pulled_round(double mu, double ratio) {
  using namespace collision;
  Model model = chain();
  State at = start(model);
  const double apothem = kLength / 2 / std::tan(std::numbers::pi / 2 / kArch);
  std::vector<Shape> shapes = {
      {Cylinder{apothem - kRadius + kDepth, 0.2},
       Link::world,
       {Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitX()).toRotationMatrix(), {}}}};
  shapes[0].in_link.p.setZero();
  std::vector<Index> handles;
  for (Index i = 0; i < model.size(); ++i) {
    handles.push_back(i);
    shapes.push_back(
        {Capsule{kRadius, kLength - 2 * kRadius},
         i,
         {Eigen::AngleAxisd(std::numbers::pi / 2, Vector3d::UnitY()).toRotationMatrix(),
          {kLength / 2, 0, 0}}});
  }
  World world(shapes, neighbours(model));
  return {.model = std::move(model),
          .start = std::move(at),
          .handles = std::move(handles),
          .collide = [world](const Kinematics& k) mutable { return world.contacts(k); },
          .pull = [ratio](double, const Kinematics& k) -> std::vector<PointForce> {
            const Vector3d first = k.pose[0].p;
            const Vector3d last = k.pose[kLinks - 1] * Vector3d(kLength, 0, 0);
            return {{0, first, {0, 0, -kHeld}}, {kLinks - 1, last, {0, 0, -ratio * kHeld}}};
          },
          .mu = mu,
          .gravity = Vector3d::Zero()};
}

/// Speed, m/s, at which the chain runs over the cylinder after 40 ms.
double speed_after_a_while(double mu, double ratio) {
  Simulation simulation(pulled_round(mu, ratio), {.dt = 1e-3});
  const Index failures = cases::run(simulation, 0.04, cases::solver_in_the_loop());
  EXPECT_EQ(failures, 0);
  const System& system = simulation.system();
  return momentum(system.model, kinematics(system.model, simulation.state())).tail<3>().x() /
         system.model.mass();
}

TEST(Capstan, HoldsUpToEulersRatioAndSlipsBeyond) {
  for (const double mu : {0.2, 0.4}) {
    const double limit = std::exp(mu * std::numbers::pi);
    EXPECT_LT(std::abs(speed_after_a_while(mu, 0.97 * limit)), 1e-3);
    EXPECT_GT(speed_after_a_while(mu, 1.03 * limit), 1e-2);
  }
}

}  // namespace
}  // namespace lcp
