#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "harness/measure/runner.h"
#include "harness/studies/loop/drift.h"
#include "harness/studies/sufficient/ladder.h"

namespace lcp {

/// How far from the reference a model may be that is enough.
struct Criteria {
  double trajectory = 1e-3;   ///< m, of a link's centre of mass, whenever and wherever largest.
  double force = 0.02;        ///< Of the weight: contact forces on a mechanism, averaged.
  double window = 0.02;       ///< s, over which forces are averaged.
  double penetration = 1e-3;  ///< m, of the largest overlap.
  double slip = 1e-3;         ///< m, of the way that a handle slips on its contacts.
};

/// Distances from the reference, in units of Criteria.
struct PhysicalError {
  double trajectory = 0, force = 0, penetration = 0, slip = 0;
};

/// The largest of the errors over their tolerances: at most 1 where all criteria are met.
double over_tolerance(const PhysicalError& error, const Criteria& criteria);

/// Names of the criteria that are not met.
std::vector<std::string> exceeded(const PhysicalError& error, const Criteria& criteria);

/// What is compared, and how.
struct StudyPlan {
  ModelLadder ladder;
  Criteria criteria;
  double duration = 1;         ///< s, simulated, at most.
  double disturbance = 1e-12;  ///< Of the reference's velocities at the start (m/s, rad/s).
  /// Simulations are compared up to where the reference and its disturbed self are this share of a
  /// tolerance apart: beyond, a difference says nothing about a model.
  double floor_share = 0.25;
  int rounds = 3;  ///< Simulations of each model for its times, the least of each frame; models
                   ///< take turns.
  /// A model is stopped at so many times the computing time of the reference: it is not cheaper.
  double patience = 4;
  std::chrono::nanoseconds silence = std::chrono::seconds(60);  ///< A step may last.
};

/// Part of the reference's time that a model saves, 1: all of it. Negative where it costs more.
struct Saving {
  double all = 0;            ///< By all rounds.
  double low = 0, high = 0;  ///< With one round left out, whichever; `all` where there is only one.
};

/// How a model did.
struct ModelRow {
  SceneModel model;
  std::string axis;  ///< Of the ladder; "reference", "disturbed", "combination".
  PhysicalError error;
  double until = 0;          ///< s, simulated.
  std::string broken;        ///< Why not to the end.
  bool stopped = false;      ///< In that it took too long.
  Index frames = 0;          ///< With contact,
  Index failed = 0;          ///< and those whose frictional LCP failed.
  double n = 0;              ///< Mean size of the LCP.
  double lcp = 0, step = 0;  ///< Processor time of LCPs and of all, s per simulated s.
  Saving lcp_saved, step_saved;
  double time_noise = 0;  ///< Part of a step's time that the disturbed reference saved or cost.
  bool passes = false;    ///< It went to the end, all criteria met.
  bool cheaper = false;   ///< It saves more of a step's time than time_noise.
};

/// Which models of a scene are enough.
struct Study {
  StudyPlan plan;
  double horizon = 0;                   ///< s, up to which simulations are compared.
  ModelRow reference;                   ///< In the rounds of single rungs.
  ModelRow disturbed;                   ///< The reference again: its error is the noise floor.
  std::vector<ModelRow> rows;           ///< Each axis alone, then combinations.
  std::optional<std::size_t> cheapest;  ///< The row that passes and saves most.
};

/// Simulates the reference, then each rung of each axis alone, then combinations of those that pass
/// (combine.h). An answer that its solver claims to be solved acts, whatever its residual: models are
/// judged by what the bodies do. Where it claims none the rule of the paper's V-A applies.
///
/// Every simulation runs in a process of its own, models taking turns in each round. Returns nothing
/// when interrupted. Throws std::runtime_error when the reference does not reach the end, or its
/// disturbed self is too far away within one window already.
std::optional<Study> study(const StudyPlan& plan,
                           const std::function<void(const Progress&)>& progress,
                           const std::atomic<bool>& interrupted);

}  // namespace lcp
