#include "problems/rigid/kinematics.h"

namespace lcp {

namespace {

/// Rotation of a joint's child relative to where it stands at q = 0.
Matrix3d joint_rotation(const Link& link, const VectorXd& q, Index at) {
  switch (link.joint) {
    case JointKind::revolute:
    case JointKind::prescribed:
      return Eigen::AngleAxisd(q(at), link.axis).toRotationMatrix();
    case JointKind::ball:
      return read_quaternion(q, at).toRotationMatrix();
    default:
      return Matrix3d::Identity();
  }
}

Pose link_pose(const Model& model, const VectorXd& q, Index i, const std::vector<Pose>& pose) {
  const Link& link = model.link(i);
  const Index at = model.q_of(i);
  if (link.joint == JointKind::free)
    return {read_quaternion(q, at + 3).toRotationMatrix(), q.segment<3>(at)};
  const Pose placed =
      link.parent == Link::world ? link.in_parent : pose[link.parent] * link.in_parent;
  return {placed.R * joint_rotation(link, q, at), placed.p};
}

Space motion_space(const Link& link, const Pose& pose, const Vector3d& r) {
  Space S(6, velocities(link.joint));
  switch (link.joint) {
    case JointKind::fixed:
      break;
    case JointKind::revolute:
    case JointKind::prescribed: {
      const Vector3d axis = pose.R * link.axis;
      S.col(0) = stack(axis, r.cross(axis));
      break;
    }
    case JointKind::ball:
      for (Index k = 0; k < 3; ++k) S.col(k) = stack(pose.R.col(k), r.cross(pose.R.col(k)));
      break;
    case JointKind::free:
      S.setIdentity();
      S.bottomLeftCorner<3, 3>() = skew(r);
      break;
  }
  return S;
}

/// Turn that takes the first rotation to the second, about an axis of the world.
Vector3d turn_between(const Matrix3d& from, const Matrix3d& to) {
  const Eigen::AngleAxisd turn(Matrix3d(to * from.transpose()));
  return turn.angle() * turn.axis();
}

LoopKinematics loop_kinematics(const Loop& loop, const Kinematics& k) {
  const auto placed = [&](Index link, const Pose& in_link) {
    return link == Link::world ? in_link : k.pose[link] * in_link;
  };
  LoopKinematics found;
  found.pose = placed(loop.link1, loop.in_link1);
  const Pose other = placed(loop.link2, loop.in_link2);
  const Vector6d first =
      loop.link1 == Link::world ? Vector6d::Zero().eval() : k.velocity[loop.link1];
  const Vector6d relative = k.velocity[loop.link2] - first;
  const Vector3d r = k.from_origin(found.pose.p), spin = relative.head<3>();

  Vector3d allowed = Vector3d::Zero(), turn = Vector3d::Zero();
  if (loop.joint == JointKind::ball) {
    allowed = spin;
  } else if (loop.joint == JointKind::revolute) {
    const Vector3d axis = found.pose.R * loop.axis;
    allowed = axis.dot(spin) * axis;
    turn = axis.cross(other.R * loop.axis);
  } else {
    turn = turn_between(found.pose.R, other.R);
  }
  const Vector3d apart = other.p - found.pose.p;
  found.gap = apart.norm();
  found.error = stack(turn, apart + r.cross(turn));
  const Vector6d motion = stack(allowed, r.cross(allowed));
  const double rate = loop.closing_rate;
  found.sigma =
      cross_motion(first, motion) - 2 * rate * (relative - motion) - rate * rate * found.error;
  return found;
}

}  // namespace

Kinematics kinematics(const Model& model, const State& state, const Vector3d& origin,
                      const VectorXd& acceleration) {
  Kinematics k;
  k.origin = origin;
  k.pose.reserve(model.size());
  k.velocity.reserve(model.size());
  k.S.reserve(model.size());
  k.sigma.reserve(model.size());
  Index next_prescribed = 0;
  for (Index i = 0; i < model.size(); ++i) {
    const Link& link = model.link(i);
    k.pose.push_back(link_pose(model, state.q, i, k.pose));
    k.S.push_back(motion_space(link, k.pose[i], k.from_origin(k.pose[i].p)));
    const auto u = state.u.segment(model.u_of(i), velocities(link.joint));
    const Vector6d relative = k.S[i] * u;
    if (link.joint == JointKind::free) {
      k.velocity.push_back(relative);
      // u holds the velocity of the link's frame; the motion that of the point at O, which rests.
      k.sigma.push_back(stack(Vector3d::Zero(), -u.head<3>().cross(u.tail<3>())));
      continue;
    }
    const Vector6d parent =
        link.parent == Link::world ? Vector6d::Zero().eval() : k.velocity[link.parent];
    k.velocity.push_back(parent + relative);
    k.sigma.push_back(cross_motion(parent, relative));
    if (link.joint == JointKind::prescribed) k.sigma[i] += k.S[i] * acceleration(next_prescribed++);
  }
  for (const Loop& loop : model.loops()) k.loops.push_back(loop_kinematics(loop, k));
  return k;
}

Kinematics kinematics(const Model& model, const State& state, const Vector3d& origin) {
  return kinematics(model, state, origin, VectorXd::Zero(model.prescribed().size()));
}

Vector3d centre_of_mass(const Model& model, const Kinematics& k) {
  Vector3d sum = Vector3d::Zero();
  for (Index i = 0; i < model.size(); ++i)
    sum += model.link(i).mass * (k.pose[i] * model.link(i).centre);
  return sum / model.mass();
}

std::vector<Vector3d> link_centres(const Model& model, const Kinematics& k) {
  std::vector<Vector3d> centres;
  for (Index i = 0; i < model.size(); ++i) centres.push_back(k.pose[i] * model.link(i).centre);
  return centres;
}

double largest_gap(const Kinematics& k) {
  double gap = 0;
  for (const LoopKinematics& loop : k.loops) gap = std::max(gap, loop.gap);
  return gap;
}

Matrix6d link_inertia(const Model& model, const Kinematics& k, Index i) {
  const Link& link = model.link(i);
  const Matrix3d& R = k.pose[i].R;
  return spatial_inertia(link.mass, k.from_origin(k.pose[i] * link.centre),
                         R * link.inertia * R.transpose());
}

Matrix6d link_mobility(const Model& model, const Kinematics& k, Index i) {
  if (i < 0) return Matrix6d::Zero();
  const Link& link = model.link(i);
  const Matrix3d& R = k.pose[i].R;
  return inverse_spatial_inertia(link.mass, R * link.centre,
                                 R * model.inverse_inertia(i) * R.transpose());
}

Vector6d momentum(const Model& model, const Kinematics& k) {
  Vector6d sum = Vector6d::Zero();
  for (Index i = 0; i < model.size(); ++i) sum += link_inertia(model, k, i) * k.velocity[i];
  return sum;
}

double energy(const Model& model, const Kinematics& k, const Vector3d& gravity) {
  double sum = 0;
  for (Index i = 0; i < model.size(); ++i) {
    const Link& link = model.link(i);
    sum += 0.5 * k.velocity[i].dot(link_inertia(model, k, i) * k.velocity[i]) -
           link.mass * gravity.dot(k.pose[i] * link.centre);
  }
  return sum;
}

}  // namespace lcp
