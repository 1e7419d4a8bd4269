#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "harness/measure/runner.h"
#include "harness/studies/loop/drift.h"

namespace lcp {

/// A simulation to be made.
struct TrackedTask {
  NamedScene scene;
  std::string solver;                ///< Spelling.
  std::optional<double> limit = {};  ///< Computing time, s, after which it is stopped.
  std::string name = {};             ///< For whoever waits.
  bool control = false;              ///< The reference, changed or not.
};

/// The same with the velocities at the start disturbed by up to `size` (m/s, rad/s).
TrackedTask disturbed(TrackedTask task, double size);

/// One simulation beside the reference.
struct DriftLine {
  std::string label;     ///< Its task's name.
  bool control = false;  ///< As its task.
  Track track = {};
  std::vector<Drift> drifts = {};  ///< From the reference.
};

/// Thrown where a study is interrupted.
struct Interrupted {};

/// Simulations of the same bodies, each compared with a reference.
struct DriftStudy {
  Acceptance acceptance;             ///< When an answer may act.
  double window;                     ///< s, over which forces are averaged.
  std::chrono::nanoseconds silence;  ///< A step may last.
  const std::function<void(const Progress&)>& progress;
  const std::atomic<bool>& interrupted;
  Track reference = {};  ///< The first that was ever made.

  /// Makes each simulation in a process of its own, one after the other, so that a crash or a hang
  /// ends that one alone: its track then has no frames and says how it ended. A process is killed when
  /// `silence` passes without a frame. Call it while this process has one thread. Throws Interrupted,
  /// and std::runtime_error where the reference has no frame.
  std::vector<DriftLine> simulate(const std::vector<TrackedTask>& tasks);
};

}  // namespace lcp
