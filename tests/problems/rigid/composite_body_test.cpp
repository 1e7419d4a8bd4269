#include <gtest/gtest.h>

#include "problems/decompositions.h"
#include "problems/rigid/contact_dynamics.h"
#include "tests/problems/rigid/dynamics_cases.h"

namespace lcp {
namespace {

using cases::record;
using cases::relative_error;

Model one_body(cases::Uniform& uniform) {
  return cases::random_model({.joints = {JointKind::prescribed, JointKind::fixed}}, uniform);
}

const cases::DynamicsCase kOneBody{"OneBody", one_body, 3, 41};

TEST(CompositeBody, AnswersAsTheAssemblyOfItsLinks) {
  for (const std::uint64_t seed : {41, 42, 43}) {
    const cases::Situation s({"OneBody", one_body, 3, seed});
    const Kinematics k = s.kinematics();
    ForwardDynamics dynamics(s.model, s.handles);
    dynamics.assemble(k, s.torques, s.gravity);
    const HandleDynamics assembled = at_origin(dynamics.handle_dynamics());
    const HandleDynamics composite =
        CompositeBody(s.model, s.handles).handle_dynamics(k, s.gravity);
    EXPECT_LE(record("Phi", relative_error(assembled.Phi, composite.Phi)), 1e-9);
    EXPECT_LE(record("phi", relative_error(assembled.phi, composite.phi)), 1e-9);
    EXPECT_NE(assembled.Phi, composite.Phi) << "is there nothing to compare?";
  }
}

TEST(CompositeBody, AllItsHandlesShareOneInverseInertiaToTheBit) {
  const cases::Situation s(kOneBody);
  const Kinematics k = s.kinematics();
  const CompositeBody body(s.model, s.handles);
  const MatrixXd Phi = body.handle_dynamics(k, s.gravity).Phi;
  const Matrix6d first = Phi.topLeftCorner<6, 6>();
  EXPECT_EQ(first, Matrix6d(first.transpose()));
  EXPECT_EQ(Phi, MatrixXd(first.replicate(3, 3)));
  Matrix6d M = Matrix6d::Zero();
  for (Index i = 0; i < s.model.size(); ++i) M += link_inertia(s.model, k, i);
  EXPECT_LE(relative_error(M * first, Matrix6d::Identity()), 1e-12);
  const MatrixXd A = body.contact_factor(k, MatrixXd::Identity(18, 18));
  EXPECT_LE(relative_error(M * (A.transpose() * A).topLeftCorner<6, 6>(), Matrix6d::Identity()),
            1e-12);
  EXPECT_EQ(A, MatrixXd(A.leftCols<6>().replicate(1, 3)));
}

TEST(CompositeBody, ItsContactMatrixIsThatOfPhiAndOfRankSix) {
  const cases::Situation s(kOneBody);
  const Kinematics k = s.kinematics();
  std::vector<ContactPoint> points;
  cases::Uniform uniform(44);
  for (Index i = 0; i < 9; ++i)
    points.push_back({.position = cases::random_vector(uniform),
                      .normal = cases::random_vector(uniform).normalized(),
                      .id = {body_of(s.handles[i % 3]), 0, i}});
  const LinkContacts contacts = link_contacts(points, 0.5, k, s.handles);
  const CompositeBody body(s.model, s.handles);
  const HandleDynamics dynamics = body.handle_dynamics(k, s.gravity);
  const ContactProblem problem =
      contact_problem(contacts, dynamics, body.contact_factor(k, contacts.J), 1e-3, {});
  EXPECT_EQ(problem.W, MatrixXd(problem.W.transpose()));
  EXPECT_LE(relative_error(problem.W, contact_problem(contacts, dynamics, 1e-3, {}).W), 1e-12);
  const VectorXd values = singular_values(problem.W);
  EXPECT_GT(values(5), 1e-6 * values(0));
  EXPECT_LT(values(6), 1e-14 * values(0));
}

TEST(CompositeBody, RefusesSystemsThatDoNotMoveAsOneBody) {
  cases::Uniform uniform(45);
  const auto model = [&](JointKind base, JointKind joint, bool second_root = false) {
    return cases::random_model(
        {.links = 4, .base = base, .joints = {joint}, .second_root = second_root}, uniform);
  };
  using enum JointKind;
  EXPECT_NO_THROW(CompositeBody(model(free, prescribed), {3}));
  EXPECT_THROW(CompositeBody(model(free, revolute), {3}), std::invalid_argument);
  EXPECT_THROW(CompositeBody(model(free, ball), {3}), std::invalid_argument);
  EXPECT_THROW(CompositeBody(model(fixed, prescribed), {3}), std::invalid_argument);
  EXPECT_THROW(CompositeBody(model(free, prescribed, true), {3}), std::invalid_argument);
  std::vector<Link> links{cases::random_link(Link::world, free, uniform),
                          cases::random_link(Link::world, fixed, uniform)};
  EXPECT_THROW(CompositeBody(Model(links), {1}), std::invalid_argument) << "held by the world";
  EXPECT_THROW(CompositeBody(Model({}), {}), std::invalid_argument) << "no link at all";
  links = {cases::random_link(Link::world, free, uniform)};
  EXPECT_NO_THROW(CompositeBody(Model(links), {0}));
  EXPECT_THROW(CompositeBody(Model(links, {Loop{}}), {0}), std::invalid_argument) << "tied";
}

TEST(CompositeBody, RefusesHandlesThatDoNotExistOrAreNotAscending) {
  cases::Uniform uniform(46);
  const Model model = one_body(uniform);
  EXPECT_THROW(CompositeBody(model, {-1}), std::invalid_argument);
  EXPECT_THROW(CompositeBody(model, {8}), std::invalid_argument);
  EXPECT_THROW(CompositeBody(model, {3, 2}), std::invalid_argument);
}

}  // namespace
}  // namespace lcp
