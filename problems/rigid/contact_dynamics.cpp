#include "problems/rigid/contact_dynamics.h"

#include <algorithm>
#include <cmath>

#include "solvers/errors.h"

namespace lcp {

namespace {

/// Cosine beyond which the world's x axis is too near the normal to be a tangent.
constexpr double kAlongNormal = 0.9;

Vector3d first_tangent(const Vector3d& normal) {
  return std::abs(normal.x()) < kAlongNormal ? Vector3d::UnitX() : Vector3d::UnitY();
}

Index handle_place(const std::vector<Index>& handles, Index link) {
  const auto place = std::lower_bound(handles.begin(), handles.end(), link);
  if (place == handles.end() || *place != link)
    throw InvalidArgument("contacts: link {} touches but is no handle of the dynamics", link);
  return place - handles.begin();
}

/// J for handle velocities at other points than O.
MatrixXd from_points(MatrixXd J, const std::vector<Vector3d>& points) {
  for (std::size_t h = 0; h < points.size(); ++h) {
    const Index column = 6 * static_cast<Index>(h);
    J.middleCols<3>(column) -= J.middleCols<3>(column + 3) * skew(points[h]).transpose();
  }
  return J;
}

/// `J` from velocities of the handles at the points of `dynamics`.
ContactProblem without_matrix(const LinkContacts& contacts, const MatrixXd& J,
                              const HandleDynamics& dynamics, double dt,
                              const PositionCorrection& correction) {
  ContactProblem problem;
  problem.contacts = contacts.contacts;
  problem.dt = dt;
  problem.v_before = contacts.velocity;
  problem.vbar = contacts.velocity + dt * (J * dynamics.phi + contacts.velocity_product);
  for (Index i = 0; i < contacts.depth.size(); ++i)
    problem.vbar(3 * i) -= correction.gain * std::max(0.0, contacts.depth(i)) / dt;
  return problem;
}

}  // namespace

LinkContacts link_contacts(const std::vector<ContactPoint>& points, double mu, const Kinematics& k,
                           const std::vector<Index>& handles) {
  const Index contacts = static_cast<Index>(points.size());
  LinkContacts found;
  found.J = MatrixXd::Zero(3 * contacts, 6 * handles.size());
  found.velocity = VectorXd::Zero(3 * contacts);
  found.velocity_product = VectorXd::Zero(3 * contacts);
  found.depth.resize(contacts);
  for (Index i = 0; i < contacts; ++i) {
    const ContactPoint& point = points[i];
    const Contact contact = make_contact(point.normal, first_tangent(point.normal), mu, point.id);
    const Vector3d r = k.from_origin(point.position);
    Vector3d velocity = Vector3d::Zero(), turning = Vector3d::Zero();
    for (const auto& [body, sign] : {std::pair(point.id.body1, 1.0), {point.id.body2, -1.0}}) {
      if (body == 0) continue;
      const Index link = body - 1, column = 6 * handle_place(handles, link);
      const Vector3d own = velocity_at(r, k.velocity[link]);
      velocity += sign * own;
      turning += sign * k.velocity[link].head<3>().cross(own);
      Index row = 3 * i;
      for (const Vector3d* axis : {&contact.n, &contact.t1, &contact.t2})
        found.J.block<1, 6>(row++, column) = sign * force_at(r, *axis).transpose();
    }
    Index row = 3 * i;
    for (const Vector3d* axis : {&contact.n, &contact.t1, &contact.t2}) {
      found.velocity(row) = axis->dot(velocity);
      found.velocity_product(row++) = axis->dot(turning);
    }
    found.depth(i) = point.depth;
    found.contacts.push_back(contact);
  }
  return found;
}

ContactProblem contact_problem(const LinkContacts& contacts, const HandleDynamics& dynamics,
                               double dt, const PositionCorrection& correction) {
  const MatrixXd J = from_points(contacts.J, dynamics.points);
  ContactProblem problem = without_matrix(contacts, J, dynamics, dt, correction);
  problem.W = dt * (J * dynamics.Phi * J.transpose());
  return problem;
}

ContactProblem contact_problem(const LinkContacts& contacts, const HandleDynamics& dynamics,
                               const MatrixXd& A, double dt, const PositionCorrection& correction) {
  ContactProblem problem =
      without_matrix(contacts, from_points(contacts.J, dynamics.points), dynamics, dt, correction);
  problem.W = delassus_matrix(A, dt);
  return problem;
}

}  // namespace lcp
