#pragma once

#include <functional>
#include <string>
#include <vector>

#include "problems/instance.h"

namespace lcp {

/// Instances named on the command line. `where` is one of
///
///     FILE         all instances of a corpus (.hdf5, .h5) or of a Matrix Market pair (NAME.M.mtx,
///                  whose instance is called NAME)
///     FILE#NAME    the instance of that name
///     DIRECTORY    all instances of the files below it with these endings, in order of paths;
///                  a Matrix Market instance is then called by its path from there
///
/// HDF5 files are read in a child process first (try_in_child), since the library may itself crash
/// on a corrupted one. Throws UnreadableInput, in one line, when nothing is there, a file cannot be
/// read, its ending is unknown, or two instances have one name. With `skipped`, an unreadable file of
/// a directory is reported there by its line and left out instead.
std::vector<Instance> load_instances(const std::string& where,
                                     const std::function<void(const std::string&)>& skipped = {});

/// Writes instances in the format of the ending: a corpus (.hdf5, .h5), or a Matrix Market pair
/// (NAME.M.mtx, one instance). Throws std::invalid_argument on another ending, naming the known ones,
/// and on no instance or several for a pair; UnwritableOutput as write_corpus and write_matrix_market
/// say.
void save_instances(const std::string& path, const std::vector<Instance>& instances);

}  // namespace lcp
