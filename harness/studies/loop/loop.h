#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "harness/present/described.h"
#include "harness/studies/loop/drift_study.h"

namespace lcp {

/// A scene to be driven by each of several solvers, beside a reference.
struct LoopPlan {
  std::string scene;                 ///< Spelling.
  std::optional<double> dt;          ///< s; without it the scene's.
  std::optional<double> duration;    ///< s; without it the scene's.
  std::string reference;             ///< Spelling of the solver that others are compared with.
  std::vector<std::string> solvers;  ///< Full spellings.
  Acceptance acceptance = {};        ///< When an answer may act.
  double disturbance = 1e-12;        ///< Of the reference's velocities at the start, m/s and rad/s.
  double departure = 1e-3;           ///< m, of a link from its place in the reference.
  double limit = 120;                ///< Computing time of a simulation, s.
  std::chrono::nanoseconds silence = std::chrono::seconds(60);  ///< A step may last.
};

/// Simulations of a scene that began alike.
struct LoopStudy {
  LoopPlan plan;
  /// The reference; disturbed, which shows how fast nearby motions part by themselves; with half the
  /// time step, which shows what the steps' length does; then the solvers.
  std::vector<DriftLine> lines;
};

/// Drives the scene with each solver. One that breaks is a line that ends there. Throws
/// std::invalid_argument on unknown names, and as DriftStudy::simulate does.
LoopStudy loop_study(const LoopPlan& plan, const std::function<void(const Progress&)>& progress,
                     const std::atomic<bool>& interrupted);

/// When a link first was `departure` (m) from its place in the reference, s; none if it never was.
std::optional<double> departed(const DriftLine& line, double departure);

/// The text is a table; the CSV how each line drifted over time, thinned; the figure drift, energy,
/// overlap and residual over time.
Described described(const LoopStudy& study);
Figure loop_figure(const LoopStudy& study);

/// The largest values in one of the equal parts of a simulation's duration.
struct LoopSample {
  double time = 0;  ///< s, its end.
  Drift drift;
  double residual = 0;  ///< NaN without contact.
};

/// A line in at most `parts` samples.
std::vector<LoopSample> thinned(const DriftLine& line, double duration, Index parts);

}  // namespace lcp
