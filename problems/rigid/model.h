#pragma once

#include <string>
#include <vector>

#include "problems/rigid/spatial.h"
#include "solvers/problem.h"

namespace lcp {

/// How a link moves relative to its parent. In brackets: coordinates q and velocities u.
enum class JointKind {
  fixed,       ///< Not at all (0, 0).
  revolute,    ///< About an axis (1, 1): angle, rad, and its rate.
  prescribed,  ///< The same, following a reference motion whatever torque that takes (1, 1).
  ball,        ///< About a point (4, 3): unit quaternion x y z w of the relative rotation, and the
               ///< relative angular velocity in the link's axes, rad/s.
  free,        ///< Any motion in the world (7, 6): position of the link's frame, quaternion;
               ///< angular velocity, velocity of the frame's origin, both in world axes.
};

/// A rigid body and the joint that carries it. The joint sits at the origin of the link's frame.
struct Link {
  std::string name;
  Index parent = world;  ///< Comes before this link; free links stand in the world.
  JointKind joint = JointKind::free;
  Vector3d axis = Vector3d::UnitZ();    ///< Unit, of revolute and prescribed joints, link axes.
  Pose in_parent = {};                  ///< Link frame in the parent's at q = 0.
  double mass = 0;                      ///< kg, > 0.
  Vector3d centre = Vector3d::Zero();   ///< Centre of mass in the link frame, m.
  Matrix3d inertia = Matrix3d::Zero();  ///< About the centre of mass, link axes, kg m^2; positive
                                        ///< definite.
  /// Of a revolute or ball joint: the torque -damping u acts in it, N m s/rad, >= 0.
  double damping = 0;

  static constexpr Index world = -1;
};

/// A joint between links that have their places already: it closes a loop, or ties a free link to
/// something. It adds no coordinates; what it holds is kept by the dynamics, and errors that steps
/// of finite length leave decay:
///
///     d2e/dt2 + 2 r de/dt + r^2 e = 0,   e: how far the two sides of the joint are apart.
struct Loop {
  std::string name;
  JointKind joint = JointKind::ball;  ///< ball, revolute or fixed.
  Index link1 = Link::world;          ///< Or a link.
  Index link2 = 0;                    ///< Another link.
  Pose in_link1 = {}, in_link2 = {};  ///< The joint's frame in each.
  Vector3d axis = Vector3d::UnitZ();  ///< Unit, of a revolute joint, in both frames.
  double closing_rate = 100;          ///< r, 1/s; 0: errors stay.
};

/// How many coordinates and velocities a joint has.
struct JointSizes {
  Index coordinates, velocities;
  Index quaternion = -1;  ///< Where one begins among the coordinates; -1 without one.
};
constexpr JointSizes joint_sizes(JointKind kind) {
  constexpr JointSizes sizes[] = {{0, 0}, {1, 1}, {1, 1}, {4, 3, 0}, {7, 6, 3}};
  return sizes[static_cast<int>(kind)];
}
constexpr Index coordinates(JointKind kind) { return joint_sizes(kind).coordinates; }
constexpr Index velocities(JointKind kind) { return joint_sizes(kind).velocities; }

/// The rotation whose quaternion begins at `at`.
inline Eigen::Quaterniond read_quaternion(const VectorXd& q, Index at) {
  return Eigen::Quaterniond(q(at + 3), q(at), q(at + 1), q(at + 2));
}

/// Links with the places of their coordinates in the vectors q and u of the whole, and loops.
class Model {
 public:
  /// Throws std::invalid_argument, naming the link, unless parents come first, free links have no
  /// parent, masses are positive, inertias symmetric and positive definite, axes of unit length,
  /// frames rotations, and all numbers finite; likewise for loops, whose links must exist and differ.
  explicit Model(std::vector<Link> links, std::vector<Loop> loops = {});

  const std::vector<Link>& links() const { return links_; }
  const Link& link(Index i) const { return links_[i]; }
  const std::vector<Loop>& loops() const { return loops_; }
  Index size() const { return static_cast<Index>(links_.size()); }
  Index coordinates() const { return coordinates_; }
  Index velocities() const { return velocities_; }
  Index q_of(Index link) const { return q_of_[link]; }  ///< Where its coordinates begin in q.
  Index u_of(Index link) const { return u_of_[link]; }
  const Matrix3d& inverse_inertia(Index link) const { return inverse_inertia_[link]; }
  double mass() const;  ///< Of all links.

  /// The link called `name`; throws std::invalid_argument.
  Index find(const std::string& name) const;
  /// Links whose joint is prescribed, ascending.
  const std::vector<Index>& prescribed() const { return prescribed_; }

 private:
  std::vector<Link> links_;
  std::vector<Loop> loops_;
  std::vector<Index> q_of_, u_of_, prescribed_;
  std::vector<Matrix3d> inverse_inertia_;
  Index coordinates_ = 0, velocities_ = 0;
};

/// Where all links are and how fast they move.
struct State {
  VectorXd q;
  VectorXd u;
  double time = 0;  ///< s.
};

/// Every joint at zero, free links at the origin, at rest.
State state_at_zero(const Model& model);

/// Motion that prescribed joints follow, in the order of Model::prescribed(): angles (rad), rates
/// and accelerations. Twice continuously differentiable.
struct JointMotion {
  VectorXd angle, rate, acceleration;
};

/// Torques of the joints' damping at velocities u, in the order of u.
VectorXd damping_torques(const Model& model, const VectorXd& u);

/// dq/dt for velocities u: quaternions change by half their product with the angular velocity.
VectorXd coordinate_rates(const Model& model, const VectorXd& q, const VectorXd& u);

/// Moves q along u for dt: rotations by the exponential map, so that quaternions stay of unit length.
VectorXd moved(const Model& model, const VectorXd& q, const VectorXd& u, double dt);

/// Scales quaternions to unit length.
void normalise(const Model& model, VectorXd& q);

}  // namespace lcp
