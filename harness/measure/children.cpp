#include "harness/measure/children.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string_view>

#include "problems/io/child_process.h"
#include "problems/io/errors.h"
#include "problems/io/file_descriptor.h"

namespace lcp {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int tick_ms = 50;  // Between looks at `interrupted` and at silence.

// What a child sends: a byte per beat; at an exception, one of these and the text.
constexpr char beat_byte = '.';
constexpr char threw_byte = '!';
constexpr char unwritable_byte = 'W';

void run_in_child(int channel, const ChildTask& task) {
  const auto say = [channel](const std::string& bytes) {
    if (!write_all(channel, bytes)) _exit(EXIT_FAILURE);
  };
  try {
    task([&] { say({beat_byte}); });
    return;
  } catch (const UnwritableOutput& error) {
    say(unwritable_byte + std::string(error.what()));
  } catch (const std::exception& error) {
    say(threw_byte + std::string(error.what()));
  } catch (...) {
    say(threw_byte + std::string("not a std::exception"));
  }
  _exit(EXIT_FAILURE);
}

/// A process at work on one task.
class Child {
 public:
  Child(std::size_t number, const ChildTask& task) : task_(number), last_beat_(Clock::now()) {
    Pipe pipe = make_pipe();
    pipe_ = std::move(pipe.reading);
    process_ = ChildProcess({.channel = pipe.writing.get(), .keeps_files = true},
                            [&task](int channel) { run_in_child(channel, task); });
  }

  std::size_t task() const { return task_; }
  int pipe() const { return pipe_.get(); }
  bool silent_for(std::chrono::nanoseconds limit) const {
    return Clock::now() - last_beat_ > limit;
  }

  /// Takes in what was sent, once the pipe is readable. Returns false at its end.
  bool receive(const std::function<void(std::size_t)>& beat) {
    std::array<char, 4096> buffer;
    const ssize_t received = read(pipe_.get(), buffer.data(), buffer.size());
    if (received < 0) return errno == EINTR;
    if (received == 0) return false;
    last_beat_ = Clock::now();
    for (const char byte : std::string_view(buffer.data(), static_cast<std::size_t>(received))) {
      if (said_.empty() && byte == beat_byte)
        beat(task_);
      else
        said_ += byte;
    }
    return true;
  }

  /// How it ended; waits for it.
  ChildEnd end() {
    const int status = process_.wait();
    if (!said_.empty() && said_.front() == unwritable_byte) throw UnwritableOutput(said_.substr(1));
    if (!said_.empty()) return {task_, "threw: " + one_line(said_.substr(1))};
    return {task_, how_it_ended(status)};
  }

 private:
  std::size_t task_;
  FileDescriptor pipe_;
  ChildProcess process_;
  Clock::time_point last_beat_;
  std::string said_;
};

using Children = std::vector<Child>;

std::vector<pollfd> wait_for(const Children& children) {
  std::vector<pollfd> watched;
  for (const Child& child : children) watched.push_back({child.pipe(), POLLIN, 0});
  if (poll(watched.data(), watched.size(), tick_ms) < 0)
    for (pollfd& each : watched) each.revents = 0;  // interrupted: a short tick
  return watched;
}

}  // namespace

void run_children(const std::vector<ChildTask>& tasks, int jobs, std::chrono::nanoseconds silence,
                  const std::function<void(const ChildEnd&)>& ended,
                  const std::function<void(std::size_t)>& beat,
                  const std::atomic<bool>& interrupted) {
  Children running;
  std::size_t next = 0;
  while (!interrupted && (next < tasks.size() || !running.empty())) {
    if (next < tasks.size() && running.size() < static_cast<std::size_t>(jobs)) {
      running.emplace_back(next, tasks[next]);
      ++next;
      continue;
    }
    const std::vector<pollfd> watched = wait_for(running);
    std::vector<ChildEnd> ends;
    for (std::size_t i = 0; i < watched.size(); ++i) {
      Child& child = running[i];
      if (watched[i].revents != 0 && !child.receive(beat)) {
        ends.push_back(child.end());
      } else if (child.silent_for(silence)) {
        const double seconds = std::chrono::duration<double>(silence).count();
        ends.push_back({child.task(), fmt::format("stopped: no step for {:g} s", seconds)});
      }
    }
    for (const ChildEnd& end : ends) {
      std::erase_if(running, [&](const Child& child) { return child.task() == end.task; });
      ended(end);
    }
  }
}

}  // namespace lcp
