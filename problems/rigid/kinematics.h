#pragma once

#include "problems/rigid/model.h"

namespace lcp {

/// How a loop's joint stands at one instant.
struct LoopKinematics {
  Pose pose;       ///< Of the joint's frame in the world, on link 1.
  Vector6d error;  ///< How far the joint is open, (angle; distance), at O: 0 where it is closed.
  /// As Kinematics::sigma, of link 2 relative to link 1, with what closes the error.
  Vector6d sigma;
  double gap = 0;  ///< Distance of the joint's two points, m.
};

/// Where the links are and how they move at one instant; spatial vectors at `origin`, world axes.
struct Kinematics {
  Vector3d origin = Vector3d::Zero();  ///< O in the world: near the system, which keeps digits.
  std::vector<Pose> pose;              ///< Of each link's frame in the world.
  std::vector<Vector6d> velocity;      ///< Of each link, (omega; v_O).
  std::vector<Space> S;                ///< Motions each joint allows, one column per velocity u.
  /// What the velocities of joint and parent, and the reference motion of a prescribed joint, add:
  /// a_link = a_parent + S du/dt + sigma; a prescribed joint's S du/dt is in sigma.
  std::vector<Vector6d> sigma;
  std::vector<LoopKinematics> loops;

  Vector3d from_origin(const Vector3d& position) const { return position - origin; }
};

/// `origin` is O, in the world. `acceleration` holds the reference accelerations of prescribed
/// joints in the order of Model::prescribed(). Cost: O(links).
Kinematics kinematics(const Model& model, const State& state, const Vector3d& origin,
                      const VectorXd& acceleration);

/// The same with prescribed joints at constant speed.
Kinematics kinematics(const Model& model, const State& state,
                      const Vector3d& origin = Vector3d::Zero());

/// Centre of mass of all links, m.
Vector3d centre_of_mass(const Model& model, const Kinematics& kinematics);

/// Momentum of all links at O: moment about O (kg m^2/s), then linear momentum (kg m/s).
Vector6d momentum(const Model& model, const Kinematics& kinematics);

/// Kinetic energy, and potential energy over z = 0 under gravity (m/s^2, world axes); J.
double energy(const Model& model, const Kinematics& kinematics, const Vector3d& gravity);

/// Centre of mass of each link, m.
std::vector<Vector3d> link_centres(const Model& model, const Kinematics& kinematics);

/// Largest distance by which a loop's joint is open, m; 0 without loops.
double largest_gap(const Kinematics& kinematics);

/// Inertia of link i at O.
Matrix6d link_inertia(const Model& model, const Kinematics& kinematics, Index i);

/// Its inverse, but at the origin of the link's frame: how the link by itself answers to forces
/// there. 0 for i < 0, the world.
Matrix6d link_mobility(const Model& model, const Kinematics& kinematics, Index i);

}  // namespace lcp
