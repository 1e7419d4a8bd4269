#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace lcp {

/// Descriptors of this process that a child is given.
struct ChildStreams {
  int channel = -1;          ///< Handed to its work.
  int out = -1, err = -1;    ///< Become its stdout and stderr; -1: what it prints is dropped.
  bool keeps_files = false;  ///< What else this process has open stays open there.
};

/// A forked process that does one piece of work, so that a crash, an abort, a leak or a hang ends that
/// alone. It is in a process group of its own, so that Ctrl-C reaches only this process; it dies with
/// this process, dumps no core, reads /dev/null, and has no file open but its streams, unless it keeps
/// them. It is killed, with what it started, and reaped when this object goes. Fork while this process
/// has one thread.
class ChildProcess {
 public:
  /// Forks. The child ends with status 0 when `work(channel)` returns, which must not throw. Throws
  /// std::system_error when the system refuses.
  ChildProcess(const ChildStreams& streams, const std::function<void(int channel)>& work);
  ChildProcess() = default;
  ChildProcess(ChildProcess&& other) noexcept : pid_(std::exchange(other.pid_, -1)) {}
  ChildProcess& operator=(ChildProcess&& other) noexcept {
    std::swap(pid_, other.pid_);
    return *this;
  }
  ~ChildProcess() { stop(); }

  pid_t pid() const { return pid_; }
  /// Waits for its end and returns its status, as of waitpid; 0 when that was done before.
  int wait();
  /// The same after killing it and what it started. A process that is already on its way out keeps the
  /// status it chose.
  int stop();

 private:
  pid_t pid_ = -1;
};

/// "crashed with signal 6 (Aborted)", where `by_signal` is "crashed with", "exited with status 7", or
/// nothing for a process that ended well.
std::string how_it_ended(int status, const std::string& by_signal = "crashed with");

/// Runs `work` in a child process and returns what it returned there, so that a library that crashes,
/// aborts or hangs on a foreign file takes only the child with it. Throws UnreadableInput: the child's
/// own message where `work` threw a std::exception; otherwise a line beginning with `what` that says how
/// the child died, or that it was stopped after `seconds`.
std::string try_in_child(const std::string& what, unsigned seconds,
                         const std::function<std::string()>& work);

/// What a program printed and how it ended.
struct ProgramOutput {
  int status = 0;         ///< 0 when it ended well; else as waitpid gives it.
  std::string out;        ///< Standard output.
  std::string complaint;  ///< First line of standard error.
};

/// Runs `program`, found by PATH, in `directory` until it ends. Throws std::system_error where it
/// cannot be started: with std::errc::no_such_file_or_directory when it is not installed.
ProgramOutput output_of(const std::string& program, const std::vector<std::string>& arguments,
                        const std::filesystem::path& directory);

}  // namespace lcp
