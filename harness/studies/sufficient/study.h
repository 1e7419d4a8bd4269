#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "harness/studies/loop/drift_study.h"
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

/// What one of the criteria compares.
struct ErrorKind {
  const char* name;
  const char* unit;
  double scale;  ///< How many of the unit are one of the program's.
  double Drift::*error;
  double Criteria::*tolerance;
  const char *heading, *meaning;  ///< In a table.
};
inline constexpr ErrorKind error_kinds[] = {
    {"trajectory", "mm", 1e3, &Drift::distance, &Criteria::trajectory, "traj mm",
     "largest distance of a link's centre of mass from the reference's"},
    {"force", "percent", 100, &Drift::force, &Criteria::force, "force %",
     "contact force on a mechanism (links held together by joints), averaged, over the weight: "
     "largest difference"},
    {"penetration", "mm", 1e3, &Drift::depth, &Criteria::penetration, "depth mm",
     "largest difference of the deepest overlap"},
    {"slip", "mm", 1e3, &Drift::slip, &Criteria::slip, "slip mm",
     "largest difference of the way that a link slipped on its contacts"}};

/// The largest of the errors over their tolerances: at most 1 where all criteria are met.
double over_tolerance(const Drift& error, const Criteria& criteria);

/// Names of the criteria that are not met.
std::vector<std::string> exceeded(const Drift& error, const Criteria& criteria);

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
  std::string axis;          ///< Of the ladder; "reference", "disturbed", "combination".
  Drift error;               ///< Largest ones up to the horizon.
  double until = 0;          ///< s, simulated.
  std::string broken;        ///< Why not to the end.
  bool stopped = false;      ///< In that it took too long.
  Index frames = 0;          ///< With contact.
  Index failed = 0;          ///< Frames whose frictional LCP failed.
  double n = 0;              ///< Mean size of the LCP.
  double lcp = 0, step = 0;  ///< Processor time of LCPs and of all, s per simulated s.
  Saving lcp_saved = {}, step_saved = {};
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
/// Every simulation runs in a process of its own, models taking turns in each round. Throws Interrupted,
/// and std::runtime_error when the reference does not reach the end, or its disturbed self is too far
/// away within one window already.
Study study(const StudyPlan& plan, const std::function<void(const Progress&)>& progress,
            const std::atomic<bool>& interrupted);

}  // namespace lcp
