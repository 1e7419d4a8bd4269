#include "problems/rigid/transmission.h"

namespace lcp {

namespace {

/// Two perpendicular unit vectors across `axis`.
std::pair<Vector3d, Vector3d> across(const Vector3d& axis) {
  Index least;
  axis.cwiseAbs().minCoeff(&least);
  const Vector3d first = axis.cross(Vector3d::Unit(least)).normalized();
  return {first, axis.cross(first)};
}

/// Of a joint whose frame is turned by R.
Transmission transmission(JointKind kind, const Vector3d& axis_in_frame, const Matrix3d& R) {
  Transmission joint;
  switch (kind) {
    case JointKind::fixed:
    case JointKind::prescribed:
      joint.T = Space::Identity(6, 6);
      joint.F.resize(6, 0);
      break;
    case JointKind::revolute: {
      const Vector3d axis = R * axis_in_frame;
      const auto [first, second] = across(axis);
      joint.T = Space::Zero(6, 5);
      joint.T.col(0).head<3>() = first;
      joint.T.col(1).head<3>() = second;
      joint.T.bottomRightCorner<3, 3>().setIdentity();
      joint.F = stack(axis, Vector3d::Zero());
      break;
    }
    case JointKind::ball:
      joint.T = Space::Zero(6, 3);
      joint.T.bottomRows<3>().setIdentity();
      joint.F = Space::Zero(6, 3);
      joint.F.topRows<3>() = R;
      break;
    case JointKind::free:
      break;
  }
  return joint;
}

}  // namespace

Transmission link_transmission(const Model& model, const Kinematics& k, Index i) {
  return transmission(model.link(i).joint, model.link(i).axis, k.pose[i].R);
}

Transmission loop_transmission(const Model& model, const Kinematics& k, Index i) {
  const Loop& loop = model.loops()[i];
  Transmission found = transmission(loop.joint, loop.axis, k.loops[i].pose.R);
  found.F.resize(6, 0);  // no torque acts in it
  return found;
}

}  // namespace lcp
