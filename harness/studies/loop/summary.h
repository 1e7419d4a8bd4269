#pragma once

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "harness/studies/loop/in_the_loop.h"

namespace lcp {

/// A simulation in figures. Counts are of frames with contact; `failure` counts frictional LCPs.
struct LoopSummary : LoopHeader {
  double duration = 0;     ///< s, asked for.
  Index steps = 0;         ///< Done.
  Index total_frames = 0;  ///< Frames with contact.
  Index success = 0, failure = 0;
  Index no_solution = 0;            ///< Of failure: ray, exhausted, infeasible, false-infeasible.
  Index cycle = 0;                  ///< cycle, limit.
  Index error = 0;                  ///< wrong, singular.
  Index unsupported = 0;            ///< Not in failure.
  Index frictionless_failures = 0;  ///< Frames whose frictionless LCP failed.
  Index both_failures = 0;          ///< Frames whose two LCPs both failed: no force acted.
  Index restarts = 0;               ///< Frictional LCPs started cold for want of a start.
  double contacts = 0, active = 0;  ///< Means.
  Index violated = 0;           ///< Contacts that close under the forces that act, over all frames.
  Index pivots = 0, nodes = 0;  ///< Of the frictional solves, totals.
  double lcp_ms = 0;            ///< Mean time of a frictional solve.
  double simulation_ms = 0;     ///< Mean time of a step with contact, solves included.
  double outside_ms = 0;        ///< Mean time of a step without its two solves.
  double residual_median = NAN, residual_max = NAN;  ///< Natural, scaled, of the solved; if any.
  double depth_max = 0;                              ///< m.
  double tilt_max = 0;                               ///< rad.
  double turn = 0;                                   ///< Yaw at the end minus at the start, rad.
  double height_min = 0, height_end = 0;             ///< Of the centre of mass, m.
  /// Largest difference, over 20 ms averages, of the sum of contact forces (vertical) from weight
  /// plus mass times the centre of mass's acceleration minus what pulls, over the weight. None where
  /// joints to the world bear forces.
  double force_mismatch = NAN;
  double work = 0;  ///< Done by what pulls, J.
  /// Largest excess of the energy over that at the start and the work done since, over the largest
  /// kinetic energy so far. None where prescribed joints do work.
  double energy_excess = NAN;
  double gap_max = 0, gap_end = 0;  ///< By which joints of loops are open, m.
  /// LoopRun::trail, x y z.
  std::vector<std::vector<std::array<double, 3>>> trail;
};

/// `weight` of the system, N; `mass` in kg.
LoopSummary summarise(const LoopRun& run, double mass, const Vector3d& gravity);

void to_json(nlohmann::json& json, const LoopSummary& summary);
/// The same for a reader: without `trail`, every link at many times.
nlohmann::json figures_of(const LoopSummary& summary);
/// Throws std::invalid_argument saying which field is missing or malformed.
void from_json(const nlohmann::json& json, LoopSummary& summary);

/// Mean distance, m, of the links of two simulations of one scene after the same share of its
/// duration, 0 ... 1 by twentieths; NaN where either has ended by then.
double mean_link_distance(const LoopSummary& a, const LoopSummary& b, double share);

/// A line per frame: time, contacts, verdicts, work, times, residuals, forces, centre of mass.
std::string frames_csv(const LoopRun& run);

/// For a terminal.
std::string render(const LoopSummary& summary);

}  // namespace lcp
