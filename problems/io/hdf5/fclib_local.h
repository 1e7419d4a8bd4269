#pragma once

#include <string>

#include "problems/io/hdf5/values.h"
#include "problems/io/local_contacts.h"

namespace lcp {

/// A friction-contact problem of FCLIB, and how its W was stored.
struct FclibLocal {
  LocalContacts contacts;
  std::string storage;  ///< triplets, compressed columns or compressed rows.
};

/// Writes the group `fclib_local` into `parent`: spacedim = 3, W in compressed rows (W/nz = -2, with
/// W/m, n, nzmax, p, i, x) and vectors/q, mu. In a root group, FCLIB's own reader opens it. Entries
/// of W that are +0 are not stored. Throws H5::Exception.
/// Source: V. Acary et al., FCLIB, fclib_write_local.
void write_fclib_local(H5::Group& parent, const FrictionBlocks& blocks);

/// Reads it back, every bit of it, or what FCLIB itself wrote: spacedim 2 or 3; W/nz >= 0 for
/// triplets (row i, column p: the header of FCLIB says the opposite, its files and CSparse, by which
/// it multiplies, do not), -1 for compressed columns, -2 for compressed rows; entries stored twice
/// are added. Info, solution and guesses are left alone. Throws UnreadableInput on equality blocks
/// (V, R), on indices out of range, and on more than `most_contacts` contacts.
FclibLocal read_fclib_local(const hdf5::GroupReader& parent, Index most_contacts);

}  // namespace lcp
