#pragma once

#include "problems/io/hdf5/values.h"

namespace lcp {

/// A local friction-contact problem as FCLIB stores it: u = W r + q with the Coulomb cone mu_i at
/// each of Nc contacts, contact axes (normal, tangent 1, tangent 2).
struct FclibLocal {
  MatrixXd W;   ///< 3 Nc x 3 Nc.
  VectorXd q;   ///< 3 Nc.
  VectorXd mu;  ///< Nc.
};

/// Writes the group `fclib_local` into `parent`: spacedim = 3, W in compressed rows (W/nz = -2, with
/// W/m, n, nzmax, p, i, x) and vectors/q, mu. In a root group, FCLIB's own reader opens it. Entries
/// of W that are +0 are not stored. Throws H5::Exception.
/// Source: V. Acary et al., FCLIB, fclib_write_local.
void write_fclib_local(H5::Group& parent, const FclibLocal& problem);

/// Reads it back, every bit of it. Throws UnreadableInput on what write_fclib_local does not write
/// (two dimensions, other storage, equality blocks V and R), on indices out of range, and on more
/// than `most_contacts` contacts.
FclibLocal read_fclib_local(const hdf5::GroupReader& parent, Index most_contacts);

}  // namespace lcp
