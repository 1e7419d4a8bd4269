#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "harness/measure/children.h"
#include "harness/measure/runner.h"
#include "problems/io/file_descriptor.h"
#include "problems/scenes/scene.h"

namespace lcp {

/// How a table is computed.
struct Reproduction {
  std::filesystem::path directory;  ///< Of the table; see PaperDirectory.
  int jobs = 1;                     ///< Simulations, or pairs on the corpus, at the same time.
  std::function<void(const std::string&)> note = [](const std::string&) {};
  std::function<void(const Progress&)> progress = [](const Progress&) {};  ///< Of a stage.
};

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
  /// stores the environment. Throws std::invalid_argument in one line when it was begun by another
  /// commit, UnwritableOutput when it cannot be written or somebody else works in it, UnreadableInput
  /// when its files are damaged. What a user should know goes to `how.note`, each line once.
  explicit PaperDirectory(const Reproduction& how);
  /// Clears away what killed child processes left half-written.
  ~PaperDirectory();
  PaperDirectory(const PaperDirectory&) = delete;
  PaperDirectory& operator=(const PaperDirectory&) = delete;

  const std::filesystem::path& path() const { return how.directory; }
  std::string environment_id() const { return environment_.at("id"); }
  std::string commit() const { return environment_.at("commit"); }

  /// Reads a file of it, which must be of this program's commit and hold `question` (where it is not
  /// null). Throws std::invalid_argument in one line otherwise, UnreadableInput naming a damaged file.
  nlohmann::json read(const std::filesystem::path& file, const nlohmann::json& question = {}) const;

  Reproduction how;

 private:
  nlohmann::json environment_;
  FileDescriptor lock_;
};

/// Simulation of a scene in a process of its own.
struct SimulatedTask {
  std::string name;  ///< For whoever waits.
  std::size_t steps = 0;
  ChildTask work;                                          ///< A beat is a step.
  std::function<void(const std::string& failure)> failed;  ///< Called where it crashed or hung.
};

/// Runs the tasks, `jobs` at a time, telling of progress in steps. Throws as run_children does.
void simulate_all(const PaperDirectory& directory, const std::vector<SimulatedTask>& tasks,
                  int jobs, const std::atomic<bool>& interrupted);

/// A scene that lasts `duration` s, or as long as it does by itself.
NamedScene scene_lasting(const std::string& spelling, const std::optional<double>& duration);

/// Steps of time in a scene.
std::size_t steps_of(const NamedScene& scene);

}  // namespace lcp
