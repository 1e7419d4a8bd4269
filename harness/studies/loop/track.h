#pragma once

#include <atomic>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "harness/studies/loop/in_the_loop.h"

namespace lcp {

/// What bodies did in a simulation, frame by frame: what two simulations are compared by. A frame's
/// column is how things stand before that frame's forces move the bodies.
struct Track : LoopHeader {
  double weight = 0;  ///< Of all links, N.
  VectorXd time;      ///< Frames, s.
  MatrixXd centres;   ///< 3 links x frames: centres of mass, m.
  /// 3 mechanisms x frames, N s: what contacts have given so far to each set of links that joints
  /// hold together. Unlike single contact forces, this does not depend on how forces are shared out
  /// among redundant contacts.
  MatrixXd impulse;
  /// Handles x frames, m: way that each has slipped so far, the mean of its contacts' tangential
  /// speeds, weighed by their normal forces, over time.
  MatrixXd travel;
  VectorXd depth;     ///< Frames: largest overlap, m.
  VectorXd energy;    ///< Frames: kinetic and potential over z = 0, J.
  VectorXd residual;  ///< Frames: natural, scaled, of the frictional answer; NaN without contact.
  Index contact_frames = 0;  ///< Frames with contact.
  Index failed = 0;          ///< Frames whose frictional LCP failed.
  double n = 0;              ///< Mean size of the frictional LCP over frames with contact.
  VectorXd lcp_s;            ///< Frames: processor time of the LCPs, s.
  VectorXd step_s;           ///< Frames: processor time of the whole step, s.
  double elapsed_s = 0;      ///< From start to end, judging included, s.

  Index frames() const { return time.size(); }
  double simulated() const { return dt * static_cast<double>(frames()); }  ///< s.
};

/// The mechanism that each link belongs to, counted from 0 by first links: links held together by
/// joints. Links that hang from the world by several joints are as many mechanisms.
std::vector<Index> mechanisms(const Model& model);

/// Disturbs the velocities that a scene starts with by up to `size` (m/s, rad/s), uniformly;
/// always alike.
void disturb_start(NamedScene& scene, double size);

/// Simulates as run_in_the_loop; calls `beat` at every frame.
Track run_tracked(const NamedScene& scene, const NamedSolver& solver, const Acceptance& acceptance,
                  const std::function<void()>& beat, const std::atomic<bool>& interrupted,
                  std::optional<double> limit = {});

void to_json(nlohmann::json& json, const Track& track);
void from_json(const nlohmann::json& json, Track& track);

}  // namespace lcp
