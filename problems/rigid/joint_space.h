#pragma once

#include "problems/rigid/forward_dynamics.h"

namespace lcp {

/// How handles answer to forces, J Phi J' as in HandleDynamics, as a product A'A instead of a
/// difference: from the mass matrix M of the joints' velocities u, prescribed ones left out,
///
///     M = L L',   B = L^-1 (J K)',   C = L^-1 G',   A = Q'B,   Q'Q = 1, C'Q = 0,
///
/// where K (6N x n) maps u to the handles' velocities and G u = 0 (c x n) holds the loops closed.
/// The columns of Q span what C leaves free, so that A'A = B'(1 - C C^+) B; C may be redundant. A
/// has as many rows as the system has freedoms.
///
/// A'A is symmetric and positive semidefinite up to rounding of its entries, and of a rank no
/// higher than the number of freedoms; what rounding changes is the system, by about 1e-16 cond(M)
/// relative. Cost for l links and m rows of J: O(l depth) for M, n^3/3 for L, n^2 (m + c) for B and
/// C, 2 n c (m + c) for Q and A, O(l m) for J K.
///
/// Source: R. Featherstone, Rigid Body Dynamics Algorithms (2008), 6.2 (M by composite bodies) and
/// 8 (loops).
class JointSpace {
 public:
  /// `options.redundancy` means the same: a direction of a loop's joint that answers less than this
  /// share once others hold is held already. `model` must outlive this. Throws
  /// std::invalid_argument on handles as ForwardDynamics does.
  JointSpace(const Model& model, std::vector<Index> handles, const AssemblyOptions& options = {});

  /// A, freedoms x rows of J, for J (rows x 6N) of the handles' velocities.
  MatrixXd contact_factor(const Kinematics& kinematics, const MatrixXd& J) const;

  /// n, velocities that are not prescribed.
  Index velocities() const { return velocities_; }

 private:
  Index columns(Index link) const;  ///< How many of the n belong to the link's joint.
  MatrixXd mass_matrix(const Kinematics& kinematics) const;
  MatrixXd of_joints(const Kinematics& kinematics, MatrixXd of_links) const;
  MatrixXd loop_rates(const Kinematics& kinematics) const;

  const Model* model_;
  std::vector<Index> handles_;
  AssemblyOptions options_;
  std::vector<Index> column_of_;  ///< Where the velocities of a link's joint begin among the n.
  Index velocities_ = 0;
};

}  // namespace lcp
