#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "harness/measure/runner.h"
#include "harness/studies/loop/drift.h"
#include "harness/studies/table/table.h"

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

/// One simulation beside the reference.
struct LoopLine {
  std::string label;     ///< A solver; or how the reference was changed.
  bool control = false;  ///< The reference, changed.
  Track track;
  std::vector<Drift> drifts;
};

/// Simulations of a scene that began alike.
struct LoopStudy {
  LoopPlan plan;
  Track reference;
  /// The reference disturbed, which shows how fast nearby motions part by themselves; with half the
  /// time step, which shows what the steps' length does; then the solvers.
  std::vector<LoopLine> lines;
};

/// Drives the scene with each solver, every simulation in a process of its own, one after the other.
/// One that breaks is a line that ends there. Returns nothing when interrupted. Throws
/// std::runtime_error when the reference has no frame, std::invalid_argument on unknown names.
std::optional<LoopStudy> loop_study(const LoopPlan& plan,
                                    const std::function<void(const Progress&)>& progress,
                                    const std::atomic<bool>& interrupted);

/// When a link first was `departure` from its place in the reference, s; none if it never was.
std::optional<double> departed(const LoopLine& line, double departure);

/// `text`, `csv` (how each line drifted over time, thinned) or `json` (both). Throws
/// std::invalid_argument on another format.
std::string render(const LoopStudy& study, TableFormat format);

/// Draws drift, energy, overlap and residual over time, a line per simulation; script and data are
/// kept beside it. Throws as draw_with_gnuplot.
void draw_loop_study(const LoopStudy& study, const std::filesystem::path& svg);

/// The largest values in one of the equal parts of a simulation's duration.
struct LoopSample {
  double time = 0;  ///< s, its end.
  Drift drift;
  double residual = 0;  ///< NaN without contact.
};

/// A line in at most `parts` samples.
std::vector<LoopSample> thinned(const LoopLine& line, double duration, Index parts);

}  // namespace lcp
