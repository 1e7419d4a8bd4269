#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "problems/io/file_descriptor.h"

namespace lcp {

/// The directory in which the columns of one table are kept:
///
///     env-ID.json         on what they were computed; a column names its environment by id
///     loop/SCENE/         a simulation per column, SOLVER@CRITERION.json, and .csv with its frames
///     corpus/             the LCPs of the scene, complete when corpus.json stands beside it
///     corpus-rows/        rows of the columns on them, a run directory per file of the corpus
///
/// While this object lives no other process may work in it.
class PaperDirectory {
 public:
  /// Makes the directory or goes on with it, clears away what a killed program left half-written, and
  /// stores the environment with `jobs`. Throws std::invalid_argument in one line when it was begun
  /// by another commit, UnwritableOutput when it cannot be written or somebody else works in it,
  /// UnreadableInput when its files are damaged. What a user should know goes to `note`.
  PaperDirectory(const std::filesystem::path& path, int jobs,
                 const std::function<void(const std::string&)>& note);
  /// Clears away what killed child processes left half-written.
  ~PaperDirectory();
  PaperDirectory(const PaperDirectory&) = delete;
  PaperDirectory& operator=(const PaperDirectory&) = delete;

  const std::filesystem::path& path() const { return path_; }
  const nlohmann::json& environment() const { return environment_; }
  std::string environment_id() const { return environment_.at("id"); }

 private:
  std::filesystem::path path_;
  nlohmann::json environment_;
  FileDescriptor lock_;
};

/// Reads a JSON file. Throws UnreadableInput naming it.
nlohmann::json read_json_file(const std::filesystem::path& path);

}  // namespace lcp
