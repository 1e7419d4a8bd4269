#pragma once

#include <Eigen/Dense>
#include <optional>
#include <string>
#include <vector>

namespace lcp {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The contact problem behind a friction LCP, for methods that work contact by contact.
///
/// v+ = W f + vbar (eq. 14) in contact axes (normal, tangent 1, tangent 2), force on body 1 of each
/// pair and velocity of body 1 relative to body 2; |f_t| is bounded by the polygon
/// mu_i f_n conv{c_m}. The vectors tell where contact i's unknowns stand in the LCP (25).
struct FrictionBlocks {
  MatrixXd W;     ///< 3 Nc x 3 Nc, m/s per N: dt J Phi J' (15), symmetric, often rank-deficient.
  VectorXd vbar;  ///< 3 Nc, m/s: velocity at the end of the step without contact forces (16).
  VectorXd mu;    ///< Nc, friction coefficients, >= 0.
  MatrixXd
      directions;  ///< 2 x Nc*m: unit vectors c_im in contact i's tangent plane, columns i*m...
  Index directions_per_contact = 0;  ///< m: even, c_i,m/2+k = -c_ik; in ascending angle.
  std::vector<Index> normal_row;     ///< Row of a_i.
  std::vector<Index> friction_row;   ///< Row of b_i1 (b_im follow one another); -1 where mu_i = 0.
  std::vector<Index> cone_row;       ///< Row of lambda_i; -1 where mu_i = 0.

  Index contacts() const { return mu.size(); }
  /// Rows of contact i's unknowns: a, then b_1 ... b_m and lambda where it has friction.
  std::vector<Index> rows_of(Index i) const;
};

/// Calls visit(name, field) for every field, in their order. `blocks` may be const.
template <class Blocks, class Visit>
void each_field(Blocks& blocks, const Visit& visit) {
  visit("W", blocks.W);
  visit("vbar", blocks.vbar);
  visit("mu", blocks.mu);
  visit("directions", blocks.directions);
  visit("directions_per_contact", blocks.directions_per_contact);
  visit("normal_row", blocks.normal_row);
  visit("friction_row", blocks.friction_row);
  visit("cone_row", blocks.cone_row);
}

/// LCP(M, q): find z with w = M z + q, w >= 0, z >= 0, w'z = 0 (eqs. 1-2).
///
/// M is n x n and need be neither symmetric nor definite. Components of z and w carry different
/// units; s_z and s_w (n, positive) make them comparable: z_i / s_z,i and w_i / s_w,i are
/// dimensionless.
struct Problem {
  MatrixXd M;
  VectorXd q;
  VectorXd s_z;
  VectorXd s_w;
  VectorXd c;  ///< Covering vector (n, positive); empty means 1 in whatever scale a solver works.
  /// Pivots allowed before `limit`; 0 means max(1000, 50 n). Exponential families set 2^(n+1).
  Index pivot_limit = 0;
  std::optional<FrictionBlocks> friction;

  Index size() const { return q.size(); }
  Index max_pivots() const {
    return pivot_limit > 0 ? pivot_limit : std::max<Index>(1000, 50 * size());
  }
};

/// The rows and columns `rows` of M, with those of q, scales and covering vector, and the pivot limit;
/// without friction blocks.
Problem restricted(const Problem& problem, const std::vector<Index>& rows);

/// Fills s_z and s_w of a problem without contact structure: s_w = |q|_inf (1 if zero),
/// s_z = s_w / max |M| (s_w if M is zero).
void set_plain_scales(Problem& problem);

/// Throws std::invalid_argument, naming the field, unless shapes agree, every number is finite and
/// scales and covering vector are positive. `where` begins the message.
void check(const Problem& problem, const std::string& where);

}  // namespace lcp
