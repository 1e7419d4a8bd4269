#include "tests/problems/rigid/maximal_coordinates.h"

namespace lcp::cases {

namespace {

using Eigen::Quaterniond;

/// Two unit vectors that span the plane across `axis`.
Eigen::Matrix<double, 3, 2> plane_across(const Vector3d& axis) {
  Eigen::Matrix<double, 3, 2> plane;
  plane.col(0) = axis.unitOrthogonal();
  plane.col(1) = axis.cross(plane.col(0));
  return plane;
}

Eigen::Matrix3d cross_matrix(const Vector3d& v) {
  Matrix3d matrix;
  for (Index k = 0; k < 3; ++k) matrix.col(k) = v.cross(Vector3d::Unit(k));
  return matrix;
}

}  // namespace

MaximalCoordinates::MaximalCoordinates(const Model& model, const State& state,
                                       const VectorXd& acceleration)
    : model_(model), u_(state.u) {
  place(state);
  constrain(acceleration);
  const Index n = 6 * model.size(), constraints = C_.rows();
  system_ = MatrixXd::Zero(n + constraints, n + constraints);
  for (Index i = 0; i < model.size(); ++i) {
    system_.block<3, 3>(6 * i, 6 * i) =
        bodies_[i].R * model.link(i).inertia * bodies_[i].R.transpose();
    system_.block<3, 3>(6 * i + 3, 6 * i + 3) = model.link(i).mass * Matrix3d::Identity();
  }
  system_.topRightCorner(n, constraints) = -C_.transpose();
  system_.bottomLeftCorner(constraints, n) = C_;
  factor_.compute(system_);
}

void MaximalCoordinates::place(const State& state) {
  for (Index i = 0; i < model_.size(); ++i) {
    const Link& link = model_.link(i);
    const auto q = state.q.segment(model_.q_of(i), coordinates(link.joint));
    const auto u = state.u.segment(model_.u_of(i), velocities(link.joint));
    Body body;
    if (link.joint == JointKind::free) {
      body.R = Quaterniond(q(6), q(3), q(4), q(5)).toRotationMatrix();
      body.p = q.head<3>();
      body.omega = u.head<3>();
      body.c = body.p + body.R * link.centre;
      body.v = u.tail<3>() + body.omega.cross(body.c - body.p);
      bodies_.push_back(body);
      continue;
    }
    Body ground{Matrix3d::Identity(), Vector3d::Zero(), Vector3d::Zero(), Vector3d::Zero(),
                Vector3d::Zero()};
    const Body& parent = link.parent == Link::world ? ground : bodies_[link.parent];
    body.p = parent.p + parent.R * link.in_parent.p;
    body.R = parent.R * link.in_parent.R;
    body.omega = parent.omega;
    if (link.joint == JointKind::ball) {
      body.R = body.R * Quaterniond(q(3), q(0), q(1), q(2)).toRotationMatrix();
      body.omega += body.R * u;
    } else if (link.joint != JointKind::fixed) {
      body.omega += body.R * link.axis * u(0);
      const Matrix3d K = cross_matrix(link.axis);  // Rodrigues' formula
      body.R = body.R * (Matrix3d::Identity() + std::sin(q(0)) * K + (1 - std::cos(q(0))) * K * K);
    }
    body.c = body.p + body.R * link.centre;
    body.v = parent.v + parent.omega.cross(body.p - parent.c) + body.omega.cross(body.c - body.p);
    bodies_.push_back(body);
  }
}

void MaximalCoordinates::constrain(const VectorXd& acceleration) {
  const Index most = 6 * (model_.size() + static_cast<Index>(model_.loops().size()));
  C_.setZero(most, 6 * model_.size());
  right_.setZero(most);
  Index rows = 0, next_prescribed = 0;
  for (Index i = 0; i < model_.size(); ++i) {
    const Link& link = model_.link(i);
    if (link.joint == JointKind::free) continue;
    const Body& child = bodies_[i];
    const bool in_world = link.parent == Link::world;
    const Vector3d omega_p = in_world ? Vector3d::Zero().eval() : bodies_[link.parent].omega;

    // Equal accelerations a + alpha x r + omega x (omega x r) of the joint's point.
    const auto point = [&](Index body, double sign) {
      const Body& b = bodies_[body];
      const Vector3d r = child.p - b.c;
      C_.block<3, 3>(rows, 6 * body) = -sign * cross_matrix(r);
      C_.block<3, 3>(rows, 6 * body + 3) = sign * Matrix3d::Identity();
      right_.segment<3>(rows) -= sign * b.omega.cross(b.omega.cross(r));
    };
    point(i, 1);
    if (!in_world) point(link.parent, -1);
    rows += 3;

    const auto turning = [&](const MatrixXd& across, const Vector3d& alpha) {
      C_.block(rows, 6 * i, across.cols(), 3) = across.transpose();
      if (!in_world) C_.block(rows, 6 * link.parent, across.cols(), 3) = -across.transpose();
      right_.segment(rows, across.cols()) = across.transpose() * alpha;
      rows += across.cols();
    };
    const Vector3d axis = child.R * link.axis;
    const Vector3d carried = omega_p.cross(child.omega - omega_p);
    if (link.joint == JointKind::revolute)
      turning(plane_across(axis), carried);
    else if (link.joint == JointKind::prescribed)
      turning(Matrix3d::Identity(), carried + acceleration(next_prescribed++) * axis);
    else if (link.joint == JointKind::fixed)
      turning(Matrix3d::Identity(), Vector3d::Zero());
  }
  constrain_loops(rows);
  C_.conservativeResize(rows, Eigen::NoChange);
  right_.conservativeResize(rows);
}

void MaximalCoordinates::constrain_loops(Index& rows) {
  for (const Loop& loop : model_.loops()) {
    const Body& second = bodies_[loop.link2];
    const Vector3d point = second.p + second.R * loop.in_link2.p;
    const Vector3d axis = second.R * loop.in_link2.R * loop.axis;
    const Vector3d omega_1 =
        loop.link1 == Link::world ? Vector3d::Zero().eval() : bodies_[loop.link1].omega;
    MatrixXd across(3, 0);
    if (loop.joint == JointKind::revolute) across = plane_across(axis);
    if (loop.joint == JointKind::fixed) across = Matrix3d::Identity();
    for (const auto& [link, sign] : {std::pair(loop.link2, 1.0), {loop.link1, -1.0}}) {
      if (link == Link::world) continue;
      const Body& b = bodies_[link];
      const Vector3d r = point - b.c;
      C_.block<3, 3>(rows, 6 * link) = -sign * cross_matrix(r);
      C_.block<3, 3>(rows, 6 * link + 3) = sign * Matrix3d::Identity();
      right_.segment<3>(rows) -= sign * b.omega.cross(b.omega.cross(r));
      C_.block(rows + 3, 6 * link, across.cols(), 3) = sign * across.transpose();
    }
    right_.segment(rows + 3, across.cols()) =
        across.transpose() * omega_1.cross(second.omega - omega_1);
    rows += 3 + across.cols();
  }
}

VectorXd MaximalCoordinates::solve(const VectorXd& forces, bool at_rest) const {
  VectorXd right(forces.size() + right_.size());
  right << forces, at_rest ? VectorXd::Zero(right_.size()).eval() : right_;
  VectorXd found = factor_.solve(right);
  found += factor_.solve(right - system_ * found);
  return found.head(forces.size());
}

VectorXd MaximalCoordinates::own_forces(const VectorXd& torques, const Vector3d& gravity) const {
  VectorXd forces = VectorXd::Zero(6 * model_.size());
  for (Index i = 0; i < model_.size(); ++i) {
    const Link& link = model_.link(i);
    const Body& body = bodies_[i];
    const Vector3d spin = body.R * link.inertia * body.R.transpose() * body.omega;
    forces.segment<3>(6 * i) -= body.omega.cross(spin);
    forces.segment<3>(6 * i + 3) += link.mass * gravity;
    Vector3d torque = Vector3d::Zero();
    if (link.joint == JointKind::revolute)
      torque = torques(model_.u_of(i)) * (body.R * link.axis);
    else if (link.joint == JointKind::ball)
      torque = body.R * torques.segment<3>(model_.u_of(i));
    forces.segment<3>(6 * i) += torque;
    if (link.parent != Link::world) forces.segment<3>(6 * link.parent) -= torque;
  }
  return forces;
}

void MaximalCoordinates::add_force(Index link, const Vector6d& at_origin, const Vector3d& origin,
                                   VectorXd& forces) const {
  const Vector3d moment = at_origin.head<3>(), force = at_origin.tail<3>();
  forces.segment<3>(6 * link) += moment + (origin - bodies_[link].c).cross(force);
  forces.segment<3>(6 * link + 3) += force;
}

Vector6d MaximalCoordinates::spatial(Index link, const VectorXd& accelerations,
                                     const Vector3d& origin, bool at_rest) const {
  const Body& body = bodies_[link];
  const Vector3d alpha = accelerations.segment<3>(6 * link),
                 a = accelerations.segment<3>(6 * link + 3);
  Vector6d found;
  found << alpha, a + alpha.cross(origin - body.c);  // of v + omega x (origin - c), c moving with v
  if (!at_rest) found.tail<3>() -= body.omega.cross(body.v);
  return found;
}

HandleDynamics MaximalCoordinates::handle_dynamics(const std::vector<Index>& handles,
                                                   const Vector3d& origin, const VectorXd& torques,
                                                   const Vector3d& gravity) const {
  const Index n = static_cast<Index>(handles.size());
  HandleDynamics dynamics{MatrixXd(6 * n, 6 * n), VectorXd(6 * n),
                          std::vector<Vector3d>(n, Vector3d::Zero())};
  const VectorXd bias = solve(own_forces(torques, gravity), false);
  for (Index h = 0; h < n; ++h)
    dynamics.phi.segment<6>(6 * h) = spatial(handles[h], bias, origin, false);
  for (Index column = 0; column < 6 * n; ++column) {
    VectorXd forces = VectorXd::Zero(6 * model_.size());
    add_force(handles[column / 6], Vector6d::Unit(column % 6), origin, forces);
    const VectorXd response = solve(forces, true);
    for (Index h = 0; h < n; ++h)
      dynamics.Phi.block<6, 1>(6 * h, column) = spatial(handles[h], response, origin, true);
  }
  return dynamics;
}

Accelerations MaximalCoordinates::accelerations(const std::vector<Index>& handles,
                                                const VectorXd& forces, const Vector3d& origin,
                                                const VectorXd& torques,
                                                const Vector3d& gravity) const {
  VectorXd all = own_forces(torques, gravity);
  for (std::size_t h = 0; h < handles.size(); ++h)
    add_force(handles[h], forces.segment<6>(6 * h), origin, all);
  const VectorXd found = solve(all, false);

  Accelerations result{VectorXd::Zero(model_.velocities()), {}};
  for (Index i = 0; i < model_.size(); ++i) {
    result.links.push_back(spatial(i, found, origin, false));
    const Link& link = model_.link(i);
    const Body& body = bodies_[i];
    const bool in_world = link.parent == Link::world;
    const Vector3d alpha = found.segment<3>(6 * i);
    const Vector3d alpha_p = in_world ? Vector3d::Zero().eval() : found.segment<3>(6 * link.parent);
    const Vector3d omega_p = in_world ? Vector3d::Zero().eval() : bodies_[link.parent].omega;
    const Index at = model_.u_of(i);
    if (link.joint == JointKind::revolute) {
      result.joints(at) = (body.R * link.axis).dot(alpha - alpha_p);
    } else if (link.joint == JointKind::ball) {  // d/dt R'(omega_c - omega_p)
      const Vector3d relative = body.omega - omega_p;
      result.joints.segment<3>(at) =
          body.R.transpose() * (alpha - alpha_p - body.omega.cross(relative));
    } else if (link.joint == JointKind::free) {
      const Vector3d r = body.p - body.c;
      result.joints.segment<3>(at) = alpha;
      result.joints.segment<3>(at + 3) =
          found.segment<3>(6 * i + 3) + alpha.cross(r) + body.omega.cross(body.omega.cross(r));
    }
  }
  return result;
}

}  // namespace lcp::cases
