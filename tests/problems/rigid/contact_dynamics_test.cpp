#include "problems/rigid/contact_dynamics.h"

#include <gtest/gtest.h>

#include "tests/problems/rigid/dynamics_cases.h"

namespace lcp {
namespace {

using cases::record;
using cases::relative_error;

const cases::DynamicsCase kTree{
    "Tree",
    [](cases::Uniform& uniform) {
      return cases::random_model(
          {.joints = {JointKind::revolute, JointKind::ball}, .second_root = true}, uniform);
    },
    4, 81};

/// Contacts of the first handle with the second, of the third with the world, of the world with the
/// fourth.
std::vector<ContactPoint> three_points(const cases::Situation& s) {
  cases::Uniform uniform(82);
  std::vector<ContactPoint> points(3);
  for (ContactPoint& point : points) {
    point.position = s.origin + cases::random_vector(uniform);
    point.normal = cases::random_vector(uniform).normalized();
  }
  points[0].id = {body_of(s.handles[0]), body_of(s.handles[1]), 0};
  points[1].id = {body_of(s.handles[2]), 0, 1};
  points[2].id = {0, body_of(s.handles[3]), 2};
  return points;
}

/// Velocities of the handles, stacked.
VectorXd handle_velocities(const cases::Situation& s, const Kinematics& k) {
  VectorXd velocities(6 * s.handles.size());
  for (std::size_t h = 0; h < s.handles.size(); ++h)
    velocities.segment<6>(6 * h) = k.velocity[s.handles[h]];
  return velocities;
}

TEST(LinkContacts, HaveOrthonormalAxesWithTheFirstTangentAlongTheWorldsXWhereItCan) {
  const cases::Situation s(kTree);
  std::vector<ContactPoint> points = three_points(s);
  points[1].normal = Vector3d::UnitX();
  points[2].normal = Vector3d::UnitZ();
  const LinkContacts found = link_contacts(points, 0.3, s.kinematics(), s.handles);
  for (Index i = 0; i < 3; ++i) {
    const Contact& contact = found.contacts[i];
    Matrix3d axes;
    axes << contact.n, contact.t1, contact.t2;
    EXPECT_LE((axes.transpose() * axes - Matrix3d::Identity()).norm(), 1e-14);
    EXPECT_NEAR(axes.determinant(), 1, 1e-14);
    EXPECT_LE((contact.n - points[i].normal).norm(), 1e-15);
    EXPECT_EQ(contact.mu, 0.3);
    EXPECT_EQ(contact.id, points[i].id);
  }
  EXPECT_EQ(found.contacts[1].t1, Vector3d(Vector3d::UnitY()));
  EXPECT_EQ(found.contacts[2].t1, Vector3d(Vector3d::UnitX()));
}

TEST(LinkContacts, VelocitiesAreThoseOfBody1RelativeToBody2) {
  const cases::Situation s(kTree);
  const Kinematics k = s.kinematics();
  const std::vector<ContactPoint> points = three_points(s);
  const LinkContacts found = link_contacts(points, 0.3, k, s.handles);
  EXPECT_LE(relative_error(found.J * handle_velocities(s, k), found.velocity), 1e-13);

  const auto of_link = [&](Index body, const Vector3d& x) -> Vector3d {
    if (body == 0) return Vector3d::Zero();
    const Vector6d& v = k.velocity[body - 1];
    const Pose& pose = k.pose[body - 1];
    const Vector3d own = velocity_at(k.from_origin(pose.p), v);
    return own + Vector3d(v.head<3>()).cross(x - pose.p);
  };
  for (Index i = 0; i < 3; ++i) {
    const ContactPoint& p = points[i];
    const Vector3d v = of_link(p.id.body1, p.position) - of_link(p.id.body2, p.position);
    const Contact& c = found.contacts[i];
    const Vector3d expected(c.n.dot(v), c.t1.dot(v), c.t2.dot(v));
    EXPECT_LE((found.velocity.segment<3>(3 * i) - expected).norm(), 1e-13);
  }
}

TEST(LinkContacts, RefuseLinksThatAreNoHandles) {
  const cases::Situation s(kTree);
  std::vector<ContactPoint> points = three_points(s);
  points[1].id.body1 = body_of(s.model.size());
  EXPECT_THROW(link_contacts(points, 0.3, s.kinematics(), s.handles), std::invalid_argument);
  points[1].id.body1 = body_of(s.handles[0] + 1);
  EXPECT_THROW(link_contacts(points, 0.3, s.kinematics(), s.handles), std::invalid_argument);
}

TEST(ContactProblem, WIsWhatForcesAddToTheVelocitiesInAStep) {
  const cases::Situation s(kTree);
  const Kinematics k = s.kinematics();
  ForwardDynamics dynamics(s.model, s.handles);
  dynamics.assemble(k, s.torques, s.gravity);
  const LinkContacts contacts = link_contacts(three_points(s), 0.3, k, s.handles);
  constexpr double dt = 2e-3;
  const ContactProblem problem = contact_problem(contacts, dynamics.handle_dynamics(), dt, {});
  EXPECT_NO_THROW(check(problem, "problem"));
  EXPECT_EQ(problem.dt, dt);
  EXPECT_EQ(problem.v_before, contacts.velocity);
  const VectorXd free = dynamics.disassemble(VectorXd::Zero(24)).joints;
  for (Index column = 0; column < 9; ++column) {
    const VectorXd pushed = dynamics.disassemble(contacts.J.row(column).transpose()).joints;
    State after = s.state;
    after.u = dt * (pushed - free);  // J is linear in u, so that no velocity need be added
    const VectorXd expected =
        contacts.J * handle_velocities(s, kinematics(s.model, after, s.origin, s.acceleration));
    EXPECT_LE(relative_error(problem.W.col(column), expected), 1e-9) << column;
  }
}

TEST(ContactProblem, VbarIsTheVelocityThatPointsOfTheBodiesGainWithoutForces) {
  // Second differences of where those points of the bodies are that touch now.
  const cases::Situation s(kTree);
  const Kinematics k = s.kinematics();
  ForwardDynamics dynamics(s.model, s.handles);
  dynamics.assemble(k, s.torques, s.gravity);
  const std::vector<ContactPoint> points = three_points(s);
  const LinkContacts contacts = link_contacts(points, 0.3, k, s.handles);
  const VectorXd rate = dynamics.disassemble(VectorXd::Zero(24)).joints;
  constexpr double h = 1e-4, dt = 1e-3;
  const auto pose_after = [&](double time) {
    State state = s.state;
    state.q = moved(s.model, s.state.q, s.state.u + time / 2 * rate, time);
    return kinematics(s.model, state, s.origin, s.acceleration).pose;
  };
  const std::vector<Pose> before = pose_after(-h), after = pose_after(h);
  const auto acceleration = [&](Index body, const Vector3d& x) -> Vector3d {
    if (body == 0) return Vector3d::Zero();
    const Pose& here = k.pose[body - 1];
    const Vector3d own = here.R.transpose() * (x - here.p);
    return (before[body - 1] * own - 2 * x + after[body - 1] * own) / (h * h);
  };
  const ContactProblem problem = contact_problem(contacts, dynamics.handle_dynamics(), dt, {});
  VectorXd expected = contacts.velocity;
  for (Index i = 0; i < 3; ++i) {
    const ContactPoint& p = points[i];
    const Vector3d a = acceleration(p.id.body1, p.position) - acceleration(p.id.body2, p.position);
    const Contact& c = contacts.contacts[i];
    expected.segment<3>(3 * i) += dt * Vector3d(c.n.dot(a), c.t1.dot(a), c.t2.dot(a));
  }
  EXPECT_LE(record("gain",
                   relative_error(problem.vbar - contacts.velocity, expected - contacts.velocity)),
            1e-6);
}

TEST(ContactProblem, TakesBackAShareOfAnOverlapInTheNormalRowOnly) {
  const cases::Situation s(kTree);
  const Kinematics k = s.kinematics();
  ForwardDynamics dynamics(s.model, s.handles);
  dynamics.assemble(k, s.torques, s.gravity);
  std::vector<ContactPoint> points = three_points(s);
  points[0].depth = 2e-3;
  points[1].depth = -5e-3;  // a gap is not closed
  const LinkContacts contacts = link_contacts(points, 0.3, k, s.handles);
  constexpr double dt = 1e-3;
  const HandleDynamics handles = dynamics.handle_dynamics();
  const ContactProblem without = contact_problem(contacts, handles, dt, {.gain = 0});
  const ContactProblem with = contact_problem(contacts, handles, dt, {.gain = 0.005});
  VectorXd expected = VectorXd::Zero(9);
  expected(0) = -0.005 * 2e-3 / dt;
  EXPECT_LE((with.vbar - without.vbar - expected).norm(), 1e-15);
  EXPECT_EQ(with.W, without.W);
}

}  // namespace
}  // namespace lcp
