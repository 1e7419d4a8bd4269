// Closed loops: the answers of links, accelerations, and what drift control does.

#include <gtest/gtest.h>

#include "problems/rigid/assembly_plan.h"
#include "tests/problems/rigid/closed_systems.h"
#include "tests/problems/rigid/figures.h"
#include "tests/problems/rigid/maximal_coordinates.h"

namespace lcp {
namespace {

using cases::ClosedSystem;
using cases::LoopCase;
using cases::record;
using cases::relative_error;

class OnLoops : public testing::TestWithParam<LoopCase> {};

TEST_P(OnLoops, HandlesAnswerAsInMaximalCoordinates) {
  const ClosedSystem s(GetParam());
  ForwardDynamics dynamics(s.model, s.handles);
  dynamics.assemble(s.kinematics(), s.torques, s.gravity);
  const HandleDynamics ours = at_origin(dynamics.handle_dynamics());
  const cases::MaximalCoordinates oracle(s.model, s.state, {});
  const HandleDynamics expected =
      oracle.handle_dynamics(s.handles, s.origin(), s.torques, s.gravity);
  EXPECT_LE(record("Phi", relative_error(ours.Phi, expected.Phi)), 1e-9);
  EXPECT_LE(record("phi", relative_error(ours.phi, expected.phi)), 1e-9);
}

TEST_P(OnLoops, AllJointsAccelerateAsInMaximalCoordinates) {
  const ClosedSystem s(GetParam());
  ForwardDynamics dynamics(s.model, s.handles);
  dynamics.assemble(s.kinematics(), s.torques, s.gravity);
  const Accelerations ours = dynamics.disassemble(s.forces);
  const cases::MaximalCoordinates oracle(s.model, s.state, {});
  const Accelerations expected =
      oracle.accelerations(s.handles, s.forces, s.origin(), s.torques, s.gravity);
  EXPECT_LE(record("joints", relative_error(ours.joints, expected.joints)), 1e-9);
}

TEST_P(OnLoops, AreClosedAndStayOpenOnlyWhileTheyMust) {
  const ClosedSystem s(GetParam());
  for (const LoopKinematics& loop : s.kinematics().loops) {
    EXPECT_LE(loop.gap, 1e-14);
    EXPECT_LE(loop.error.norm(), 1e-13);
  }
  const AssemblyPlan plan = plan_assembly(s.model, {});
  for (const Index root : plan.roots)
    EXPECT_TRUE(plan.parts[root].open.empty() || plan.parts[root].is_body());
}

TEST_P(OnLoops, PhiIsSymmetricToTheLastBit) {
  const ClosedSystem s(GetParam());
  ForwardDynamics dynamics(s.model, s.handles);
  dynamics.assemble(s.kinematics(), s.torques, s.gravity);
  const MatrixXd Phi = dynamics.handle_dynamics().Phi;
  EXPECT_EQ((Phi - Phi.transpose()).cwiseAbs().maxCoeff(), 0);
}

INSTANTIATE_TEST_SUITE_P(ForwardDynamics, OnLoops, testing::ValuesIn(cases::loop_cases()),
                         [](const auto& each) { return each.param.name; });

/// A system whose loops lie within one tree, so that its loops' joints alone may be redundant.
class OnInnerLoops : public testing::TestWithParam<LoopCase> {};

TEST_P(OnInnerLoops, AJointTransmitsNothingWhereItAnswersLessThanItsShareOfRedundancy) {
  const ClosedSystem s(GetParam());
  const Model open(s.model.links());
  const Kinematics apart = kinematics(open, s.state, s.origin());
  // A loop's joint answers at most as the two bodies would by themselves, each of its up to six
  // components by up to 1: all of them are below 7, which leaves every loop open.
  ForwardDynamics dropped(s.model, s.handles, {.redundancy = 7}), without(open, s.handles);
  dropped.assemble(s.kinematics(), s.torques, s.gravity);
  without.assemble(apart, s.torques, s.gravity);
  EXPECT_LE(relative_error(at_origin(dropped.handle_dynamics()).Phi,
                           at_origin(without.handle_dynamics()).Phi),
            1e-12);
  EXPECT_LE(
      relative_error(dropped.disassemble(s.forces).joints, without.disassemble(s.forces).joints),
      1e-12);
}

std::vector<LoopCase> inner_loop_cases() {
  std::vector<LoopCase> inner = cases::loop_cases();
  std::erase_if(inner, [](const LoopCase& each) {
    return each.recipe.second_root ||
           std::any_of(each.closures.begin(), each.closures.end(),
                       [](const cases::Closure& c) { return c.link1 == Link::world; });
  });
  return inner;
}

INSTANTIATE_TEST_SUITE_P(ForwardDynamics, OnInnerLoops, testing::ValuesIn(inner_loop_cases()),
                         [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace lcp
