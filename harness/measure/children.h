#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace lcp {

/// A piece of work that writes its result into a file. It calls `beat` at every step.
using ChildTask = std::function<void(const std::function<void()>& beat)>;

/// How the process of a task ended.
struct ChildEnd {
  std::size_t task = 0;
  std::string failure;  ///< Empty when it ended well: an exception's text, a signal, silence.
};

/// Runs each task in a process of its own, `jobs` at a time, so that a crash or hang ends that task
/// alone. A process dies with its parent, prints nowhere, does not hear Ctrl-C, and is killed when
/// `silence` passes without a beat. `beat` and `ended` are called here, in the parent.
///
/// When `interrupted` becomes true the processes are killed and the function returns. Throws
/// UnwritableOutput where a task did, and std::system_error when the system refuses a process;
/// exceptions of `ended` pass through. All of them kill what runs. Call it while this process has
/// one thread.
void run_children(const std::vector<ChildTask>& tasks, int jobs, std::chrono::nanoseconds silence,
                  const std::function<void(const ChildEnd&)>& ended,
                  const std::function<void(std::size_t task)>& beat,
                  const std::atomic<bool>& interrupted);

}  // namespace lcp
