// Forward dynamics against MuJoCo, an independent program. Without its library these tests are
// skipped and say so.

#include <gtest/gtest.h>

#ifdef LCPBENCH_HAS_MUJOCO

#include "tests/problems/rigid/dynamics_cases.h"
#include "tests/problems/rigid/mujoco_model.h"

namespace lcp {
namespace {

using cases::DynamicsCase;
using cases::record;
using cases::relative_error;

class AgainstMuJoCo : public testing::TestWithParam<DynamicsCase> {
 protected:
  AgainstMuJoCo() : mujoco_(s_.model, s_.gravity) { mujoco_.set(s_.state); }

  cases::Situation s_{GetParam()};
  cases::MuJoCoModel mujoco_;
};

/// Places in u of joints that are not prescribed.
std::vector<Index> free_velocities(const Model& model) {
  std::vector<Index> places;
  for (Index i = 0; i < model.size(); ++i)
    for (Index k = 0; k < velocities(model.link(i).joint); ++k)
      if (model.link(i).joint != JointKind::prescribed) places.push_back(model.u_of(i) + k);
  return places;
}

TEST_P(AgainstMuJoCo, LinksMoveAlike) {
  const Kinematics k = s_.kinematics();
  MatrixXd ours(6, s_.model.size()), theirs(6, s_.model.size());
  for (Index i = 0; i < s_.model.size(); ++i) {
    ours.col(i) = k.velocity[i];
    theirs.col(i) = mujoco_.jacobian(i, s_.origin) * s_.state.u;
  }
  EXPECT_LE(record("velocities", relative_error(ours, theirs)), 1e-9);
}

TEST_P(AgainstMuJoCo, HandlesAnswerAsJMinusJTransposed) {
  ForwardDynamics dynamics(s_.model, s_.handles);
  dynamics.assemble(s_.kinematics(), s_.torques, s_.gravity);
  const std::vector<Index> moving = free_velocities(s_.model);
  MatrixXd J(6 * s_.handles.size(), moving.size());
  for (std::size_t h = 0; h < s_.handles.size(); ++h)
    J.middleRows<6>(6 * h) = mujoco_.jacobian(s_.handles[h], s_.origin)(Eigen::all, moving);
  const MatrixXd M = mujoco_.mass_matrix()(moving, moving);
  const MatrixXd expected = J * M.llt().solve(J.transpose());
  EXPECT_LE(
      record("J M^-1 J'", relative_error(at_origin(dynamics.handle_dynamics()).Phi, expected)),
      1e-9);
}

TEST_P(AgainstMuJoCo, JointsAccelerateAlikeUnderGravityVelocitiesTorquesAndWrenches) {
  ForwardDynamics dynamics(s_.model, s_.handles);
  dynamics.assemble(s_.kinematics(), s_.torques, s_.gravity);
  const VectorXd ours = dynamics.disassemble(s_.forces).joints;

  VectorXd expected;
  if (s_.model.prescribed().empty()) {
    expected = mujoco_.accelerations(s_.handles, s_.forces, s_.origin, s_.torques);
  } else {
    // What MuJoCo's hinges need beside `torques` so that they follow: M du/dt = forces, by parts.
    const std::vector<Index> moving = free_velocities(s_.model);
    const MatrixXd M = mujoco_.mass_matrix();
    VectorXd right = -mujoco_.bias(), known = VectorXd::Zero(s_.model.velocities());
    Index next = 0;
    for (const Index i : s_.model.prescribed()) known(s_.model.u_of(i)) = s_.acceleration(next++);
    for (Index i = 0; i < s_.model.size(); ++i) {
      const JointKind kind = s_.model.link(i).joint;
      if (kind == JointKind::revolute || kind == JointKind::ball)
        right.segment(s_.model.u_of(i), velocities(kind)) +=
            s_.torques.segment(s_.model.u_of(i), velocities(kind));
    }
    for (std::size_t h = 0; h < s_.handles.size(); ++h)
      right += mujoco_.jacobian(s_.handles[h], s_.origin).transpose() * s_.forces.segment<6>(6 * h);
    const VectorXd rest = (right - M * known)(moving);
    expected = VectorXd::Zero(s_.model.velocities());
    expected(moving) = VectorXd(MatrixXd(M(moving, moving)).llt().solve(rest));
  }
  EXPECT_LE(record("joints", relative_error(ours, expected)), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(All, AgainstMuJoCo, testing::ValuesIn(cases::dynamics_cases()),
                         [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace lcp

#else

TEST(AgainstMuJoCo, IsTestedOnlyWhereMuJoCoIsInstalled) {
  GTEST_SKIP() << "built without MuJoCo's library: scripts/setup installs libmujoco-dev";
}

#endif
