#include "harness/measure/children.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>
#include <system_error>

#include "problems/io/file_descriptor.h"
#include "problems/io/errors.h"

namespace lcp {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int tick_ms = 50;  // Between looks at `interrupted` and at silence.

// What a child sends: a byte per beat; at an exception, one of these and the text.
constexpr char beat_byte = '.';
constexpr char threw_byte = '!';
constexpr char unwritable_byte = 'W';

void send(int pipe, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = write(pipe, bytes.data(), bytes.size());
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) _exit(EXIT_FAILURE);
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
}

void isolate(pid_t parent) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(EXIT_FAILURE);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  const int nowhere = open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
}

[[noreturn]] void run_child(int pipe, const ChildTask& task) {
  try {
    task([pipe] { send(pipe, {&beat_byte, 1}); });
    _exit(EXIT_SUCCESS);
  } catch (const UnwritableOutput& error) {
    send(pipe, unwritable_byte + std::string(error.what()));
  } catch (const std::exception& error) {
    send(pipe, threw_byte + std::string(error.what()));
  } catch (...) {
    send(pipe, threw_byte + std::string("not a std::exception"));
  }
  _exit(EXIT_FAILURE);
}

/// A process at work on one task; killed and reaped when it goes.
class Child {
 public:
  Child(std::size_t number, const ChildTask& task) : task_(number), last_beat_(Clock::now()) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
      throw std::system_error(errno, std::generic_category(), "pipe");
    pipe_ = FileDescriptor(ends[0]);
    FileDescriptor childs_end(ends[1]);
    std::fflush(nullptr);
    const pid_t parent = getpid();
    pid_ = fork();
    if (pid_ < 0) throw std::system_error(errno, std::generic_category(), "fork");
    if (pid_ > 0) return;
    isolate(parent);
    run_child(childs_end.get(), task);
  }
  ~Child() {
    if (pid_ > 0) stop();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

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
    const int status = wait();
    if (!said_.empty() && said_.front() == unwritable_byte) throw UnwritableOutput(said_.substr(1));
    if (!said_.empty()) return {task_, "threw: " + one_line(said_.substr(1))};
    if (WIFSIGNALED(status))
      return {task_, fmt::format("crashed with signal {} ({})", WTERMSIG(status),
                                 strsignal(WTERMSIG(status)))};
    if (WEXITSTATUS(status) != EXIT_SUCCESS)
      return {task_, fmt::format("exited with status {}", WEXITSTATUS(status))};
    return {task_, ""};
  }

  void stop() {
    kill(-pid_, SIGKILL);  // its group: also what it started
    kill(pid_, SIGKILL);   // it may not have a group yet
    wait();
  }

 private:
  int wait() {
    int status = 0;
    while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
    }
    pid_ = -1;
    return status;
  }

  std::size_t task_;
  pid_t pid_ = -1;
  FileDescriptor pipe_;
  Clock::time_point last_beat_;
  std::string said_;
};

using Children = std::vector<std::unique_ptr<Child>>;

std::vector<pollfd> wait_for(const Children& children) {
  std::vector<pollfd> watched;
  for (const auto& child : children) watched.push_back({child->pipe(), POLLIN, 0});
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
      running.push_back(std::make_unique<Child>(next, tasks[next]));
      ++next;
      continue;
    }
    const std::vector<pollfd> watched = wait_for(running);
    std::vector<ChildEnd> ends;
    for (std::size_t i = 0; i < watched.size(); ++i) {
      Child& child = *running[i];
      if (watched[i].revents != 0 && !child.receive(beat)) {
        ends.push_back(child.end());
      } else if (child.silent_for(silence)) {
        child.stop();
        const double seconds = std::chrono::duration<double>(silence).count();
        ends.push_back({child.task(), fmt::format("stopped: no step for {:g} s", seconds)});
      }
    }
    for (const ChildEnd& end : ends) {
      std::erase_if(running, [&](const auto& child) { return child->task() == end.task; });
      ended(end);
    }
  }
}

}  // namespace lcp
