#pragma once

#include <string>
#include <vector>

#include "problems/instance.h"
#include "problems/io/read_options.h"

namespace lcp {

/// Our corpus, an HDF5 file with one group per instance. The instance `squat-like/0042` is the group
/// /squat-like/0042 (nested groups); a file of one instance holds it in the root group, with the
/// attribute `name`, so that FCLIB's own reader opens its contacts. In the group of an instance:
///
///     M, q          n x n and n
///     s_z, s_w      n: the scales; plain ones (set_plain_scales) where they are missing
///     c             n: covering vector, where the instance has its own
///     known_solution  n, where known
///     previous_alpha, previous_z  rows (ascending) and n: the solution of the frame before, carried
///                   over to these rows, where known; z may be missing
///     fclib_local   W, vbar (as vectors/q) and mu of an instance with contacts
///     layout        its directions (2 x Nc m), normal_row, friction_row, cone_row (Nc each), and
///                   the attribute directions_per_contact
///     provenance    a group with one attribute, text or number, per key
///     attributes    sha256, pivot_limit, active_contacts (where known), previous_sha256
///                   (hash_with_previous, where that solution is known), and the features of
///                   problems/features.h for whoever browses the file
///
/// M and q are enough: a file written by hand, with numbers of any HDF5 type and names of its own,
/// is a corpus too; a sha256 that is there has to agree. A group with `fclib_local` and neither M nor
/// q is an instance as well, the LCP (25) of its contacts; with that in the root group, the file is
/// FCLIB's own. The root's instance, if it has no attribute `name`, is called after the file.
///
/// Vectors are datasets, since HDF5 holds no attribute beyond 64 kB. We store M and q also where the
/// contacts determine them: whoever reads gets the bits that were written, whatever becomes of the
/// code that assembles them. The root group of our files has the integer attribute corpus_version
/// = 1. The same instances give the same bytes.
///
/// Replaces `path` by a corpus of these instances (see replace_file). Throws std::invalid_argument
/// when there are none; UnwritableOutput when two have one name, when one lies inside the other
/// (a, a/b), when a name cannot be a path (empty parts, `.`, `#`) or the file cannot be written.
void write_corpus(const std::string& path, const std::vector<Instance>& instances);

/// The instances of a corpus, the root's first, then in order of their paths; or the one called
/// `name` alone. `unnamed` is what the root's instance is called if it does not say. Shapes, sizes
/// and finiteness are checked, and the content against its sha256. Throws UnreadableInput
/// `file: /group/dataset: what is wrong, what was expected`. The HDF5 library itself may crash on a
/// corrupted file: read foreign files through load_instances.
std::vector<Instance> read_corpus(const std::string& path, const std::string& name = "",
                                  const ReadOptions& options = {},
                                  const std::string& unnamed = "instance");

}  // namespace lcp
