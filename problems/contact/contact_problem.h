#pragma once

#include <string>
#include <vector>

#include "solvers/problem.h"

namespace lcp {

/// What makes a contact the same one in the next frame: its pair of bodies and the feature that
/// touches (a corner of a sole, a bead of a link), whatever its index.
struct ContactId {
  Index body1 = 0;
  Index body2 = 0;
  Index feature = 0;

  bool operator==(const ContactId&) const = default;
};

/// One contact point. Forces act on body 1; velocities are of body 1 relative to body 2.
struct Contact {
  Eigen::Vector3d n;   ///< Unit normal from body 2 to body 1, world axes.
  Eigen::Vector3d t1;  ///< Unit tangents with n x t1 = t2, world axes.
  Eigen::Vector3d t2;
  double mu = 0;  ///< Friction coefficient, >= 0.
  ContactId id;
};

/// Contacts at one instant and what forces do to their velocities (eqs. 14-16):
///
///     v+ = W f + vbar,   W = dt J Phi J',   vbar = v- + dt phi.
///
/// Vectors stack the contacts' axes, normal first: (n, t1, t2) of contact 0, then of contact 1, ...
/// This is the local form of FCLIB (u = W r + q). Source: K. Yamane, Y. Nakamura, "A Numerically
/// Robust LCP Solver for Simulating Articulated Rigid Bodies in Contact", RSS 2008, IV-B.
struct ContactProblem {
  std::vector<Contact> contacts;
  MatrixXd W;         ///< 3 Nc x 3 Nc, m/s per N, symmetric, often rank-deficient.
  VectorXd vbar;      ///< 3 Nc, m/s: velocity at the end of the step without contact forces.
  VectorXd v_before;  ///< 3 Nc, m/s: velocity v- at its start; empty where unknown.
  double dt = 1e-3;   ///< s.
  /// How far W(i, j) and W(j, i) may differ, relative to W's largest entry: rounding in a matrix that
  /// is symmetric by its definition. Readers of measured or printed matrices raise it.
  double asymmetry_allowed = 1e-9;

  Index size() const { return static_cast<Index>(contacts.size()); }
};

/// Completes a contact frame: t1 is `along` without its part along `normal`, normalised, and
/// t2 = n x t1. Throws std::invalid_argument if `normal` is zero or `along` is parallel to it.
Contact make_contact(const Eigen::Vector3d& normal, const Eigen::Vector3d& along, double mu,
                     ContactId id);

/// `body1-body2-feature` of each contact, in their order, with spaces between.
std::string spell_ids(const std::vector<Contact>& contacts);

/// Axes of all contacts as rows, 3 Nc x 3: row 3i + k holds axis k of contact i in the world.
MatrixXd contact_axes(const std::vector<Contact>& contacts);

/// W = dt A'A, symmetric to the last bit, for A = M^-1/2 J' (degrees of freedom x 3 Nc) of bodies
/// with mass matrix M and contact velocities J nu.
MatrixXd delassus_matrix(const MatrixXd& A, double dt);

/// Throws std::invalid_argument, naming the field, unless shapes agree, numbers are finite, W is
/// symmetric to `asymmetry_allowed` of its largest entry, mu >= 0 and dt > 0. `where` begins the message.
void check(const ContactProblem& problem, const std::string& where);

}  // namespace lcp
