#include "problems/io/load.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <new>
#include <stdexcept>

#include "problems/io/child_process.h"
#include "problems/io/errors.h"
#include "problems/io/hdf5/corpus.h"
#include "problems/io/instance_image.h"
#include "problems/io/local_contacts.h"
#include "problems/io/text/json.h"
#include "problems/io/text/matrix_market.h"
#include "problems/io/text/siconos.h"
#include "solvers/errors.h"

namespace lcp {

namespace {

namespace fs = std::filesystem;

constexpr const char* known_endings = ".hdf5, .h5, .M.mtx (with .q.mtx beside it), .dat, .json";

/// A child that has not read a file by then is stopped. Our largest corpora take a few seconds.
constexpr unsigned foreign_file_seconds = 300;

enum class Format { corpus, matrix_market, siconos, json, unknown };

Format format_of(const std::string& path) {
  if (path.ends_with(".hdf5") || path.ends_with(".h5")) return Format::corpus;
  if (path.ends_with(matrix_market_ending)) return Format::matrix_market;
  if (path.ends_with(siconos_ending)) return Format::siconos;
  if (path.ends_with(json_ending)) return Format::json;
  return Format::unknown;
}

/// Name of the instance in a file without names: dir/x of dir/x.M.mtx or dir/x.dat.
std::string name_of_file(const std::string& path) {
  for (const char* ending : {matrix_market_ending, siconos_ending, json_ending, ".hdf5", ".h5"})
    if (path.ends_with(ending)) return path.substr(0, path.rfind(ending));
  return path;
}

/// The child reads and hands over what it found: the file that the HDF5 library survived there might
/// still break it here, where the memory looks different.
std::vector<Instance> load_corpus(const std::string& file, const std::string& name,
                                  const ReadOptions& options, const std::string& unnamed) {
  const std::string image =
      try_in_child(fmt::format("{}: reading it with the HDF5 library", file), foreign_file_seconds,
                   [&] { return to_image(read_corpus(file, name, options, unnamed)); });
  try {
    return from_image(image);
  } catch (const std::invalid_argument& error) {
    throw UnreadableInput("{}: {}", file, error.what());
  }
}

std::vector<Instance> named(std::vector<Instance> instances, const std::string& file,
                            const std::string& name) {
  if (name.empty()) return instances;
  for (Instance& instance : instances)
    if (instance.name == name) return {std::move(instance)};
  throw UnreadableInput("{}: holds no instance called '{}'", file, name);
}

/// The instances of a file, or the one called `name`; `relative` is the file's path from where the
/// names of instances begin that have none.
std::vector<Instance> load_file(const std::string& file, const std::string& name,
                                const fs::path& relative, const ReadOptions& options) {
  const std::string unnamed = name_of_file(relative);
  switch (format_of(file)) {
    case Format::corpus:
      return load_corpus(file, name, options, unnamed);
    case Format::matrix_market:
      return named({read_matrix_market(file, unnamed)}, file, name);
    case Format::siconos:
      return named({read_siconos(file, unnamed, options)}, file, name);
    case Format::json:
      return named(read_json(file, unnamed), file, name);
    case Format::unknown:
      break;
  }
  throw UnreadableInput("{}: unknown ending, expected {}", file, known_endings);
}

/// Files of known formats below a directory, sorted.
std::vector<std::string> files_below(const std::string& directory) {
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(directory))
    if (entry.is_regular_file() && format_of(entry.path().string()) != Format::unknown)
      files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<Instance> load_directory(const std::string& directory,
                                     const std::function<void(const std::string&)>& skipped,
                                     const ReadOptions& options) {
  std::vector<Instance> instances;
  std::map<std::string, std::string> file_of_name;
  for (const std::string& file : files_below(directory)) {
    std::vector<Instance> found;
    try {
      found = load_file(file, "", fs::path(file).lexically_relative(directory), options);
    } catch (const UnreadableInput& error) {
      if (!skipped) throw;
      skipped(error.what());
    }
    for (Instance& instance : found) {
      const auto [first, added] = file_of_name.try_emplace(instance.name, file);
      if (!added)
        throw UnreadableInput("{}: holds '{}' like {}, expected different names", file,
                              instance.name, first->second);
      instances.push_back(std::move(instance));
    }
  }
  if (instances.empty())
    throw UnreadableInput("{}: no readable instance in this directory, expected {}", directory,
                          known_endings);
  return instances;
}

}  // namespace

std::vector<Instance> load_instances(const std::string& where,
                                     const std::function<void(const std::string&)>& skipped,
                                     const ReadOptions& options) {
  check(options);
  try {
    if (fs::is_directory(where)) return load_directory(where, skipped, options);
    std::string file = where, name;
    const std::size_t hash = where.rfind('#');
    if (!fs::exists(where) && hash != std::string::npos) {
      file = where.substr(0, hash);
      name = where.substr(hash + 1);
      if (name.empty())
        throw UnreadableInput("{}: no name behind the '#', expected FILE#NAME", where);
    }
    if (fs::is_directory(file)) return named(load_directory(file, skipped, options), file, name);
    if (!fs::is_regular_file(file)) throw UnreadableInput("{}: no such file or directory", file);
    return load_file(file, name, fs::path(file).filename(), options);
  } catch (const fs::filesystem_error& error) {
    throw UnreadableInput("{}: {}", where, error.code().message());
  } catch (const std::bad_alloc&) {
    throw UnreadableInput("{}: larger than the memory that is left", where);
  }
}

void check_ending(const std::string& path) {
  const Format format = format_of(path);
  if (format == Format::siconos)
    throw InvalidArgument(
        "{}: Siconos files are read only, expected one of .hdf5, .h5, .M.mtx, .json", path);
  if (format == Format::unknown)
    throw InvalidArgument("{}: unknown ending, expected one of {}", path, known_endings);
}

void save_instances(const std::string& path, const std::vector<Instance>& instances) {
  check_ending(path);
  const Format format = format_of(path);
  if (format == Format::corpus) return write_corpus(path, instances);
  if (format == Format::json) return write_json(path, instances);
  if (instances.size() != 1)
    throw InvalidArgument("{}: {} instances for one Matrix Market pair, expected 1", path,
                          instances.size());
  write_matrix_market(path, instances.front());
}

}  // namespace lcp
