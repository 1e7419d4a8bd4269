#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "harness/measure/runner.h"
#include "harness/studies/loop/track.h"

namespace lcp {

/// A simulation to be made.
struct TrackedTask {
  NamedScene scene;
  std::string solver;           ///< Spelling.
  std::optional<double> limit;  ///< Computing time, s, after which it is stopped.
  std::string name;             ///< For whoever waits.
};

/// Makes each simulation in a process of its own, one after the other, so that a crash or a hang
/// ends that one alone: its track then has no frames and says how it ended. A process is killed when
/// `silence` passes without a frame. Returns nothing when interrupted. Call it while this process
/// has one thread.
std::optional<std::vector<Track>> run_tracks(const std::vector<TrackedTask>& tasks,
                                             const Acceptance& acceptance,
                                             std::chrono::nanoseconds silence,
                                             const std::function<void(const Progress&)>& progress,
                                             const std::atomic<bool>& interrupted);

}  // namespace lcp
