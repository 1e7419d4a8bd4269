#include "harness/studies/loop/tracked_runs.h"

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <memory>
#include <system_error>

#include "harness/measure/children.h"

namespace lcp {

namespace {

/// A file without a name in which a process leaves its track. It goes with its last user.
class Mailbox {
 public:
  Mailbox() : file_(std::tmpfile(), &std::fclose) {
    if (!file_) throw std::system_error(errno, std::generic_category(), "temporary file");
  }

  void put(const Track& track) const {
    const std::vector<std::uint8_t> bytes = nlohmann::json::to_cbor(track);
    if (std::fwrite(bytes.data(), 1, bytes.size(), file_.get()) != bytes.size() ||
        std::fflush(file_.get()) != 0)
      throw std::system_error(errno, std::generic_category(), "temporary file");
  }

  Track take() const {
    std::rewind(file_.get());
    return nlohmann::json::from_cbor(file_.get()).get<Track>();
  }

 private:
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

std::size_t steps_to_make(const NamedScene& scene) {
  return static_cast<std::size_t>(std::lround(scene.setup.duration / scene.setup.stepping.dt));
}

}  // namespace

std::optional<std::vector<Track>> run_tracks(const std::vector<TrackedTask>& tasks,
                                             const Acceptance& acceptance,
                                             std::chrono::nanoseconds silence,
                                             const std::function<void(const Progress&)>& progress,
                                             const std::atomic<bool>& interrupted) {
  const std::atomic<bool> never = false;
  std::vector<Mailbox> boxes(tasks.size());
  std::vector<std::size_t> beats(tasks.size(), 0);
  std::vector<ChildTask> work;
  Progress state;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    state.total += steps_to_make(tasks[i].scene);
    work.push_back([&, i](const std::function<void()>& beat) {
      const TrackedTask& task = tasks[i];
      boxes[i].put(
          run_tracked(task.scene, make_solver(task.solver), acceptance, beat, never, task.limit));
    });
  }
  std::vector<Track> tracks(tasks.size());
  run_children(
      work, 1, silence,
      [&](const ChildEnd& end) {
        state.done += steps_to_make(tasks[end.task].scene) - beats[end.task];
        Track& track = tracks[end.task];
        if (end.failure.empty()) {
          track = boxes[end.task].take();
          return;
        }
        track.scene = tasks[end.task].scene.spelling;
        track.solver = tasks[end.task].solver;
        track.dt = tasks[end.task].scene.setup.stepping.dt;
        track.broken = end.failure;
      },
      [&](std::size_t task) {
        ++beats[task];
        ++state.done;
        state.at = tasks[task].name;
        progress(state);
      },
      interrupted);
  if (interrupted) return std::nullopt;
  return tracks;
}

}  // namespace lcp
