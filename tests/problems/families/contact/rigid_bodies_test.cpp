#include "problems/families/contact/rigid_bodies.h"

#include <gtest/gtest.h>

#include "tests/problems/families/contact/rigid_cases.h"

namespace lcp {
namespace {

using Eigen::Vector3d;

Vector3d random_vector(cases::Uniform& uniform) {
  const double x = uniform(), y = uniform();
  return {x, y, uniform()};
}

struct Heap {
  std::vector<RigidBody> bodies;
  std::vector<PlacedContact> contacts;
};

/// Three bodies turned and moving at random, four contacts among them and two with the world.
Heap heap() {
  cases::Uniform uniform(31);
  Heap heap;
  for (const double mass : {0.5, 3.0, 20.0}) {
    RigidBody body;
    body.mass = mass;
    body.inertia = mass * Vector3d(0.01, 0.02, 0.025);
    body.axes =
        Eigen::AngleAxisd(uniform() * 3, random_vector(uniform).normalized()).toRotationMatrix();
    body.centre = random_vector(uniform);
    body.velocity = random_vector(uniform);
    body.angular_velocity = 4 * random_vector(uniform);
    body.force = 10 * random_vector(uniform);
    body.moment = random_vector(uniform);
    heap.bodies.push_back(body);
  }
  const std::pair<Index, Index> pairs[] = {{1, 2}, {2, 3}, {3, 1}, {2, 1}, {1, 0}, {0, 3}};
  for (const auto& [body1, body2] : pairs)
    heap.contacts.push_back(
        {make_contact(random_vector(uniform), random_vector(uniform), 0.5, {body1, body2, 0}),
         random_vector(uniform)});
  return heap;
}

TEST(RigidBodies, DelassusMatrixIsWhatUnitImpulsesDo) {
  const Heap h = heap();
  const MatrixXd W = contact_problem(h.bodies, h.contacts, 2e-3).W;
  const MatrixXd expected = cases::delassus_by_impulses(h.bodies, h.contacts, 2e-3);
  EXPECT_LT((W - expected).cwiseAbs().maxCoeff(), 1e-12 * expected.cwiseAbs().maxCoeff());
  EXPECT_EQ(W, W.transpose().eval());
  const VectorXd eigenvalues = independent::eigenvalues(W);
  EXPECT_GT(eigenvalues(0), -1e-14 * eigenvalues.maxCoeff());
}

TEST(RigidBodies, VelocitiesAreThoseOfPointsThatTheBodiesCarryAlong) {
  // Where the points of both bodies are after a short time, by turning the bodies.
  const Heap h = heap();
  const VectorXd velocity = contact_problem(h.bodies, h.contacts, 2e-3).v_before;
  const double time = 1e-7;
  const auto carried = [&](Index b, const Vector3d& point) -> Vector3d {
    if (b == 0) return point;
    const RigidBody& body = h.bodies[b - 1];
    const double rate = body.angular_velocity.norm();
    const Eigen::AngleAxisd turn(rate * time, body.angular_velocity / rate);
    return body.centre + time * body.velocity + turn * (point - body.centre);
  };
  for (std::size_t i = 0; i < h.contacts.size(); ++i) {
    const PlacedContact& placed = h.contacts[i];
    const Vector3d apart = carried(placed.contact.id.body1, placed.position) -
                           carried(placed.contact.id.body2, placed.position);
    EXPECT_NEAR(velocity(3 * Index(i)), placed.contact.n.dot(apart) / time, 1e-5);
    EXPECT_NEAR(velocity(3 * Index(i) + 2), placed.contact.t2.dot(apart) / time, 1e-5);
  }
}

TEST(RigidBodies, FreeMotionFollowsNewtonAndEuler) {
  const Heap h = heap();
  const double dt = 2e-3;
  std::vector<RigidBody> moved = h.bodies;
  for (RigidBody& body : moved) {
    const Eigen::Matrix3d inertia = body.axes * body.inertia.asDiagonal() * body.axes.transpose();
    const Vector3d omega = body.angular_velocity;
    body.velocity += dt * (body.force / body.mass + Vector3d(0, 0, -9.81));
    body.angular_velocity +=
        dt * inertia.inverse() * (body.moment - omega.cross(Vector3d(inertia * omega)));
  }
  const VectorXd expected = contact_problem(moved, h.contacts, dt).v_before;
  EXPECT_LT((contact_problem(h.bodies, h.contacts, dt).vbar - expected).norm(), 1e-12);
}

TEST(RigidBodies, PenetrationIsPushedBackAndAGapIsNot) {
  Heap h = heap();
  const VectorXd plain = contact_problem(h.bodies, h.contacts, 2e-3).vbar;
  h.contacts[1].depth = 1e-3;
  h.contacts[2].depth = -1e-3;
  const VectorXd pushed = contact_problem(h.bodies, h.contacts, 2e-3).vbar;
  VectorXd expected = plain;
  expected(3) -= 0.005 * 1e-3 / 2e-3;
  EXPECT_EQ(pushed, expected);
}

TEST(RigidBodies, BoxInertiaIsThatOfItsEighthsByParallelAxes) {
  const Vector3d size(0.2, 0.3, 0.5), arm = size / 4;
  const double eighth = 6.0 / 8;
  const Vector3d squares = arm.cwiseAbs2();
  const Vector3d expected =
      8 * (box_inertia(eighth, size / 2) + eighth * (Vector3d::Constant(squares.sum()) - squares));
  EXPECT_LT((box_inertia(6, size) - expected).norm(), 1e-15);
  EXPECT_NEAR(box_inertia(6, size).x(), 6.0 / 12 * (0.09 + 0.25), 1e-15);
}

TEST(RigidBodies, OutlineGoesRoundThroughTheCorners) {
  const std::vector<Vector3d> points = rectangle_outline({1, 2, 3}, 0.4, 0.2, 8);
  const Vector3d expected[] = {{1.2, 2.1, 3}, {1, 2.1, 3}, {0.8, 2.1, 3}, {0.8, 2, 3},
                               {0.8, 1.9, 3}, {1, 1.9, 3}, {1.2, 1.9, 3}, {1.2, 2, 3}};
  ASSERT_EQ(points.size(), 8U);
  for (std::size_t k = 0; k < 8; ++k) EXPECT_LT((points[k] - expected[k]).norm(), 1e-15) << k;
}

TEST(RigidBodies, RefusesAContactWithABodyThatIsNotThere) {
  Heap h = heap();
  h.contacts[0].contact.id.body2 = 4;
  EXPECT_THROW(contact_problem(h.bodies, h.contacts, 1e-3), std::invalid_argument);
}

}  // namespace
}  // namespace lcp
