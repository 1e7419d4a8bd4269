#pragma once

#include <map>
#include <string>

#include "problems/instance.h"
#include "problems/io/read_options.h"

namespace lcp {

/// A local friction-contact problem as FCLIB and Siconos store it: u = W r + q with Coulomb cones
/// |r_t| <= mu_i r_n at Nc contacts. Axes of a contact: normal first, then d - 1 tangents. It is
/// (14) with u = v+, r = f and q = vbar.
struct LocalContacts {
  Index dimension = 3;  ///< d: 3, or 2 in the plane.
  MatrixXd W;           ///< d Nc x d Nc.
  VectorXd q;           ///< d Nc.
  VectorXd mu;          ///< Nc.
};

/// How far W of a foreign file may be from symmetric, max |W - W'| / max |W|. Printed and iterated
/// matrices are not exact: those of the Siconos test suite reach 1.1e-5 (Rover), 1.3e-3 (capsules)
/// and 2.5e-3 (rock pile). Beyond this share it is another matrix, or rows taken for columns.
inline constexpr double foreign_asymmetry = 1e-2;

/// Throws std::invalid_argument naming `--directions` unless options.directions is even and >= 2.
void check(const ReadOptions& options);

/// Throws UnreadableInput, beginning with `where`, when the LCP of so many contacts has more than
/// `largest_rows` rows. Readers call it before they allocate W.
void require_readable_size(Index contacts, Index dimension, const ReadOptions& options,
                           const std::string& where);

/// The LCP (25) of local contacts as an instance, its numbers as they are: friction_lcp with
/// options.directions fixed directions. Contacts in the plane become contacts in space whose second
/// tangent W and q do not touch (zero rows and columns), with m = 2. Provenance gains dimension,
/// directions and asymmetry of W. Throws UnreadableInput beginning with `where`.
Instance contact_instance(const std::string& name, LocalContacts local, const ReadOptions& options,
                          std::map<std::string, std::string> provenance, const std::string& where);

}  // namespace lcp
