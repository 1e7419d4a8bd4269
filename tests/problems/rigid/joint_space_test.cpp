// Contact matrices as products: what they equal, and what the ADA's differences cannot promise.

#include "problems/rigid/joint_space.h"

#include <gtest/gtest.h>

#include "problems/decompositions.h"
#include "problems/rigid/contact_dynamics.h"
#include "tests/problems/rigid/closed_systems.h"
#include "tests/problems/rigid/dynamics_cases.h"
#include "tests/problems/rigid/maximal_coordinates.h"

namespace lcp {
namespace {

using cases::ClosedSystem;
using cases::DynamicsCase;
using cases::LoopCase;
using cases::record;
using cases::relative_error;

/// Each handle on the next, and every third on the world.
LinkContacts random_contacts(const std::vector<Index>& handles, const Vector3d& origin,
                             const Kinematics& k) {
  cases::Uniform uniform(61);
  const Index n = static_cast<Index>(handles.size());
  std::vector<ContactPoint> points(12);
  for (Index i = 0; i < 12; ++i) {
    points[i].position = origin + cases::random_vector(uniform);
    points[i].normal = cases::random_vector(uniform).normalized();
    const bool world = i % 3 == 2 || n == 1;
    points[i].id = {body_of(handles[i % n]), world ? 0 : body_of(handles[(i + 1) % n]), i};
  }
  return link_contacts(points, 0.5, k, handles);
}

/// What must hold of any system, the ADA's and the oracle's answers at hand.
void expect_clean_twin(const JointSpace& joints, const Kinematics& k, const LinkContacts& contacts,
                       const HandleDynamics& assembled, const MatrixXd& oracle) {
  const MatrixXd all = joints.contact_factor(k, MatrixXd::Identity(oracle.rows(), oracle.cols()));
  EXPECT_LE(record("Phi", relative_error(all.transpose() * all, oracle)), 1e-9);

  const MatrixXd A = joints.contact_factor(k, contacts.J);
  const ContactProblem clean = contact_problem(contacts, assembled, A, 1e-3, {});
  const ContactProblem ada = contact_problem(contacts, assembled, 1e-3, {});
  EXPECT_NO_THROW(check(clean, "clean"));
  EXPECT_LE(record("W", relative_error(clean.W, ada.W)), 1e-9);
  EXPECT_EQ(clean.vbar, ada.vbar);
  EXPECT_EQ(clean.W, MatrixXd(clean.W.transpose()));
  const VectorXd values = symmetric_eigen(clean.W).values;
  EXPECT_GE(record("least eigenvalue", values(0) / values.maxCoeff()), -1e-15);
  const VectorXd noisy = symmetric_eigen((ada.W + ada.W.transpose()) / 2).values;
  record("least eigenvalue, ADA", noisy(0) / noisy.maxCoeff());
}

class OnTrees : public testing::TestWithParam<DynamicsCase> {};

TEST_P(OnTrees, GivesACleanTwinOfTheAssemblysMatrix) {
  const cases::Situation s(GetParam());
  const Kinematics k = s.kinematics();
  ForwardDynamics dynamics(s.model, s.handles);
  dynamics.assemble(k, s.torques, s.gravity);
  const cases::MaximalCoordinates oracle(s.model, s.state, s.acceleration);
  expect_clean_twin(JointSpace(s.model, s.handles), k, random_contacts(s.handles, s.origin, k),
                    dynamics.handle_dynamics(),
                    oracle.handle_dynamics(s.handles, s.origin, s.torques, s.gravity).Phi);
}

INSTANTIATE_TEST_SUITE_P(JointSpace, OnTrees, testing::ValuesIn(cases::dynamics_cases()),
                         [](const auto& each) { return each.param.name; });

class OnClosedChains : public testing::TestWithParam<LoopCase> {};

TEST_P(OnClosedChains, GivesACleanTwinOfTheAssemblysMatrix) {
  const ClosedSystem s(GetParam());
  const Kinematics k = s.kinematics();
  ForwardDynamics dynamics(s.model, s.handles);
  dynamics.assemble(k, s.torques, s.gravity);
  const cases::MaximalCoordinates oracle(s.model, s.state, {});
  expect_clean_twin(JointSpace(s.model, s.handles), k, random_contacts(s.handles, s.origin(), k),
                    dynamics.handle_dynamics(),
                    oracle.handle_dynamics(s.handles, s.origin(), s.torques, s.gravity).Phi);
}

INSTANTIATE_TEST_SUITE_P(JointSpace, OnClosedChains, testing::ValuesIn(cases::loop_cases()),
                         [](const auto& each) { return each.param.name; });

/// Rows of the factor that answers for all handles.
Index freedoms(const Model& model, const State& state, const AssemblyOptions& options = {}) {
  const JointSpace joints(model, {model.size() - 1}, options);
  return joints.contact_factor(kinematics(model, state), MatrixXd::Identity(6, 6)).rows();
}

TEST(JointSpace, OfARobotWhoseJointsArePrescribedIsThatOfOneBody) {
  const cases::Situation s(
      {"Magnum", [](auto&) { return cases::magnum_with(JointKind::prescribed); }, 2, 22});
  const Kinematics k = s.kinematics();
  const LinkContacts contacts = random_contacts(s.handles, s.origin, k);
  const JointSpace joints(s.model, s.handles);
  const CompositeBody body(s.model, s.handles);
  EXPECT_EQ(joints.velocities(), 6);
  const MatrixXd A = joints.contact_factor(k, contacts.J);
  EXPECT_EQ(A.rows(), 6);
  const MatrixXd W = delassus_matrix(A, 1e-3);
  EXPECT_LE(relative_error(W, delassus_matrix(body.contact_factor(k, contacts.J), 1e-3)), 1e-12);
  const VectorXd values = singular_values(W);
  EXPECT_GT(values(5), 1e-6 * values(0));
  EXPECT_LT(values(6), 1e-14 * values(0));
}

TEST(JointSpace, CountsFreedomsWhereLoopsAreRedundant) {
  const auto of_case = [](Index i) {
    const ClosedSystem s(cases::loop_cases()[i]);
    return freedoms(s.model, s.state);
  };
  EXPECT_EQ(of_case(0), 24 - 3) << "both ends fixed";
  EXPECT_EQ(of_case(1), 9 - 5) << "hinges askew";
  EXPECT_EQ(of_case(5), 2 * (6 + 9) - 6) << "two free chains tied";
  EXPECT_EQ(of_case(6), 18 - 5) << "two points of one link held on another: a hinge";
}

/// Hinges of a four-bar loop in a plane, the last turned by `tilt` (rad) about x.
Model four_bar(double tilt) {
  cases::Uniform uniform(63);
  std::vector<Link> links;
  const Vector3d steps[] = {{0, 0, 0}, {0.1, 0.3, 0}, {0.4, 0.05, 0}};
  for (Index i = 0; i < 3; ++i) {
    links.push_back(cases::random_link(i - 1, JointKind::revolute, uniform));
    links[i].axis = Vector3d::UnitZ();
    links[i].in_parent = {Matrix3d::Identity(), steps[i]};
  }
  const Matrix3d turn = Eigen::AngleAxisd(tilt, Vector3d::UnitX()).toRotationMatrix();
  Loop loop;
  loop.joint = JointKind::revolute;
  loop.link2 = 2;
  loop.in_link2 = {turn, {0.1, -0.3, 0}};
  loop.in_link1 = {turn, {0.6, 0.05, 0}};
  return Model(links, {loop});
}

TEST(JointSpace, TakesNearlyParallelHingesForParallelBelowTheTolerance) {
  const Model planar = four_bar(0), tilted = four_bar(1e-5);  // a share of 1e-14 to 1e-12
  EXPECT_EQ(freedoms(planar, state_at_zero(planar)), 1);
  EXPECT_EQ(freedoms(tilted, state_at_zero(tilted)), 1);
  EXPECT_EQ(freedoms(tilted, state_at_zero(tilted), {.redundancy = 1e-16}), 0);
  EXPECT_EQ(freedoms(planar, state_at_zero(planar), {.redundancy = 1e-16}), 1);
}

TEST(JointSpace, OfAPlanarFourBarIsThatOfItsAssembly) {
  const Model model = four_bar(0);
  const Kinematics k = kinematics(model, state_at_zero(model));
  ForwardDynamics dynamics(model, {0, 1, 2});
  dynamics.assemble(k, VectorXd::Zero(3), Vector3d::Zero());
  const MatrixXd A = JointSpace(model, {0, 1, 2}).contact_factor(k, MatrixXd::Identity(18, 18));
  EXPECT_LE(
      record("Phi", relative_error(A.transpose() * A, at_origin(dynamics.handle_dynamics()).Phi)),
      1e-9);
}

TEST(JointSpace, OfWhatIsHeldEverywhereIsExactlyZero) {
  cases::Uniform uniform(62);
  const Link free = cases::random_link(Link::world, JointKind::free, uniform);
  const Link led = cases::random_link(Link::world, JointKind::prescribed, uniform);
  const Model tied({free}, {Loop{.name = "loop", .joint = JointKind::fixed}}), driven({led});
  for (const Model* model : {&tied, &driven}) {
    const State state = state_at_zero(*model);
    EXPECT_EQ(freedoms(*model, state), 0);
    const Kinematics k = kinematics(*model, state);
    const LinkContacts contacts = random_contacts({0}, Vector3d::Zero(), k);
    const MatrixXd A = JointSpace(*model, {0}).contact_factor(k, contacts.J);
    EXPECT_EQ(delassus_matrix(A, 1e-3), MatrixXd(MatrixXd::Zero(36, 36)));
  }
}

TEST(JointSpace, RefusesHandlesThatDoNotExistAndMatricesOfAnotherShape) {
  const Model model = four_bar(0);
  EXPECT_THROW(JointSpace(model, {3}), std::invalid_argument);
  EXPECT_THROW(JointSpace(model, {1, 0}), std::invalid_argument);
  const Kinematics k = kinematics(model, state_at_zero(model));
  EXPECT_THROW(JointSpace(model, {0, 1}).contact_factor(k, MatrixXd::Zero(3, 6)),
               std::invalid_argument);
}

}  // namespace
}  // namespace lcp
