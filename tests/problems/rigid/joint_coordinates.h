#pragma once

#include "problems/rigid/forward_dynamics.h"

namespace lcp::cases {

/// The equation of motion in joint coordinates,
///
///     M(q) du/dt + c(q, u) = tau + J' F,
///
/// and what it says of handles. Prescribed joints' du/dt is known: their rows are left out.
struct JointCoordinates {
  MatrixXd M;                          ///< Of all u.
  VectorXd c;                          ///< With gravity; all of u, prescribed du/dt in it.
  VectorXd driven;                     ///< 1 for each u whose joint may have a torque, else 0.
  std::vector<MatrixXd> J;             ///< 6 x u of each link, at O.
  std::vector<Vector6d> bias;          ///< Acceleration of each link while du/dt = 0.
  std::vector<Index> free_velocities;  ///< Places in u that are not prescribed.

  /// J M^-1 J' of the links `handles`.
  MatrixXd delassus(const std::vector<Index>& handles) const {
    const MatrixXd Jh = jacobian(handles);
    return Jh * factor().solve(Jh.transpose());
  }

  /// du/dt under torques (none in free joints) and forces (6N at O) on `handles`.
  VectorXd accelerations(const std::vector<Index>& handles, const VectorXd& forces,
                         const VectorXd& torques) const {
    const VectorXd right = (driven.cwiseProduct(torques) - c)(free_velocities) +
                           jacobian(handles).transpose() * forces;
    VectorXd found = VectorXd::Zero(M.rows());
    found(free_velocities) = VectorXd(factor().solve(right));
    return found;
  }

 private:
  MatrixXd jacobian(const std::vector<Index>& handles) const {
    MatrixXd Jh(6 * handles.size(), free_velocities.size());
    for (std::size_t h = 0; h < handles.size(); ++h)
      Jh.middleRows<6>(6 * h) = J[handles[h]](Eigen::all, free_velocities);
    return Jh;
  }
  Eigen::LLT<MatrixXd> factor() const {
    return Eigen::LLT<MatrixXd>(MatrixXd(M(free_velocities, free_velocities)));
  }
};

/// From Jacobians of the links, M = sum J_i' M_i J_i, with what `kinematics` says of joints.
inline JointCoordinates joint_coordinates(const Model& model, const Kinematics& k,
                                          const Vector3d& gravity) {
  JointCoordinates found;
  const Index n = model.velocities();
  found.M = MatrixXd::Zero(n, n);
  found.c = VectorXd::Zero(n);
  found.driven = VectorXd::Zero(n);
  for (Index i = 0; i < model.size(); ++i) {
    const Link& link = model.link(i);
    MatrixXd J = MatrixXd::Zero(6, n);
    Vector6d bias = k.sigma[i];
    if (link.parent != Link::world) {
      J = found.J[link.parent];
      bias += found.bias[link.parent];
    }
    for (Index column = 0; column < k.S[i].cols(); ++column) {
      J.col(model.u_of(i) + column) += k.S[i].col(column);
      if (link.joint != JointKind::prescribed)
        found.free_velocities.push_back(model.u_of(i) + column);
    }
    if (link.joint == JointKind::revolute || link.joint == JointKind::ball)
      found.driven.segment(model.u_of(i), k.S[i].cols()).setOnes();
    const Matrix6d M = link_inertia(model, k, i);
    const Vector6d& v = k.velocity[i];
    const Vector3d r = k.from_origin(k.pose[i] * link.centre);
    found.M += J.transpose() * M * J;
    found.c +=
        J.transpose() * (M * bias + cross_force(v, M * v) - force_at(r, link.mass * gravity));
    found.J.push_back(std::move(J));
    found.bias.push_back(bias);
  }
  return found;
}

}  // namespace lcp::cases
