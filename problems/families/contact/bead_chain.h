#pragma once

#include <vector>

#include "problems/contact/contact_problem.h"

namespace lcp {

/// A chain of thin rigid rods joined end to end by ball joints, each with a bead, a small sphere, at
/// `bead_offset` on either side of its centre; the beads touch a fixed horizontal rod.
///
/// Maximal coordinates: link i has its centre x_i, the unit vector d_i from its head to its tail,
/// and a twist (v_i, omega_i) in world axes about x_i, stacked in nu (6 L). Its inertia is
/// m_i l^2 / 12 across d_i and `axial_share` of that along d_i, which regularises a rod that is thin.
struct BeadChain {
  double link_length = 0;  ///< l, m.
  double bead_radius = 0;  ///< m.
  double bead_offset = 0;  ///< m, at most l / 2.
  double axial_share = 0;  ///< Positive.
  VectorXd masses;         ///< L, kg.
  Eigen::Vector3d head;    ///< Free end of link 0, m.
  MatrixXd axes;           ///< 3 x L, column i is d_i.
  VectorXd nu;             ///< 6 L, m/s and rad/s.

  Index links() const { return masses.size(); }
  /// Centres of all links, 3 x L, that follow from `head` and `axes`.
  MatrixXd centres() const;
  /// Moves head and axes along nu for `dt` s and keeps the axes of unit length.
  void advance(double dt);
};

/// What the beads touch: a cylinder about the y axis through the origin, without ends.
struct FixedRod {
  double radius = 0;             ///< m.
  double margin = 0;             ///< m: beads whose gap is at most this are contacts.
  double mu = 0;                 ///< Friction coefficient.
  double position_gain = 0.005;  ///< Share of a penetration that one step takes back.
};

/// The dynamics of a chain at one pose under gravity (9.81 m/s^2 along -z), with the joints
/// eliminated.
///
/// With M the block-diagonal inertia, G nu = 0 the joints (3 (L - 1) rows) and P the orthogonal
/// projection onto the null space of G M^-1/2,
///
///     nu+ = nu_free + B f,   nu_free = M^-1/2 P M^1/2 (nu + dt M^-1 h),   B = dt M^-1/2 P M^-1/2 J',
///     W = J B = dt (P M^-1/2 J')' (P M^-1/2 J'),   vbar = J nu_free,
///
/// h holding weight and the gyroscopic moment. W is symmetric to the last bit and has no negative
/// eigenvalue beyond rounding. The normal entry of vbar of a contact with gap g < 0 has
/// `position_gain` g / dt added. Frames: n from the rod's axis to the bead, t1 around the rod, t2
/// along it. Ids: link + 1, 0 (the rod), bead (0 towards the head, 1 towards the tail).
class ChainStep {
 public:
  ChainStep(const BeadChain& chain, const FixedRod& rod, double dt);

  const ContactProblem& contact_problem() const { return problem_; }
  /// J, 3 Nc x 6 L: contact velocities are J nu.
  const MatrixXd& contact_jacobian() const { return J_; }
  /// nu+ under contact forces (3 Nc, N, contact axes).
  VectorXd velocity_after(const VectorXd& forces) const { return nu_free_ + response_ * forces; }

 private:
  ContactProblem problem_;
  MatrixXd J_;
  VectorXd nu_free_;
  MatrixXd response_;  ///< B.
};

/// The velocity nearest to `chain.nu` in the kinetic metric that the joints allow: M^-1/2 P M^1/2 nu.
VectorXd joined_velocity(const BeadChain& chain);

}  // namespace lcp
