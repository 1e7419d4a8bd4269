#include "harness/studies/paper/columns/loop_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numbers>

#include "problems/io/errors.h"
#include "problems/io/replace_file.h"

namespace lcp {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr double fallen_tilt = std::numbers::pi / 4;

json or_null(const std::optional<double>& value) { return value ? json(*value) : json(); }

json to_json(const LoopQuestion& question) {
  return {{"scene", question.scene},
          {"solver", question.solver},
          {"criterion", to_string(question.acceptance.criterion)},
          {"tolerance", question.acceptance.tolerance},
          {"duration", or_null(question.duration)}};
}

void write(const fs::path& file, const LoopColumn& column) {
  const json object = {{"question", to_json(column.question)},
                       {"limit", or_null(column.question.limit)},
                       {"summary", column.summary},
                       {"environment", column.environment},
                       {"commit", column.commit},
                       {"jobs", column.jobs}};
  replace_file(file.string(), object.dump(1) + "\n");
}

/// The work of a process: simulates and writes the frames, then the column, whose file says that
/// both are there.
void simulate(const fs::path& file, LoopColumn column, const NamedScene& scene,
              const std::function<void()>& beat) {
  const std::atomic<bool> never = false;
  const LoopRun run = run_in_the_loop(
      scene, make_solver(column.question.solver), column.question.acceptance,
      [&](const Simulation&, const Frame&, const FrameRecord&) { beat(); }, never,
      column.question.limit);
  column.summary = summarise(run, scene.setup.system.model.mass(), scene.setup.system.gravity);
  replace_file(fs::path(file).replace_extension(".csv").string(), frames_csv(run));
  write(file, column);
}

}  // namespace

bool LoopColumn::fell() const { return summary.tilt_max > fallen_tilt || !summary.broken.empty(); }

fs::path loop_file(const LoopQuestion& question) {
  std::string name = fmt::format("{}\n{}@{}.json", question.scene, question.solver,
                                 to_string(question.acceptance.criterion));
  std::replace(name.begin(), name.end(), ':', ',');
  std::replace(name.begin(), name.end(), '/', '_');
  std::replace(name.begin(), name.end(), '\n', '/');
  return fs::path("loop") / name;
}

std::optional<LoopColumn> read_loop_column(const PaperDirectory& directory,
                                           const LoopQuestion& question) {
  const fs::path file = directory.path() / loop_file(question);
  if (!fs::exists(file)) return std::nullopt;
  const json object = directory.read(file, to_json(question));
  try {
    LoopColumn column{question, object.at("summary"), object.at("environment"), object.at("commit"),
                      object.at("jobs")};
    const json& limit = object.at("limit");
    const bool lower = !limit.is_null() && (!question.limit || limit < *question.limit);
    if (column.summary.stopped && lower) return std::nullopt;
    return column;
  } catch (const std::exception& error) {
    throw UnreadableInput(fmt::format("{}: {}", file.string(), error.what()));
  }
}

std::vector<LoopQuestion> open_questions(const PaperDirectory* directory,
                                         const std::vector<LoopQuestion>& questions) {
  std::vector<LoopQuestion> open;
  for (const LoopQuestion& each : questions)
    if (std::find(open.begin(), open.end(), each) == open.end() &&
        !(directory && read_loop_column(*directory, each)))
      open.push_back(each);
  return open;
}

void compute_loop_columns(const PaperDirectory& directory,
                          const std::vector<LoopQuestion>& questions,
                          const std::atomic<bool>& interrupted) {
  // Scenes are set up once; processes get them by forking.
  std::map<std::pair<std::string, std::optional<double>>, NamedScene> scenes;
  std::vector<SimulatedTask> tasks;
  for (const LoopQuestion& question : open_questions(&directory, questions)) {
    const std::pair key(question.scene, question.duration);
    if (!scenes.contains(key)) scenes.emplace(key, scene_lasting(key.first, key.second));
    const NamedScene& scene = scenes.at(key);
    const fs::path file = directory.path() / loop_file(question);
    make_directories(file.parent_path());
    LoopColumn column{
        question, {}, directory.environment_id(), directory.commit(), directory.how.jobs};
    tasks.push_back({fmt::format("{} {}", question.scene, question.solver), steps_of(scene),
                     [&scene, file, column](const std::function<void()>& beat) {
                       simulate(file, column, scene, beat);
                     },
                     [file, column](const std::string& failure) mutable {
                       column.summary.scene = column.question.scene;
                       column.summary.solver = column.question.solver;
                       column.summary.broken = failure;
                       write(file, column);
                     }});
  }
  simulate_all(directory, tasks, directory.how.jobs, interrupted);
}

}  // namespace lcp
