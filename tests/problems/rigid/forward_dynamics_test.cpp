#include "problems/rigid/forward_dynamics.h"

#include <gtest/gtest.h>

#include <numeric>

#include "problems/scenes/humanoid/magnum.h"
#include "tests/problems/rigid/dynamics_cases.h"
#include "tests/problems/rigid/joint_coordinates.h"
#include "tests/problems/rigid/maximal_coordinates.h"

namespace lcp {
namespace {

using cases::DynamicsCase;
using cases::record;
using cases::relative_error;

VectorXd stacked(const std::vector<Vector6d>& parts) {
  VectorXd whole(6 * parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) whole.segment<6>(6 * i) = parts[i];
  return whole;
}

class OnManySystems : public testing::TestWithParam<DynamicsCase> {};

TEST_P(OnManySystems, HandlesAnswerAsInMaximalCoordinates) {
  const cases::Situation s(GetParam());
  ForwardDynamics dynamics(s.model, s.handles);
  dynamics.assemble(s.kinematics(), s.torques, s.gravity);
  const HandleDynamics ours = at_origin(dynamics.handle_dynamics());
  const cases::MaximalCoordinates oracle(s.model, s.state, s.acceleration);
  const HandleDynamics expected = oracle.handle_dynamics(s.handles, s.origin, s.torques, s.gravity);
  EXPECT_LE(record("Phi", relative_error(ours.Phi, expected.Phi)), 1e-9);
  EXPECT_LE(record("phi", relative_error(ours.phi, expected.phi)), 1e-9);
}

TEST_P(OnManySystems, AllLinksAndJointsAccelerateAsInMaximalCoordinates) {
  const cases::Situation s(GetParam());
  ForwardDynamics dynamics(s.model, s.handles);
  dynamics.assemble(s.kinematics(), s.torques, s.gravity);
  const Accelerations ours = dynamics.disassemble(s.forces);
  const cases::MaximalCoordinates oracle(s.model, s.state, s.acceleration);
  const Accelerations expected =
      oracle.accelerations(s.handles, s.forces, s.origin, s.torques, s.gravity);
  EXPECT_LE(record("joints", relative_error(ours.joints, expected.joints)), 1e-9);
  EXPECT_LE(record("links", relative_error(stacked(ours.links), stacked(expected.links))), 1e-9);
}

TEST_P(OnManySystems, HandlesAndJointsAnswerAsInJointCoordinates) {
  const cases::Situation s(GetParam());
  const Kinematics k = s.kinematics();
  ForwardDynamics dynamics(s.model, s.handles);
  dynamics.assemble(k, s.torques, s.gravity);
  const cases::JointCoordinates oracle = cases::joint_coordinates(s.model, k, s.gravity);
  EXPECT_LE(record("J M^-1 J'", relative_error(at_origin(dynamics.handle_dynamics()).Phi,
                                               oracle.delassus(s.handles))),
            1e-9);
  EXPECT_LE(record("joints", relative_error(dynamics.disassemble(s.forces).joints,
                                            oracle.accelerations(s.handles, s.forces, s.torques))),
            1e-9);
}

TEST_P(OnManySystems, ForcesAccelerateTheHandlesAsPhiSays) {
  const cases::Situation s(GetParam());
  ForwardDynamics dynamics(s.model, s.handles);
  dynamics.assemble(s.kinematics(), s.torques, s.gravity);
  const HandleDynamics d = at_origin(dynamics.handle_dynamics());
  const VectorXd expected = d.Phi * s.forces + d.phi;
  const Accelerations found = dynamics.disassemble(s.forces);
  std::vector<Vector6d> of_handles;
  for (const Index h : s.handles) of_handles.push_back(found.links[h]);
  EXPECT_LE(record("a - Phi F - phi", relative_error(stacked(of_handles), expected)), 1e-9);
}

TEST_P(OnManySystems, PhiIsSymmetric) {
  const cases::Situation s(GetParam());
  ForwardDynamics dynamics(s.model, s.handles);
  dynamics.assemble(s.kinematics(), s.torques, s.gravity);
  const MatrixXd Phi = at_origin(dynamics.handle_dynamics()).Phi;
  EXPECT_LE(record("Phi - Phi'", relative_error(Phi.transpose(), Phi)), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(All, OnManySystems, testing::ValuesIn(cases::dynamics_cases()),
                         [](const auto& each) { return each.param.name; });

TEST(ForwardDynamics, FreeLinksDoNotFeelOneAnother) {
  cases::Uniform uniform(31);
  const Model model({cases::random_link(Link::world, JointKind::free, uniform),
                     cases::random_link(Link::world, JointKind::free, uniform)});
  ForwardDynamics dynamics(model, {0, 1});
  dynamics.assemble(kinematics(model, cases::random_state(model, uniform)),
                    VectorXd::Zero(model.velocities()), Vector3d::Zero());
  const MatrixXd Phi = at_origin(dynamics.handle_dynamics()).Phi;
  EXPECT_TRUE((Phi.topRightCorner(6, 6).isZero(0)));
  EXPECT_TRUE((Phi.bottomLeftCorner(6, 6).isZero(0)));
}

TEST(ForwardDynamics, TheAnswerOnOneLinkDoesNotDependOnTheOtherHandles) {
  const cases::Situation s(cases::dynamics_cases().front());
  std::vector<Index> all(s.model.size());
  std::iota(all.begin(), all.end(), Index{0});
  ForwardDynamics few(s.model, {s.handles.front()}), many(s.model, all);
  few.assemble(s.kinematics(), s.torques, s.gravity);
  many.assemble(s.kinematics(), s.torques, s.gravity);
  const Index at = 6 * s.handles.front();
  EXPECT_LE(relative_error(at_origin(few.handle_dynamics()).Phi,
                           at_origin(many.handle_dynamics()).Phi.block(at, at, 6, 6)),
            1e-12);
  EXPECT_LE(relative_error(at_origin(few.handle_dynamics()).phi,
                           at_origin(many.handle_dynamics()).phi.segment(at, 6)),
            1e-12);
}

TEST(ForwardDynamics, AssemblesAgainWhereTheSystemHasMovedTo) {
  const cases::Situation s(cases::dynamics_cases().front());
  cases::Uniform uniform(32);
  const State elsewhere = cases::random_state(s.model, uniform);
  ForwardDynamics used(s.model, s.handles), fresh(s.model, s.handles);
  used.assemble(kinematics(s.model, elsewhere), s.torques, s.gravity);
  used.disassemble(s.forces);
  used.assemble(s.kinematics(), s.torques, s.gravity);
  fresh.assemble(s.kinematics(), s.torques, s.gravity);
  EXPECT_EQ(at_origin(used.handle_dynamics()).Phi, at_origin(fresh.handle_dynamics()).Phi);
  EXPECT_EQ(used.disassemble(s.forces).joints, fresh.disassemble(s.forces).joints);
}

TEST(ForwardDynamics, RefusesHandlesThatDoNotExistOrAreNotAscending) {
  const Model model = magnum::model();
  EXPECT_THROW(ForwardDynamics(model, {-1}), std::invalid_argument);
  EXPECT_THROW(ForwardDynamics(model, {21}), std::invalid_argument);
  EXPECT_THROW(ForwardDynamics(model, {4, 3}), std::invalid_argument);
  EXPECT_THROW(ForwardDynamics(model, {4, 4}), std::invalid_argument);
  EXPECT_NO_THROW(ForwardDynamics(model, {}));
}

TEST(ForwardDynamics, RefusesForcesOfAnotherNumberOfHandles) {
  const Model model = magnum::model();
  ForwardDynamics dynamics(model, {3});
  dynamics.assemble(kinematics(model, state_at_zero(model)), VectorXd::Zero(model.velocities()),
                    Vector3d::Zero());
  EXPECT_THROW(dynamics.disassemble(VectorXd::Zero(12)), std::invalid_argument);
}

}  // namespace
}  // namespace lcp
