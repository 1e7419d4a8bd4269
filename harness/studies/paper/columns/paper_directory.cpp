#include "harness/studies/paper/columns/paper_directory.h"

#include <fcntl.h>
#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <memory>
#include <set>
#include <stdexcept>

#include "harness/measure/environment.h"
#include "problems/io/errors.h"
#include "problems/io/replace_file.h"

namespace lcp {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr auto step_silence = std::chrono::minutes(2);  ///< A step may last.

/// Held until the descriptor is closed. Child processes do not inherit it.
FileDescriptor lock(const fs::path& directory) {
  const std::string path = (directory / "lock").string();
  FileDescriptor file(open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
  if (file.get() < 0)
    throw UnwritableOutput(fmt::format("{}: cannot write: {}", path, std::strerror(errno)));
  struct flock whole {};
  whole.l_type = F_WRLCK;
  whole.l_whence = SEEK_SET;
  if (fcntl(file.get(), F_SETLK, &whole) != 0 && (errno == EACCES || errno == EAGAIN))
    throw UnwritableOutput(fmt::format("{}: another process works in it", directory.string()));
  return file;
}

}  // namespace

PaperDirectory::PaperDirectory(const Reproduction& asked)
    : how(asked), environment_(describe_environment(how.jobs)) {
  // Run directories repeat what they note.
  how.note = [note = asked.note,
              told = std::make_shared<std::set<std::string>>()](const std::string& line) {
    if (told->insert(line).second) note(line);
  };
  make_directories(path());
  for (const fs::directory_entry& entry : fs::directory_iterator(path()))
    if (entry.path().filename().string().starts_with("env-")) read(entry.path());
  lock_ = lock(path());
  remove_unfinished(path());
  if (environment_.at("dirty") == true)
    how.note("built from a changed tree: columns of different code cannot be told apart");
  const fs::path file = path() / fmt::format("env-{}.json", environment_id());
  if (!fs::exists(file)) replace_file(file.string(), environment_.dump(1) + "\n");
}

PaperDirectory::~PaperDirectory() {
  try {
    remove_unfinished(path());
  } catch (const std::exception&) {  // the next session does it
  }
}

json PaperDirectory::read(const fs::path& file, const json& question) const {
  std::ifstream stream(file);
  json object = json::parse(stream, nullptr, false);
  const bool asks = !question.is_null();
  if (!object.is_object() || !object.contains("commit") || (asks && !object.contains("question")))
    throw UnreadableInput(fmt::format("{}: expected a JSON object with field 'commit'{}",
                                      file.string(), asks ? " and field 'question'" : ""));
  if (object["commit"] == commit() && (!asks || object["question"] == question)) return object;
  const auto stated = [&](const json& commit, const char* has, const json& asked) {
    return commit.dump() + (asks ? has + asked.dump() : "");
  };
  throw std::invalid_argument(fmt::format(
      "{} is of commit {}, this program is {}: move {} away, or name another directory with --out",
      file.string(), stated(object["commit"], " and ", asks ? object["question"] : json()),
      stated(commit(), " and asks for ", question), path().string()));
}

void simulate_all(const PaperDirectory& directory, const std::vector<SimulatedTask>& tasks,
                  int jobs, const std::atomic<bool>& interrupted) {
  Progress state;
  std::vector<ChildTask> work;
  std::vector<std::size_t> beats(tasks.size(), 0);
  for (const SimulatedTask& task : tasks) {
    work.push_back(task.work);
    state.total += task.steps;
  }
  run_children(
      work, jobs, step_silence,
      [&](const ChildEnd& end) {
        state.done += tasks[end.task].steps - beats[end.task];  // those that it did not come to
        if (!end.failure.empty()) tasks[end.task].failed(end.failure);
      },
      [&](std::size_t task) {
        if (beats[task] == tasks[task].steps) return;
        ++beats[task];
        ++state.done;
        state.at = tasks[task].name;
        directory.how.progress(state);
      },
      interrupted);
}

NamedScene scene_lasting(const std::string& spelling, const std::optional<double>& duration) {
  NamedScene scene = make_scene(spelling);
  if (duration) scene.setup.duration = *duration;
  return scene;
}

std::size_t steps_of(const NamedScene& scene) {
  return static_cast<std::size_t>(std::lround(scene.setup.duration / scene.setup.stepping.dt));
}

}  // namespace lcp
