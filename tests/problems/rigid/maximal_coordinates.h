#pragma once

#include "problems/rigid/forward_dynamics.h"

namespace lcp::cases {

/// Forward dynamics with every link a free body and every joint a set of equations, from the joints'
/// geometry by classical mechanics: no spatial vectors, nothing of problems/rigid but the model's
/// figures. For each link m a = m g + f and I alpha + omega x I omega = n about the centre of mass;
/// for each joint, where it stands on parent and child,
///
///     the two points accelerate alike,
///     alpha_c - alpha_p = omega_p x (omega_c - omega_p) + (a turn about the axes that are free);
///
/// and likewise for each loop, whose joint must be closed and move as it may; multipliers act on both
/// sides along the equations' rows. Solved densely, redundant equations included:
///
///     | M  -C' | | a      |   | forces |
///     | C   0  | | lambda | = | right  |
///
/// Cost: (6 links + constraints)^3.
class MaximalCoordinates {
 public:
  /// `acceleration`: of prescribed joints, in the order of Model::prescribed().
  MaximalCoordinates(const Model& model, const State& state, const VectorXd& acceleration);

  /// Of the links `handles` at `origin`, by one solution for each unit force.
  HandleDynamics handle_dynamics(const std::vector<Index>& handles, const Vector3d& origin,
                                 const VectorXd& torques, const Vector3d& gravity) const;
  /// `forces`: 6N at `origin` on the handles.
  Accelerations accelerations(const std::vector<Index>& handles, const VectorXd& forces,
                              const Vector3d& origin, const VectorXd& torques,
                              const Vector3d& gravity) const;

 private:
  /// A link as a free body: rotation, its frame's origin, centre of mass and their motions.
  struct Body {
    Matrix3d R;
    Vector3d p, c, omega, v;  ///< v: of the centre of mass.
  };

  void place(const State& state);
  void constrain(const VectorXd& acceleration);
  void constrain_loops(Index& rows);
  /// Accelerations (alpha; a of the centre of mass) of all links under such forces on them.
  VectorXd solve(const VectorXd& forces, bool at_rest) const;
  VectorXd own_forces(const VectorXd& torques, const Vector3d& gravity) const;
  void add_force(Index link, const Vector6d& at_origin, const Vector3d& origin,
                 VectorXd& forces) const;
  Vector6d spatial(Index link, const VectorXd& accelerations, const Vector3d& origin,
                   bool at_rest) const;

  const Model& model_;
  VectorXd u_;
  std::vector<Body> bodies_;
  MatrixXd C_;
  VectorXd right_;
  MatrixXd system_;
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> factor_;
};

}  // namespace lcp::cases
