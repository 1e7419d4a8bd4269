#include "problems/io/load.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "problems/io/child_process.h"
#include "problems/io/errors.h"
#include "problems/io/hdf5/corpus.h"
#include "problems/io/text/matrix_market.h"

namespace lcp {

namespace {

namespace fs = std::filesystem;

constexpr const char* known_endings = ".hdf5, .h5, .M.mtx (with .q.mtx beside it)";

/// A child that has not read a file by then is stopped. Our largest corpora take a few seconds.
constexpr unsigned foreign_file_seconds = 300;

enum class Format { corpus, matrix_market, unknown };

Format format_of(const std::string& path) {
  if (path.ends_with(".hdf5") || path.ends_with(".h5")) return Format::corpus;
  if (path.ends_with(matrix_market_ending)) return Format::matrix_market;
  return Format::unknown;
}

/// What the instance of a Matrix Market pair is called: dir/x of dir/x.M.mtx.
std::string pair_name(const std::string& path) {
  return path.substr(0, path.rfind(matrix_market_ending));
}

std::vector<Instance> load_corpus(const std::string& file, const std::string& name) {
  try_in_child(fmt::format("{}: reading it with the HDF5 library", file), foreign_file_seconds,
               [&] { read_corpus(file, name); });
  return read_corpus(file, name);
}

/// The instances of a file, or the one called `name`; `relative` is the file's path from where the
/// names of Matrix Market instances begin.
std::vector<Instance> load_file(const std::string& file, const std::string& name,
                                const fs::path& relative) {
  switch (format_of(file)) {
    case Format::corpus:
      return load_corpus(file, name);
    case Format::matrix_market:
      if (!name.empty() && name != pair_name(relative))
        throw UnreadableInput(fmt::format("{}: holds '{}', not an instance called '{}'", file,
                                          pair_name(relative), name));
      return {read_matrix_market(file, pair_name(relative))};
    case Format::unknown:
      break;
  }
  throw UnreadableInput(fmt::format("{}: unknown ending, expected {}", file, known_endings));
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
                                     const std::function<void(const std::string&)>& skipped) {
  std::vector<Instance> instances;
  std::map<std::string, std::string> file_of_name;
  for (const std::string& file : files_below(directory)) {
    std::vector<Instance> found;
    try {
      found = load_file(file, "", fs::path(file).lexically_relative(directory));
    } catch (const UnreadableInput& error) {
      if (!skipped) throw;
      skipped(error.what());
    }
    for (Instance& instance : found) {
      const auto [first, added] = file_of_name.try_emplace(instance.name, file);
      if (!added)
        throw UnreadableInput(fmt::format("{}: holds '{}' like {}, expected different names", file,
                                          instance.name, first->second));
      instances.push_back(std::move(instance));
    }
  }
  if (instances.empty())
    throw UnreadableInput(fmt::format("{}: no readable instance in this directory, expected {}",
                                      directory, known_endings));
  return instances;
}

}  // namespace

std::vector<Instance> load_instances(const std::string& where,
                                     const std::function<void(const std::string&)>& skipped) {
  try {
    if (fs::is_directory(where)) return load_directory(where, skipped);
    std::string file = where, name;
    const std::size_t hash = where.rfind('#');
    if (!fs::exists(where) && hash != std::string::npos) {
      file = where.substr(0, hash);
      name = where.substr(hash + 1);
      if (name.empty())
        throw UnreadableInput(fmt::format("{}: no name behind the '#', expected FILE#NAME", where));
    }
    if (!fs::is_regular_file(file))
      throw UnreadableInput(fmt::format("{}: no such file or directory", file));
    return load_file(file, name, fs::path(file).filename());
  } catch (const fs::filesystem_error& error) {
    throw UnreadableInput(fmt::format("{}: {}", where, error.code().message()));
  }
}

void save_instances(const std::string& path, const std::vector<Instance>& instances) {
  switch (format_of(path)) {
    case Format::corpus:
      return write_corpus(path, instances);
    case Format::matrix_market:
      if (instances.size() != 1)
        throw std::invalid_argument(fmt::format(
            "{}: {} instances for one Matrix Market pair, expected 1", path, instances.size()));
      return write_matrix_market(path, instances.front());
    case Format::unknown:
      break;
  }
  throw std::invalid_argument(
      fmt::format("{}: unknown ending, expected one of {}", path, known_endings));
}

}  // namespace lcp
