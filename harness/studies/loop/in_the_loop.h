#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "harness/judge/acceptance.h"
#include "problems/scenes/scene.h"
#include "solvers/registry.h"

namespace lcp {

/// What happened in one frame of a simulation. In frames without contact no solver is asked.
struct FrameRecord {
  Index frame = 0;
  double time = 0;         ///< s.
  Index points_found = 0;  ///< Contact points before reduction.
  Index contacts = 0;
  Index n = 0;                            ///< Of the frictional LCP.
  std::optional<Index> active;            ///< Contacts active without friction; where known.
  Verdict frictional = Verdict::not_run;  ///< On the full LCP, by the loop's criterion.
  Verdict frictionless = Verdict::not_run;
  std::string message;
  Applied applied = Applied::none;
  Accuracy accuracy = {};  ///< Of the frictional answer.
  Index violated = 0;      ///< Contacts whose w_a is below -1e-6 s_w under the forces that act.
  Work work;               ///< Of the frictional solve.
  Work frictionless_work;  ///< Of the frictionless solve before; all 0 where nothing has friction.
  std::int64_t frictional_ns = 0, frictionless_ns = 0;
  std::int64_t step_ns = 0;  ///< The whole step, solves included; no judging, no looking.
  /// The same of both solves and of the step in processor time of the process, to which waiting for
  /// a busy machine adds nothing.
  std::int64_t lcp_cpu_ns = 0, step_cpu_ns = 0;
  double depth = 0;     ///< Largest overlap, m.
  double approach = 0;  ///< Largest speed at which a contact closes, m/s.
  Vector3d centre_of_mass = Vector3d::Zero(), com_velocity = Vector3d::Zero();
  double yaw = 0;                       ///< Of the first link, rad, continued over turns.
  double tilt = 0;                      ///< Angle between its z axis and the vertical, rad.
  std::vector<Vector3d> handle_forces;  ///< Contact force on each handle, N, world axes.
  Vector3d pull = Vector3d::Zero();     ///< Sum of the forces that pull at links, N.
  double kinetic = 0;                   ///< Energy, J.
  double energy = 0;                    ///< Kinetic and potential, the latter over z = 0, J.
  double pull_work = 0;                 ///< Done so far by what pulls at links, J.
  double gap = 0;                       ///< By which the joint of a loop is open at most, m.
};

/// Parts of a simulation's duration after which positions are kept.
inline constexpr Index trail_parts = 20;

/// Which simulation something is of, and how it ended.
struct LoopHeader {
  std::string scene, solver;  ///< Full spellings.
  double dt = 0;              ///< s.
  std::string broken = {};    ///< Why it ended early: bodies no longer at finite speed; stopped.
  bool stopped = false;       ///< By its limit of time or an interruption, while all was well.
};

/// As fields.h has them.
inline constexpr auto loop_header_fields = [](auto& header, const auto& field) {
  field("scene", header.scene);
  field("solver", header.solver);
  field("dt", header.dt);
  field("broken", header.broken);
  field("stopped", header.stopped);
};

LoopHeader loop_header(const NamedScene& scene, const std::string& solver);

/// A simulation from its start to its end, or to where it broke.
struct LoopRun : LoopHeader {
  Acceptance acceptance = {};
  double duration = 0;  ///< s, asked for.
  std::vector<FrameRecord> frames = {};
  bool driven = false;    ///< Prescribed joints do work that nobody counts.
  bool anchored = false;  ///< Joints to the world hold forces that nobody counts.
  /// Centres of mass of the links, m, at the start and after every further part of the duration.
  std::vector<std::vector<Vector3d>> trail = {};
};

/// Steps of a scene's duration.
Index steps_to_make(const NamedScene& scene);

/// Looks at a frame before the bodies move, with its record (step_ns is still 0).
using FrameLook = std::function<void(const Simulation&, const Frame&, const FrameRecord&)>;

/// Simulates a scene with a solver in the loop: the forces it finds move the bodies. An answer that
/// is not accepted counts as failed and the frictionless one acts (paper V-A). Contacts that do not
/// influence one another are solved apart (islands). Before a step that
/// would begin `limit` s of wall-clock time after the first it stops.
LoopRun run_in_the_loop(const NamedScene& scene, const NamedSolver& solver,
                        const Acceptance& acceptance, const FrameLook& look,
                        const std::atomic<bool>& interrupted, std::optional<double> limit = {});

}  // namespace lcp
