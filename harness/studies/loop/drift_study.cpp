#include "harness/studies/loop/drift_study.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <memory>
#include <stdexcept>
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

}  // namespace

TrackedTask disturbed(TrackedTask task, double size) {
  disturb_start(task.scene, size);
  return task;
}

std::vector<DriftLine> DriftStudy::simulate(const std::vector<TrackedTask>& tasks) {
  const std::atomic<bool> never = false;
  const std::vector<Mailbox> boxes(tasks.size());
  std::vector<std::size_t> to_come;
  std::vector<ChildTask> work;
  std::vector<DriftLine> lines;
  Progress state;
  for (const TrackedTask& task : tasks) {
    to_come.push_back(static_cast<std::size_t>(steps_to_make(task.scene)));
    state.total += to_come.back();
    lines.push_back({task.name, task.control});
    work.push_back([&, &box = boxes[work.size()]](const std::function<void()>& beat) {
      box.put(
          run_tracked(task.scene, make_solver(task.solver), acceptance, beat, never, task.limit));
    });
  }
  run_children(
      work, 1, silence,
      [&](const ChildEnd& end) {
        state.done += to_come[end.task];
        Track& track = lines[end.task].track;
        if (end.failure.empty()) {
          track = boxes[end.task].take();
        } else {
          static_cast<LoopHeader&>(track) =
              loop_header(tasks[end.task].scene, tasks[end.task].solver);
          track.broken = end.failure;
        }
      },
      [&](std::size_t task) {
        --to_come[task];
        ++state.done;
        state.at = tasks[task].name;
        progress(state);
      },
      interrupted);
  if (interrupted) throw Interrupted();
  if (reference.frames() == 0) reference = lines.front().track;
  if (reference.frames() == 0)
    throw std::runtime_error(fmt::format("the reference {} with {} has no frame: {}",
                                         reference.scene, reference.solver, reference.broken));
  for (DriftLine& line : lines) line.drifts = drift(line.track, reference, window);
  return lines;
}

}  // namespace lcp
