#pragma once

#include "problems/contact/contact_problem.h"
#include "problems/contact/reduction.h"
#include "problems/rigid/forward_dynamics.h"

namespace lcp {

/// Number of a link as a contact's body: bodies count from 1, 0 is the world.
inline Index body_of(Index link) { return link + 1; }

/// Contacts between links, and between links and the world, at one instant: eqs. (11)-(13).
struct LinkContacts {
  std::vector<Contact> contacts;
  MatrixXd J;         ///< 3 Nc x 6N (11): relative velocities of contacts from the handles'.
  VectorXd velocity;  ///< 3 Nc, v, m/s.
  VectorXd velocity_product;  ///< 3 Nc, dJ/dt v-hat (13), m/s^2.
  VectorXd depth;             ///< Nc, overlap, m.
};

/// How positions answer to contacts that velocities alone decide.
struct PositionCorrection {
  double gain =
      0.005;  ///< Share of an overlap that one step takes back: w_a = N'v+ - gain depth/dt.
};

/// `handles` must hold every link that a point names. Tangents: t1 is the world's x, or y where that
/// is nearly along the normal. Throws std::invalid_argument when a body is neither a handle nor the
/// world.
LinkContacts link_contacts(const std::vector<ContactPoint>& points, double mu,
                           const Kinematics& kinematics, const std::vector<Index>& handles);

/// The contact problem of one Euler step of length dt from v- (14)-(16):
///
///     W = dt J Phi J',   vbar = v- + dt (J phi + dJ/dt v-hat) - gain depth/dt on normal rows.
ContactProblem contact_problem(const LinkContacts& contacts, const HandleDynamics& dynamics,
                               double dt, const PositionCorrection& correction);

/// The same from a factor A, J Phi J' = A'A (CompositeBody, JointSpace), instead of Phi: W = dt A'A
/// is symmetric and positive semidefinite up to rounding of its entries.
ContactProblem contact_problem(const LinkContacts& contacts, const HandleDynamics& dynamics,
                               const MatrixXd& A, double dt, const PositionCorrection& correction);

}  // namespace lcp
