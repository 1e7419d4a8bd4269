#pragma once

#include <functional>
#include <string>
#include <vector>

#include "problems/instance.h"
#include "problems/io/read_options.h"

namespace lcp {

/// Instances named on the command line. `where` is one of
///
///     FILE         all instances of a file
///     FILE#NAME    the instance of that name; likewise DIRECTORY#NAME
///     DIRECTORY    all instances of the files below it with the endings that follow, in order of
///                  paths
///
///     .hdf5, .h5   a corpus of ours, or groups with M and q, or a local problem of FCLIB
///     .M.mtx       a Matrix Market pair, with .q.mtx beside it
///     .dat         Siconos: an LCP or local friction contacts
///     .json        one instance or several
///
/// An instance that its file does not name is called after the file, without the ending; in a
/// directory by the path from there. `options` say what a file of contacts leaves open.
///
/// HDF5 files are read in a child process, which hands over what it found (try_in_child), since the
/// library may itself crash on a corrupted one. Throws UnreadableInput, in one line, when nothing is
/// there, a file cannot be read, its ending is unknown, or two instances have one name;
/// std::invalid_argument on options that no file could use. With `skipped`, an unreadable file of a
/// directory is reported there by its line and left out instead.
std::vector<Instance> load_instances(const std::string& where,
                                     const std::function<void(const std::string&)>& skipped = {},
                                     const ReadOptions& options = {});

/// Throws std::invalid_argument, naming the known endings, unless save_instances knows that of `path`.
/// For who works long before there is something to write.
void check_ending(const std::string& path);

/// Writes instances in the format of the ending: a corpus (.hdf5, .h5), a Matrix Market pair
/// (NAME.M.mtx, one instance) or JSON (.json). Throws std::invalid_argument on another ending, naming
/// the known ones, and on no instance or several for a pair; UnwritableOutput as write_corpus,
/// write_matrix_market and write_json say.
void save_instances(const std::string& path, const std::vector<Instance>& instances);

}  // namespace lcp
