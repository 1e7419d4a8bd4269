#include "harness/studies/paper/columns/loop_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <stdexcept>

#include "harness/measure/children.h"
#include "problems/io/errors.h"
#include "problems/io/replace_file.h"

namespace lcp {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr double kFallen = std::numbers::pi / 4;

/// A spelling as a name of a file or directory.
std::string as_file_name(std::string spelling) {
  std::replace(spelling.begin(), spelling.end(), ':', ',');
  std::replace(spelling.begin(), spelling.end(), '/', '_');
  return spelling;
}

json to_json(const LoopQuestion& question) {
  return {{"scene", question.scene},
          {"solver", question.solver},
          {"criterion", to_string(question.acceptance.criterion)},
          {"tolerance", question.acceptance.tolerance},
          {"duration", question.duration ? json(*question.duration) : json()}};
}

/// Whether a simulation stopped at one limit would go on under another.
bool is_lower(const std::optional<double>& limit, const std::optional<double>& other) {
  return limit && (!other || *limit < *other);
}

void write(const fs::path& file, const LoopColumn& column) {
  const std::optional<double>& limit = column.question.limit;
  const json object = {{"question", to_json(column.question)},
                       {"limit", limit ? json(*limit) : json()},
                       {"summary", column.summary},
                       {"environment", column.environment},
                       {"commit", column.commit},
                       {"jobs", column.jobs}};
  replace_file(file.string(), object.dump(1) + "\n");
}

/// Scenes set up once; processes get them by forking.
class Stages {
 public:
  const NamedScene& of(const LoopQuestion& question) {
    const auto key = std::pair(question.scene, question.duration);
    auto place = stages_.find(key);
    if (place == stages_.end()) {
      place = stages_.emplace(key, make_scene(question.scene)).first;
      if (question.duration) place->second.setup.duration = *question.duration;
    }
    return place->second;
  }

 private:
  std::map<std::pair<std::string, std::optional<double>>, NamedScene> stages_;
};

std::size_t steps_of(const NamedScene& scene) {
  return static_cast<std::size_t>(std::lround(scene.setup.duration / scene.setup.stepping.dt));
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

bool LoopColumn::fell() const { return summary.tilt_max > kFallen || !summary.broken.empty(); }

fs::path loop_file(const LoopQuestion& question) {
  return fs::path("loop") / as_file_name(question.scene) /
         fmt::format("{}@{}.json", as_file_name(question.solver),
                     to_string(question.acceptance.criterion));
}

std::optional<LoopColumn> read_loop_column(const PaperDirectory& directory,
                                           const LoopQuestion& question) {
  const fs::path file = directory.path() / loop_file(question);
  if (!fs::exists(file)) return std::nullopt;
  const json object = read_json_file(file);
  LoopColumn column{question, {}, {}, {}, 1};
  json asked;
  std::optional<double> limit;
  try {
    asked = object.at("question");
    if (!object.at("limit").is_null()) limit = object.at("limit").get<double>();
    object.at("environment").get_to(column.environment);
    object.at("commit").get_to(column.commit);
    object.at("jobs").get_to(column.jobs);
    object.at("summary").get_to(column.summary);
  } catch (const json::exception& error) {
    throw UnreadableInput(fmt::format("{}: {}", file.string(), error.what()));
  } catch (const std::invalid_argument& error) {
    throw UnreadableInput(fmt::format("{}: {}", file.string(), error.what()));
  }
  if (asked != to_json(question) || column.commit != directory.environment().at("commit"))
    throw std::invalid_argument(
        fmt::format("{} is of commit {} and {}, this program is {} and asks for {}: move {} away, "
                    "or name another directory with --out",
                    file.string(), column.commit, asked.dump(),
                    directory.environment().at("commit").get<std::string>(),
                    to_json(question).dump(), directory.path().string()));
  if (column.summary.stopped && is_lower(limit, question.limit)) return std::nullopt;
  return column;
}

void compute_loop_columns(const PaperDirectory& directory,
                          const std::vector<LoopQuestion>& questions, int jobs,
                          const std::function<void(const Progress&)>& progress,
                          const std::atomic<bool>& interrupted, std::chrono::nanoseconds silence) {
  Stages stages;
  Progress state;
  std::vector<LoopColumn> columns;
  std::vector<ChildTask> tasks;
  std::vector<std::size_t> steps, beats(questions.size(), 0);
  for (const LoopQuestion& question : questions) {
    const NamedScene& scene = stages.of(question);
    const fs::path file = directory.path() / loop_file(question);
    make_directories(file.parent_path());
    columns.push_back(
        {question, {}, directory.environment_id(), directory.environment().at("commit"), jobs});
    tasks.push_back([&scene, file, column = columns.back()](const std::function<void()>& beat) {
      simulate(file, column, scene, beat);
    });
    steps.push_back(steps_of(scene));
    state.total += steps.back();
  }
  const auto ended = [&](const ChildEnd& end) {
    state.done += steps[end.task] - beats[end.task];  // those that it did not come to
    if (end.failure.empty()) return;
    LoopColumn& column = columns[end.task];
    column.summary.scene = column.question.scene;
    column.summary.solver = column.question.solver;
    column.summary.broken = end.failure;
    write(directory.path() / loop_file(column.question), column);
  };
  const auto beat = [&](std::size_t task) {
    if (beats[task] == steps[task]) return;
    ++beats[task];
    ++state.done;
    state.at = fmt::format("{} {}", questions[task].scene, questions[task].solver);
    progress(state);
  };
  run_children(tasks, jobs, silence, ended, beat, interrupted);
}

}  // namespace lcp
