#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "problems/families/contact/rigid_bodies.h"
#include "problems/registry.h"
#include "solvers/registry.h"
#include "tests/problems/contact/contact_cases.h"
#include "tests/problems/families/independent.h"

namespace lcp::cases {

inline Instance first_of(const std::string& family) {
  return generate(family, {.count = 1}).front();
}

/// Singular values above 1e-10 of the largest.
inline Index rank(const MatrixXd& W) {
  const VectorXd values = independent::singular_values(W);
  return (values.array() > 1e-10 * values(0)).count();
}

/// N'WN: what normal forces do to normal velocities.
inline MatrixXd normal_part(const FrictionBlocks& blocks) {
  return blocks.W(Eigen::seqN(0, blocks.contacts(), 3), Eigen::seqN(0, blocks.contacts(), 3));
}

/// The contacts' places, from provenance, 3 x Nc.
inline Eigen::Matrix3Xd positions(const Instance& instance) {
  std::istringstream text(instance.provenance.at("contact_positions"));
  Eigen::Matrix3Xd places(3, instance.problem.friction->contacts());
  char comma;
  for (auto place : places.colwise()) text >> place.x() >> comma >> place.y() >> comma >> place.z();
  EXPECT_TRUE(text) << instance.name;
  return places;
}

/// Contact forces (3 Nc, N, contact axes) of a solution of the LCP.
inline VectorXd solved_forces(const Instance& instance) {
  const Result result = make_solver("best-first").solver->solve(instance.problem);
  EXPECT_EQ(to_string(result.claim), "solved") << instance.name;
  EXPECT_LE(natural_residual(instance.problem, result.z), 1e-6) << instance.name;
  return contact_forces(*instance.problem.friction, result.z);
}

/// By one of the factorised searches, to a natural residual of 1e-6.
inline void expect_solved(const std::vector<Instance>& instances) {
  const NamedSolver rows[] = {make_solver("best-first"), make_solver("best-first-lexicographic")};
  for (const Instance& instance : instances)
    EXPECT_TRUE(std::any_of(std::begin(rows), std::end(rows), [&](const NamedSolver& row) {
      const Result result = row.solver->solve(instance.problem);
      return result.claim == Claim::solved && natural_residual(instance.problem, result.z) <= 1e-6;
    })) << instance.name;
}

inline void expect_seeds_to_matter(const std::string& family) {
  const std::vector<Instance> once = generate(family, {.count = 3, .seed = 2});
  const std::vector<Instance> again = generate(family, {.count = 3, .seed = 2});
  const std::vector<Instance> other = generate(family, {.count = 3, .seed = 3});
  for (std::size_t k = 0; k < once.size(); ++k) {
    EXPECT_EQ(once[k].sha256, again[k].sha256);
    EXPECT_NE(once[k].sha256, other[k].sha256);
    EXPECT_NE(once[k].sha256, once[(k + 1) % 3].sha256);
  }
}

/// Total force and moment about `point` of contact forces: (6), N and N m.
inline Eigen::Vector<double, 6> total_wrench(const std::vector<Contact>& contacts,
                                             const Eigen::Matrix3Xd& places, const VectorXd& forces,
                                             const Eigen::Vector3d& point) {
  Eigen::Vector<double, 6> total = Eigen::Vector<double, 6>::Zero();
  for (Index i = 0; i < places.cols(); ++i) {
    const Contact& contact = contacts[i];
    const Eigen::Vector3d force =
        forces(3 * i) * contact.n + forces(3 * i + 1) * contact.t1 + forces(3 * i + 2) * contact.t2;
    total.head<3>() += force;
    total.tail<3>() += (places.col(i) - point).cross(force);
  }
  return total;
}

/// The message with which a family refuses its knobs; empty if it does not.
inline std::string refusal(const std::string& family) {
  try {
    generate(family, {.count = 1});
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

/// W, column by column: an impulse of dt N along an axis acts on the bodies by Newton and Euler, and
/// the change of every contact's velocity is read off. Inertias are inverted as full matrices.
inline MatrixXd delassus_by_impulses(const std::vector<RigidBody>& bodies,
                                     const std::vector<PlacedContact>& contacts, double dt) {
  const auto axis_of = [&](Index row) -> Eigen::Vector3d {
    const Contact& contact = contacts[row / 3].contact;
    return row % 3 == 0 ? contact.n : row % 3 == 1 ? contact.t1 : contact.t2;
  };
  const Index rows = static_cast<Index>(3 * contacts.size());
  MatrixXd W(rows, rows);
  for (Index column = 0; column < rows; ++column) {
    std::vector<RigidBody> struck = bodies;
    for (RigidBody& body : struck) body.velocity = body.angular_velocity = Eigen::Vector3d::Zero();
    const Eigen::Vector3d impulse = dt * axis_of(column), place = contacts[column / 3].position;
    const auto strike = [&](Index b, const Eigen::Vector3d& by) {
      if (b == 0) return;
      RigidBody& body = struck[b - 1];
      const Eigen::Matrix3d inertia = body.axes * body.inertia.asDiagonal() * body.axes.transpose();
      body.velocity += by / body.mass;
      body.angular_velocity += inertia.inverse() * (place - body.centre).cross(by);
    };
    const ContactId& id = contacts[column / 3].contact.id;
    strike(id.body1, impulse);
    strike(id.body2, -impulse);
    for (Index row = 0; row < rows; ++row) {
      const ContactId& at = contacts[row / 3].contact.id;
      const auto velocity = [&](Index b) -> Eigen::Vector3d {
        if (b == 0) return Eigen::Vector3d::Zero();
        return struck[b - 1].velocity_at(contacts[row / 3].position);
      };
      W(row, column) = axis_of(row).dot(velocity(at.body1) - velocity(at.body2));
    }
  }
  return W;
}

}  // namespace lcp::cases
