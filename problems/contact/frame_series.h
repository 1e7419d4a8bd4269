#pragma once

#include <string>
#include <vector>

#include "problems/contact/carried_over.h"
#include "problems/contact/friction_lcp.h"
#include "problems/instance.h"
#include "solvers/registry.h"

namespace lcp {

/// A time series of contact problems in which a solver, the driver, decides the forces: each frame
/// becomes an instance, and the forces that act in it shape the next one.
///
/// Where the driver does not claim `solved` for a frame's frictional LCP (25), the forces of its
/// frictionless LCP act, and where it fails there too, none. Source: K. Yamane, Y. Nakamura, "A
/// Numerically Robust LCP Solver for Simulating Articulated Rigid Bodies in Contact", RSS 2008, V-A.
class FrameSeries {
 public:
  /// `scene` names the instances scene/0000 ...; `driver` is a solver's spelling. Throws
  /// std::invalid_argument, with the list of what is allowed, when there is no such solver.
  FrameSeries(std::string scene, const std::string& driver, FrictionModel model);

  /// Appends the frame at `time` (s) and returns the contact forces that act in it: 3 Nc, N, contact
  /// axes, as they come from the driver's z. `start` says where the start velocity comes from when
  /// that is not the frame before; empty otherwise.
  VectorXd add(const ContactProblem& frame, double time, const std::string& start);

  /// The instances, in order, each with the driver's solution of the frame before as its `previous`,
  /// where the driver solved it, wherever the start velocity comes from. Provenance: scene, time, driver, predecessor, start, applied
  /// (frictional, frictionless or none), fallbacks (frames so far whose frictional LCP the driver
  /// did not solve), contact_ids (body1-body2-feature, in the order of the contacts).
  std::vector<Instance> take() { return std::move(instances_); }

 private:
  std::string scene_;
  NamedSolver driver_;
  FrictionModel model_;
  Index fallbacks_ = 0;
  FrameSolutions last_;
  std::vector<Instance> instances_;
};

/// A frame that stands alone: instance scene/`number` (four digits) of the frictional LCP. `driver`
/// solves its frictionless LCP only, for `active_contacts`. Provenance: what is given and scene,
/// driver, contact_ids.
Instance lone_frame(const std::string& scene, Index number, const ContactProblem& frame,
                    const FrictionModel& model, const NamedSolver& driver,
                    std::map<std::string, std::string> provenance);

}  // namespace lcp
