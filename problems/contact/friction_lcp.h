#pragma once

#include "problems/contact/contact_problem.h"
#include "problems/contact/friction_directions.h"

namespace lcp {

/// The LCP (25) of a contact problem, unknowns [a (Nc) | b (m per contact) | lambda (1 per
/// contact)]:
///
///     | N'WN  N'WC  0  | | a      |   | N'vbar |   | w_a      |
///     | C'WN  C'WC  E' | | b      | + | C'vbar | = | w_b      |,   z >= 0, w >= 0, z'w = 0,
///     | mu    -E    0  | | lambda |   | 0      |   | w_lambda |
///
/// with f = N a + C b (20). Contacts with mu_i = 0 have neither b_i nor lambda_i, so that
/// n = Nc + (m + 1) #{mu_i > 0}. a, b in N, lambda in m/s; w_a, w_b in m/s, w_lambda in N.
///
/// Scales: v* = |vbar|_inf (1 if zero), f* = v* / mean normal diagonal of W (v* if that is zero);
/// rows a and b have s_z = f*, s_w = v*; rows lambda have s_z = v*, s_w = f*. `friction` is filled.
/// Throws std::invalid_argument on what check(ContactProblem) or friction_directions refuse.
/// Source: Yamane and Nakamura 2008, eqs. (14)-(26).
Problem friction_lcp(const ContactProblem& problem, const FrictionModel& model = {});

/// The LCP (25) of `blocks`, each unknown in the row that their lists give it, with the scales above.
/// The rows must share out 0 ... n - 1. The blocks of friction_lcp give its problem, bit for bit.
Problem assemble_friction_lcp(FrictionBlocks blocks);

/// The same contacts without friction, first of the two steps of IV-C: N'WN a + N'vbar = w_a,
/// n = Nc, with the scales and blocks of friction_lcp at mu = 0.
Problem frictionless_lcp(const ContactProblem& problem);

/// Sets s_z and s_w of an LCP (25) from its blocks, as friction_lcp does.
void set_contact_scales(Problem& problem);

/// True where some contact has mu_i > 0.
bool has_friction(const Problem& problem);

/// The frictionless LCP of the contacts behind a friction LCP: rows and columns normal_row of M and
/// q (also of the scales and a covering vector), in the order of the contacts, and its blocks at
/// mu = 0. Of friction_lcp(contacts) it is frictionless_lcp(contacts), bit for bit, with the
/// directions and pivot limit of `problem`. An island keeps the scales of its whole.
///
/// Throws std::invalid_argument if `problem` has no friction blocks.
Problem frictionless_part(const Problem& problem);

/// Contact forces f = N a + C b (20) in contact axes, 3 Nc, N, from the z (n) of the LCP to which
/// `blocks` belong. Throws std::invalid_argument if z is too short for the blocks' rows.
VectorXd contact_forces(const FrictionBlocks& blocks, const VectorXd& z);

/// Contact velocities v+ = W f + vbar (14) in contact axes, 3 Nc, m/s. Throws std::invalid_argument
/// unless f has 3 Nc entries.
VectorXd post_velocities(const FrictionBlocks& blocks, const VectorXd& forces);

}  // namespace lcp
