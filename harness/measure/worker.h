#pragma once

#include <poll.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "problems/io/child_process.h"
#include "problems/io/file_descriptor.h"
#include "solvers/result.h"

namespace lcp {

/// How far one solve may go, and how it is timed.
struct Limits {
  std::chrono::nanoseconds time;
  std::int64_t resident_bytes;  ///< Above what the worker held when it was started.
  /// A solve is timed right after another, untimed one where the last one took less than this.
  std::chrono::nanoseconds warm_up_below{};
};

/// How one solve in a worker ended.
struct Outcome {
  enum class How {
    answered,
    threw,      ///< An exception left the solver; its text is in `message`.
    died,       ///< The process ended, by `exit_signal` or by exiting.
    timed_out,  ///< Killed at the time limit.
    overgrown,  ///< Killed at the limit on resident memory.
  } how;
  std::int64_t time_ns = 0;  ///< Of the solve by the worker's clock; until its end where it died.
  Result result = {};        ///< Of an answer.
  std::string answer = {};   ///< The bytes of `result`: equal exactly when every field is.
  std::string message = {};
  int exit_signal = 0;
};

/// A child process that computes `solve` whenever it is asked to, so that hanging, crashing or
/// eating memory ends the child alone. What it prints is kept from the terminal.
class Worker {
 public:
  /// Forks, and has the child call `prepare` once, outside the clock; throws std::system_error when the
  /// system refuses.
  Worker(
      const std::function<Result()>& solve, const Limits& limits,
      const std::function<void()>& prepare = [] {});

  /// Begins one solve. The one before must have ended with an answer.
  void ask();

  /// How the solve asked for ended; empty while it goes on. Enforces the limits, does not wait:
  /// call it whenever one of `watched` is ready and every few milliseconds. Unless it answered,
  /// the process is gone.
  std::optional<Outcome> check();

  /// What to poll while waiting for an answer.
  std::vector<pollfd> watched() const;

  /// The last 400 bytes the worker printed.
  const std::string& output_end() const { return output_end_; }

 private:
  using Clock = std::chrono::steady_clock;

  void drain_output();
  std::optional<Outcome> receive();
  Outcome read_frame();
  Outcome end(Outcome::How how, const std::string& message);
  Outcome death();

  Limits limits_;
  FileDescriptor socket_;
  FileDescriptor output_;
  ChildProcess process_;
  std::int64_t resident_at_start_ = 0;
  Clock::time_point asked_;
  Clock::time_point looked_;  ///< When resident memory was last read.
  std::string received_;
  std::string output_end_;
};

}  // namespace lcp
