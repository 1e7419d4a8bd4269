#include "problems/rigid/kinematics.h"

#include <gtest/gtest.h>

#include "tests/problems/rigid/dynamics_cases.h"
#include "tests/problems/rigid/joint_coordinates.h"

namespace lcp {
namespace {

using cases::record;
using cases::relative_error;

constexpr double kStep = 1e-5;        // s, of central differences
constexpr double kDifference = 1e-8;  // what they are good for, relative

class KinematicsOfManySystems : public testing::TestWithParam<cases::DynamicsCase> {
 protected:
  /// The system a little later on its way, prescribed joints speeding up as their reference does.
  Kinematics after(double dt) const {
    State state = s_.state;
    Index next = 0;
    for (const Index i : s_.model.prescribed())
      state.u(s_.model.u_of(i)) += dt * s_.acceleration(next++);
    state.q = moved(s_.model, s_.state.q, s_.state.u, dt);
    return kinematics(s_.model, state, s_.origin, s_.acceleration);
  }

  const cases::Situation s_{GetParam()};
  const Kinematics here_ = s_.kinematics(), later_ = after(kStep), before_ = after(-kStep);
};

TEST_P(KinematicsOfManySystems, VelocitiesAreDerivativesOfPoses) {
  for (Index i = 0; i < s_.model.size(); ++i) {
    const Matrix3d turning = (later_.pose[i].R - before_.pose[i].R) / (2 * kStep);
    const Vector3d moving = (later_.pose[i].p - before_.pose[i].p) / (2 * kStep);
    const Vector6d& v = here_.velocity[i];
    EXPECT_LE((turning - skew(v.head<3>()) * here_.pose[i].R).norm(), kDifference * (1 + v.norm()));
    EXPECT_LE((moving - velocity_at(here_.from_origin(here_.pose[i].p), v)).norm(),
              kDifference * (1 + v.norm()));
  }
}

TEST_P(KinematicsOfManySystems, SigmaIsWhatAccelerationAddsWhileJointVelocitiesStayAsTheyAre) {
  std::vector<Vector6d> expected;
  for (Index i = 0; i < s_.model.size(); ++i) {
    expected.push_back(here_.sigma[i]);
    if (s_.model.link(i).parent != Link::world) expected[i] += expected[s_.model.link(i).parent];
    const Vector6d found = (later_.velocity[i] - before_.velocity[i]) / (2 * kStep);
    EXPECT_LE((found - expected[i]).norm(), kDifference * (1 + expected[i].norm())) << "link " << i;
  }
}

TEST_P(KinematicsOfManySystems, TheMassTimesTheSpeedOfItsCentreIsTheLinearMomentum) {
  const Vector3d moving =
      (centre_of_mass(s_.model, later_) - centre_of_mass(s_.model, before_)) / (2 * kStep);
  const Vector3d linear = momentum(s_.model, here_).tail<3>();
  EXPECT_LE((s_.model.mass() * moving - linear).norm(), kDifference * (1 + linear.norm()));
}

TEST_P(KinematicsOfManySystems, MomentumMovesToAnotherOriginAsAForceDoes) {
  const Vector3d shift(0.3, -0.7, 0.2);
  const Kinematics there = kinematics(s_.model, s_.state, s_.origin + shift, s_.acceleration);
  const Vector6d p = momentum(s_.model, here_);
  const Vector6d expected = stack(p.head<3>() - shift.cross(p.tail<3>()), p.tail<3>());
  EXPECT_LE(relative_error(momentum(s_.model, there), expected), 1e-12);
}

TEST_P(KinematicsOfManySystems, EnergyIsHalfUMuAndTheWeightTimesTheHeightOfTheCentre) {
  const cases::JointCoordinates d = cases::joint_coordinates(s_.model, here_, s_.gravity);
  const double expected = 0.5 * s_.state.u.dot(d.M * s_.state.u) -
                          s_.model.mass() * s_.gravity.dot(centre_of_mass(s_.model, here_));
  EXPECT_NEAR(energy(s_.model, here_, s_.gravity), expected, 1e-12 * std::abs(expected) + 1e-12);
}

TEST_P(KinematicsOfManySystems, CoordinateRatesAreDerivativesOfTheCoordinates) {
  const VectorXd rates = coordinate_rates(s_.model, s_.state.q, s_.state.u);
  const VectorXd found = (moved(s_.model, s_.state.q, s_.state.u, kStep) -
                          moved(s_.model, s_.state.q, s_.state.u, -kStep)) /
                         (2 * kStep);
  EXPECT_EQ(rates.size(), s_.model.coordinates());
  EXPECT_LE((found - rates).norm(), kDifference * (1 + rates.norm()));
}

TEST_P(KinematicsOfManySystems, MovingInHalvesAtConstantVelocityEndsAtTheSamePlace) {
  const VectorXd once = moved(s_.model, s_.state.q, s_.state.u, 0.5);
  const VectorXd half = moved(s_.model, s_.state.q, s_.state.u, 0.25);
  EXPECT_LE((moved(s_.model, half, s_.state.u, 0.25) - once).norm(), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(All, KinematicsOfManySystems, testing::ValuesIn(cases::dynamics_cases()),
                         [](const auto& each) { return each.param.name; });

TEST(Kinematics, ATumblingBodyReturnsAfterAFullTurn) {
  cases::Uniform uniform(61);
  const Model model({cases::random_link(Link::world, JointKind::free, uniform)});
  State state = cases::random_state(model, uniform);
  state.u.tail<3>().setZero();
  const double turn = 2 * std::numbers::pi / state.u.head<3>().norm();
  const VectorXd q = moved(model, state.q, state.u, turn);
  EXPECT_LE((q.segment<4>(3) + state.q.segment<4>(3)).norm(), 1e-14) << "q and -q are one rotation";
}

TEST(Kinematics, QuaternionsAreScaledToUnitLengthAndNothingElse) {
  cases::Uniform uniform(62);
  const Model model({cases::random_link(Link::world, JointKind::free, uniform),
                     cases::random_link(0, JointKind::ball, uniform)});
  const State state = cases::random_state(model, uniform);
  VectorXd q = 3 * state.q;
  normalise(model, q);
  EXPECT_EQ(Vector3d(q.head<3>()), Vector3d(3 * state.q.head<3>()));
  EXPECT_LE((q.tail<8>() - state.q.tail<8>()).norm(), 1e-15);
}

}  // namespace
}  // namespace lcp
