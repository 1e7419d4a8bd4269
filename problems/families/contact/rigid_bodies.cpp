#include "problems/families/contact/rigid_bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "solvers/errors.h"
#include "solvers/options.h"

namespace lcp {

namespace {

using Eigen::Vector3d;

constexpr double kGravity = 9.81;        // m/s^2
constexpr double kPositionGain = 0.005;  // share of a penetration that one step takes back

/// The same body after dt without contact forces, at the same place.
RigidBody freely_moved(const RigidBody& body, double dt) {
  const Vector3d spin = body.axes.transpose() * body.angular_velocity;
  const Vector3d moment =
      body.axes.transpose() * body.moment - spin.cross(body.inertia.cwiseProduct(spin));
  RigidBody moved = body;
  moved.velocity += dt * (body.force / body.mass - kGravity * Vector3d::UnitZ());
  moved.angular_velocity += dt * (body.axes * moment.cwiseQuotient(body.inertia));
  return moved;
}

/// Calls use(b, sign) for each free body b of a contact: body 1 with 1, body 2 with -1.
template <class Use>
void for_each_body(const std::vector<RigidBody>& bodies, const ContactId& id, Use use) {
  for (const auto& [b, sign] : {std::pair(id.body1, 1.0), {id.body2, -1.0}}) {
    if (b < 0 || b > static_cast<Index>(bodies.size()))
      throw InvalidArgument(
          "rigid bodies: a contact names body {}, expected 0 "
          "(the world) ... {}",
          b, bodies.size());
    if (b > 0) use(b - 1, sign);
  }
}

VectorXd contact_velocities(const std::vector<RigidBody>& bodies,
                            const std::vector<PlacedContact>& contacts) {
  VectorXd velocities(3 * contacts.size());
  Index row = 0;
  for (const PlacedContact& placed : contacts) {
    Vector3d relative = Vector3d::Zero();
    for_each_body(bodies, placed.contact.id, [&](Index b, double sign) {
      relative += sign * bodies[b].velocity_at(placed.position);
    });
    for (const Vector3d* axis : {&placed.contact.n, &placed.contact.t1, &placed.contact.t2})
      velocities(row++) = axis->dot(relative);
  }
  return velocities;
}

}  // namespace

Vector3d box_inertia(double mass, const Vector3d& size) {
  const Vector3d squares = size.cwiseAbs2();
  return mass / 12 * (Vector3d::Constant(squares.sum()) - squares);
}

Eigen::Vector<double, 6> weighted_push(const RigidBody& body, const Vector3d& position,
                                       const Vector3d& axis) {
  const Vector3d moment = body.axes.transpose() * (position - body.centre).cross(axis);
  Eigen::Vector<double, 6> push;
  push << axis / std::sqrt(body.mass), moment.cwiseQuotient(body.inertia.cwiseSqrt());
  return push;
}

std::vector<Vector3d> rectangle_outline(const Vector3d& centre, double length, double width,
                                        Index points) {
  const double x = length / 2, y = width / 2;
  const Vector3d corners[] = {{x, y, 0}, {-x, y, 0}, {-x, -y, 0}, {x, -y, 0}};
  std::vector<Vector3d> outline;
  for (Index k = 0; k < points; ++k) {
    const Index edge = 4 * k / points;
    const double share = static_cast<double>(4 * k % points) / static_cast<double>(points);
    outline.push_back(centre + (1 - share) * corners[edge] + share * corners[(edge + 1) % 4]);
  }
  return outline;
}

ContactProblem contact_problem(const std::vector<RigidBody>& bodies,
                               const std::vector<PlacedContact>& contacts, double dt) {
  ContactProblem problem;
  problem.dt = dt;
  for (const PlacedContact& placed : contacts) problem.contacts.push_back(placed.contact);

  const MatrixXd axes = contact_axes(problem.contacts);
  MatrixXd A = MatrixXd::Zero(6 * bodies.size(), axes.rows());
  for (Index row = 0; row < axes.rows(); ++row) {
    const PlacedContact& placed = contacts[row / 3];
    for_each_body(bodies, placed.contact.id, [&](Index b, double sign) {
      A.block<6, 1>(6 * b, row) =
          sign * weighted_push(bodies[b], placed.position, axes.row(row).transpose());
    });
  }
  problem.W = delassus_matrix(A, dt);

  std::vector<RigidBody> moved;
  for (const RigidBody& body : bodies) moved.push_back(freely_moved(body, dt));
  problem.v_before = contact_velocities(bodies, contacts);
  problem.vbar = contact_velocities(moved, contacts);
  for (Index i = 0; i < problem.size(); ++i)
    problem.vbar(3 * i) -= kPositionGain * std::max(0.0, contacts[i].depth) / dt;
  return problem;
}

std::string spell_positions(const std::vector<PlacedContact>& contacts) {
  std::string positions;
  for (const PlacedContact& placed : contacts)
    positions +=
        fmt::format("{}{},{},{}", positions.empty() ? "" : " ", shortest(placed.position.x()),
                    shortest(placed.position.y()), shortest(placed.position.z()));
  return positions;
}

}  // namespace lcp
